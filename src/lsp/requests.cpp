// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The requests of the protocol, one row each.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "editor/help.h"
#include "editor/placing.h"
#include "editor/text_features.h"
#include "lsp/state.h"
#include "scene/colors.h"
#include "scene/document.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

using State = LanguageServer::State;

constexpr std::size_t most_words = 1000;  // offered at once

LspRefusal no_text() { return {LspRefusal::bad_parameters, "the document is not open, or the position is missing"}; }

Json start(State& s, const Json&) {
  s.begun = true;
  return {{"capabilities", lsp_capabilities()}, {"serverInfo", {{"name", "betwixt"}}}};
}
Json shut_down(State& s, const Json&) {
  s.shut = true;
  return nullptr;
}

// A position in a text, and the film that the text belongs to.
struct Asked {
  OpenScript& script;
  OpenScript& root;
  std::size_t place = 0;
  const Document& film() const { return root.film.document; }
};
std::optional<Asked> asked(State& s, const Json& params) {
  OpenScript* const script = s.find(params);
  const auto place = script ? place_of(script->lines, member(params, "position")) : std::nullopt;
  if (!place) return std::nullopt;
  return Asked{*script, s.root_of(*script), *place};
}
// The same, with the names of the film and the name at the position.
struct AskedName {
  Asked at;
  const TextNames& names;
  std::size_t text = 0;
  std::optional<NameAt> name() const { return names.at(text, at.place); }
};
std::optional<AskedName> asked_name(State& s, const Json& params) {
  const auto at = asked(s, params);
  if (!at) return std::nullopt;
  const TextNames& names = s.names_of(at->root);
  return AskedName{*at, names, s.text_in(at->root, at->script)};
}

Json location(const State& s, const OpenScript& root, const TextSpan& at) {
  const FilmText& text = root.texts[at.text];
  const std::string uri = at.text == 0 ? root.uri : s.uri_of(text.path);
  return {{"uri", uri}, {"range", range_of(text.lines, at.span)}};
}
Json locations(const State& s, const OpenScript& root, const std::vector<TextSpan>& all) {
  Json out = Json::array();
  for (const TextSpan& at : all) out.push_back(location(s, root, at));
  return out;
}

Json as_code(const std::string& said) { return {{"kind", "markdown"}, {"value", "```betwixt\n" + said + "```"}}; }

// Kinds of completions and of symbols, by the protocol's numbers.
int kind_of_word(std::string_view word, const Document& d) {
  constexpr int function = 3, variable = 6, type = 7, property = 10, keyword = 14, color = 16, file = 17, member = 20;
  if (word.ends_with('=') || word.find('.') != std::string_view::npos) {
    const bool target = word.ends_with('=') || d.find(word.substr(0, word.find('.')));
    return target ? property : file;
  }
  if (d.find(word)) return variable;
  if (named_color(word)) return color;
  for (const HelpEntry& e : help_entries()) {
    if (e.word != word) continue;
    if (e.group == HelpGroup::kind) return type;
    if (e.group == HelpGroup::function) return property;
    if (e.group == HelpGroup::twerper) return member;
    if (e.group == HelpGroup::filter) return function;
  }
  return keyword;
}

LspAnswer completion(State& s, const Json& params) {
  const auto at = asked(s, params);
  if (!at) return no_text();
  const std::filesystem::path folder = std::filesystem::path(at->script.path).parent_path();
  const Completions found = completions_at(at->script.lines, at->place, at->film(), folder.empty() ? "." : folder);
  const Json range = range_of(at->script.lines, {found.from, at->place - found.from});
  Json items = Json::array();
  for (const std::string& word : found.words) {
    if (items.size() == most_words) break;
    Json item{
        {"label", word}, {"kind", kind_of_word(word, at->film())}, {"textEdit", {{"range", range}, {"newText", word}}}};
    if (const std::string_view sentence = sentence_of(word, found.kind); !sentence.empty())
      item["documentation"] = sentence;
    items.push_back(std::move(item));
  }
  return Json{{"isIncomplete", found.words.size() > most_words}, {"items", std::move(items)}};
}

LspAnswer hover(State& s, const Json& params) {
  const auto at = asked_name(s, params);
  if (!at) return no_text();
  const auto found = hover_at(at->names, at->at.root.texts[at->text], at->text, at->at.place, at->at.film());
  if (!found) return Json(nullptr);
  return Json{{"contents", as_code(found->said)}, {"range", range_of(at->at.script.lines, found->word)}};
}

LspAnswer signature_help(State& s, const Json& params) {
  const auto at = asked(s, params);
  if (!at) return no_text();
  const auto usage = usage_at(at->script.lines, at->place);
  if (!usage) return Json(nullptr);
  Json one{{"label", usage->written}, {"documentation", usage->sentence}};
  return Json{{"signatures", Json::array({std::move(one)})}, {"activeSignature", 0}};
}

