// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/renaming.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "base/names.h"
#include "scene/document.h"
#include "scene/names.h"
#include "scene/own_kinds.h"

namespace betwixt {
namespace {

bool is_taken(const Scene& s, const NameAt& of, const std::string& name) {
  switch (of.kind) {
    case NameKind::thing:
      return s.names.find(name) || s.aliases->contains(name) || s.lists->contains(name);
    case NameKind::let:
      return s.lets->contains(name);
    case NameKind::function:
      return s.defined->find(name).has_value();
    case NameKind::procedure:
      return find_procedure(s, name) != nullptr;
    case NameKind::kind:
      return find_kind(name) || s.kinds->find(name);
  }
  return false;
}

bool can_be_name(NameKind kind, const std::string& name) {
  if (kind == NameKind::let) return is_name(name) && name.find_first_of("-/") == std::string::npos;
  return is_name(name) && (kind == NameKind::thing || name.find('/') == std::string::npos);
}

std::size_t errors_in(const Loaded& film) {
  return static_cast<std::size_t>(std::ranges::count(film.diagnostics, Severity::error, &Diagnostic::severity));
}

std::vector<std::string> with_name(std::span<const FilmText> texts, std::span<const TextSpan> places,
                                   const std::string& to) {
  std::vector<std::string> all;
  for (std::size_t t = 0; t < texts.size(); ++t) {
    std::vector<Span> here;
    for (const TextSpan& p : places)
      if (p.text == t) here.push_back(p.span);
    all.push_back(with_others(texts[t].lines.text(), here, to));
  }
  return all;
}

// Returns true if the aliases of both scenes name the same objects, however they are written.
bool same_aliases(const Scene& a, const Scene& b) {
  const auto names = [](const Scene& s, const std::string& alias) {
    std::vector<std::string> all;
    for (const ObjectId id : select(s, alias)) all.push_back(object_name(s, id));
    return all;
  };
  return std::ranges::equal(*a.aliases, *b.aliases, [&](const auto& x, const auto& y) {
    return x.first == y.first && (x.second == y.second || names(a, x.first) == names(b, y.first));
  });
}

// For things in a document, `rename` gives the expected result: the changed texts must make the same.
bool makes_the_same(std::span<const FilmText> texts, const NameAt& name, const std::string& to, const Loaded& then,
                    const LoadTexts& load) {
  std::vector<std::string> said;
  for (const FilmText& t : texts) said.push_back(t.lines.text());
  said[0] += fmt::format("\nrename {} {}\n", name.name, to);
  const Document wanted = load(said).document;
  Scene made = then.document.scene();
  if (same_aliases(made, wanted.scene())) made.aliases = wanted.scene().aliases;
  return same(made, wanted.scene());
}

}  // namespace

std::string with_others(std::string text, std::span<const Span> places, std::string_view others) {
  for (const Span& s : std::views::reverse(places)) text.replace(s.at, s.size, others);
  return text;
}

Result<NameAt> to_rename(const TextNames& names, std::size_t text, std::size_t place) {
  const auto found = names.at(text, place);
  if (!found) return fail(ErrorCode::name, "there is no name here that can be renamed");
  if (found->pattern)
    return fail(ErrorCode::name, fmt::format("'{}' is a pattern; rename one of its objects instead", found->name));
  const std::vector<TextSpan> made = names.made(*found);
  const auto is_made = [&](const MadeName& m) { return !made.empty() && m.word == made[0]; };
  const auto by = std::ranges::find_if(names.all(), is_made);
  if (by == names.all().end())
    return fail(ErrorCode::name, fmt::format("no line of these files creates '{}'", found->name));
  const std::vector<TextSpan> uses = names.uses(*found);
  if (by->many || std::ranges::find(uses, made[0]) == uses.end())
    return fail(
        ErrorCode::name,
        fmt::format("a pattern or another line creates '{}' together with other objects, so it cannot be renamed alone",
                    found->name));
  return *found;
}

Result<std::vector<TextSpan>> renaming(std::span<const FilmText> texts, const TextNames& names, const Loaded& film,
                                       const NameAt& name, const std::string& to, const LoadTexts& load) {
  if (!can_be_name(name.kind, to)) return fail(ErrorCode::syntax, fmt::format("'{}' cannot be a name here", to));
  if (to == name.name) return std::vector<TextSpan>();
  const Scene& scene = film.document.scene();
  if (is_taken(scene, name, to)) return fail(ErrorCode::name, fmt::format("'{}' already exists", to));
  std::vector<TextSpan> places = names.uses(name);
  const std::vector<std::string> said = with_name(texts, places, to);
  const Loaded then = load(said);
  std::vector<FilmText> then_texts;
  for (const std::string& text : said) then_texts.push_back({texts[then_texts.size()].path, ScriptText(text)});
  NameAt renamed = name;
  renamed.name = to;
  if (TextNames(then_texts, then.document).uses(renamed).size() != places.size())
    return fail(ErrorCode::name, fmt::format("'{}' is already used in a line, although nothing has this name", to));
  const bool alias = scene.aliases->contains(name.name);
  const bool stands = scene.names.find(name.name) || scene.lists->contains(name.name);
  const bool same =
      errors_in(then) <= errors_in(film) &&
      (name.kind != NameKind::thing || alias ||
       (stands ? makes_the_same(texts, name, to, then, load) : then.document == film.document));  // deleted later
  if (same) return places;
  return fail(
      ErrorCode::name,
      has_errors(film.diagnostics)
          ? fmt::format("'{}' cannot be renamed to '{}' while the script has errors", name.name, to)
          : fmt::format("renaming would change the film: a pattern or code refers to '{}' in another way", name.name));
}

}  // namespace betwixt
