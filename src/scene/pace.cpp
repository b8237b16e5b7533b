// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/pace.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <string>

namespace betwixt {
namespace {

std::string ticks(std::int64_t n) { return std::to_string(n) + (n == 1 ? " tick" : " ticks"); }

Status check(const Timing& t) {
  if (t.interval < 1) return fail(ErrorCode::range, "an interval must be at least 1 tick, not " + ticks(t.interval));
  if (t.change == 0) return Nothing{};
  if (t.period < 1)
    return fail(ErrorCode::range, "an interval must change every 1 tick or more, not every " + ticks(t.period));
  if (t.ceiling < 1) return fail(ErrorCode::range, "a limit must be at least 1 tick, not " + ticks(t.ceiling));
  for (std::int64_t n : {t.interval, t.change, t.period, t.ceiling})
    if (n > Pace::largest || n < -Pace::largest)
      return fail(ErrorCode::range,
                  "an interval that changes can have at most " + ticks(Pace::largest) + ", not " + ticks(n));
  return Nothing{};
}

std::int64_t up(std::int64_t a, std::int64_t b) { return (a + b - 1) / b; }

// Evaluates D(u). The number of changes is compared before it is multiplied, so nothing overflows.
Pace::Row running(const Timing& t, std::int64_t update, std::int64_t count) {
  const std::int64_t changes = update / t.period;
  if (t.change > 0) {
    const bool ended = t.interval >= t.ceiling || changes >= up(t.ceiling - t.interval, t.change);
    return {update, count, ended ? std::max(t.interval, t.ceiling) : t.interval + t.change * changes, ended};
  }
  const bool terminal = changes >= up(t.interval - 1, -t.change);
  return {update, count, terminal ? 1 : t.interval + t.change * changes, false};
}

}  // namespace

Result<Pace> Pace::make(const Timing& t, std::optional<std::int64_t> first) {
  if (const Status good = check(t); !good) return good.error();
  assert((!first || *first >= 1) && "an update would come before its Animate");
  Pace p;
  p.shown_ = t.interval;
  p.only_.interval = t.interval;
  const bool slowed = t.change > 0, passive = slowed && t.interval >= t.ceiling;
  if (passive) {
    p.only_.ended = true;
    return p;
  }
  if (t.change == 0 && (!first || *first == t.interval)) return p;

  std::vector<Row> rows;
  Row row{0, 0, t.interval, false};
  if (first) {
    rows.push_back({0, 0, *first, false});
    row = t.change == 0 ? Row{*first, 1, t.interval, false} : running(t, *first, 1);
  }
  while (true) {
    if (rows.size() == most_rows)
      return fail(ErrorCode::range, "this interval changes more than " + std::to_string(most_rows) + " times",
                  "make each change larger");
    rows.push_back(row);
    if (row.ended || t.change == 0 || (t.change < 0 && row.interval == 1)) break;
    // The updates until the next change: those that begin before it, and the one at it or after it.
    const std::int64_t change = (row.begin / t.period + 1) * t.period, steps = up(change - row.begin, row.interval);
    row = running(t, row.begin + steps * row.interval, row.count + steps);
  }
  p.rows_ = std::make_shared<const std::vector<Row>>(std::move(rows));
  return p;
}

Pace::Row Pace::row(std::int64_t elapsed) const {
  assert(elapsed >= 0 && "a pace is asked about what was before it");
  if (!rows_) return only_;
  const auto after =
      std::upper_bound(rows_->begin(), rows_->end(), elapsed, [](std::int64_t t, const Row& r) { return t < r.begin; });
  return *std::prev(after);
}

std::int64_t Pace::count(std::int64_t elapsed) const {
  const Row r = row(elapsed);
  return r.ended ? r.count : r.count + (elapsed - r.begin) / r.interval;
}

std::optional<std::int64_t> Pace::due(std::int64_t elapsed) const {
  const Row r = row(elapsed);
  if (r.ended) return std::nullopt;
  const std::int64_t last = elapsed - (elapsed - r.begin) % r.interval;
  if (last > std::numeric_limits<std::int64_t>::max() - r.interval) return std::nullopt;
  return last + r.interval;
}

std::int64_t Pace::interval(std::int64_t elapsed) const {
  const Row r = row(elapsed);
  return r.count == 0 ? shown_ : r.interval;
}

}  // namespace betwixt
