// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/color_table.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "base/files.h"
#include "exchange/unpacking.h"

namespace betwixt {
namespace {

using Colors = Result<std::shared_ptr<const ColorTable>>;

constexpr std::string_view packed_begins = "betwixt colors 1\n";

std::size_t colors_in(const ColorTable& t) {
  const auto side = static_cast<std::size_t>(t.size);
  return t.cube ? side * side * side : side;
}

std::uint16_t signal_16(double share) {
  return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(share, 0.0, 1.0)));
}

// ---- .cube, as Adobe and Blackmagic Design describe it

std::string_view next_word(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t\r"), line.size());
  const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

class CubeReader {
 public:
  CubeReader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  Colors read(bool of_light) {
    auto table = std::make_shared<ColorTable>();
    table->takes = of_light ? ColorTable::light : ColorTable::picture;
    while (!rest_.empty()) {
      std::string_view line = rest_.substr(0, rest_.find('\n'));
      rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
      ++line_;
      if (Status s = read_line(line, *table); !s) return s.error();
    }
    if (table->size == 0) return broken("it has neither LUT_3D_SIZE nor LUT_1D_SIZE");
    if (table->signals.size() != wanted_)
      return broken(fmt::format("it ends after {} of {} colors", table->signals.size() / 3, wanted_ / 3));
    for (std::size_t c = 0; c < 3; ++c)
      if (!(table->least[c] < table->most[c]) || std::max(std::abs(table->least[c]), std::abs(table->most[c])) > 1e5F)
        return broken("its domain is empty");
    return std::shared_ptr<const ColorTable>(std::move(table));
  }
  static bool has_both(std::string_view text) {
    return text.find("LUT_1D_SIZE") != text.npos && text.find("LUT_3D_SIZE") != text.npos;
  }

 private:
  Error broken(std::string_view why) const {
    return fail(ErrorCode::file, fmt::format("{} is damaged: {}", name_, why));
  }
  Error in_line(std::string_view why) const {
    return fail(ErrorCode::file, fmt::format("{}, line {}: {}", name_, line_, why));
  }

  Status numbers(std::string_view line, std::span<double> out) const {
    for (double& number : out) {
      const std::string_view word = next_word(line);
      const auto read = fast_float::from_chars(word.data(), word.data() + word.size(), number);
      if (word.empty() || read.ec != std::errc() || read.ptr != word.data() + word.size() || !std::isfinite(number))
        return in_line(word.empty() ? fmt::format("{} numbers are needed here", out.size())
                                    : fmt::format("'{}' is not a number", word.substr(0, 40)));
    }
    const std::string_view more = next_word(line);
    return more.empty() ? Status(Nothing{}) : in_line(fmt::format("'{}' is one word too many", more.substr(0, 40)));
  }

  Status read_size(std::string_view line, bool cube, ColorTable& t) {
    std::array<double, 1> size{};
    if (Status s = numbers(line, size); !s) return s;
    const int most = cube ? ColorTable::most_side : ColorTable::most_curve;
    if (!(size[0] >= 2 && size[0] <= most) || size[0] != std::floor(size[0]))
      return fail(ErrorCode::range, fmt::format("{}, line {}: the size of a {} must be from 2 to {}, not {}", name_,
                                                line_, cube ? "3D table" : "1D table", most, size[0]));
    if (t.size != 0) return in_line("the size is given twice");
    t.size = static_cast<int>(size[0]), t.cube = cube;
    wanted_ = 3 * colors_in(t);
    if (Status fits = unpack(2 * wanted_, name_); !fits) return fits;
    t.signals.reserve(wanted_);
    return Nothing{};
  }

  Status read_range(std::string_view line, ColorTable& t) const {
    std::array<double, 2> both{};
    if (Status s = numbers(line, both); !s) return s;
    t.least.fill(static_cast<float>(both[0])), t.most.fill(static_cast<float>(both[1]));
    return Nothing{};
  }
  Status read_end(std::string_view line, std::array<float, 3>& to) const {
    std::array<double, 3> all{};
    if (Status s = numbers(line, all); !s) return s;
    for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(all[c]);
    return Nothing{};
  }

  Status read_line(std::string_view line, ColorTable& t) {
    std::string_view rest = line;
    const std::string_view word = next_word(rest);
    if (word.empty() || word[0] == '#' || word == "TITLE") return Nothing{};
    if (word == "LUT_3D_SIZE" || word == "LUT_1D_SIZE") return read_size(rest, word == "LUT_3D_SIZE", t);
    if (word == "LUT_3D_INPUT_RANGE" || word == "LUT_1D_INPUT_RANGE") return read_range(rest, t);
    if (word == "DOMAIN_MIN") return read_end(rest, t.least);
    if (word == "DOMAIN_MAX") return read_end(rest, t.most);
    const bool letter = std::isalpha(static_cast<unsigned char>(word[0])) != 0;
    if (letter && word != "nan" && word != "inf" && word != "NaN" && word != "Inf")
      return in_line(fmt::format("'{}' is no word of a .cube file", word.substr(0, 40)));
    std::array<double, 3> color{};
    if (Status s = numbers(line, color); !s) return s;
    if (t.size == 0) return in_line("colors come before LUT_3D_SIZE or LUT_1D_SIZE");
    if (t.signals.size() >= wanted_) return in_line(fmt::format("there are more than {} colors", wanted_ / 3));
    for (const double share : color) t.signals.push_back(signal_16(share));
    return Nothing{};
  }

  std::string_view rest_;
  const std::string& name_;
  int line_ = 0;
  std::size_t wanted_ = 0;
};

// ---- packed

// "cube 65 2", six numbers and the signals, the lower byte first.
Colors read_packed(std::string_view text, const std::string& name) {
  const Error broken = fail(ErrorCode::file, fmt::format("{} is damaged", name));
  text.remove_prefix(packed_begins.size());
  const std::size_t end = text.find('\n');
  if (end == text.npos) return broken;
  std::string_view head = text.substr(0, end);
  text.remove_prefix(end + 1);
  auto t = std::make_shared<ColorTable>();
  t->cube = next_word(head) == "cube";
  std::array<double, 8> all{};
  for (double& number : all) {
    const std::string_view word = next_word(head);
    fast_float::from_chars(word.data(), word.data() + word.size(), number);
    if (!(std::abs(number) <= 1e5)) return broken;
  }
  if (all[0] < 2 || all[0] > (t->cube ? ColorTable::most_side : ColorTable::most_curve) || all[1] < 0 || all[1] > 2)
    return broken;
  t->size = static_cast<int>(all[0]);
  t->takes = static_cast<ColorTable::Takes>(static_cast<int>(all[1]));
  for (std::size_t c = 0; c < 3; ++c) {
    t->least[c] = static_cast<float>(all[2 + c]), t->most[c] = static_cast<float>(all[5 + c]);
    if (!(t->least[c] < t->most[c])) return broken;
  }
  if (text.size() != 6 * colors_in(*t)) return broken;
  t->signals.resize(text.size() / 2);
  for (std::size_t i = 0; i < t->signals.size(); ++i)
    t->signals[i] = static_cast<std::uint16_t>(static_cast<unsigned char>(text[2 * i]) |
                                               static_cast<unsigned char>(text[2 * i + 1]) << 8);
  return std::shared_ptr<const ColorTable>(std::move(t));
}

}  // namespace

