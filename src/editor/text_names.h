// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Names in the texts of a film: the name at a place, its definition, and its uses.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "betwixt/document.h"
#include "commands/line_head.h"
#include "editor/line_pieces.h"
#include "syntax/script_text.h"

namespace betwixt {

// A text of a film: the script, or one that it uses.
struct FilmText {
  std::string path;
  ScriptText lines;
};
// A span of one of the texts.
struct TextSpan {
  std::size_t text = 0;
  Span span;
  friend bool operator==(const TextSpan& a, const TextSpan& b) {
    return a.text == b.text && a.span.at == b.span.at && a.span.size == b.span.size;
  }
};

// A name that a line defines, or a pattern that defines many: `create ball{1..3} sphere`.
struct MadeName {
  TextSpan word;
  NameKind kind = NameKind::thing;
  std::size_t verb = 0, verb_size = 0;  // the verb that defines it, in the same line
  bool many = false;
};

struct NameAt {
  std::string name;  // man/arm if the cursor is on `arm` of man/arm/hand
  NameKind kind = NameKind::thing;
  Span span;             // of the whole name
  bool pattern = false;  // it is a pattern, and not a name itself
};

class TextNames {
 public:
  // The texts and the film that they make; both must outlive this object.
  TextNames(std::span<const FilmText>, const Document&);

  std::optional<NameAt> at(std::size_t text, std::size_t place) const;
  // Returns the definitions of a name; of a pattern, those of all names that it matches. The definition of man also
  // defines man/arm if nothing else does.
  std::vector<TextSpan> made(const NameAt&) const;
  // Returns all places with the name itself, definitions included, in the order of the texts.
  std::vector<TextSpan> uses(const NameAt&) const;
  std::span<const MadeName> all() const { return made_; }

 private:
  bool known(const std::string& name, NameKind) const;
  std::optional<NameAt> word_at(std::string_view line, std::size_t from, std::size_t place, const LinePiece&,
                                std::optional<NameKind> must) const;
  std::optional<NameAt> in_text(const ScriptText&, std::size_t line, const LinePiece&, std::size_t place) const;
  void find_made(std::size_t text);

  std::span<const FilmText> texts_;
  const Document& film_;
  std::vector<MadeName> made_;
  std::unordered_map<std::string, std::vector<std::size_t>> by_name_;
};

}  // namespace betwixt
