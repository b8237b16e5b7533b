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
    return base_;
  }  // the text before the records; nullopt if there was no journal
  const std::vector<Record>& records() const { return records_; }
  void forget() { records_ = {}; }
  bool foreign() const { return foreign_; }   // the file is no journal
  std::size_t torn() const { return torn_; }  // bytes of an incomplete record at the end
  bool damaged() const { return damaged_; }   // the incomplete record was not just cut off

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
  std::uint64_t size() const { return end_; }
  bool in_place() const;  // its path still names this file
  // Copies the journal to a free file name. Returns that name.
  Result<std::string> keep_aside() const;
  void remove();

 private:
  Journal(std::string path, int file) : path_(std::move(path)), file_(file) {}
  void read();
  bool read_record(const std::string& all, std::size_t& at);

  const std::string path_;
  int file_;
  std::uint64_t sum_ = 0;  // the checksum of all bytes up to end_
  std::uint64_t end_ = 0;  // of the last complete record
  std::optional<Fingerprint> base_;
  std::vector<Record> records_;
  std::size_t torn_ = 0;
  bool foreign_ = false, damaged_ = false, dirty_ = false;
};

// Returns nullopt if the file does not exist. Errors: file, machine.
Result<std::optional<std::string>> read_script(const std::string& path);
// Replaces the file on the disk, whole or not at all. Links are followed.
Status write_script(const std::string& path, std::string_view text);

}  // namespace betwixt
