// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Names in the texts of a film: what stands at a place, where it is made, and where it is spoken of.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "betwixt/document.h"
#include "editor/text_lines.h"

namespace betwixt {

// An object, a layer, an environment, a display list or an alias; what `let` gave; a function, or code, of the
// author's.
enum class NameKind : std::uint8_t { thing, let, function, procedure };

// A text that a film is made of: the script, or one that it uses.
struct FilmText {
  std::string path;
  TextLines lines;
};
// A part of one of them.
struct TextSpan {
  std::size_t text = 0;
  Span span;
  friend bool operator==(const TextSpan& a, const TextSpan& b) {
    return a.text == b.text && a.span.at == b.span.at && a.span.size == b.span.size;
  }
};

// A name that a line makes, or a pattern that makes many: `create ball{1..3} sphere`.
struct MadeName {
  TextSpan word;
  NameKind kind = NameKind::thing;
  std::size_t verb = 0, verb_size = 0;  // that makes it, in the same line
  bool many = false;
};

struct NameAt {
  std::string name;  // man/arm, where the cursor is on `arm` of man/arm/hand
  NameKind kind = NameKind::thing;
  Span span;             // of the name as a whole
  bool pattern = false;  // it names what it matches, and is no name itself
};

class TextNames {
 public:
  // Of texts and the film that they make; both must stay.
  TextNames(std::span<const FilmText>, const Document&);

  std::optional<NameAt> at(std::size_t text, std::size_t place) const;
  // What makes it: of a pattern what makes all that it names. What makes man makes man/arm, where nothing else does.
  std::vector<TextSpan> made(const NameAt&) const;
  // Wherever it is spoken of by its own name, where it is made too, in the order of the texts.
  std::vector<TextSpan> uses(const NameAt&) const;
  std::span<const MadeName> all() const { return made_; }

 private:
  bool known(const std::string& name, NameKind) const;
  std::optional<NameAt> word_at(std::string_view line, std::size_t from, std::size_t place, const LinePiece&,
                                std::optional<NameKind> must) const;
  std::optional<NameAt> in_text(const TextLines&, std::size_t line, const LinePiece&, std::size_t place) const;
  void find_made(std::size_t text);

  std::span<const FilmText> texts_;
  const Document& film_;
  std::vector<MadeName> made_;
  std::unordered_map<std::string, std::vector<std::size_t>> by_name_;
};

// The word that a line gives as a name, and the verb that makes it.
struct Making {
  std::string_view verb, word;
  NameKind kind = NameKind::thing;
};
std::optional<Making> making(std::string_view line);

}  // namespace betwixt
