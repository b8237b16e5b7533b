// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/part.h"

namespace betwixt {

std::string usage_of(const std::string& name, const Part& part) {
  std::string out = name;
  for (const PartParameter& p : part.parameters) out += " " + p.name + "=" + p.said;
  return out;
}

}  // namespace betwixt
