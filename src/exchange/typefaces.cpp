// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/typefaces.h"

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

#include "base/utf8.h"
#include "scene/text_functions.h"

namespace betwixt {
namespace {

struct FontsDeleter {
  void operator()(FcPattern* p) const { FcPatternDestroy(p); }
  void operator()(FcFontSet* s) const { FcFontSetDestroy(s); }
  void operator()(FcObjectSet* s) const { FcObjectSetDestroy(s); }
};
template <class T>
using OwnedByUs = std::unique_ptr<T, FontsDeleter>;

// Fontconfig's numbers of the weights.
constexpr std::array<int, weight_names.size()> weight_numbers{
    FC_WEIGHT_THIN,     FC_WEIGHT_EXTRALIGHT, FC_WEIGHT_LIGHT,     FC_WEIGHT_REGULAR, FC_WEIGHT_MEDIUM,
    FC_WEIGHT_DEMIBOLD, FC_WEIGHT_BOLD,       FC_WEIGHT_EXTRABOLD, FC_WEIGHT_BLACK};

std::mutex& fonts_mutex() {
  static std::mutex& m = *new std::mutex;  // never destroyed: other threads may still draw at program exit
  return m;
}

const FcChar8* bytes(const std::string& s) { return reinterpret_cast<const FcChar8*>(s.c_str()); }

std::string lowered(std::string s) {
  std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return std::tolower(c); });
  return s;
}

// Sorted, without duplicates.
const std::vector<std::string>& families() {
  static std::vector<std::string>& all = *new std::vector<std::string>;
  if (!all.empty()) return all;
  const OwnedByUs<FcPattern> any(FcPatternCreate());
  const OwnedByUs<FcObjectSet> wanted(FcObjectSetBuild(FC_FAMILY, nullptr));
  const OwnedByUs<FcFontSet> set(FcFontList(nullptr, any.get(), wanted.get()));
  for (int i = 0; set && i < set->nfont; ++i) {
    FcChar8* name = nullptr;
    for (int n = 0; FcPatternGetString(set->fonts[i], FC_FAMILY, n, &name) == FcResultMatch; ++n)
      all.emplace_back(reinterpret_cast<const char*>(name));
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

bool has_family(const std::string& family) {
  const auto& all = families();
  return std::any_of(all.begin(), all.end(), [&](const auto& f) { return lowered(f) == lowered(family); });
}

// Returns the number of letters to change, add or leave out.
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

std::string near_family(const std::string& family) {
  std::string best;
  std::size_t least = 1 + family.size() / 3;
  for (const auto& f : families())
    if (const auto d = distance(lowered(f), lowered(family.substr(0, 100))); d < least) least = d, best = f;
  return best;
}

std::size_t nearest_weight(double number) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < weight_numbers.size(); ++i)
    if (std::abs(weight_numbers[i] - number) < std::abs(weight_numbers[best] - number)) best = i;
  return best;
}

// The styles of a family: whether italic, then the weight. Ignores narrow and wide fonts.
using Styles = std::set<std::pair<bool, std::size_t>>;
Styles styles_of(const std::string& family) {
  const OwnedByUs<FcPattern> pattern(FcPatternCreate());
  FcPatternAddString(pattern.get(), FC_FAMILY, bytes(family));
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  const OwnedByUs<FcObjectSet> wanted(FcObjectSetBuild(FC_WEIGHT, FC_SLANT, FC_WIDTH, nullptr));
  const OwnedByUs<FcFontSet> set(FcFontList(nullptr, pattern.get(), wanted.get()));
  Styles all;
  for (int i = 0; set && i < set->nfont; ++i) {
    const FcPattern* font = set->fonts[i];
    double width = FC_WIDTH_NORMAL;
    if (FcPatternGetDouble(font, FC_WIDTH, 0, &width) == FcResultMatch && std::abs(width - FC_WIDTH_NORMAL) > 5)
      continue;
    int slant = FC_SLANT_ROMAN;
    FcPatternGetInteger(font, FC_SLANT, 0, &slant);
    double weight = FC_WEIGHT_REGULAR;
    FcRange* range = nullptr;  // of a font with variable weight
    double low = 0, high = 0;
    if (FcPatternGetDouble(font, FC_WEIGHT, 0, &weight) == FcResultMatch) {
      all.emplace(slant != FC_SLANT_ROMAN, nearest_weight(weight));
    } else if (FcPatternGetRange(font, FC_WEIGHT, 0, &range) == FcResultMatch && FcRangeGetDouble(range, &low, &high)) {
      for (std::size_t w = nearest_weight(low); w <= nearest_weight(high); ++w) all.emplace(slant != FC_SLANT_ROMAN, w);
    }
  }
  return all;
}

