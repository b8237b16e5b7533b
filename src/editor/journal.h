// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The journal of a session: what was done, on the disk before it is answered. It is only ever appended to. Each record
// says its length and a checksum over all that stands before it, so that a record that was torn is seen.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"
#include "editor/step.h"

namespace betwixt {

// What tells one text from another.
struct Fingerprint {
  std::uint64_t size = 0, hash = 0;
  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};
Fingerprint fingerprint(std::string_view text);
std::string to_string(const Fingerprint&);  // "SIZE HASH"

struct Record {
  Did what = Did::command;
  std::string text;  // of save: the fingerprint of the file; of checkpoint: that, and how many commands it stands for
};

// How many commands stand, and how many of them a file does not know.
struct Tally {
  std::size_t at = 0, all = 0, saved = 0, gone = 0;  // gone: saved ones that were undone and replaced
  void command() {
    if (at < saved) gone += saved - at, saved = at;
    all = ++at;
  }
  bool undo() { return at > 0 && (--at, true); }
  bool redo() { return at < all && (++at, true); }
  void save() { saved = at, gone = 0; }
  void count(Did what) {
    if (what == Did::command) command();
    if (what == Did::undo) undo();
    if (what == Did::redo) redo();
    if (what == Did::save) save();
  }
  std::size_t unsaved() const { return gone + (at > saved ? at - saved : saved - at); }
};

// The journal of a script, or of a film without a name.
std::string journal_path(const std::string& script);

class Journal {
 public:
  // Finds or makes the journal and holds it until it is destroyed. Errors: name (another process holds it), machine
  // (it cannot be made).
  static Result<std::unique_ptr<Journal>> open(const std::string& path);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // What was found in it.
  const std::optional<Fingerprint>& base() const {
    return base_;
  }  // the text that the records follow; none: no journal
  const std::vector<Record>& records() const { return records_; }
  void forget() { records_ = {}; }
  bool foreign() const { return foreign_; }   // it holds something that is no journal
  std::size_t torn() const { return torn_; }  // bytes at its end that are no whole record
  bool damaged() const { return damaged_; }   // … and were not just cut off

  // Another journal takes its place, whole and on the disk, or it stays as it was.
  Status begin(const Fingerprint& base, std::span<const Record> records = {});
  // … with records that are as if they had been found in it.
  Status begin_with(const Fingerprint& base, std::vector<Record> records);
  // The record is on the disk when this returns; on failure the journal is as it was.
  Status append(Did what, std::string_view text);
  // The same in two: written at its end, which is taken back on failure; and what was written is on the disk. Of a
  // failure of the second it is unknown what is.
  Status write(Did what, std::string_view text);
  Status sync();
  std::uint64_t size() const { return end_; }
  bool in_place() const;  // its name still leads to it
  // A copy under another name that nothing has; the name.
  Result<std::string> keep_aside() const;
  void remove();

 private:
  Journal(std::string path, int file) : path_(std::move(path)), file_(file) {}
  void read();
  bool read_record(const std::string& all, std::size_t& at);

  const std::string path_;
  int file_;
  std::uint64_t sum_ = 0;  // of all up to the end
  std::uint64_t end_ = 0;  // of the last whole record
  std::optional<Fingerprint> base_;
  std::vector<Record> records_;
  std::size_t torn_ = 0;
  bool foreign_ = false, damaged_ = false, dirty_ = false;
};

// Errors: file, machine. A file that is not there: none.
Result<std::optional<std::string>> read_script(const std::string& path);
// The text is under its name, whole and on the disk, or what was there before still is. Links are followed.
Status write_script(const std::string& path, std::string_view text);

}  // namespace betwixt
