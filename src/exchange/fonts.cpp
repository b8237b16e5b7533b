// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/fonts.h"

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <hb-ft.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>

#include "base/utf8.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr double line_spacing = 1.2;  // em
constexpr double fineness = 0.0015;   // em: how far a flattened curve may stray

// A glyph's contours at 1 m an em, outer ones counter-clockwise.
using Glyph = std::vector<Contour>;

struct Deleter {
  void operator()(hb_font_t* f) const { hb_font_destroy(f); }
  void operator()(hb_buffer_t* b) const { hb_buffer_destroy(b); }
  void operator()(FcPattern* p) const { FcPatternDestroy(p); }
  void operator()(FcFontSet* s) const { FcFontSetDestroy(s); }
  void operator()(FcObjectSet* s) const { FcObjectSetDestroy(s); }
};
template <class T>
using Owned = std::unique_ptr<T, Deleter>;

// An opened font file; used under the one lock of this file.
struct Face {
  FT_Face face = nullptr;
  Owned<hb_font_t> shaper;
  std::map<FT_UInt, Glyph> glyphs;
};

struct Machine {
  std::mutex mutex;
  FT_Library library = nullptr;
  std::vector<std::string> families;                   // sorted, without doubles
  std::map<std::string, std::shared_ptr<Face>> faces;  // by family as asked for; null: nothing to draw with
  std::map<std::pair<std::string, std::string>, Outline> outlines;  // by family and text
};

Machine& machine() {
  static Machine& m = *new Machine;  // never taken down: other threads may still draw while the program ends
  return m;
}

std::string lowered(std::string s) {
  std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return std::tolower(c); });
  return s;
}

const std::vector<std::string>& families(Machine& m) {
  if (!m.families.empty()) return m.families;
  const Owned<FcPattern> all(FcPatternCreate());
  const Owned<FcObjectSet> wanted(FcObjectSetBuild(FC_FAMILY, nullptr));
  const Owned<FcFontSet> set(FcFontList(nullptr, all.get(), wanted.get()));
  for (int i = 0; set && i < set->nfont; ++i) {
    FcChar8* name = nullptr;
    for (int n = 0; FcPatternGetString(set->fonts[i], FC_FAMILY, n, &name) == FcResultMatch; ++n)
      m.families.emplace_back(reinterpret_cast<const char*>(name));
  }
  std::sort(m.families.begin(), m.families.end());
  m.families.erase(std::unique(m.families.begin(), m.families.end()), m.families.end());
  return m.families;
}

bool has_family(Machine& m, const std::string& family) {
  const auto& all = families(m);
  return std::any_of(all.begin(), all.end(), [&](const auto& f) { return lowered(f) == lowered(family); });
}

// How many letters to change, add or leave out.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j)
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])}));
  }
  return row[b.size()];
}

std::string near_family(Machine& m, const std::string& family) {
  std::string best;
  std::size_t least = 1 + family.size() / 3;
  for (const auto& f : families(m))
    if (const auto d = distance(lowered(f), lowered(family.substr(0, 100))); d < least) least = d, best = f;
  return best;
}

