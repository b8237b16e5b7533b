// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes the values of formulas, so that they read back to the same value.
#include "language/formula.h"
#include "language/values.h"

namespace betwixt {

std::string_view to_string(Quantity::Of of) {
  static constexpr std::string_view words[] = {"a number", "an angle", "a length", "a time"};
  return words[static_cast<std::size_t>(of)];
}

std::string write_let(const LetItem& item) {
  if (const auto* q = std::get_if<Quantity>(&item)) return write_quantity(*q);
  if (const auto* v = std::get_if<Vec3>(&item)) return write_vector(*v);
  if (const auto* t = std::get_if<Text>(&item)) return write_text(**t);
  return write_color(std::get<Color>(item));
}

std::string write_let(const Let& let) {
  if (LetItem item; single(let, item)) return write_let(item);
  std::string out;
  for (const LetItem& item : std::get<LetList>(let)) out += (out.empty() ? "(" : " ") + write_let(item);
  return out + ")";
}

std::string write_quantity(const Quantity& q) {
  if (q.of != Quantity::Of::time) {
    static constexpr std::string_view units[] = {"", "deg", "m"};
    return write_number(q.value) + std::string(units[static_cast<std::size_t>(q.of)]);
  }
  if (!q.counts_frames) return write_number(q.value) + "s";
  std::string out = write_number(q.frames) + "f";
  if (q.value != 0) out += (q.value > 0 ? "+" : "") + write_number(q.value) + "s";
  return out;
}

std::string write_parts_and_tables(const Scene& s) {
  std::string out;
  for (const auto& [name, part] : *s.parts)
    if (part.help.empty()) out += "part " + usage_of(name, part) + "\n" + part.lines;
  for (const auto& [name, table] : *s.tables) out += "data " + name + " " + table->command + "\n";
  return out;
}

}  // namespace betwixt
