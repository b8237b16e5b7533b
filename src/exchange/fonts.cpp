// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/fonts.h"

#include <ft2build.h>
#include <hb-ft.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "base/utf8.h"
#include "exchange/flattener.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr double line_spacing = 1.2;  // em

// A glyph's contours at 1 m an em, outer ones counter-clockwise.
using Glyph = std::vector<Contour>;

struct Deleter {
  void operator()(hb_font_t* f) const { hb_font_destroy(f); }
  void operator()(hb_buffer_t* b) const { hb_buffer_destroy(b); }
};
template <class T>
using Owned = std::unique_ptr<T, Deleter>;

// An open font file. This file's only lock protects it.
struct Face {
  FT_Face face = nullptr;
  Owned<hb_font_t> shaper;
  std::map<FT_UInt, Glyph> glyphs;
};

struct Machine {
  std::mutex mutex;
  FT_Library library = nullptr;
  std::map<Typeface, std::shared_ptr<Face>> faces;  // by the requested typeface; nullptr: no font is available
  std::map<std::tuple<Typeface, Align, std::uint32_t, std::string>, Outline> outlines;
};

Machine& machine() {
  static Machine& m = *new Machine;  // never destroyed: other threads may still draw at program exit
  return m;
}

std::shared_ptr<Face> open_face(Machine& m, const Typeface& typeface) {
  if (m.library == nullptr && FT_Init_FreeType(&m.library) != 0) return nullptr;
  const auto [file, index] = font_file(typeface);
  auto face = std::make_shared<Face>();
  if (file.empty() || FT_New_Face(m.library, file.c_str(), index, &face->face) != 0) return nullptr;
  // One em has the design's number of units, so nothing is rounded.
  FT_Set_Char_Size(face->face, face->face->units_per_EM * 64, 0, 72, 72);
  face->shaper.reset(hb_ft_font_create_referenced(face->face));
  hb_ft_font_set_load_flags(face->shaper.get(), FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP);
  return face->face->units_per_EM > 0 ? face : nullptr;
}

Face* face_for(Machine& m, const Typeface& typeface) {
  const auto [i, fresh] = m.faces.try_emplace(typeface);
  if (fresh) i->second = open_face(m, typeface);
  return i->second.get();
}

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

const Glyph& glyph_of(Face& face, FT_UInt index) {
  const auto [i, fresh] = face.glyphs.try_emplace(index);
  if (!fresh) return i->second;
  if (FT_Load_Glyph(face.face, index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) return i->second;
  FT_GlyphSlot slot = face.face->glyph;
  if (slot->format != FT_GLYPH_FORMAT_OUTLINE) return i->second;  // bitmap glyphs have no contours
  if (FT_Outline_Get_Orientation(&slot->outline) == FT_ORIENTATION_TRUETYPE) FT_Outline_Reverse(&slot->outline);
  GlyphReader r{.unit = 1 / (64.0 * face.face->units_per_EM)};
  const FT_Outline_Funcs funcs{&GlyphReader::move, &GlyphReader::line, &GlyphReader::conic, &GlyphReader::cubic, 0, 0};
  if (FT_Outline_Decompose(&slot->outline, &funcs, &r) != 0) return i->second;
  i->second = r.lines.take();
  return i->second;
}

// A glyph of a line, and the part of the text that it represents.
struct SetGlyph {
  FT_UInt index = 0;
  Vec3 at;
  std::size_t begin = 0, end = 0;  // bytes
};
using SetLine = std::vector<SetGlyph>;  // from left to right

// Sets the end of each glyph's part from the begins of all glyphs.
void find_ends(SetLine& line, std::size_t end) {
  std::vector<SetGlyph*> by_begin;
  for (SetGlyph& g : line) by_begin.push_back(&g);
  std::sort(by_begin.begin(), by_begin.end(), [](const SetGlyph* a, const SetGlyph* b) { return a->begin < b->begin; });
  for (std::size_t i = by_begin.size(), next = end; i-- > 0;) {
    by_begin[i]->end = next;
    if (i > 0 && by_begin[i - 1]->begin < by_begin[i]->begin) next = by_begin[i]->begin;
  }
}

// Sets one line of a text with its baseline at y. `from`: the index of its first byte.
SetLine set_line(Face& face, std::string_view text, std::size_t from, double y, Align align) {
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
  SetLine out;
  Vec3 pen{align == Align::left ? 0 : align == Align::right ? -width : -width / 2, y, 0};
  for (unsigned i = 0; i < count; ++i) {
    const Vec3 shift{static_cast<double>(places[i].x_offset), static_cast<double>(places[i].y_offset), 0};
    out.push_back({infos[i].codepoint, pen + unit * shift, from + infos[i].cluster, 0});
    pen.x += unit * places[i].x_advance;
  }
  find_ends(out, from + text.size());
  return out;
}

// Calls f(glyphs) for each line.
template <class F>
void each_line(Face& face, const std::string& all, Align align, const F& f) {
  const std::string_view text = first_characters(all, most_letters);
  double y = 0;
  for (std::size_t begin = 0; begin <= text.size(); y -= line_spacing) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    f(set_line(face, text.substr(begin, end - begin), begin, y, align));
    begin = end + 1;
  }
}

