// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Live input: the messages of a control set the values of its dials' targets, or are recorded as events.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/result.h"

namespace betwixt {

// Returns the document after a control has sent `numbers` or, if `text` is not null, a text. The value holds for all
// times and replaces the target's tracks and filters. Either all dials of the address turn or none. Errors: name (no
// dial has this address), type (not as many numbers as the target takes), range (not finite).
Result<Document> turn(const Document&, std::string_view address, std::span<const double> numbers,
                      const std::string* text);

// Records live performances. From a target's first message until the end of the take, only the control sets its value;
// after the take the film is as it was before. The recording has what was seen: a control that rests holds its value.
class Take {
 public:
  explicit Take(Document script) : script_(script), before_(script), document_(std::move(script)) {}

  // Like the function turn(), at the time `now`, which must not be before the previous message (end the take first).
  // `within`: the tolerance of each number, or empty if the numbers are exact. The values are written as short as the
  // tolerance allows.
  Status turn(std::string_view address, std::span<const double> numbers, const std::string* text, Time now,
              std::span<const double> within = {});
  // Ends the take: the film stops at `now`, or jumps to another time. The next message begins another take.
  void end(Time now);

  const Document& document() const { return document_; }
  // Returns the author's text, followed by the recording.
  std::string text(std::string_view script) const;

 private:
  struct Touched {
    Target target;
    Time from, last, held;  // its first message, its last change, its last message
    Value value;            // since the last change
  };
  struct Covered {
    Target target;
    Time from, to;
  };
  void record(Scene&, const Target&, const Value&, Time now);

  Document script_, before_, document_;  // before_: at the start of this take
  std::vector<Touched> touched_;
  std::vector<Covered> covered_;
};

}  // namespace betwixt
