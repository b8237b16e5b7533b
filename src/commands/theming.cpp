// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Themes: one word chooses the background, and the colors of what has none of its own.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "commands/command.h"
#include "language/values.h"
#include "scene/axes_functions.h"
#include "scene/flat_functions.h"
#include "scene/formula_parts.h"
#include "scene/kinds.h"
#include "scene/materials.h"
#include "scene/theme.h"

namespace betwixt {
namespace {

// Gives the colors of the theme their names, except names that the author uses. Colors of the theme before change.
void name_colors(Scene& s, const Theme& before, const Theme& now) {
  for (const ThemeColor& c : theme_colors()) {
    const auto known = s.lets->find(c.name);
    const bool ours = known != s.lets->end() && known->second == Let(c.of(before));
    if (known == s.lets->end() || (ours && !before.name.empty()))
      s.lets.edit().insert_or_assign(std::string(c.name), Let(c.of(now)));
  }
}

bool say_theme(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view word = c.next_word();
  const Theme before = *s.appearance.theme;
  if (word == "none") return finish(c) && (s.appearance.theme = Theme(), true);
  if (const Theme* named = find_theme(word)) {
    if (!finish(c)) return false;
    s.appearance.theme = *named;
    s.background = named->paper, s.appearance.below.reset(), s.appearance.clear = false;
    name_colors(s, before, *named);
    return true;
  }
  const auto colors = theme_colors();
  const auto one = std::find_if(colors.begin(), colors.end(), [&](const ThemeColor& t) { return t.name == word; });
  if (one == colors.end()) {
    std::vector<std::string_view> known{"dark", "light", "paper", "none"};
    for (const ThemeColor& t : colors) known.push_back(t.name);
    return no_choice(c, word,
                     "a theme is dark, light, paper or none; or write the name of one of its colors and a color",
                     did_you_mean(word, known));
  }
  Theme now = theme_of(s);
  if (!values(k).color(one->of(now)) || !finish(c)) return false;
  s.appearance.theme = now;
  if (one->one == &Theme::paper) s.background = now.paper;
  name_colors(s, before, now);
  return true;
}

constexpr Verb theming_rows[] = {
    {"theme", "theme dark|light|paper|none or theme NAME COLOR",
     "Sets the background, and the colors of things that have none of their own. The colors have names for the lines "
     "below: ink, muted, accent, and the palette lake, amber, leaf, rose, grape, lagoon, blush, moss, clay, iris, "
     "straw, "
     "jade. `theme NAME COLOR` changes one of them.",
     "theme paper\ntheme lake #205080\ncreate a circle color=leaf", Verb::once, say_theme,
     "dark light paper none ink muted accent; COLOR"},
};

// Returns the name without the number at its end: b for b12.
std::string_view stem_of(std::string_view name) {
  while (!name.empty() && name.back() >= '0' && name.back() <= '9') name.remove_suffix(1);
  return name;
}

// The kinds that have the color of ink. Others that have a surface have a color of the palette.
constexpr KindBits inked_kinds = letter_kinds | line_kinds | bits_of({Kind::arrow, Kind::brace});

bool is_solid(Kind kind) {
  const Fill fill = row_of(kind).fill;
  return fill != Fill::nothing && fill != Fill::file && !(inked_kinds & bit(kind)) && kind != Kind::plane;
}

}  // namespace

namespace {

// Returns whether its material has a colour of its own.
bool is_of_a_color(const Object& o) {
  const Slot* const slot = o.find(fn::material);
  const auto* word = slot && slot->set ? std::get_if<Text>(&*slot->set) : nullptr;
  return word && !material_row(**word).plain;
}

}  // namespace

void give_theme_color(Command& k, Object& o) {
  const Theme& theme = theme_of(k.scene);
  const bool own_colors = (furnished_kinds & bit(o.kind)) != 0;  // a plot takes one of the palette
  if (k.scene.appearance.theme->name.empty() || !drawable(o.kind) || own_colors || o.find(fn::color) ||
      o.find(fn::texture) || is_of_a_color(o))
    return;
  if (inked_kinds & bit(o.kind)) {
    if (!shown_part(o)) o.slot(fn::color).set = theme.ink;
    return;
  }
  if (!is_solid(o.kind)) return;
  // Things with one name and several numbers have one color.
  auto& stems = k.script.stems;
  if (stems.empty())
    for (std::uint32_t i = 0; i < k.scene.objects.size(); ++i)
      if (const Object& other = k.scene.objects[i]; is_solid(other.kind))
        stems.emplace(stem_of(other.name), stems.size());
  const auto [at, fresh] = stems.emplace(stem_of(o.name), stems.size());
  o.slot(fn::color).set = theme.palette[at->second % theme.palette.size()];
}

std::span<const Verb> theming_verbs() { return theming_rows; }

}  // namespace betwixt