// Does the same without the letters that are not typed yet.
template <class F>
void each_typed_line(Face& face, const std::string& all, const Letters& letters, const F& f) {
  const std::size_t typed = first_characters(all, letters.typed).size();
  each_line(face, all, letters.align, [&](SetLine line) {
    std::erase_if(line, [&](const SetGlyph& g) { return g.end > typed; });
    f(line);
  });
}

void add_outlines(Face& face, const SetLine& line, const std::string& text, Outline& out) {
  std::size_t first = out.contours.size();  // of the letter that the glyph belongs to
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0 && line[i].begin != line[i - 1].begin) first = out.contours.size();
    const bool begun = out.contours.size() > first;
    for (Contour contour : glyph_of(face, line[i].index)) {
      for (Vec3& p : contour) p = p + line[i].at;
      out.contours.push_back(std::move(contour));
    }
    if (!begun && out.contours.size() > first)
      out.letters.push_back({first, text.substr(line[i].begin, line[i].end - line[i].begin)});
  }
}

// Makes a text of a part of a line. Joiners preserve the contextual forms of its letters.
TextPart part_of(Face& face, const SetLine& whole, std::string_view text) {
  static constexpr std::string_view joiner = "\u200d";
  const auto alike = [](const SetGlyph& a, const SetGlyph& b) { return a.index == b.index; };
  TextPart part;
  SetLine alone;
  for (const int joins : {0, 1, 2, 3, 0}) {
    part.text.clear();
    for (const std::string_view piece : {joins & 1 ? joiner : "", text, joins & 2 ? joiner : ""}) part.text += piece;
    alone = set_line(face, part.text, 0, 0, Align::centre);
    std::erase_if(alone, [&](const SetGlyph& g) { return glyph_of(face, g.index).empty(); });
    if (std::equal(alone.begin(), alone.end(), whole.begin(), whole.end(), alike)) break;
  }
  part.at = whole[0].at - (alone.empty() ? Vec3{} : alone[0].at);
  return part;
}

// Returns the begin and end of each part of a line: runs of letters separated by blank ones, each letter, or the whole
// line.
std::vector<std::pair<std::size_t, std::size_t>> part_ends(Face& face, const SetLine& line, SplitInto into) {
  std::map<std::size_t, std::pair<std::size_t, bool>> letters;  // by begin: the end, and whether it is visible
  for (const SetGlyph& g : line) {
    auto& [end, seen] = letters[g.begin];
    end = g.end, seen = seen || !glyph_of(face, g.index).empty();
  }
  std::vector<std::pair<std::size_t, std::size_t>> out;
  bool open = false;
  for (const auto& [begin, letter] : letters) {
    const auto& [end, seen] = letter;
    if (seen && (into == SplitInto::letters || !open)) out.emplace_back(begin, end);
    if (seen) out.back().second = end;
    open = into == SplitInto::lines ? !out.empty() : into == SplitInto::words && seen;
  }
  return out;
}

}  // namespace

Outline text_outline(const std::string& text, const std::string& family, const Letters& letters) {
  Machine& m = machine();
  const std::lock_guard lock(m.mutex);
  const Typeface typeface{family, letters.weight, letters.italic};
  const std::tuple key{typeface, letters.align, letters.typed, text};
  if (const auto i = m.outlines.find(key); i != m.outlines.end()) return i->second;
  Outline out;
  if (Face* face = face_for(m, typeface))
    each_typed_line(*face, text, letters, [&](const SetLine& line) { add_outlines(*face, line, text, out); });
  if (m.outlines.size() >= 256) m.outlines.clear();  // outlines of texts that always change are not worth caching
  return m.outlines[key] = out;
}

SetText set_text(const std::string& text, const std::string& family, const Letters& letters) {
  Machine& m = machine();
  const std::lock_guard lock(m.mutex);
  SetText out;
  std::map<FT_UInt, std::size_t> known;
  Face* face = face_for(m, {family, letters.weight, letters.italic});
  if (face)
    each_typed_line(*face, text, letters, [&](const SetLine& line) {
      for (const SetGlyph& g : line) {
        const auto [at, fresh] = known.try_emplace(g.index, out.glyphs.size());
        if (fresh) out.glyphs.push_back({g.index, {glyph_of(*face, g.index), {}}});
        if (!out.glyphs[at->second].outline.contours.empty()) out.places.push_back({at->second, g.at});
      }
    });
  return out;
}

std::vector<TextPart> text_parts(const std::string& text, const std::string& family, const Letters& letters,
                                 SplitInto into) {
  Machine& m = machine();
  const std::lock_guard lock(m.mutex);
  std::vector<TextPart> out;
  if (Face* face = face_for(m, {family, letters.weight, letters.italic}))
    each_line(*face, text, letters.align, [&](const SetLine& line) {
      const auto ends = part_ends(*face, line, into);
      std::vector<SetLine> drawn(ends.size());  // of each part, from left to right
      for (const SetGlyph& g : line)
        if (!glyph_of(*face, g.index).empty()) {
          const auto behind = std::upper_bound(ends.begin(), ends.end(), std::pair(g.begin, std::string::npos));
          drawn[static_cast<std::size_t>(behind - ends.begin()) - 1].push_back(g);
        }
      for (std::size_t i = 0; i < ends.size(); ++i)
        out.push_back(
            part_of(*face, drawn[i], std::string_view(text).substr(ends[i].first, ends[i].second - ends[i].first)));
    });
  return out;
}

}  // namespace betwixt