bool is_configuration(std::string_view path) { return ending(std::string(path)) == "ocio"; }

std::string packed_colors(const ColorTable& t) {
  std::string out =
      fmt::format("{}{} {} {} {} {} {} {} {} {}\n", packed_begins, t.cube ? "cube" : "curve", t.size,
                  static_cast<int>(t.takes), t.least[0], t.least[1], t.least[2], t.most[0], t.most[1], t.most[2]);
  out.reserve(out.size() + 2 * t.signals.size());
  for (const std::uint16_t s : t.signals) (out += static_cast<char>(s & 0xff)) += static_cast<char>(s >> 8);
  return out;
}

std::string text_of_query(const ColorQuery& q) {
  return fmt::format("{}\n{}\n{}\n{}\n{}", q.of_light ? "light" : "picture", q.display, q.through, q.look, q.space);
}
ColorQuery query_of_text(std::string_view text) {
  ColorQuery q;
  std::string of;
  for (std::string* line : {&of, &q.display, &q.through, &q.look, &q.space}) {
    *line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line->size() + 1, text.size()));
  }
  q.of_light = of == "light";
  return q;
}

Colors parse_colors(const std::string& path, FileSource& files, std::string_view asked) {
  const ColorQuery query = query_of_text(asked);
  const auto text = files.read(path);
  if (!text) return text.error();
  if (text->starts_with(packed_begins)) return read_packed(*text, path);
  if (ending(path) == "cube" && !CubeReader::has_both(*text)) return CubeReader(*text, path).read(query.of_light);
  if (bake_colors != nullptr) return bake_colors(path, files, query);
  return fail(ErrorCode::machine, fmt::format("{} is read by OpenColorIO, which is not in this program", path),
              "betwixt-parser has it where it was built with OpenColorIO; a .cube with one table needs it not");
}

}  // namespace betwixt
