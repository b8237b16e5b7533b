// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Carries out commands of the language for hosts.
#include <fmt/format.h>

#include "base/memory_budget.h"
#include "base/names.h"
#include "commands/reader.h"
#include "commands/verbs.h"
#include "language/json.h"
#include "scene/memory.h"
#include "server/answers.h"
#include "server/imaging.h"

namespace betwixt {

Result<Imaging::CommandOutcome> Imaging::carry_out(const Point& from, std::size_t events, std::string_view line,
                                                   std::int64_t stamp) const {
  const Scene& was = from.document.scene();
  CommandOutcome c;
  try {
    c.result = editor_.carry_out(from, line, was.ticks.span(static_cast<double>(stamp)));
  } catch (const OverBudget& limit) {
    return too_many_bytes(limit.most);
  }
  if (auto error = sort_out(c.result.said, c.warnings)) return *std::move(error);
  const Scene& is = c.result.after.document.scene();
  c.events = count_events(was.objects, events, is.objects);
  c.bytes = Editor::bytes_kept(from, c.result.after);
  c.kept = !c.result.opens || !is.lists.same(was.lists) || !is.later_lists.same(was.later_lists);
  if (const Status fits = within(options_.ceilings, was.objects, events, is.objects, c.events); !fits)
    return fits.error();
  return c;
}

std::optional<Error> Imaging::sort_out(const Diagnostics& all, std::vector<std::string>& warnings) const {
  for (const Diagnostic& d : all) {
    Error e = d.what;
    if (!e.place.file.empty() && e.place.line > 0)
      e.message = fmt::format("{}:{}:{}: {}", e.place.file, e.place.line, e.place.column, e.message);
    if (!e.place.file.empty() || e.place.line < 1) e.place = {};
    if (d.severity == Severity::error) {
      if (e.needs == Permission::read_anywhere)
        e.hint = options_.load.read_nothing ? "this server has no script, so it reads no files"
                                            : "hosts can read only files below the script's folder";
      if (e.needs == Permission::tex) e.hint = "LaTeX typesets only the formulas of the server's script";
      return e;
    }
    warnings.push_back(fmt::format("{}: {}", d.severity == Severity::warning ? "warning" : "notice", e.message));
  }
  return std::nullopt;
}

// Counts all values ever made, also those since removed. If the sum exceeds the limit, measures the document.
Result<std::size_t> Imaging::values_in(const Scene& after, std::size_t made) const {
  const std::size_t before = values_, most = options_.ceilings.values;
  if (made == 0 || before + made <= most) return before + made;
  const std::size_t now = bytes_of_values(after);
  if (now <= most || now <= before) return now;
  Error e = too_many_bytes(most);
  e.place.column = 1;  // of the whole command
  return e;
}

bool Imaging::starts_show(std::string_view verb) {
  const Verb* known = find_verb(verb);
  return known && known->flags & Verb::starts_show;
}

Imaging::Reply Imaging::command(HostState& h, const SaidLine& line, Nanos now) {
  if (line.words.empty()) return yes(h, now, "");
  const std::int64_t at = stamp(now);
  Result<CommandOutcome> c = Error{};
  const auto carry = [&](Point from, std::size_t events) {
    from.script.left = h.sheet;
    const MemoryBudget share(making_, options_.ceilings.values, values_);
    c = carry_out(from, events, line.text, at);
    if (!c) return false;
    const auto values = values_in(c->result.after.document.scene(), share.made());
    if (values)
      c->values = *values;
    else
      c = values.error();
    return bool(c);
  };
  if (const Worked worked = work_out(h, takes_long(h, line), carry); worked != Worked::done) {
    discard(std::move(c));
    return not_worked(h, worked, now);
  }
  if (!c) {
    Error e = c.error();
    if (!line.indented) h.sheet.reset();
    if (unknown_command(e, line.text)) {
      std::vector<std::string_view> known;
      for (const Word& w : words()) known.push_back(w.word);
      set_hint(e, did_you_mean(line.verb, known));
    }
    return no(h, now, e);
  }
  CommandResult& result = c->result;
  result.after.counts = {c->events, c->values};
  h.sheet = result.after.script.left;
  if (!c->kept) return yes(h, now, warned(c->warnings));
  if (Status s = editor_.take(std::move(result.after), {{result.line}, result.sheet}, c->bytes); !s)
    return no(h, now, s.error());
  ++commands_;
  event_count_ = c->events, values_ = c->values;
  if (starts_show(line.verb)) start_clock(now);
  changed(h.host, json_text(result.line), now);
  return yes(h, now, warned(c->warnings), result.stamped ? std::optional(at) : std::nullopt);
}

}  // namespace betwixt
