// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A place on the line of some object, as a value: for a position the place, for a rotation the direction there. Between
// two such events on one line the share of its length is interpolated.
#pragma once

#include <fmt/format.h>

#include "track/procedure.h"

namespace betwixt {

class Along : public Routine {
 public:
  ObjectId road;
  double share = 0;  // of the line's length

  Along(ObjectId line, double at) : road(line), share(at) {
    language = "along";
    source = fmt::format("{} {}", road.index, share);  // equal values have equal texts
  }
};

// Returns null if the value is another one.
inline const Along* along(const Value& v) {
  const auto* p = std::get_if<Procedure>(&v);
  return p ? dynamic_cast<const Along*>(p->code.get()) : nullptr;
}
inline Value along(ObjectId road, double share) { return Procedure{std::make_shared<Along>(road, share)}; }

}  // namespace betwixt
