// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/axes.h"

#include <fmt/format.h>

#include <algorithm>

#include "betwixt/language.h"
#include "betwixt/track.h"
#include "editor/text_rows.h"
#include "language/values.h"
#include "scene/document.h"
#include "studio/panels/value_parts.h"
#include "track/types.h"

namespace betwixt::studio {

bool can_separate(const Document& d, const Target& t) {
  if (t.component >= 0 || !t.object) return false;
  const Type type = spec_of(d.scene(), t.function).type;
  if (type != Type::pair && type != Type::vector && type != Type::rotation && type != Type::color) return false;
  const auto track = betwixt::track(d, t);
  if (!track || track->event_count == 0) return false;
  // Turns have no angles, code makes whole values, and light is not blended by component.
  bool all = type != Type::color;
  each_event(d, t, track->first, track->last, [&](const EventView& e) {
    all = all && (e.what != EventView::What::value || std::holds_alternative<Vec3>(*e.value) ||
                  std::holds_alternative<Angles>(*e.value));
  });
  return all;
}

namespace {
Target axis_of(Target t, int component) {
  t.component = component;
  return t;
}

// Returns the film with the track separated.
Document separated(const Document& d, const Target& t) {
  auto scene = std::make_shared<Scene>(d.scene());
  (void)edit_track(*scene, axis_of(t, 0));  // this separates it
  return Document(std::move(scene));
}

}  // namespace

Lines separate_in_sheets(const Document& d, const std::string& text, const Target& t) {
  if (!can_separate(d, t)) return {};
  const auto track = *betwixt::track(d, t);
  const int count = spec_of(d.scene(), t.function).type == Type::pair ? 2 : 3;
  const TextRows found = rows_about(text, d, std::span(&t, 1));
  std::vector<const SheetText*> sheets;
  for (const SheetText& s : found.sheets)
    if (std::ranges::find(s.targets, t) != s.targets.end()) sheets.push_back(&s);
  const Document apart = separated(d, t);
  if (sheets.size() != 1 || sheets[0]->targets.size() != 1 || sheets[0]->alone ||
      sheets[0]->rows.size() != track.event_count)
    return {};
  const SheetText& sheet = *sheets[0];
  // The remarks behind the rows go with the first component.
  const auto remark = [&](const RowText& row) {
    const std::size_t end = row.rest.end(), feed = text.find('\n', end);
    const std::size_t last = std::min(feed, row.line.end());
    return text.substr(end, last - end);
  };
  std::string all;
  for (int i = 0; i < count; ++i) {
    std::string rows = write_rows(apart, axis_of(t, i));
    if (i == 0) {
      std::string with;
      std::size_t k = 0;
      for (const std::size_t at : line_starts(rows)) {
        std::string line(line_at(rows, at));
        if (k < sheet.rows.size()) line.insert(line.size() - 1, remark(sheet.rows[k++]));
        with += line;
      }
      rows = std::move(with);
    }
    all += fmt::format("{}{}\n{}", layer_words(d, t), d.name(axis_of(t, i)), rows);
  }
  return {rewriting_line(text, {sheet.opener.at, sheet.rows.back().line.end() - sheet.opener.at}, all)};
}

Lines separate_by_event(const Document& d, const Target& t) {
  if (!can_separate(d, t)) return {};
  const auto track = *betwixt::track(d, t);
  // Any event of a component separates the track.
  Lines lines;
  each_event(d, t, track.first, track.last, [&](const EventView& e) {
    if (lines.empty() && e.what == EventView::What::value)
      lines.push_back(fmt::format("{}at {} {} {}", layer_words(d, t), format_time(e.time, d), d.name(axis_of(t, 0)),
                                  write_event(separated(d, t), axis_of(t, 0), e.time)));
  });
  return lines;
}

}  // namespace betwixt::studio
