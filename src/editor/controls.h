// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Live input: what a control says becomes the value of what its dials turn, or is recorded as events. (G57)
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/result.h"

namespace betwixt {

// The document after a control has said `numbers` or, where there is one, `text`: the value holds for all times, and
// what the target had of tracks and filters gives way. All dials of the address turn or none.
// Errors: name (no dial has this address), type (not as many numbers as the target takes), range (not finite).
Result<Document> turn(const Document&, std::string_view address, std::span<const double> numbers,
                      const std::string* text);

// Performances that are recorded. From a target's first message on, only the control says what it is, until the take
// ends; behind that the film is as it was. What is recorded is what was seen: a control that stands still holds.
class Take {
 public:
  explicit Take(Document script) : script_(script), before_(script), document_(std::move(script)) {}

  // As turn(), at `now`, which is not before the message before it (else the take has to end first). `within`: by how
  // much each number may be off and still be what the control said; nothing: exact. It is written as short as that
  // allows.
  Status turn(std::string_view address, std::span<const double> numbers, const std::string* text, Time now,
              std::span<const double> within = {});
  // The film stops at `now`, or goes on from elsewhere; the next message begins another take.
  void end(Time now);

  const Document& document() const { return document_; }
  // The author's text with what was recorded behind it.
  std::string text(std::string_view script) const;

 private:
  struct Touched {
    Target target;
    Time from, last, held;  // its first message, its last change, its last message
    Value value;            // since then
  };
  struct Covered {
    Target target;
    Time from, to;
  };
  void record(Scene&, const Target&, const Value&, Time now);

  Document script_, before_, document_;  // before_: when this take began
  std::vector<Touched> touched_;
  std::vector<Covered> covered_;
};

}  // namespace betwixt