// The file and the face's number in it of what comes nearest to a family; the file is empty where there are no fonts at
// all.
std::pair<std::string, int> font_file(const std::string& family) {
  const Owned<FcPattern> pattern(FcPatternCreate());
  FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult found = FcResultNoMatch;
  const Owned<FcPattern> match(FcFontMatch(nullptr, pattern.get(), &found));
  FcChar8* file = nullptr;
  int index = 0;
  if (!match || FcPatternGetString(match.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
  FcPatternGetInteger(match.get(), FC_INDEX, 0, &index);
  return {reinterpret_cast<const char*>(file), index};
}

std::shared_ptr<Face> open_face(Machine& m, const std::string& family) {
  if (m.library == nullptr && FT_Init_FreeType(&m.library) != 0) return nullptr;
  const auto [file, index] = font_file(has_family(m, family) ? family : "DejaVu Sans");
  auto face = std::make_shared<Face>();
  if (file.empty() || FT_New_Face(m.library, file.c_str(), index, &face->face) != 0) return nullptr;
  // One em is as many units as the design has: nothing is rounded.
  FT_Set_Char_Size(face->face, face->face->units_per_EM * 64, 0, 72, 72);
  face->shaper.reset(hb_ft_font_create_referenced(face->face));
  hb_ft_font_set_load_flags(face->shaper.get(), FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP);
  return face->face->units_per_EM > 0 ? face : nullptr;
}

Face* face_for(Machine& m, const std::string& family) {
  const auto [i, fresh] = m.faces.try_emplace(family);
  if (fresh) i->second = open_face(m, family);
  return i->second.get();
}

// Takes a glyph's outline apart into straight lines.
struct Flattener {
  Glyph glyph;
  double unit;  // metres

  Vec3 point(const FT_Vector* v) const {
    return {unit * static_cast<double>(v->x), unit * static_cast<double>(v->y), 0};
  }
  Vec3 here() const { return glyph.back().back(); }
  // As many steps as keep the lines near the curve, whose second differences are `bend`.
  static int steps(double bend) {
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(bend / (8 * fineness)))), 1, 32);
  }

  static int move(const FT_Vector* to, void* self) {
    auto& f = *static_cast<Flattener*>(self);
    f.glyph.push_back({f.point(to)});
    return 0;
  }
  static int line(const FT_Vector* to, void* self) {
    auto& f = *static_cast<Flattener*>(self);
    f.glyph.back().push_back(f.point(to));
    return 0;
  }
  static int conic(const FT_Vector* control, const FT_Vector* to, void* self) {
    auto& f = *static_cast<Flattener*>(self);
    const Vec3 a = f.here(), b = f.point(control), c = f.point(to);
    const int n = steps(2 * length(a - 2 * b + c));
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n, u = 1 - t;
      f.glyph.back().push_back(u * u * a + 2 * u * t * b + t * t * c);
    }
    return 0;
  }
  static int cubic(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* self) {
    auto& f = *static_cast<Flattener*>(self);
    const Vec3 a = f.here(), b = f.point(first), c = f.point(second), d = f.point(to);
    const int n = steps(6 * std::max(length(a - 2 * b + c), length(b - 2 * c + d)));
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n, u = 1 - t;
      f.glyph.back().push_back(u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d);
    }
    return 0;
  }
};

const Glyph& glyph_of(Face& face, FT_UInt index) {
  const auto [i, fresh] = face.glyphs.try_emplace(index);
  if (!fresh) return i->second;
  if (FT_Load_Glyph(face.face, index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) return i->second;
  FT_GlyphSlot slot = face.face->glyph;
  if (slot->format != FT_GLYPH_FORMAT_OUTLINE) return i->second;  // a picture of a letter has no contours
  if (FT_Outline_Get_Orientation(&slot->outline) == FT_ORIENTATION_TRUETYPE) FT_Outline_Reverse(&slot->outline);
  Flattener f{{}, 1 / (64.0 * face.face->units_per_EM)};
  const FT_Outline_Funcs funcs{&Flattener::move, &Flattener::line, &Flattener::conic, &Flattener::cubic, 0, 0};
  if (FT_Outline_Decompose(&slot->outline, &funcs, &f) != 0) return i->second;
  for (auto& contour : f.glyph) {
    contour.erase(std::unique(contour.begin(), contour.end()), contour.end());
    if (contour.size() > 1 && contour.front() == contour.back()) contour.pop_back();
    if (contour.size() > 2) i->second.push_back(std::move(contour));
  }
  return i->second;
}

// The part of `text` that each glyph stands for, by where it begins.
std::map<std::size_t, std::string> clusters(std::string_view text, const hb_glyph_info_t* infos, unsigned count) {
  std::map<std::size_t, std::string> parts;
  for (unsigned i = 0; i < count; ++i) parts[infos[i].cluster];
  std::size_t end = text.size();
  for (auto part = parts.rbegin(); part != parts.rend(); end = (part++)->first)
    part->second = text.substr(part->first, end - part->first);
  return parts;
}

// A glyph of a line, and the part of the text that it stands for begins there.
struct SetGlyph {
  FT_UInt index = 0;
  Vec3 at;
  std::size_t cluster = 0;
};

// One line of text, centred about x = 0 with its baseline at y; `parts`: what its clusters are.
std::vector<SetGlyph> set_line(Face& face, std::string_view text, double y, std::map<std::size_t, std::string>& parts) {
  const Owned<hb_buffer_t> buffer(hb_buffer_create());
  hb_buffer_add_utf8(buffer.get(), text.data(), static_cast<int>(text.size()), 0, static_cast<int>(text.size()));
  hb_buffer_guess_segment_properties(buffer.get());
  hb_shape(face.shaper.get(), buffer.get(), nullptr, 0);
  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
  const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer.get(), &count);
  const double unit = 1 / (64.0 * face.face->units_per_EM);
  double width = 0;
  for (unsigned i = 0; i < count; ++i) width += unit * places[i].x_advance;
  parts = clusters(text, infos, count);
  std::vector<SetGlyph> out;
  Vec3 pen{-width / 2, y, 0};
  for (unsigned i = 0; i < count; ++i) {
    const Vec3 shift{static_cast<double>(places[i].x_offset), static_cast<double>(places[i].y_offset), 0};
    out.push_back({infos[i].codepoint, pen + unit * shift, infos[i].cluster});
    pen.x += unit * places[i].x_advance;
  }
  return out;
}