LspAnswer definition(State& s, const Json& params) {
  const auto at = asked_name(s, params);
  if (!at) return no_text();
  const OpenScript& root = at->at.root;
  if (const auto file = used_at(at->at.script.lines, at->at.place)) {
    const auto path = std::filesystem::path(at->at.script.path).parent_path() / *file;
    std::error_code none;
    if (at->at.script.path.empty() || !std::filesystem::is_regular_file(path, none)) return Json::array();
    const Json zero{{"line", 0}, {"character", 0}};
    return Json::array({{{"uri", s.uri_of(path.string())}, {"range", {{"start", zero}, {"end", zero}}}}});
  }
  const auto name = at->name();
  return name ? locations(s, root, at->names.made(*name)) : Json::array();
}

LspAnswer references(State& s, const Json& params) {
  const auto at = asked_name(s, params);
  if (!at) return no_text();
  const auto name = at->name();
  if (!name) return Json::array();
  std::vector<TextSpan> all = at->names.uses(*name);
  if (member(member(params, "context"), "includeDeclaration") == false) {
    const std::vector<TextSpan> made = at->names.made(*name);
    std::erase_if(all, [&](const TextSpan& use) { return std::ranges::find(made, use) != made.end(); });
  }
  return locations(s, at->at.root, all);
}

LspAnswer highlights(State& s, const Json& params) {
  const auto at = asked_name(s, params);
  if (!at) return no_text();
  Json all = Json::array();
  if (const auto name = at->name())
    for (const TextSpan& use : at->names.uses(*name))
      if (use.text == at->text) all.push_back({{"range", range_of(at->at.script.lines, use.span)}});
  return all;
}

LspRefusal because(const Error& e) {
  return {LspRefusal::failed, e.hint.empty() ? e.message : e.message + "; " + e.hint};
}

LspAnswer prepare_rename(State& s, const Json& params) {
  const auto at = asked_name(s, params);
  if (!at) return no_text();
  const Result<NameAt> name = to_rename(at->names, at->text, at->at.place);
  if (!name) return because(name.error());
  return Json{{"range", range_of(at->at.script.lines, name->span)}, {"placeholder", name->name}};
}

LspAnswer rename_it(State& s, const Json& params) {
  const auto at = asked_name(s, params);
  const Json& to = member(params, "newName");
  if (!at || !to.is_string()) return no_text();
  const Result<NameAt> name = to_rename(at->names, at->text, at->at.place);
  if (!name) return because(name.error());
  const OpenScript& root = at->at.root;
  const LoadTexts load = [&](const std::vector<std::string>& texts) {
    std::vector<std::pair<std::string, std::string>> said;
    for (std::size_t i = 0; i < texts.size(); ++i)
      said.emplace_back(i == 0 ? root.real : real_path(root.texts[i].path), texts[i]);
    return s.load(root, said);
  };
  const auto places = renaming(root.texts, at->names, root.film, *name, to.get<std::string>(), load);
  if (!places) return because(places.error());
  Json changes = Json::object();
  for (const TextSpan& place : *places) {
    const Json where = location(s, root, place);
    changes[where["uri"].get<std::string>()].push_back({{"range", where["range"]}, {"newText", to}});
  }
  return Json{{"changes", std::move(changes)}};
}

int kind_of_symbol(const TextSymbol& symbol) {
  constexpr int property = 7, function = 12, variable = 13, object = 19, event = 24;
  if (!symbol.made) return event;
  return *symbol.made == NameKind::thing      ? object
         : *symbol.made == NameKind::let      ? variable
         : *symbol.made == NameKind::function ? property
                                              : function;
}

LspAnswer document_symbols(State& s, const Json& params) {
  OpenScript* const script = s.find(params);
  if (!script) return no_text();
  Json all = Json::array();
  for (const TextSymbol& symbol : symbols(script->lines))
    all.push_back({{"name", symbol.name},
                   {"detail", symbol.detail},
                   {"kind", kind_of_symbol(symbol)},
                   {"range", range_of(script->lines, symbol.whole)},
                   {"selectionRange", range_of(script->lines, symbol.word)}});
  return all;
}

LspAnswer folding(State& s, const Json& params) {
  OpenScript* const script = s.find(params);
  if (!script) return no_text();
  Json all = Json::array();
  for (const Fold& fold : folds(script->lines)) {
    Json one{{"startLine", fold.first}, {"endLine", fold.last}};
    if (fold.remark) one["kind"] = "comment";
    all.push_back(std::move(one));
  }
  return all;
}

LspAnswer document_colors(State& s, const Json& params) {
  OpenScript* const script = s.find(params);
  if (!script) return no_text();
  const OpenScript& root = s.root_of(*script);
  Json all = Json::array();
  for (const ColorAt& at : colors_in(script->lines, root.film.document)) {
    const auto share = [](double v) { return std::clamp(v, 0.0, 1.0); };
    all.push_back(
        {{"range", range_of(script->lines, at.span)},
         {"color",
          {{"red", share(at.color.r)}, {"green", share(at.color.g)}, {"blue", share(at.color.b)}, {"alpha", 1}}}});
  }
  return all;
}

