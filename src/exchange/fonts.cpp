// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/fonts.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "base/utf8.h"
#include "exchange/font_face.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr std::size_t most_own_faces = 64;

// The open fonts of one sort. Its lock protects all of them.
struct Faces {
  std::mutex mutex;
  std::map<Typeface, std::shared_ptr<FontFace>> faces;  // by the requested typeface; nullptr: no font is available
  std::map<std::tuple<Typeface, Align, std::uint32_t, Anchor, double, std::string>, Outline> outlines;
};

// Fonts of strangers have a lock of their own: whoever uses them waits for a parser, and nobody else does.
Faces& faces_for(const FontName& font) {
  static Faces& installed = *new Faces;  // never destroyed: other threads may still draw at program exit
  static Faces& own = *new Faces;
  return font.own ? own : installed;
}

std::shared_ptr<FontFace> open_installed(const Typeface& typeface) {
  const auto [file, index] = font_file(typeface);
  return file.empty() ? nullptr : open_font_file(file, index);
}

FontFace* face_for(Faces& all, const FontName& font, const Letters& letters) {
  const Typeface typeface = typeface_of(font, letters);
  if (font.own && all.faces.size() >= most_own_faces && !all.faces.contains(typeface))
    all.faces.clear(), all.outlines.clear();
  const auto [i, fresh] = all.faces.try_emplace(typeface);
  if (fresh) i->second = font.own ? open_own_font(font.own) : open_installed(typeface);
  return i->second.get();
}

// A glyph of a line, and the part of the text that it represents.
struct SetGlyph {
  std::uint32_t index = 0;
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
SetLine set_line(FontFace& face, std::string_view text, std::size_t from, double y, Align align) {
  const auto shaped = face.shape(text);
  if (!shaped) return {};
  double width = 0;
  for (const ShapedGlyph& g : *shaped) width += g.advance;
  SetLine out;
  Vec3 pen{align == Align::left ? 0 : align == Align::right ? -width : -width / 2, y, 0};
  for (const ShapedGlyph& g : *shaped) {
    out.push_back({g.number, pen + g.shift, from + g.begin, 0});
    pen.x += g.advance;
  }
  find_ends(out, from + text.size());
  return out;
}

// The first byte of a line, and the one behind its last.
struct LineEnds {
  std::size_t begin, end;
};

// Breaks a line at blanks, so that the lines are at most `wrap` wide. Breaks between letters where a word is wider.
// Blanks at a break are in no line.
void wrap_line(FontFace& face, std::string_view text, LineEnds whole, double wrap, std::vector<LineEnds>& out) {
  constexpr std::size_t none = std::string_view::npos;
  std::vector<double> advance(whole.end - whole.begin + 1);  // of each letter, by its first byte
  if (const auto shaped = face.shape(text.substr(whole.begin, whole.end - whole.begin)))
    for (const ShapedGlyph& g : *shaped) advance[g.begin] += g.advance;
  std::size_t begin = whole.begin, blank = none;  // of the open line: its first byte, and its last blank
  double width = 0, behind_blank = 0;
  const double most = wrap * (1 + 1e-9);
  for (std::size_t at = whole.begin; at < whole.end; ++at) {
    const double more = advance[at - whole.begin];
    if (text[at] == ' ') {
      blank = at, width += more, behind_blank = 0;
      continue;
    }
    while (more > 0 && width + more > most && at > begin) {
      std::size_t end = blank == none ? at : blank;
      const std::size_t next = blank == none ? at : blank + 1;
      while (end > begin && text[end - 1] == ' ') --end;
      out.push_back({begin, end});
      begin = next, width = blank == none ? 0 : behind_blank, blank = none;
    }
    width += more, behind_blank += more;
  }
  out.push_back({begin, whole.end});
}

// Calls f(glyphs) for each line.
template <class F>
void each_line(FontFace& face, const std::string& all, const Letters& letters, const F& f) {
  const std::string_view text = first_characters(all, most_letters);
  std::vector<LineEnds> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const LineEnds line{begin, std::min(text.find('\n', begin), text.size())};
    letters.wrap > 0 ? wrap_line(face, text, line, letters.wrap, lines) : lines.push_back(line);
    begin = line.end + 1;
  }
  double y = first_baseline(letters.anchor, static_cast<double>(lines.size()));
  for (const LineEnds& line : lines) {
    f(set_line(face, text.substr(line.begin, line.end - line.begin), line.begin, y, letters.align));
    y -= line_spacing;
  }
}

