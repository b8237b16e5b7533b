// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/editor_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "commands/line_head.h"
#include "editor/help.h"
#include "editor/line_pieces.h"
#include "export/json.h"
#include "scene/colors.h"

namespace betwixt {
namespace {

using Words = std::vector<std::string_view>;

// Puts longer words first, so that they match before their own prefixes.
std::string either(Words words, const char* between) {
  std::ranges::sort(words, [](auto a, auto b) { return a.size() != b.size() ? a.size() > b.size() : a < b; });
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return fmt::format("{}", fmt::join(words, between));
}

Words words_of(HelpGroup group) {
  Words all;
  for (const HelpEntry& e : help_entries())
    if (e.group == group) all.push_back(e.word);
  return all;
}
// The verbs before a name and a kind.
Words kind_verbs() {
  Words all;
  for (const Verb& v : verbs())
    if (has_word(words_at(v.words, 1), "KIND")) all.push_back(v.word);
  return all;
}

constexpr const char* not_by_hand = "Written by betwixt help --print {}: the words are those of its rows.";

}  // namespace

std::string vim_syntax() {
  const auto any = [](HelpGroup g) { return either(words_of(g), "\\|"); };
  std::string out = "\" SPDX-FileCopyrightText: 2026 The Betwixt authors\n\" SPDX-License-Identifier: Apache-2.0\n\" " +
                    fmt::format(fmt::runtime(not_by_hand), "vim") +
                    "\nif exists('b:current_syntax')\n  finish\nendif\nsyn case match\nsyn iskeyword @,48-57,_,-\n\n";
  const auto match = [&](const char* group, const std::string& pattern) {
    out += fmt::format("syn match betwixt{} '{}'\n", group, pattern);
  };
  // In vim the later one of two matches wins.
  match("Number", R"([-+]\=\%(\d\+\.\=\d*\|\.\d\+\)\%([eE][-+]\=\d\+\)\=\%(deg\|rad\|turn\|mm\|cm\|m\)\=\>)");
  match("Time", R"(\<[-+]\=\%(\d\+\.\=\d*\|\.\d\+\)\%(ms\|f\|s\|t\)\>)");
  match("Time", R"(\<\d\+:[0-9:.]\+)");
  out += fmt::format("syn keyword betwixtColor {}\n", either(color_names(), " "));
  match("Color", R"(#\%(\x\{6}\|\x\{3}\)\>)");
  match("Option", fmt::format(R"(\<\%({}\)\>)", either(option_words(), "\\|")));
  match("Twerper", fmt::format(R"(\<\%({}\|{}\)\>)", any(HelpGroup::twerper), any(HelpGroup::filter)));
  match("Function", fmt::format(R"(\.\zs\%({}\)\>)", any(HelpGroup::function)));
  match("Function", fmt::format(R"(\<\%({}\)\ze[.a-z]*=)", any(HelpGroup::function)));
  match("Option", R"(\<\%(ease\|tangent\|handle\)-\%(in\|out\)\ze=)");
  match("Kind",
        fmt::format(R"(\%(^\%({}\)\s\+\S\+\s\+\)\@<=\%({}\)\>)", either(kind_verbs(), "\\|"), any(HelpGroup::kind)));
  match("Verb", fmt::format(R"(^\s\+\zs\%({}\)\>)", any(HelpGroup::row)));
  match("Verb", fmt::format(R"(^\%({}\)\>)", any(HelpGroup::verb)));
  match("Verb", fmt::format(R"(\%(^\%({}\)\s\+\S\+\s\+\)\@<=\%({}\)\>)", either(verb_words(Verb::prefix), "\\|"),
                            any(HelpGroup::verb)));
  match("Comment", R"(\%(^\|[ \t(),=]\)\@1<=#\%(\s.*\)\=$)");
  out += R"(syn region betwixtText start='"' skip='\\.' end='"' oneline
syn region betwixtText start='"""' end='"""'

hi def link betwixtComment Comment
hi def link betwixtText String
hi def link betwixtVerb Statement
hi def link betwixtKind Type
hi def link betwixtFunction Identifier
hi def link betwixtTwerper Special
hi def link betwixtOption PreProc
hi def link betwixtColor Constant
hi def link betwixtNumber Number
hi def link betwixtTime Float

let b:current_syntax = 'betwixt'
)";
  return out;
}

