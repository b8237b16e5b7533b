// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fonts of strangers: each line of text is shaped in the parser's process.
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <map>
#include <optional>

#include "base/files.h"
#include "exchange/font_face.h"
#include "exchange/parser_process.h"

namespace betwixt {
namespace {

constexpr ParserCeilings one_line{.memory = std::uint64_t{512} << 20, .seconds = 1, .wall = 60};
constexpr std::size_t longest_line = 30'000;  // bytes, in one message
constexpr std::size_t most_lines = 1024;      // kept; lines that always change are not worth it
constexpr const char* shown = "the font";     // in errors: the caller knows its name

// Whether the glyphs begin at letters of the line.
bool fits(const ShapedLine& shaped, std::string_view line) {
  for (const ShapedGlyph& g : shaped.glyphs)
    if (g.begin > line.size() || (g.begin < line.size() && (line[g.begin] & '\xc0') == '\x80')) return false;
  return true;
}

class OwnFace final : public FontFace {
 public:
  explicit OwnFace(std::shared_ptr<const OwnFont> font)
      : font_(std::move(font)), file_(::memfd_create("betwixt-font", MFD_CLOEXEC)) {}

  bool open() const { return file_ && write_all(file_.fd(), font_->bytes) == 0; }

  Result<ShapedGlyphs> shape(std::string_view line) override {
    if (const auto known = lines_.find(line); known != lines_.end()) return known->second;
    if (broken_) return *broken_;
    if (line.size() > longest_line) return fail(ErrorCode::range, "a line of text is too long for a font from a file");
    auto shaped = ask(line);
    if (!shaped) {  // what the machine lacks for a moment is not the font's fault
      if (shaped.error().code != ErrorCode::machine) broken_ = shaped.error();
      return shaped.error();
    }
    for (const auto& [number, contours] : (*shaped)->outlines) glyphs_.try_emplace(number, contours);
    if (lines_.size() >= most_lines) lines_.clear();
    return lines_.emplace(line, (*shaped)->glyphs).first->second;
  }
  const Contours& glyph(std::uint32_t number) override { return glyphs_[number]; }

 private:
  Result<std::shared_ptr<const ShapedLine>> ask(std::string_view line) const {
    using Wanted = std::shared_ptr<const ShapedLine>;
    auto read = shape_apart(shown, file_.fd(), line, one_line);
    if (!read) return parse_letters(font_->bytes, shown, line);  // this machine has no parser
    if (const auto* error = std::get_if<Error>(&*read)) return *error;
    const auto* shaped = std::get_if<Wanted>(&*read);
    if (!shaped || !fits(**shaped, line)) return fail(ErrorCode::file, "the font is damaged");
    return *shaped;
  }

  const std::shared_ptr<const OwnFont> font_;
  const OpenFile file_;  // for the parser
  std::map<std::string, ShapedGlyphs, std::less<>> lines_;
  std::map<std::uint32_t, Contours> glyphs_;
  std::optional<Error> broken_;
};

}  // namespace

std::unique_ptr<FontFace> open_own_font(std::shared_ptr<const OwnFont> font) {
  auto face = std::make_unique<OwnFace>(std::move(font));
  if (!face->open()) return nullptr;
  return face;
}

}  // namespace betwixt
