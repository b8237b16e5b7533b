// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A place on a line that some object is, as a value: of a position the place, of a rotation the direction there. Two
// such events of one line are joined along it: their shares of its length blend.
#pragma once

#include <fmt/format.h>

#include "track/procedure.h"

namespace betwixt {

class Along : public Routine {
 public:
  ObjectId road;
  double share = 0;  // of its length

  Along(ObjectId line, double at) : road(line), share(at) {
    language = "along";
    source = fmt::format("{} {}", road.index, share);  // equal ones are equal
  }
};

// Null: the value is something else.
inline const Along* along(const Value& v) {
  const auto* p = std::get_if<Procedure>(&v);
  return p ? dynamic_cast<const Along*>(p->code.get()) : nullptr;
}
inline Value along(ObjectId road, double share) { return Procedure{std::make_shared<Along>(road, share)}; }

}  // namespace betwixt
