// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Bundles: commands that take effect together, all at one moment or none.
#include <fmt/format.h>

#include <algorithm>

#include "base/memory_budget.h"
#include "language/json.h"
#include "server/answers.h"
#include "server/imaging.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

constexpr std::size_t largest_bundle = 16 << 20;  // bytes

}  // namespace

struct Imaging::Together {
  std::optional<Editor::Draft> draft;  // while they are carried out …
  Point point;                         // … and the result
  std::size_t events = 0, values = 0;  // in the document after it
  std::size_t bytes = 0;               // kept for undo
  std::vector<std::string> lines;      // in the form of the history
  std::vector<std::string> warnings;
  std::string errors, told;
  std::optional<Error> first;
  bool stamped = false, starts = false;
  bool full = false;  // a limit was exceeded, so the rest is not carried out

  void note(std::int64_t number, Error e) {
    errors += fmt::format("{}{{\"line\":{},\"error\":{}{}{}}}", errors.empty() ? "" : ",", number,
                          json_words(e.message), e.hint.empty() ? "" : ",\"hint\":" + json_words(e.hint),
                          e.place.column > 0 ? fmt::format(",\"column\":{}", e.place.column) : "");
    e.message = fmt::format("line {}: {}", number, e.message), e.place = {};
    if (!first) first = std::move(e);
  }
};

// Display lists have an `end` of their own: an indented one does not end the bundle.
bool Imaging::ends_bundle(const HostState& h, const SaidLine& said) {
  const bool goes_on = !h.bundle.empty() && h.bundle.back().open;
  return said.alone() && !said.indented && !goes_on && said.verb == "end";
}

Imaging::Reply Imaging::collect(HostState& h, std::string_view line, Nanos now) {
  const bool goes_on = !h.bundle.empty() && h.bundle.back().open;
  const SaidLine said = look_at(line, longest_question);
  const bool lone = said.alone() && !said.indented && !goes_on;
  if (ends_bundle(h, said)) return end_bundle(h, now);
  // Allowed inside a bundle: it changes nothing, and a host may need more numbers here.
  if (lone && said.verb == "names") {
    const auto given = names(h, said.words, now);
    return given ? yes(h, now, *given) : no(h, now, given.error());
  }
  if (lone && said.verb == "bundle" && !h.bundle_broken)
    h.bundle_broken = fail(ErrorCode::syntax, fmt::format("line {}: a bundle is already open", h.line));
  if (!goes_on && !said.indented && said.verb == "send" && !h.bundle_broken)
    h.bundle_broken = fail(ErrorCode::syntax, fmt::format("line {}: bytes cannot be sent in a bundle", h.line),
                           "send them before the bundle");
  h.bundle_size += line.size() + 64;
  if (h.bundle_size > largest_bundle && !h.bundle_broken)
    h.bundle_broken = fail(ErrorCode::range, fmt::format("a bundle can have at most {} bytes", largest_bundle));
  if (h.bundle_broken) {
    h.bundle.clear();
    return {};
  }
  if (!goes_on) {
    h.bundle.push_back({h.line, std::string(line), said.alone(), said.open});
    return {};
  }
  BundleLine& before = h.bundle.back();
  before.text += "\n" + std::string(line);
  const SaidLine whole = look_at(before.text, longest_question);
  before.alone = whole.alone(), before.open = whole.open && before.text.size() <= longest_line;
  return {};
}

// Carries out a bundle's command after the ones before it. Returns an error if it is refused.
std::optional<Error> Imaging::carry_out(const BundleLine& line, Together& all, std::int64_t stamp) const {
  Editor::Draft& draft = *all.draft;
  const std::string_view verb = first_word(line.text);
  const bool row = indented(line.text) && draft.sheet_is_open();
  if (!row && (verb == "quit" || (line.alone && find_word(verb)))) {
    draft.close_sheet();
    return fail(ErrorCode::syntax, fmt::format("a bundle cannot contain '{}'", verb),
                "a bundle can contain only commands of the language");
  }
  if (line_words(line.text).empty()) return {};
  const Objects before = draft.scene().objects;
  CommandResult result;
  try {
    result = draft.carry_out(line.text, draft.scene().ticks.span(static_cast<double>(stamp)));
  } catch (const OverBudget&) {
    all.full = true;
    return too_many_bytes(options_.ceilings.values);
  }
  if (auto error = sort_out(result.said, all.warnings)) {
    if (!row) draft.close_sheet();
    return error;
  }
  const Objects& after = draft.scene().objects;
  const std::size_t events = count_events(before, all.events, after);
  if (const Status fits = within(options_.ceilings, before, all.events, after, events); !fits) {
    all.full = true;
    return fits.error();
  }
  all.stamped = all.stamped || result.stamped;
  all.starts = all.starts || starts_show(verb);
  all.events = events;
  all.lines.push_back(std::move(result.line));
  return {};
}

Imaging::Reply Imaging::end_bundle(HostState& h, Nanos now) {
  auto lines = std::exchange(h.bundle, {});
  const auto broken = std::exchange(h.bundle_broken, {});
  const std::size_t size = std::exchange(h.bundle_size, 0);
  h.bundling = false, h.sheet.reset();
  if (broken) return no(h, now, *broken);
  const std::int64_t at = stamp(now);
  Together all;
  const auto carry = [&](const Point& from, std::size_t events) {
    all = {};
    const MemoryBudget share(making_, options_.ceilings.values, values_);
    all.draft.emplace(editor_, from), all.events = events;
    all.draft->close_sheet();
    for (std::size_t i = 0; i < lines.size() && !all.full; ++i)
      if (auto e = carry_out(lines[i], all, at)) all.note(lines[i].number, *std::move(e));
    all.point = std::move(*all.draft).point();
    all.draft.reset();
    if (const auto values = values_in(all.point.document.scene(), share.made()); values)
      all.values = *values;
    else if (!all.first)
      all.first = values.error();
    if (all.first) all.point = {};  // frees a large copy here, on the worker's thread
    if (!all.first) all.bytes = Editor::bytes_kept(from, all.point);
    if (!all.first) all.told = json_text(fmt::format("{}\n", fmt::join(all.lines, "\n")));
    return !all.first;
  };
  const bool takes_time = lines.size() > 20 || std::any_of(lines.begin(), lines.end(), [&](const BundleLine& l) {
                            return takes_long(h, look_at(l.text, longest_question));
                          });
  const Worked worked = work_out(h, takes_time, carry);
  if (worked == Worked::later) h.bundle = std::move(lines), h.bundle_size = size, h.bundling = true;
  if (worked != Worked::done) {
    discard(std::move(all));
    return not_worked(h, worked, now);
  }
  if (all.first) return no(h, now, *all.first, ",\"errors\":[" + all.errors + "]");
  if (all.lines.empty()) return yes(h, now, "");
  const std::size_t done = all.lines.size();
  all.point.counts = {all.events, all.values};
  if (Status s = editor_.take(std::move(all.point), {std::move(all.lines), ""}, all.bytes); !s)
    return no(h, now, s.error());
  commands_ += done;
  event_count_ = all.events, values_ = all.values;
  if (all.starts) start_clock(now);
  changed(h.host, all.told, now);
  return yes(h, now, warned(all.warnings), all.stamped ? std::optional(at) : std::nullopt);
}

}  // namespace betwixt
