// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/translating.h"

#include <fmt/format.h>

#include "base/files.h"
#include "language/translations.h"

namespace betwixt {
namespace {

std::string with_place(const Error& e) {
  return e.place.file.empty() ? e.message : fmt::format("{}:{}: {}", e.place.file, e.place.line, e.message);
}

bool language(Command& k) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  const char* const start = c.at;
  std::string name;
  if (!c.text(name)) return false;
  const std::string_view about = c.since(start);
  if (!finish(c)) return false;
  if (script.texts_shown && script.whole)  // a live author sees which texts change
    return c.fail(ErrorCode::syntax, "`language` must come before the first text", about);
  if (script.options.language) return true;  // another one is wanted
  std::filesystem::path where;
  if (!may_use(k, name, about, where)) return false;
  const Result<std::string> text = read_whole(where.string());
  if (!text) return c.fail(text.error(), about);
  Result<Translations> read = read_po(*text, script.shown(where));
  if (!read) return c.fail(read.error().code, with_place(read.error()), about, Hint(read.error().hint));
  script.translations = std::make_shared<const Translations>(*std::move(read));
  return true;
}

constexpr Verb translating_rows[] = {
    {"language", "language \"FILE.po\"",
     "Shows the texts of the lines below in another language: as the gettext catalogue has them. Texts that it lacks "
     "stay "
     "as they are written. `betwixt check FILE --po OUT.pot` writes the catalogue to translate.",
     "language \"de.po\"\ncreate title text text=\"The end\"", Verb::once, language, "FILE"},
};

}  // namespace

std::span<const Verb> translating_verbs() { return translating_rows; }

bool is_read_by_people(FunctionId f) {
  if (f == fn::text) return true;
  const auto built_in = built_in_functions();
  if (f >= built_in.size()) return false;  // the author's own, or none
  const std::string_view name = built_in[f].name;
  return name.size() == 7 && name.ends_with("-title");  // x-title, y-title
}

void translate_text(Script& script, std::string& text, std::string_view about) {
  if (text.empty()) return;
  script.texts_shown = true;
  if (script.options.shows) script.options.shows(text, script.source.diagnose(Severity::notice, {}, about).what.place);
  if (!script.translations) return;
  if (const auto found = script.translations->find(text); found != script.translations->end()) text = found->second;
}

void begin_translation(Script& script) {
  if (!script.options.language || script.options.language->empty() || script.translations) return;
  const std::string& path = *script.options.language;
  const Result<std::string> text = read_whole(path);
  Result<Translations> read = text ? read_po(*text, path) : Result<Translations>(text.error());
  if (read)
    script.translations = std::make_shared<const Translations>(*std::move(read));
  else
    script.diagnostics.push_back({Severity::error, read.error(), {}, 0});
}

}  // namespace betwixt
