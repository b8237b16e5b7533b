// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The journal of a session. A record is on the disk before its command is acknowledged. Records are only appended. Each
// has its length and a checksum over all bytes before it, so that a torn record is detected.
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

// Size and hash of a text, to compare it with others.
struct Fingerprint {
  std::uint64_t size = 0, hash = 0;
  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};
Fingerprint fingerprint(std::string_view text);
std::string to_string(const Fingerprint&);  // "SIZE HASH"

struct Record {
  Did what = Did::command;
  std::string text;  // save: the fingerprint of the file; checkpoint: that, and the number of commands in it
};

// A place between two records of a journal, and the checksum of all bytes before it.
struct JournalPlace {
  std::uint64_t end = 0, sum = 0;
};

// The records in the bytes of a journal.
struct JournalText {
  std::optional<Fingerprint> base;  // the text before the records; nullopt if the journal is empty
  std::vector<Record> records;
  JournalPlace end;      // of the last complete record
  std::size_t torn = 0;  // bytes of an incomplete record at the end
  bool foreign = false;  // the file is no journal
  bool damaged = false;  // the incomplete record was not just cut off
};
// Reads the records of the file behind `text.end`. Another thread may append records meanwhile. Returns 0 or
// the errno of a failure.
int read_more(int file, JournalText& text);

// The number of standing commands, and of those that are not saved in the file.
struct Tally {
  std::size_t at = 0, all = 0, saved = 0, gone = 0;  // gone: saved commands that were undone and replaced
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

// Returns the path of the journal of a script; "" is a film without a name.
std::string journal_path(const std::string& script);

class Journal {
 public:
  // Opens or creates the journal, and locks it until it is destroyed. Errors: name (another process has it open),
  // machine (it cannot be made).
  static Result<std::unique_ptr<Journal>> open(const std::string& path);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // The contents when it was opened.
  const std::optional<Fingerprint>& base() const {
    return text_.base;
  }  // the text before the records; nullopt if there was no journal
  const std::vector<Record>& records() const { return text_.records; }
  void forget() { text_.records = {}; }
  bool foreign() const { return text_.foreign; }   // the file is no journal
  std::size_t torn() const { return text_.torn; }  // bytes of an incomplete record at the end
  bool damaged() const { return text_.damaged; }   // the incomplete record was not just cut off

  // Writes a journal to the disk beside its place. replace() puts it in its place; any thread may call that.
  static Result<std::unique_ptr<Journal>> beside(const std::string& path, const Fingerprint& base,
                                                 std::span<const Record> records);
  Status replace();
  static void drop_beside(const std::string& path);  // removes one that was not put in its place
  // Replaces the journal by another. On failure the old one is unchanged.
  Status begin(const Fingerprint& base, std::span<const Record> records = {});
  // Like begin(), and records() returns the records afterwards.
  Status begin_with(const Fingerprint& base, std::vector<Record> records);
  // Writes a record and flushes it to the disk. On failure the journal is unchanged.
  Status append(Did what, std::string_view text);
  // The two halves of append(): write() appends the record and removes it again on failure; sync() flushes to the disk.
  // After a failure of sync() it is unknown which records are there.
  Status write(Did what, std::string_view text);
  Status sync();
  Status put(Did what, std::string_view text);  // like write(), wherever the file is now
  std::uint64_t size() const { return text_.end.end; }
  JournalPlace place() const { return text_.end; }
  void back_to(const JournalPlace&);  // removes the records behind the place, which have not been flushed
  int read_more(JournalText& text) const { return betwixt::read_more(file_, text); }
  bool in_place() const;  // its path still names this file
  Error lost() const;     // the error if it does not
  // Copies the journal to a free file name. Returns that name.
  Result<std::string> keep_aside() const;
  void remove();

 private:
  Journal(std::string path, int file) : path_(std::move(path)), file_(file) {}
  const std::string path_;
  int file_;
  JournalText text_;
  bool dirty_ = false;
};

// Returns nullopt if the file does not exist. Errors: file, machine.
Result<std::optional<std::string>> read_script(const std::string& path);
// Replaces the file on the disk, whole or not at all. Links are followed.
Status write_script(const std::string& path, std::string_view text);

}  // namespace betwixt
