// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motions as lists of CSS transforms.
#include "betwixt/css.h"

#include <fmt/format.h>

#include "algebra/text.h"

namespace betwixt {
namespace {

using algebra::angle_text, algebra::written;
using Kind = Factor::Kind;
using Law = Factor::Law;

Error about(std::size_t i, std::string what, std::string hint) {
  return fail(ErrorCode::type, fmt::format("factor {}: {}", i + 1, what), std::move(hint));
}

// CSS can express positions as centres and the linear law only.
Status has_css(const Motion& motion) {
  if (auto sound = check(motion); !sound) return sound;
  for (std::size_t i = 0; i < motion.factors.size(); ++i) {
    const Factor& f = motion.factors[i];
    if (!f.about.empty())
      return about(i, fmt::format("its centre is the object '{}', but CSS has no objects", f.about),
                   "write the centre as numbers");
    if (f.kind == Kind::scale && f.law == Law::exponential && f.by != Vec3{1, 1, 1})
      return about(i, "it scales by the exponential law, but CSS scales by the linear law", "write S(… linear)");
  }
  return Nothing{};
}

std::string list(Vec3 v, int count, std::string_view unit) {
  std::string s;
  for (int i = 0; i < count; ++i) s += (i > 0 ? ", " : "") + written(v[i]) + std::string(unit);
  return s;
}

std::string translate_text(Vec3 way, bool in_space) {
  return fmt::format("translate{}({})", in_space ? "3d" : "", list(way, in_space ? 3 : 2, "px"));
}

// Returns the text of the factor, or, if not `all`, of the function of the same name that does nothing.
std::string css_text(const Factor& f, bool all) {
  if (f.kind == Kind::translate) return translate_text(all ? f.by : Vec3{}, f.by.z != 0);
  if (f.kind == Kind::scale) {
    const int count = f.by.z == 1 ? 2 : 3;
    return fmt::format("scale{}({})", count == 3 ? "3d" : "", list(all ? f.by : Vec3{1, 1, 1}, count, ""));
  }
  const std::string angle = all ? angle_text({f.angle, f.angle_rest}) : "0deg";
  return f.axis == Vec3{0, 0, 1} ? fmt::format("rotate({})", angle)
                                 : fmt::format("rotate3d({}, {})", list(f.axis, 3, ""), angle);
}

void append(std::string& css, const std::string& function) { css += (css.empty() ? "" : " ") + function; }

}  // namespace

Result<CssLists> to_css(const Motion& motion) {
  if (auto possible = has_css(motion); !possible) return possible.error();
  CssLists lists;
  Vec3 here;  // the current centre of the list; a translation does not depend on it
  const auto go = [&](Vec3 centre) {
    for (const Vec3 way : {-here, centre})
      for (std::string* css : {&lists.from, &lists.to})
        if (way != Vec3{}) append(*css, translate_text(way, way.z != 0));
    here = centre;
  };
  for (const Factor& f : motion.factors) {
    if (f.kind != Kind::translate && f.centre != here) go(f.centre);
    append(lists.from, css_text(f, false));
    append(lists.to, css_text(f, true));
  }
  go({});
  if (lists.to.empty()) lists.from = lists.to = "none";
  return lists;
}

}  // namespace betwixt
