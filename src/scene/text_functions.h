// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Functions of letters, besides text, font and size; the rows come after those of flat shapes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/code_languages.h"
#include "scene/document.h"
#include "scene/flat_functions.h"
#include "scene/functions.h"
#include "scene/graph_layout.h"

namespace betwixt {

// In the order of their enumerations.
inline constexpr std::array<std::string_view, 3> align_names{"left", "centre", "right"};
inline constexpr std::array<std::string_view, 4> anchor_names{"baseline", "top", "middle", "bottom"};
inline constexpr std::array<std::string_view, 9> weight_names{
    "thin", "extralight", "light", "regular", "medium", "semibold", "bold", "extrabold", "black"};

// Returns the index of a text among the words, or `otherwise` if code has made it none of them.
template <class Word, std::size_t n>
Word word_in(const std::array<std::string_view, n>& words, const Value& v, Word otherwise) {
  const auto* text = std::get_if<Text>(&v);
  const auto at = text ? std::find(words.begin(), words.end(), **text) : words.end();
  return at == words.end() ? otherwise : static_cast<Word>(at - words.begin());
}
inline Weight weight_of(const Value& v) { return word_in(weight_names, v, Weight::regular); }
inline bool is_italic(const Value& v) { return std::get_if<Text>(&v) && *std::get<Text>(v) == "italic"; }

inline const FunctionSpec text_functions[] = {
    {.name = "align",
     .type = Type::text,
     .rest = Text(std::string("centre")),
     .kinds = letter_kinds,
     .words = "left|centre|right",
     .shape = [](Shape& s, const Value& v, const Scene&) { s.letters.align = word_in(align_names, v, Align::centre); },
     .sentence = "Whether the lines of a text begin at x = 0, end there or have their middles there.",
     .written = "\"left\", \"centre\" or \"right\"",
     .example = "create title text\nset title.align left"},
    {.name = "weight",
     .type = Type::text,
     .rest = Text(std::string("regular")),
     .kinds = letter_kinds,
     .words = "thin|extralight|light|regular|medium|semibold|bold|extrabold|black",
     .shape = [](Shape& s, const Value& v, const Scene&) { s.letters.weight = weight_of(v); },
     .sentence = "How heavy the letters of a text are.",
     .written = "\"thin\", \"extralight\", \"light\", \"regular\", \"medium\", \"semibold\", \"bold\", \"extrabold\" "
                "or \"black\"",
     .example = "create title text\nset title.weight bold"},
    {.name = "slant",
     .type = Type::text,
     .rest = Text(std::string("upright")),
     .kinds = letter_kinds,
     .words = "upright|italic",
     .shape = [](Shape& s, const Value& v, const Scene&) { s.letters.italic = is_italic(v); },
     .sentence = "Whether letters are italic.",
     .written = "\"upright\" or \"italic\"",
     .example = "create title text\nset title.slant italic"},
    {.name = "typed",
     .type = Type::scalar,
     .rest = static_cast<double>(most_letters),
     .kinds = letter_kinds,
     .low = 0,
     .high = most_letters,
     .shape =
         [](Shape& s, const Value& v, const Scene&) {
           // A number that is whole except for rounding counts as whole.
           const double all = static_cast<double>(most_letters);
           s.letters.typed = static_cast<std::uint32_t>(std::floor(std::clamp(std::get<double>(v), 0.0, all) + 1e-6));
         },
     .sentence = "How many letters of a text are visible, blanks counted; letters keep their places.",
     .written = "a number",
     .example = "create title text text=\"The end\"\nat 1f title.typed 0 linear\nat 24f title.typed 7"},
    {.name = "wrap",
     .type = Type::scalar,
     .rest = 0.0,
     .kinds = bit(Kind::text),
     .unit = Unit::metres,
     .low = 0,
     .high = most_metres,
     .shape = [](Shape& s, const Value& v, const Scene&) { s.letters.wrap = std::max(std::get<double>(v), 0.0); },
     .sentence = "The width at which the lines of a text break, between words; 0: they break only where the text does.",
     .written = "a length",
     .example = "create says text text=\"A sentence that is too long for one line\"\nset says.wrap 6"},
    {.name = "anchor",
     .type = Type::text,
     .rest = Text(std::string("baseline")),
     .kinds = bit(Kind::text),
     .words = "baseline|top|middle|bottom",
     .instead = {{"centre", "anchor=middle; align=centre is across"},
                 {"center", "anchor=middle; align=centre is across"}},
     .shape = [](Shape& s, const Value& v,
                 const Scene&) { s.letters.anchor = word_in(anchor_names, v, Anchor::baseline); },
     .sentence =
         "What of a text is at its place: the baseline of the first line, the top of its capitals, the baseline "
         "of the last line, or the middle between the last two.",
     .written = "\"baseline\", \"top\", \"middle\" or \"bottom\"",
     .example = "create title text\nset title.anchor middle"},
    {.name = "tex",
     .type = Type::text,
     .rest = Text(),
     .kinds = bit(Kind::text),
     .shape =
         [](Shape& s, const Value& v, const Scene& scene) {
           const auto found = scene.formulas->find(*std::get<Text>(v));
           s.formula = found != scene.formulas->end() ? found->second : nullptr;
         },
     .by_script = true,
     .sentence = "A formula in TeX's notation, drawn instead of the text.",
     .written = "\"\\\\frac{a}{b}\"",
     .example = "create f text\nset f.tex \"\\\\frac{a}{b}\""},
    {.name = "part",
     .type = Type::text,
     .rest = Text(),
     .kinds = bit(Kind::text),
     .by_script = true,
     .sentence = "The part of its parent's formula or code that a text shows; Betwixt sets it.",
     .written = "\"a\""},
    {.name = "language",
     .type = Type::text,
     .rest = Text(std::string("plain")),
     .kinds = bit(Kind::code),
     .words = std::string(code_language_words()),
     .shape = [](Shape& s, const Value& v, const Scene&) { s.language = std::get<Text>(v); },
     .by_script = true,
     .sentence = "The language of code, which tells its colors.",
     .written = "python, javascript, cpp …",
     .example = "create c code text=\"x = 1\"\nset c.language python"},
    {.name = "lines",
     .type = Type::pair,
     .rest = Vec3{},
     .kinds = bit(Kind::code),
     .low = 0,
     .high = most_letters,
     .sentence = "The first and the last line of code that are marked; (0 0): none. `highlight` sets it.",
     .written = "(first last)",
     .example = "create c code text=\"a\\nb\\nc\"\nset c.lines (2 3)"},
    {.name = "of",
     .type = Type::text,
     .rest = Text(),
     .kinds = bit(Kind::diagram),
     .by_script = true,
     .sentence = "The nodes and edges of a diagram.",
     .written = "\"a -> b; b -- c: label\"",
     .example = "create d diagram of=\"a -> b -> c\""},
    {.name = "layout",
     .type = Type::text,
     .rest = Text(std::string("layered")),
     .kinds = bit(Kind::diagram),
     .words = std::string(graph_layout_words),
     .by_script = true,
     .sentence = "How the nodes of a diagram are placed.",
     .written = "layered, tree, force or circle",
     .example = "create d diagram of=\"a -> b; b -> c; c -> a\" layout=circle"},
    {.name = "direction",
     .type = Type::text,
     .rest = Text(std::string("down")),
     .kinds = bit(Kind::diagram),
     .words = std::string(graph_way_words),
     .by_script = true,
     .sentence = "Where the arrows of a diagram go, with layout=layered or layout=tree.",
     .written = "down, right, left or up",
     .example = "create d diagram of=\"a -> b; a -> c\" direction=right"},
    {.name = "nodes",
     .type = Type::text,
     .rest = Text(std::string("box")),
     .kinds = bit(Kind::diagram),
     .words = "box|circle",
     .by_script = true,
     .sentence = "The shape of the nodes of a diagram.",
     .written = "box or circle",
     .example = "create d diagram of=\"1 -- 2 -- 3\" nodes=circle"},
    {.name = "apart",
     .type = Type::pair,
     .rest = Vec3{},
     .kinds = bit(Kind::diagram),
     .unit = Unit::metres,
     .low = 0,
     .high = most_metres,
     .by_script = true,
     .sentence = "The distance of neighbours in a diagram, along x and y; 0: what suits the texts.",
     .written = "(x y)",
     .example = "create d diagram of=\"a -> b -> c\" apart=(3 2)"},
    {.name = "panel",
     .type = Type::boolean,
     .rest = true,
     .kinds = bit(Kind::code),
     .sentence = "Whether code has a panel behind it.",
     .written = "on or off",
     .example = "create c code text=\"x = 1\"\nset c.panel off"},
};

}  // namespace betwixt