std::string textmate_grammar() {
  const auto any = [](HelpGroup g) { return either(words_of(g), "|"); };
  Json patterns = Json::array();
  const auto match = [&](const char* name, const std::string& pattern) {
    patterns.push_back({{"name", fmt::format("{}.betwixt", name)}, {"match", pattern}});
  };
  const auto text = [&](const char* name, const char* mark, bool escapes) {
    Json one{{"name", fmt::format("string.quoted.{}.betwixt", name)}, {"begin", mark}, {"end", mark}};
    if (escapes) one["patterns"] = Json::array({{{"name", "constant.character.escape.betwixt"}, {"match", R"(\\.)"}}});
    patterns.push_back(std::move(one));
  };
  // The end of a word.
  constexpr std::string_view end = "(?![\\w/-])";
  // In TextMate grammars the first one of two matches wins.
  match("comment.line.number-sign", R"((?<=^|[\s(),=])#(?=\s|$).*$)");
  text("triple", "\"\"\"", false);
  text("double", "\"", true);
  const auto captured = [&](const std::string& pattern, std::initializer_list<const char*> names) {
    Json captures = Json::object();
    for (const char* name : names)
      captures[std::to_string(captures.size() + 1)] = {{"name", fmt::format("{}.betwixt", name)}};
    patterns.push_back({{"match", pattern}, {"captures", std::move(captures)}});
  };
  constexpr std::string_view name = "[A-Za-z](?:\\{[^}]*\\}|[^\\s,()=\"@{])*";
  captured(fmt::format("^({})\\s+({})\\s+({}){}", either(kind_verbs(), "|"), name, any(HelpGroup::kind), end),
           {"keyword.control", "entity.name", "storage.type"});
  captured(fmt::format("^({})\\s+({})", either(making_verbs(), "|"), name), {"keyword.control", "entity.name"});
  captured(fmt::format("^({})\\s+(\\S+)\\s+({}){}", either(verb_words(Verb::prefix), "|"), any(HelpGroup::verb), end),
           {"keyword.control", "constant.numeric.time", "keyword.control"});
  match("keyword.control", fmt::format("^(?:{}){}", any(HelpGroup::verb), end));
  match("keyword.control", fmt::format("^\\s+(?:{}){}", any(HelpGroup::row), end));
  match("support.function", fmt::format(R"((?<=\.)(?:{}){})", any(HelpGroup::function), end));
  match("support.function", fmt::format(R"((?<![\w/-])(?:{})(?=[.a-z]*=))", any(HelpGroup::function)));
  match("keyword.other", R"((?<![\w/-])(?:ease|tangent|handle)-(?:in|out)(?==))");
  match("support.constant.color", R"((?<![\w/-])#(?:[0-9a-fA-F]{6}|[0-9a-fA-F]{3})(?![\w-]))");
  match("constant.numeric.time", fmt::format(R"((?<![\w/-])[-+]?(?:\d+\.?\d*|(?<!\.)\.\d+)(?:ms|f|s|t){})", end));
  match("constant.numeric.time", R"((?<![\w/-])\d+:[0-9:.]+)");
  match("constant.numeric",
        fmt::format(R"((?<![\w/])[-+]?(?:\d+\.?\d*|(?<!\.)\.\d+)(?:[eE][-+]?\d+)?(?:deg|rad|turn|mm|cm|m)?{})", end));
  match("keyword.other", fmt::format(R"((?<![\w./-])(?:{}){}(?![.=]))", either(option_words(), "|"), end));
  match("constant.language",
        fmt::format(R"((?<![\w./-])(?:{}|{}){}(?![.=]))", any(HelpGroup::twerper), any(HelpGroup::filter), end));
  match("support.constant.color", fmt::format(R"((?<![\w./-])(?:{}){}(?![.=]))", either(color_names(), "|"), end));
  return Json{{"information_for_contributors", fmt::format(fmt::runtime(not_by_hand), "textmate")},
              {"name", "Betwixt"},
              {"scopeName", "source.betwixt"},
              {"fileTypes", {"bx"}},
              {"patterns", std::move(patterns)}}
             .dump(2) +
         "\n";
}

}  // namespace betwixt
