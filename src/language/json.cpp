// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/json.h"

#include "language/values.h"

namespace betwixt {
namespace {

std::string list(const std::vector<double>& numbers) {
  std::string out = "[";
  for (double n : numbers) out += (out.size() > 1 ? "," : "") + json_number(n);
  return out + "]";
}

}  // namespace

std::string json(const Value& r, const Target& target, const Document& d) {
  if (const auto* n = std::get_if<double>(&r)) return json_number(*n);
  if (const auto* b = std::get_if<bool>(&r)) return *b ? "true" : "false";
  if (const auto* id = std::get_if<ObjectId>(&r)) return *id ? json_text(d.name(*id)) : "null";
  if (const auto* t = std::get_if<Text>(&r)) return json_text(**t);
  if (const auto* points = std::get_if<Points>(&r)) {
    std::string out = "[";
    for (Vec3 p : **points) out += (out.size() > 1 ? "," : "") + list({p.x, p.y, p.z});
    return out + "]";
  }
  if (const auto* a = std::get_if<Attachment>(&r))
    return json_text(write_value(*a, spec_of(d.scene(), fn::attachment), -1, [&](ObjectId id) { return d.name(id); }));
  if (const auto* m = std::get_if<Moves>(&r)) return json_text(to_string(**m));
  if (const auto* names = std::get_if<Names>(&r)) {
    std::string out = "[";
    for (const auto& n : **names) out += (out.size() > 1 ? "," : "") + json_text(n);
    return out + "]";
  }
  auto n = numbers(r);
  const bool whole = !target.query() && target.component < 0;
  if (whole && n.size() == 3)
    n.resize(static_cast<std::size_t>(std::min(3, row_of(spec_of(d.scene(), target.function).type).channels)));
  return list(n);
}

}  // namespace betwixt