// f(glyphs, parts) for each line.
template <class F>
void each_line(Face& face, const std::string& all, const F& f) {
  const std::string_view text = first_characters(all, most_letters);
  double y = 0;
  std::map<std::size_t, std::string> parts;
  for (std::size_t begin = 0; begin <= text.size(); y -= line_spacing) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::vector<SetGlyph> glyphs = set_line(face, text.substr(begin, end - begin), y, parts);
    f(glyphs, parts);
    begin = end + 1;
  }
}

void add_outlines(Face& face, const std::vector<SetGlyph>& glyphs, const std::map<std::size_t, std::string>& parts,
                  Outline& out) {
  std::size_t first = out.contours.size();  // of the letter that the glyph belongs to
  for (std::size_t i = 0; i < glyphs.size(); ++i) {
    if (i > 0 && glyphs[i].cluster != glyphs[i - 1].cluster) first = out.contours.size();
    const bool begun = out.contours.size() > first;
    for (Contour contour : glyph_of(face, glyphs[i].index)) {
      for (Vec3& p : contour) p = p + glyphs[i].at;
      out.contours.push_back(std::move(contour));
    }
    if (!begun && out.contours.size() > first) out.letters.push_back({first, parts.at(glyphs[i].cluster)});
  }
}

}  // namespace

Status find_font(const std::string& family) {
  Machine& m = machine();
  const std::lock_guard lock(m.mutex);
  if (has_family(m, family)) return Nothing{};
  const std::string near = near_family(m, family);
  return fail(ErrorCode::name, fmt::format("this machine has no font called \"{}\"", family),
              near.empty() ? "" : fmt::format("did you mean \"{}\"?", near));
}

Outline text_outline(const std::string& text, const std::string& family) {
  Machine& m = machine();
  const std::lock_guard lock(m.mutex);
  const std::pair key{family, text};
  if (const auto i = m.outlines.find(key); i != m.outlines.end()) return i->second;
  Outline out;
  if (Face* face = face_for(m, family))
    each_line(*face, text, [&](const auto& glyphs, const auto& parts) { add_outlines(*face, glyphs, parts, out); });
  if (m.outlines.size() >= 256) m.outlines.clear();  // texts that change all the time are not worth keeping
  return m.outlines[key] = out;
}

SetText set_text(const std::string& text, const std::string& family) {
  Machine& m = machine();
  const std::lock_guard lock(m.mutex);
  SetText out;
  std::map<FT_UInt, std::size_t> known;
  Face* face = face_for(m, family);
  if (face)
    each_line(*face, text, [&](const std::vector<SetGlyph>& glyphs, const auto&) {
      for (const SetGlyph& g : glyphs) {
        const auto [at, fresh] = known.try_emplace(g.index, out.glyphs.size());
        if (fresh) out.glyphs.push_back({g.index, {glyph_of(*face, g.index), {}}});
        if (!out.glyphs[at->second].outline.contours.empty()) out.places.push_back({at->second, g.at});
      }
    });
  return out;
}

}  // namespace betwixt
