// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// An open font: it shapes lines of text and gives the outlines of glyphs, in em (1 m an em).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/result.h"
#include "scene/flat_shapes.h"
#include "scene/outline.h"
#include "scene/own_font.h"

struct hb_font_t;

namespace betwixt {

struct ShapedGlyph {
  std::uint32_t number = 0;  // in the font
  std::uint32_t begin = 0;   // the first byte of its letter in the line
  double advance = 0;
  Vec3 shift;  // from the pen
};
// From left to right.
using ShapedGlyphs = std::vector<ShapedGlyph>;
// A line with the outlines of its glyphs, each once: what a parser process returns.
struct ShapedLine {
  ShapedGlyphs glyphs;
  std::vector<std::pair<std::uint32_t, Contours>> outlines;
};

// One thread at a time may use a face.
class FontFace {
 public:
  virtual ~FontFace() = default;
  // Errors: file (the font is damaged or takes too long).
  virtual Result<ShapedGlyphs> shape(std::string_view line) = 0;
  // The outer contours are counter-clockwise. No contours for a glyph that is blank, damaged, or was in no line yet.
  virtual const Contours& glyph(std::uint32_t number) = 0;
  // HarfBuzz's font, for its tables: 64 times the design's units an em. Null for a font that is read elsewhere.
  virtual hb_font_t* shaper() { return nullptr; }
};

// Both return nullptr if the file is no font with outlines. They read it in this process.
std::unique_ptr<FontFace> open_font_file(const std::string& path, int index);
std::unique_ptr<FontFace> open_font_bytes(std::string bytes);

// Shapes one line with the font in the bytes. Errors: file (no font with outlines), range (too many points).
Result<std::shared_ptr<const ShapedLine>> parse_letters(std::string bytes, const std::string& path,
                                                        std::string_view line);

// Opens a font of a stranger: each new line is shaped in the parser's process. After a first failure the face refuses
// all further lines, so that a font that takes long does so once.
std::unique_ptr<FontFace> open_own_font(std::shared_ptr<const OwnFont>);
// Reads a font's file and shapes a few letters. Errors: file, range (more than 32 MiB).
Result<std::shared_ptr<const OwnFont>> load_font(const std::string& path);

}  // namespace betwixt
