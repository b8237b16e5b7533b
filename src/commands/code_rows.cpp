// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The pieces of a block of code: a panel, the numbers of its lines, the mark of some lines, and a part for each class
// of words.
#include <algorithm>
#include <cmath>

#include "commands/furniture_rows.h"
#include "language/values.h"
#include "scene/code_languages.h"

namespace betwixt {
namespace {

constexpr double letter_width = 0.602;  // em, of DejaVu Sans Mono
constexpr double line_height = 1.2, line_middle = 0.27;

}  // namespace

void make_code(Furnishing& f) {
  const std::string& name = f.name;
  if (!f.says("font")) f.line("set {}.font {}", name, write_text(std::string(code_font)));
  if (!f.says("align")) f.line("set {}.align left", name);
  // A block without a size fits into the usual picture.
  const CodeExtent extent = code_extent(f.text("text"));
  const double numbers = std::get<bool>(f.value("numbers")) ? 3 : 0;
  const double em =
      f.says("size")
          ? f.number("size")
          : std::min({0.3, 15 / (letter_width * extent.columns + 2 + numbers), 8 / (line_height * extent.lines + 1.2)});
  if (!f.says("size")) f.line("set {}.size {}", name, write_number(std::floor(em * 100) / 100));
  if (!f.colored()) f.line("set {}.color {}", name, write_color(theme_of(f.scene).code[0]));
  if (!f.says("position"))
    f.line("set {}.position ({} {})", name, write_number(0.5 * em * (numbers - letter_width * extent.columns)),
           write_number((0.5 * (extent.lines - 1) * line_height - line_middle) * em));
  f.line("create {}/panel rectangle color={} position=(0 0 -0.02)", name, f.panel());
  f.line("set {0}/panel.display = \"value('{0}.panel')\"", name);
  f.line(
      "set {0}/panel.size = \"local e = block.extent('{0}') local n = value('{0}.numbers') and 3 or 0 return "
      "vec(value('{0}.size') * (e.x * {1} + 2 + n), value('{0}.size') * (e.y * {2} + 1.2))\"",
      name, letter_width, line_height);
  f.line(
      "set {0}/panel.position = \"local e = block.extent('{0}') local n = value('{0}.numbers') and 3 or 0 return "
      "vec(value('{0}.size') * (e.x * {1} - n) / 2, value('{0}.size') * ({3} - (e.y - 1) * {2} / 2), -0.02)\"",
      name, letter_width, line_height, line_middle);
  f.line("set {0}/panel.corner = \"0.4 * value('{0}.size')\"", name);
  f.line("create {}/mark rectangle color={} position=(0 0 -0.01)", name, f.faint());
  f.line("set {0}/mark.display = \"value('{0}.lines').x > 0 and value('{0}.lines').y <= block.extent('{0}').y + 0.01\"",
         name);
  f.line(
      "set {0}/mark.size = \"local l = value('{0}.lines') return vec(value('{0}/panel.size').x, value('{0}.size') * "
      "(l.y - l.x + 1) * {1})\"",
      name, line_height);
  f.line(
      "set {0}/mark.position = \"local l = value('{0}.lines') return vec(value('{0}/panel.position').x, "
      "value('{0}.size') * ({2} - ((l.x + l.y) / 2 - 1) * {1}), -0.01)\"",
      name, line_height, line_middle);
  f.line("create {}/numbers text align=right color={} font={}", name, f.muted(), write_text(std::string(code_font)));
  f.line("set {0}/numbers.text = \"block.numbers('{0}')\"", name);
  f.line("set {0}/numbers.size = \"value('{0}.size')\"", name);
  f.line("set {0}/numbers.position = \"vec(-0.9 * value('{0}.size'), 0)\"", name);
  f.line("set {0}/numbers.display = \"value('{0}.numbers')\"", name);
  for (std::size_t is = 1; is < code_class_names.size(); ++is)
    f.line("create {0}/{1} text part=\"{1}\" color={2}", name, code_class_names[is],
           write_color(theme_of(f.scene).code[is]));
}

}  // namespace betwixt
