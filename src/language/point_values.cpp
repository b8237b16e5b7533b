// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads lists of points, and lists of such lists.
#include "base/cancellation.h"
#include "base/memory_budget.h"
#include "language/values.h"

namespace betwixt {
namespace {

// Reads the elements in brackets, one after the other.
template <class Read>
bool list_of(Cursor& c, const Read& read_one) {
  if (!c.open()) return false;
  for (;;) {
    c.space();
    if (c.peek() == ')' || c.at == c.end) return c.close();
    if (!read_one()) return false;
  }
}

}  // namespace

bool ValueReader::point(Vec3& out) {
  c.space();
  const char* start = c.at;
  if (c.peek() != '(')
    return c.fail_here(ErrorCode::syntax, "expected a point (x y) or (x y z) here",
                       "points look like ((0 0) (1 0) (1 1))");
  Vec3 p;
  if (!c.open() || !c.number(p.x) || !c.number(p.y)) return false;
  c.space();
  if (c.peek() != ')' && !c.number(p.z)) return false;
  c.space();
  if (c.at < c.end && c.peek() != ')')
    return c.fail(ErrorCode::syntax, "a point must have two or three numbers", c.since(start));
  if (!c.close()) return false;
  out = p;
  return true;
}

bool ValueReader::points(Points& out) {
  std::vector<Vec3> list;
  if (!list_of(c, [&] {
        Vec3 p;
        Cancellation::check(), MemoryBudget::charge(sizeof p);
        return point(p) && (list.push_back(p), true);
      }))
    return false;
  out = Points(std::move(list));
  return true;
}

bool ValueReader::holes(Points& out) {
  Cursor ahead = c;
  const auto opens = [&ahead] { return ahead.accept('(') && (ahead.space(), true); };
  if (!opens() || !opens() || !opens()) return points(out);
  std::vector<Vec3> list;
  if (!list_of(c, [&] {
        Points ring;
        if (!points(ring)) return false;
        list.insert(list.end(), ring->begin(), ring->end());
        if (ring->size() > 1 && ring->front() != ring->back()) list.push_back(ring->front());
        return true;
      }))
    return false;
  out = Points(std::move(list));
  return true;
}

}  // namespace betwixt
