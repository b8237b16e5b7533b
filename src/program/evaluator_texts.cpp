// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts that turn into others, and the parts of formulas.
#include "program/evaluator.h"

namespace betwixt {

// Parts of formulas change with the whole.
void Evaluator::mark_pieces() {
  for (const std::uint32_t i : compiled_.formula_pieces) {
    const auto whole = static_cast<std::uint32_t>(compiled_.drawables[i].whole);
    if (const std::uint8_t what = marks_[whole] & (affects::look | affects::form)) marks_.add(i, what);
  }
}

// Sets the text that the drawable's text turns into. It differs in nothing else from the present shape.
void Evaluator::take_match(std::uint32_t i, Looks& now, Asking& asking) {
  const std::uint32_t own = static_cast<std::uint32_t>(compiled_.shapes.size()) + i;
  if (!compiled_.drawables[i].matches || now.shape != own) return;
  const auto turn = compiled_.text_turn(compiled_.nodes[i].object, now_, asking);
  if (!turn || turn->share == 0) return;
  now.toward = put(2 * looks.size() + i, turned_text(*shape(now.shape), *turn, compiled_.document.scene()));
  now.blend = turn->share;
}

}  // namespace betwixt
