// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The fonts of a page: a built-in one, and the font files of its films.
#include "exchange/typefaces.h"

#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_TRUETYPE_TABLES_H

#include <algorithm>
#include <cstdio>
#include <vector>

#include "scene/text_functions.h"
#include "typefaces.h"

namespace betwixt {

extern const unsigned char usual_font[];  // a subset of DejaVu Sans, made by the build
extern const unsigned usual_font_size;

namespace {

struct Known {
  Typeface face;
  std::string path;
};

constexpr const char* usual_family = "DejaVu Sans";
constexpr const char* usual_path = "/fonts/usual.ttf";

std::vector<Known>& fonts() {
  static std::vector<Known> all = [] {
    if (std::FILE* file = std::fopen(usual_path, "wb")) {
      std::fwrite(usual_font, 1, usual_font_size, file);
      std::fclose(file);
    }
    return std::vector<Known>{{{usual_family}, usual_path}};
  }();
  return all;
}

bool same_name(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

// Returns how far a font is from the wanted one. Another family counts for more than style and weight together.
int distance(const Known& font, const Typeface& wanted) {
  return 100 * !same_name(font.face.family, wanted.family) + 10 * (font.face.italic != wanted.italic) +
         std::abs(static_cast<int>(font.face.weight) - static_cast<int>(wanted.weight));
}

const Known& nearest(const Typeface& wanted) {
  const auto& all = fonts();
  return *std::min_element(all.begin(), all.end(),
                           [&](const Known& a, const Known& b) { return distance(a, wanted) < distance(b, wanted); });
}

}  // namespace

bool add_font(const std::string& path) {
  static FT_Library library = nullptr;
  if (library == nullptr && FT_Init_FreeType(&library) != 0) return false;
  FT_Face face = nullptr;
  if (FT_New_Face(library, path.c_str(), 0, &face) != 0) return false;
  // The table gives weights from 100 to 900.
  const auto* table = static_cast<const TT_OS2*>(FT_Get_Sfnt_Table(face, FT_SFNT_OS2));
  const int hundreds = table != nullptr ? std::clamp((table->usWeightClass + 50) / 100, 1, 9) : 4;
  Known known{{face->family_name != nullptr ? face->family_name : "", static_cast<Weight>(hundreds - 1),
               (face->style_flags & FT_STYLE_FLAG_ITALIC) != 0},
              path};
  FT_Done_Face(face);
  std::erase_if(fonts(), [&](const Known& k) { return k.face == known.face; });
  fonts().push_back(std::move(known));
  return true;
}

Status find_font(const std::string& family) {
  if (same_name(nearest({family}).face.family, family)) return Nothing{};
  return fail(ErrorCode::name, fmt::format("this page has no font called \"{}\"", family),
              "a page made by betwixt web brings the fonts of its film along");
}

Status find_style(const Typeface& face) {
  const Known& near = nearest(face);
  if (!same_name(near.face.family, face.family) || distance(near, face) == 0) return Nothing{};
  return fail(
      ErrorCode::name,
      fmt::format("this page has no {}{} of the font \"{}\"", weight_names[static_cast<std::size_t>(face.weight)],
                  face.italic ? " italic" : "", face.family),
      "a page made by betwixt web brings the fonts of its film along");
}

FontFile font_file(const Typeface& face) {
  // Without this family, returns the built-in font.
  const Known& near = nearest(face);
  return {same_name(near.face.family, face.family) ? near.path : nearest({usual_family, face.weight, face.italic}).path,
          0};
}

// Who edits a page sees the letters.
std::string missing_letter(const Typeface&, std::string_view) { return {}; }

}  // namespace betwixt
