// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fonts through FreeType and HarfBuzz.
#include "exchange/font_face.h"

#include <fmt/format.h>
#include <ft2build.h>
#include <hb-ft.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <map>

#include "exchange/flattener.h"

namespace betwixt {
namespace {

constexpr std::size_t most_points = 1'000'000;  // of one line

struct Deleter {
  void operator()(hb_font_t* f) const { hb_font_destroy(f); }
  void operator()(hb_buffer_t* b) const { hb_buffer_destroy(b); }
};
template <class T>
using Owned = std::unique_ptr<T, Deleter>;

// Reads a glyph's outline.
struct GlyphReader {
  Flattener lines{fineness};
  double unit;  // metres

  Vec3 point(const FT_Vector* v) const {
    return {unit * static_cast<double>(v->x), unit * static_cast<double>(v->y), 0};
  }
  static GlyphReader& of(void* self) { return *static_cast<GlyphReader*>(self); }

  static int move(const FT_Vector* to, void* self) { return of(self).lines.move(of(self).point(to)), 0; }
  static int line(const FT_Vector* to, void* self) { return of(self).lines.line(of(self).point(to)), 0; }
  static int conic(const FT_Vector* control, const FT_Vector* to, void* self) {
    GlyphReader& r = of(self);
    return r.lines.conic(r.point(control), r.point(to)), 0;
  }
  static int cubic(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* self) {
    GlyphReader& r = of(self);
    return r.lines.cubic(r.point(first), r.point(second), r.point(to)), 0;
  }
};

class FreeTypeFace final : public FontFace {
 public:
  explicit FreeTypeFace(std::string bytes = {}) : bytes_(std::move(bytes)) {}
  FreeTypeFace(const FreeTypeFace&) = delete;
  FreeTypeFace& operator=(const FreeTypeFace&) = delete;
  ~FreeTypeFace() override {
    shaper_.reset();
    if (face_ != nullptr) FT_Done_Face(face_);
    if (library_ != nullptr) FT_Done_FreeType(library_);
  }
  bool open(const std::string& path, int index) {
    return FT_Init_FreeType(&library_) == 0 && FT_New_Face(library_, path.c_str(), index, &face_) == 0 && prepare();
  }
  bool open_bytes() {
    return FT_Init_FreeType(&library_) == 0 &&
           FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(bytes_.data()),
                              static_cast<FT_Long>(bytes_.size()), 0, &face_) == 0 &&
           prepare();
  }

  Result<ShapedGlyphs> shape(std::string_view line) override {
    const Owned<hb_buffer_t> buffer(hb_buffer_create());
    hb_buffer_add_utf8(buffer.get(), line.data(), static_cast<int>(line.size()), 0, static_cast<int>(line.size()));
    hb_buffer_guess_segment_properties(buffer.get());
    hb_shape(shaper_.get(), buffer.get(), nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer.get(), &count);
    ShapedGlyphs out;
    for (unsigned i = 0; i < count; ++i)
      out.push_back({infos[i].codepoint,
                     infos[i].cluster,
                     unit() * places[i].x_advance,
                     {unit() * places[i].x_offset, unit() * places[i].y_offset, 0}});
    return out;
  }

  hb_font_t* shaper() override { return shaper_.get(); }

  const Contours& glyph(std::uint32_t number) override {
    const auto [i, fresh] = glyphs_.try_emplace(number);
    if (fresh) i->second = read(number);
    return i->second;
  }

 private:
  double unit() const { return 1 / (64.0 * face_->units_per_EM); }
  bool prepare() {
    if (!FT_IS_SCALABLE(face_) || face_->units_per_EM == 0) return false;
    // One em has the design's number of units, so nothing is rounded.
    FT_Set_Char_Size(face_, face_->units_per_EM * 64, 0, 72, 72);
    shaper_.reset(hb_ft_font_create_referenced(face_));
    hb_ft_font_set_load_flags(shaper_.get(), FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP);
    return true;
  }
  Contours read(std::uint32_t number) const {
    if (FT_Load_Glyph(face_, number, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) return {};
    FT_GlyphSlot slot = face_->glyph;
    if (slot->format != FT_GLYPH_FORMAT_OUTLINE) return {};  // bitmap glyphs have no contours
    if (FT_Outline_Get_Orientation(&slot->outline) == FT_ORIENTATION_TRUETYPE) FT_Outline_Reverse(&slot->outline);
    GlyphReader r{.unit = unit()};
    const FT_Outline_Funcs funcs{
        &GlyphReader::move, &GlyphReader::line, &GlyphReader::conic, &GlyphReader::cubic, 0, 0};
    if (FT_Outline_Decompose(&slot->outline, &funcs, &r) != 0) return {};
    return r.lines.take();
  }

  const std::string bytes_;
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
  Owned<hb_font_t> shaper_;
  std::map<std::uint32_t, Contours> glyphs_;
};

}  // namespace

std::unique_ptr<FontFace> open_font_file(const std::string& path, int index) {
  auto face = std::make_unique<FreeTypeFace>();
  if (!face->open(path, index)) return nullptr;
  return face;
}

std::unique_ptr<FontFace> open_font_bytes(std::string bytes) {
  auto face = std::make_unique<FreeTypeFace>(std::move(bytes));
  if (!face->open_bytes()) return nullptr;
  return face;
}

Result<std::shared_ptr<const ShapedLine>> parse_letters(std::string bytes, const std::string& path,
                                                        std::string_view line) {
  const auto face = open_font_bytes(std::move(bytes));
  if (!face) return fail(ErrorCode::file, fmt::format("{} is not a font with outlines", path));
  auto out = std::make_shared<ShapedLine>();
  out->glyphs = *face->shape(line);
  std::map<std::uint32_t, bool> known;
  std::size_t points = 0;
  for (const ShapedGlyph& g : out->glyphs) {
    if (!known.try_emplace(g.number).second) continue;
    out->outlines.emplace_back(g.number, face->glyph(g.number));
    for (const Contour& c : out->outlines.back().second) points += c.size();
    if (points > most_points)
      return fail(ErrorCode::range, fmt::format("a line in {} has more than {} points", path, most_points));
  }
  return std::shared_ptr<const ShapedLine>(std::move(out));
}

}  // namespace betwixt
