// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Messages of the Language Server Protocol in a stream of bytes: "Content-Length: N", an empty line, N bytes. Whatever
// else comes is passed over, up to the next such line. No JSON holds one, as a text in JSON has no raw end of line: so
// a length that is wrong costs one message,
// or two where it ends in the next one's head.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace betwixt {

class LspFrames {
 public:
  static constexpr std::size_t longest = std::size_t{256} << 20;  // a message that is longer is passed over

  void take(std::string_view bytes) { bytes_ += bytes; }
  // The next message that is whole. `refused`, where one was passed over: why.
  std::optional<std::string> next(std::string* refused = nullptr);

  static std::string framed(std::string_view message);

 private:
  std::string bytes_;
  std::size_t begun_ = 0;    // what is before that has been given out
  std::size_t scanned_ = 0;  // there is no head between the one at `begun_` and this place
  bool lost_ = false;        // what comes is passed over

  bool find_head();
};

}  // namespace betwixt
