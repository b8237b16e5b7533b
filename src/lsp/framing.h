// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Messages of the Language Server Protocol in a byte stream: "Content-Length: N", an empty line, N bytes. The reader
// skips other bytes up to the next such line. JSON texts contain no raw line ends, so no message contains such a line.
// A wrong length therefore costs one message, or two if it ends in the next one's head.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace betwixt {

class LspFrames {
 public:
  static constexpr std::size_t longest = std::size_t{256} << 20;  // bytes of a message; longer ones are skipped

  void take(std::string_view bytes) { bytes_ += bytes; }
  // Returns the next whole message, or nullopt if none has arrived. If one was skipped, `refused` gets the reason.
  std::optional<std::string> next(std::string* refused = nullptr);

  static std::string framed(std::string_view message);

 private:
  std::string bytes_;
  std::size_t begun_ = 0;    // bytes before this have been returned
  std::size_t scanned_ = 0;  // there is no head between the one at `begun_` and this place
  bool lost_ = false;        // skips bytes up to the next head

  bool find_head();
};

}  // namespace betwixt
