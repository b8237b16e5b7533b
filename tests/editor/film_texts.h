// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Films of one or several texts, with the names in them, and random films that refer to objects in many ways.
#pragma once

#include <fmt/format.h>

#include <random>
#include <string>
#include <vector>

#include "betwixt/language.h"
#include "editor/renaming.h"

namespace betwixt {

// The texts of a film. The first text is film.bx, and uses the others by their names: "0.bx", "1.bx" …
class FilmTexts {
 public:
  explicit FilmTexts(std::vector<std::string> texts) {
    for (std::size_t i = 0; i < texts.size(); ++i)
      texts_.push_back({i == 0 ? "film.bx" : fmt::format("{}.bx", i - 1), ScriptText(texts[i])});
    film_ = load(texts);
  }

  static Loaded load(const std::vector<std::string>& texts) {
    LoadOptions how;
    how.written = [&](const std::string& path) -> std::optional<std::string> {
      for (std::size_t i = 1; i < texts.size(); ++i)
        if (path.ends_with(fmt::format("/{}.bx", i - 1))) return texts[i];
      return std::nullopt;
    };
    return load_text(texts[0], "film.bx", how);
  }

  const Loaded& film() const { return film_; }
  const std::vector<FilmText>& texts() const { return texts_; }
  TextNames names() const { return TextNames(texts_, film_.document); }
  std::string part(const TextSpan& s) const { return texts_[s.text].lines.text().substr(s.span.at, s.span.size); }
  // Returns the first position of some words in a text, plus `behind` characters.
  std::size_t place(std::string_view words, std::size_t text = 0, std::size_t behind = 0) const {
    return texts_[text].lines.text().find(words) + behind;
  }
  // Renames the name at a position. Returns the new texts, or the error as the only text.
  std::vector<std::string> renamed(std::size_t text, std::size_t place, const std::string& to) const {
    const TextNames all = names();
    const auto name = to_rename(all, text, place);
    if (!name) return {name.error().message};
    const auto places = renaming(texts_, all, film_, *name, to, load);
    if (!places) return {places.error().message};
    std::vector<std::string> out;
    for (std::size_t t = 0; t < texts_.size(); ++t) {
      std::vector<Span> here;
      for (const TextSpan& p : *places)
        if (p.text == t) here.push_back(p.span);
      out.push_back(with_others(texts_[t].lines.text(), here, to));
    }
    return out;
  }

 private:
  std::vector<FilmText> texts_;
  Loaded film_;
};

// Returns a random film without errors, of objects with names of every kind.
inline std::string film_by_chance(std::mt19937& random) {
  const auto up_to = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const std::vector<std::string> things = {"ball", "ball2", "ball-2", "a", "man", "man/arm", "man/arm/hand", "gear_x"};
  std::string text = "rate 24\nlet beat = 6f\nlet size = 2\ndefine heat number 20\n";
  text += "procedure wobbly twerper lua \"u*u\"\n";
  for (const std::string& t : things) text += fmt::format("create {} sphere radius={}\n", t, 1 + up_to(4));
  text += "layer sway add\nalias toys = ball a\n";
  const auto thing = [&] { return things[static_cast<std::size_t>(up_to(static_cast<int>(things.size())))]; };
  for (int n = 0; n < 12; ++n) {
    const std::string one = thing(), other = thing();
    switch (up_to(11)) {
      case 0:
        text += fmt::format("{}.position  # of {}\n  1f (0 {} 0)\n\n  beat*3  (1 2 3) wobbly  # a\n", one, other, n);
        break;
      case 1:
        text += fmt::format("set {}.radius size*{}\n", one, n + 1);
        break;
      case 2:
        text += fmt::format("at 12f {}.heat {} cut {}\n", one, n, n + 1);
        break;
      case 3:
        text += fmt::format("set {}.color #{:03x}\n", one, up_to(4096));
        break;
      case 4:
        if (one != other) text += fmt::format("set {}.look-at {}\n", one, other);
        break;
      case 5:
        text += fmt::format("set {}.radius = \"size + value('{}.heat')/100\"\n", one, one);
        break;
      case 6:
        text += fmt::format("on sway {}.position\n  2f (0 0 {})\n", one, n);
        break;
      case 7:
        text += fmt::format("set {{{},{}}}.heat {}\n", one, other, n);
        break;
      case 8:
        text += fmt::format("{}.motion\n  1f..24f T(1 0) R(1turn @ {})\n", one, one);
        break;
      case 9:
        text += fmt::format("set toys.heat {}\n# {} and {}\n", n, one, other);
        break;
      default:
        text += fmt::format("at {}f note \"{} and \\\"{}\\\"\"\n", n, one, other);
    }
  }
  return text;
}

}  // namespace betwixt