std::string style_name(std::size_t weight, bool italic) {
  return fmt::format("{}{}", weight_names[weight], italic ? " italic" : "");
}

}  // namespace

Status find_font(const std::string& family) {
  const std::lock_guard lock(fonts_mutex());
  if (has_family(family)) return Nothing{};
  const std::string near = near_family(family);
  return fail(ErrorCode::name, fmt::format("this machine has no font called \"{}\"", family),
              near.empty() ? "" : fmt::format("did you mean \"{}\"?", near));
}

Status find_style(const Typeface& face) {
  const std::lock_guard lock(fonts_mutex());
  if (!has_family(face.family)) return Nothing{};
  const Styles all = styles_of(face.family);
  const auto weight = static_cast<std::size_t>(face.weight);
  if (all.contains({face.italic, weight})) return Nothing{};
  std::string there;
  for (const auto& [italic, w] : all) there += fmt::format("{}{}", there.empty() ? "" : ", ", style_name(w, italic));
  return fail(
      ErrorCode::name,
      fmt::format("the font \"{}\" has no style \"{}\" on this machine", face.family, style_name(weight, face.italic)),
      fmt::format("there is {}", there));
}

namespace {

// The best match. The caller has the lock.
OwnedByUs<FcPattern> best_match(const Typeface& face) {
  const OwnedByUs<FcPattern> pattern(FcPatternCreate());
  FcPatternAddString(pattern.get(), FC_FAMILY, bytes(has_family(face.family) ? face.family : "DejaVu Sans"));
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  FcPatternAddInteger(pattern.get(), FC_WEIGHT, weight_numbers[static_cast<std::size_t>(face.weight)]);
  FcPatternAddInteger(pattern.get(), FC_SLANT, face.italic ? FC_SLANT_ITALIC : FC_SLANT_ROMAN);
  FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult found = FcResultNoMatch;
  return OwnedByUs<FcPattern>(FcFontMatch(nullptr, pattern.get(), &found));
}

// Whether a letter is drawn, if the font has it.
bool is_drawn(char32_t c) {
  return c > 0x20 && c != 0x7F && !(c >= 0x80 && c <= 0xA0) && c != 0xAD && !(c >= 0x2000 && c <= 0x200F) &&
         !(c >= 0x2028 && c <= 0x202F) && !(c >= 0x205F && c <= 0x206F) && c != 0x3000 &&
         !(c >= 0xFE00 && c <= 0xFE0F) && c != 0xFEFF && c < 0xE0000;
}

}  // namespace

FontFile font_file(const Typeface& face) {
  const std::lock_guard lock(fonts_mutex());
  const OwnedByUs<FcPattern> match = best_match(face);
  FcChar8* file = nullptr;
  FontFile out;
  if (!match || FcPatternGetString(match.get(), FC_FILE, 0, &file) != FcResultMatch) return out;
  FcPatternGetInteger(match.get(), FC_INDEX, 0, &out.index);
  out.path = reinterpret_cast<const char*>(file);
  return out;
}

std::string missing_letter(const Typeface& face, std::string_view text) {
  const std::lock_guard lock(fonts_mutex());
  const OwnedByUs<FcPattern> match = best_match(face);
  FcCharSet* letters = nullptr;
  if (!match || FcPatternGetCharSet(match.get(), FC_CHARSET, 0, &letters) != FcResultMatch) return {};
  for (std::size_t i = 0, n = 0; i < text.size(); i += n) {
    n = std::max<std::size_t>(character_length(text, i), 1);
    FcChar32 c = 0;
    if (FcUtf8ToUcs4(reinterpret_cast<const FcChar8*>(text.data() + i), &c, static_cast<int>(n)) <= 0) continue;
    if (is_drawn(c) && !FcCharSetHasChar(letters, c)) return std::string(text.substr(i, n));
  }
  return {};
}

}  // namespace betwixt
