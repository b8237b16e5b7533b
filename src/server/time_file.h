// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The time of a history, in a file beside it, so that the next server continues from there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/files.h"
#include "betwixt/time.h"
#include "editor/journal.h"

namespace betwixt {

// A time, and whether the clock runs.
struct KeptTime {
  bool running = false;
  Time at;
  friend bool operator==(const KeptTime&, const KeptTime&) = default;
};

class TimeFile {
 public:
  // Opens the file beside a script. Errors: machine.
  static Result<TimeFile> open(const std::string& script);

  // Returns what an earlier server left, or nullopt if no half is valid.
  const std::optional<KeptTime>& found() const { return found_; }
  // Returns true if that server ended with this text, or with the beginning of it.
  bool is_of(std::string_view text) const;
  std::size_t text_size() const { return of_.size; }

  // Writes to the disk before it returns. If it fails, the earlier content remains. `of`: the content of the script.
  Status write(const KeptTime&, const Fingerprint& of);

 private:
  TimeFile(std::string path, int file) : path_(std::move(path)), file_(file) {}
  void read();

  std::string path_;
  OpenFile file_;
  std::uint64_t number_ = 0;  // number of the last write
  std::optional<KeptTime> found_;
  Fingerprint of_;
};

}  // namespace betwixt