LspAnswer color_presentations(State& s, const Json& params) {
  OpenScript* const script = s.find(params);
  const Json &color = member(params, "color"), &range = member(params, "range");
  const auto share = [&](const char* key) { return member(color, key).is_number() ? color[key].get<double>() : 0.0; };
  if (!script || !span_of(script->lines, range)) return no_text();
  Json all = Json::array();
  for (const std::string& way : ways_to_write({share("red"), share("green"), share("blue")}))
    all.push_back({{"label", way}, {"textEdit", {{"range", range}, {"newText", way}}}});
  return all;
}

// Returns one edit of the lines that differ. Keeps the text's line ends.
Json edit_between(const ScriptText& lines, std::string after) {
  const std::string& before = lines.text();
  if (before.find("\r\n") != std::string::npos)
    for (std::size_t at = 0; (at = after.find('\n', at)) != std::string::npos; ++at)
      if (at == 0 || after[at - 1] != '\r') after.insert(at++, 1, '\r');
  if (after == before) return Json::array();
  const LineChange change = change_between(before, after);
  const std::size_t from = lines.start(static_cast<std::size_t>(change.lines.first) - 1);
  const auto last = static_cast<std::size_t>(change.lines.last);
  const std::size_t to = last < lines.count() ? lines.start(last) : before.size();
  return Json::array({{{"range", range_of(lines, {from, std::max(from, to) - from})}, {"newText", change.others}}});
}

LspAnswer format(State& s, const Json& params) {
  OpenScript* const script = s.find(params);
  if (!script) return no_text();
  return edit_between(script->lines, tidy(script->lines.text()));
}

LspAnswer format_range(State& s, const Json& params) {
  OpenScript* const script = s.find(params);
  const auto span = script ? span_of(script->lines, member(params, "range")) : std::nullopt;
  if (!span) return no_text();
  return edit_between(script->lines, tidied_in(script->lines, *span));
}

// Returns the correction of a published diagnostic, or "". Editors may drop a diagnostic's data, so it is looked up.
std::string correction(const State& s, const std::string& uri, const Json& asked) {
  for (const auto& [_, files] : s.published) {
    const auto found = files.find(uri);
    if (found == files.end()) continue;
    for (const Json& d : found->second)
      if (member(d, "range") == member(asked, "range") && member(d, "message") == member(asked, "message"))
        return text_member(member(d, "data"), "instead");
  }
  return {};
}

// Offers the corrections of diagnostics.
LspAnswer code_actions(State& s, const Json& params) {
  OpenScript* const script = s.find(params);
  if (!script) return no_text();
  Json all = Json::array();
  for (const Json& d : member(member(params, "context"), "diagnostics")) {
    const std::string meant = correction(s, script->uri, d);
    if (meant.empty() || !span_of(script->lines, member(d, "range"))) continue;
    Json edit{{"range", member(d, "range")}, {"newText", meant}};
    Json changes = Json::object();
    changes[script->uri] = Json::array({std::move(edit)});
    all.push_back({{"title", fmt::format("replace by '{}'", meant)},
                   {"kind", "quickfix"},
                   {"isPreferred", true},
                   {"diagnostics", Json::array({d})},
                   {"edit", {{"changes", std::move(changes)}}}});
  }
  return all;
}

constexpr LspRequest requests[] = {
    {"initialize", [](State& s, const Json& p) { return LspAnswer(start(s, p)); }},
    {"shutdown", [](State& s, const Json& p) { return LspAnswer(shut_down(s, p)); }},
    {"textDocument/completion", completion, "completionProvider", R"({"triggerCharacters": [".", "="]})"},
    {"textDocument/hover", hover, "hoverProvider"},
    {"textDocument/signatureHelp", signature_help, "signatureHelpProvider", R"({"triggerCharacters": [" "]})"},
    {"textDocument/definition", definition, "definitionProvider"},
    {"textDocument/references", references, "referencesProvider"},
    {"textDocument/documentHighlight", highlights, "documentHighlightProvider"},
    {"textDocument/prepareRename", prepare_rename},
    {"textDocument/rename", rename_it, "renameProvider", R"({"prepareProvider": true})"},
    {"textDocument/documentSymbol", document_symbols, "documentSymbolProvider"},
    {"textDocument/foldingRange", folding, "foldingRangeProvider"},
    {"textDocument/documentColor", document_colors, "colorProvider"},
    {"textDocument/colorPresentation", color_presentations},
    {"textDocument/formatting", format, "documentFormattingProvider"},
    {"textDocument/rangeFormatting", format_range, "documentRangeFormattingProvider"},
    {"textDocument/codeAction", code_actions, "codeActionProvider", R"({"codeActionKinds": ["quickfix"]})"},
};

}  // namespace

std::span<const LspRequest> lsp_requests() { return requests; }

Json lsp_capabilities() {
  constexpr int incremental = 2;
  Json all{{"positionEncoding", "utf-16"},
           {"textDocumentSync", {{"openClose", true}, {"change", incremental}, {"save", true}}}};
  for (const LspRequest& row : requests)
    if (!row.capability.empty()) all[std::string(row.capability)] = Json::parse(row.value);
  return all;
}

}  // namespace betwixt