// Does the same without the letters that are not typed yet.
template <class F>
void each_typed_line(FontFace& face, const std::string& all, const Letters& letters, const F& f) {
  const std::size_t typed = first_characters(all, letters.typed).size();
  each_line(face, all, letters, [&](SetLine line) {
    std::erase_if(line, [&](const SetGlyph& g) { return g.end > typed; });
    f(line);
  });
}

void add_outlines(FontFace& face, const SetLine& line, const std::string& text, Outline& out) {
  std::size_t first = out.contours.size();  // of the letter that the glyph belongs to
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0 && line[i].begin != line[i - 1].begin) first = out.contours.size();
    const bool begun = out.contours.size() > first;
    for (Contour contour : face.glyph(line[i].index)) {
      for (Vec3& p : contour) p = p + line[i].at;
      out.contours.push_back(std::move(contour));
    }
    if (!begun && out.contours.size() > first)
      out.letters.push_back({first, text.substr(line[i].begin, line[i].end - line[i].begin), {}, line[i].begin});
  }
}

// Makes a text of a part of a line. Joiners preserve the contextual forms of its letters.
TextPart part_of(FontFace& face, const SetLine& whole, std::string_view text) {
  static constexpr std::string_view joiner = "\u200d";
  const auto alike = [](const SetGlyph& a, const SetGlyph& b) { return a.index == b.index; };
  TextPart part;
  SetLine alone;
  for (const int joins : {0, 1, 2, 3, 0}) {
    part.text.clear();
    for (const std::string_view piece : {joins & 1 ? joiner : "", text, joins & 2 ? joiner : ""}) part.text += piece;
    alone = set_line(face, part.text, 0, 0, Align::centre);
    std::erase_if(alone, [&](const SetGlyph& g) { return face.glyph(g.index).empty(); });
    if (std::equal(alone.begin(), alone.end(), whole.begin(), whole.end(), alike)) break;
  }
  part.at = whole[0].at - (alone.empty() ? Vec3{} : alone[0].at);
  return part;
}

// Returns the begin and end of each part of a line: runs of letters separated by blank ones, each letter, or the whole
// line.
std::vector<std::pair<std::size_t, std::size_t>> part_ends(FontFace& face, const SetLine& line, SplitInto into) {
  std::map<std::size_t, std::pair<std::size_t, bool>> letters;  // by begin: the end, and whether it is visible
  for (const SetGlyph& g : line) {
    auto& [end, seen] = letters[g.begin];
    end = g.end, seen = seen || !face.glyph(g.index).empty();
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

Outline text_outline(const std::string& text, const FontName& font, const Letters& letters) {
  Faces& all = faces_for(font);
  const std::lock_guard lock(all.mutex);
  FontFace* face = face_for(all, font, letters);
  const std::tuple key{typeface_of(font, letters), letters.align, letters.typed, letters.anchor, letters.wrap, text};
  if (const auto i = all.outlines.find(key); i != all.outlines.end()) return i->second;
  Outline out;
  if (face) each_typed_line(*face, text, letters, [&](const SetLine& line) { add_outlines(*face, line, text, out); });
  if (all.outlines.size() >= 256) all.outlines.clear();  // outlines of texts that always change are not worth caching
  return all.outlines[key] = out;
}

SetText set_text(const std::string& text, const FontName& font, const Letters& letters) {
  Faces& all = faces_for(font);
  const std::lock_guard lock(all.mutex);
  SetText out;
  std::map<std::uint32_t, std::size_t> known;
  FontFace* face = face_for(all, font, letters);
  if (face)
    each_typed_line(*face, text, letters, [&](const SetLine& line) {
      for (const SetGlyph& g : line) {
        const auto [at, fresh] = known.try_emplace(g.index, out.glyphs.size());
        if (fresh) out.glyphs.push_back({g.index, {face->glyph(g.index), {}}});
        if (!out.glyphs[at->second].outline.contours.empty()) out.places.push_back({at->second, g.at});
      }
    });
  return out;
}

std::vector<TextPart> text_parts(const std::string& text, const FontName& font, const Letters& letters,
                                 SplitInto into) {
  Faces& all = faces_for(font);
  const std::lock_guard lock(all.mutex);
  std::vector<TextPart> out;
  if (FontFace* face = face_for(all, font, letters))
    each_line(*face, text, letters, [&](const SetLine& line) {
      const auto ends = part_ends(*face, line, into);
      std::vector<SetLine> drawn(ends.size());  // of each part, from left to right
      for (const SetGlyph& g : line)
        if (!face->glyph(g.index).empty()) {
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
