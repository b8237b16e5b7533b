// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What time it is in a history, on the disk beside it, so that another server goes on from there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/files.h"
#include "betwixt/time.h"
#include "editor/journal.h"

namespace betwixt {

// A time that goes on or stands.
struct KeptTime {
  bool running = false;
  Time at;
  friend bool operator==(const KeptTime&, const KeptTime&) = default;
};

class TimeFile {
 public:
  // The file beside a script. Errors: machine.
  static Result<TimeFile> open(const std::string& script);

  // What an earlier server left; none: nothing that is whole.
  const std::optional<KeptTime>& found() const { return found_; }
  // … as it ended with this text, or with one that it begins with.
  bool is_of(std::string_view text) const;
  std::size_t text_size() const { return of_.size; }

  // It is on the disk when this returns, or what was there before still is. `of`: what the script holds.
  Status write(const KeptTime&, const Fingerprint& of);

 private:
  TimeFile(std::string path, int file) : path_(std::move(path)), file_(file) {}
  void read();

  std::string path_;
  OpenFile file_;
  std::uint64_t number_ = 0;  // of the one that was written last
  std::optional<KeptTime> found_;
  Fingerprint of_;
};

}  // namespace betwixt
