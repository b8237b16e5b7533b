// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/formulas.h"

#include <fmt/format.h>

#include <mutex>

#include "exchange/formula_setter.h"
#include "exchange/typefaces.h"

namespace betwixt {
namespace {

std::string utf8_of(char32_t c) {
  std::string out;
  const auto add = [&](std::uint32_t byte) { out.push_back(static_cast<char>(byte)); };
  const std::uint32_t n = c;
  if (n < 0x80) return add(n), out;
  if (n < 0x800) return add(0xC0 | n >> 6), add(0x80 | (n & 63)), out;
  if (n < 0x10000) return add(0xE0 | n >> 12), add(0x80 | (n >> 6 & 63)), add(0x80 | (n & 63)), out;
  return add(0xF0 | n >> 18), add(0x80 | (n >> 12 & 63)), add(0x80 | (n >> 6 & 63)), add(0x80 | (n & 63)), out;
}

// Adds a mark to the outline, as a letter of its own unless it continues the one before.
void add_mark(Outline& out, MathFont& font, const SetMark& m) {
  const Contours& contours = m.area.empty() ? font.contours(m.glyph) : m.area;
  if (contours.empty()) return;
  if (!m.joined || out.letters.empty())
    out.letters.push_back({out.contours.size(), utf8_of(m.sign), m.part != nullptr ? *m.part : std::string()});
  for (Contour c : contours) {
    for (Vec3& p : c) p = m.size * p + m.at;
    out.contours.push_back(std::move(c));
  }
}

// Opens the font when it is first needed; tries again while it is missing, because a page may bring it later. The
// caller holds the lock.
MathFont& math_font() {
  static std::unique_ptr<MathFont>& font = *new std::unique_ptr<MathFont>;  // never destroyed, as other fonts
  if (font && font->usable()) return *font;
  const std::string name(formula_font_name);
  const FontFile file = find_font(name) ? font_file({name}) : FontFile{};
  font = std::make_unique<MathFont>(file.path.empty() ? nullptr : open_font_file(file.path, file.index));
  return *font;
}

}  // namespace

Result<std::shared_ptr<const Outline>> set_formula_text(const std::string& text) {
  static std::mutex& mutex = *new std::mutex;
  const auto failed = [](FormulaError e) {
    e.what.place.column = static_cast<int>(e.at) + 1, e.what.place.length = static_cast<int>(e.length);
    return e.what;
  };
  FormulaList tree;
  FormulaError e = read_formula(text, tree);
  if (!e.what.message.empty()) return failed(std::move(e));
  const std::lock_guard lock(mutex);
  MathFont& font = math_font();
  if (!font.usable())
    return fail(ErrorCode::machine,
                fmt::format("formulas need the font {}, which this machine lacks", formula_font_name),
                "sudo apt-get install fonts-lmodern");
  FormulaSetter setter(font);
  const SetBox box = setter.list(tree, {});
  if (!setter.failed.what.message.empty()) return failed(std::move(setter.failed));
  auto out = std::make_shared<Outline>();
  for (const SetMark& m : box.marks) add_mark(*out, font, m);
  return std::shared_ptr<const Outline>(std::move(out));
}

}  // namespace betwixt
