// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/code_languages.h"

#include <algorithm>
#include <cctype>

namespace betwixt {
namespace {

constexpr std::string_view c_words =
    "auto break case const continue default do else enum extern for goto if inline register return sizeof static "
    "struct switch typedef union volatile while include define ifdef ifndef endif undef pragma";
constexpr std::string_view c_types =
    "bool char double float int long short signed unsigned void size_t int8_t int16_t int32_t int64_t uint8_t uint16_t "
    "uint32_t uint64_t true false NULL";
constexpr std::string_view cpp_words =
    "auto break case catch class concept const consteval constexpr constinit continue co_await co_return co_yield "
    "default delete do else enum explicit export extern final for friend goto if inline mutable namespace new noexcept "
    "operator override private protected public requires return sizeof static static_assert struct switch template "
    "this throw try typedef typename union using virtual volatile while include define ifdef ifndef endif undef pragma";
constexpr std::string_view cpp_types =
    "bool char double float int long short signed unsigned void size_t std string vector map set pair optional true "
    "false nullptr int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t";
constexpr std::string_view js_words =
    "async await break case catch class const continue debugger default delete do else export extends finally for from "
    "function get if import in instanceof let new of return set static super switch this throw try typeof var void "
    "while with yield";
constexpr std::string_view ts_words =
    "abstract as async await break case catch class const continue declare default delete do else enum export extends "
    "finally for from function get if implements import in infer instanceof interface is keyof let namespace new of "
    "private protected public readonly return satisfies set static super switch this throw try type typeof var void "
    "while yield";
constexpr std::string_view java_words =
    "abstract assert break case catch class const continue default do else enum extends final finally for if "
    "implements import instanceof interface native new package permits private protected public record return sealed "
    "static super switch synchronized this throw throws transient try var volatile while yield";
constexpr std::string_view csharp_words =
    "abstract as async await base break case catch checked class const continue default delegate do else enum event "
    "explicit extern finally fixed for foreach get goto if implicit in init interface internal is lock namespace new "
    "operator out override params private protected public readonly record ref return sealed set sizeof stackalloc "
    "static struct switch this throw try typeof unchecked unsafe using var virtual volatile when where while with "
    "yield";

// In the order of their names.
constexpr CodeLanguage languages[] = {
    {.name = "bash",
     .keywords = "if then else elif fi for while until do done case esac function in select return exit break continue "
                 "local export readonly declare set unset shift source trap",
     .types = "echo cd ls cat grep sed awk printf read test true false mkdir rm cp mv",
     .line_comments = "#",
     .long_quotes = "\"'`",
     .dashes = true},
    {.name = "betwixt",
     .keywords = "create at set for keep let define film range size background couple attach letgo grab animate filter "
                 "layer import include on off write draw grow erase shrink morph into match command end copy stagger",
     .types = "linear smooth ease-in ease-out ease-in-out bounce spring cut step sphere box circle rectangle text axes "
              "plot camera light",
     .line_comments = "#",
     .quotes = "\"",
     .dashes = true},
    {.name = "c",
     .keywords = c_words,
     .types = c_types,
     .line_comments = "//",
     .block_comment = "/* */",
     .quotes = "\"'"},
    {.name = "cpp",
     .keywords = cpp_words,
     .types = cpp_types,
     .line_comments = "//",
     .block_comment = "/* */",
     .quotes = "\"'",
     .capitals = true},
    {.name = "csharp",
     .keywords = csharp_words,
     .types = "bool byte char decimal double dynamic float int long object sbyte short string uint ulong ushort void "
              "true false null",
     .line_comments = "//",
     .block_comment = "/* */",
     .quotes = "\"'",
     .capitals = true},
    {.name = "css",
     .keywords = "important media import keyframes from to supports layer",
     .types = "auto none inherit initial unset flex grid block inline absolute relative fixed solid center",
     .block_comment = "/* */",
     .quotes = "\"'",
     .key = ':',
     .dashes = true},
    {.name = "go",
     .keywords = "break case chan const continue default defer else fallthrough for func go goto if import interface "
                 "map package range return select struct switch type var",
     .types = "bool byte complex64 complex128 error float32 float64 int int8 int16 int32 int64 rune string uint uint8 "
              "uint16 uint32 uint64 uintptr any true false nil iota",
     .line_comments = "//",
     .block_comment = "/* */",
     .quotes = "\"'",
     .long_quotes = "`",
     .capitals = true},
    {.name = "haskell",
     .keywords = "case class data default deriving do else forall foreign if import in infix infixl infixr instance "
                 "let module newtype of then type where qualified as hiding",
     .line_comments = "--",
     .block_comment = "{- -}",
     .quotes = "\"",
     .capitals = true},
    {.name = "html", .block_comment = "<!-- -->", .long_quotes = "\"'", .dashes = true, .markup = true},
    {.name = "java",
     .keywords = java_words,
     .types = "boolean byte char double float int long short void true false null",
     .line_comments = "//",
     .block_comment = "/* */",
     .quotes = "\"'",
     .capitals = true},
    {.name = "javascript",
     .keywords = js_words,
     .types = "true false null undefined NaN Infinity console document window",
     .line_comments = "//",
     .block_comment = "/* */",
     .quotes = "\"'",
     .long_quotes = "`",
     .capitals = true},
    {.name = "json", .types = "true false null", .quotes = "\"", .key = ':'},
    {.name = "julia",
     .keywords = "abstract baremodule begin break catch const continue do else elseif end export finally for function "
                 "global if import in isa let local macro module mutable primitive quote return struct try type using "
                 "where while",
     .types = "true false nothing missing",
     .line_comments = "#",
     .block_comment = "#= =#",
     .quotes = "\"'",
     .capitals = true},
    {.name = "kotlin",
     .keywords = "abstract as break by catch class companion const continue data do else enum finally for fun get if "
                 "import in init inline interface internal is lateinit object open operator out override package "
                 "private protected public return sealed set super suspend this throw try typealias val var vararg "
                 "when where while",
     .types = "true false null",
     .line_comments = "//",
     .block_comment = "/* */",
     .quotes = "\"'",
     .capitals = true},
    {.name = "lua",
     .keywords = "and break do else elseif end for function goto if in local not or repeat return then until while",
     .types = "true false nil self print pairs ipairs",
     .line_comments = "--",
     .block_comment = "--[[ ]]",
     .quotes = "\"'"},
    {.name = "php",
     .keywords =
         "abstract and array as break case catch class clone const continue declare default do echo else elseif "
         "enum extends final finally fn for foreach function global if implements include instanceof interface "
         "match namespace new or print private protected public readonly require return static switch throw "
         "trait try use var while yield",
     .types = "bool float int string void true false null self parent",
     .line_comments = "// #",
     .block_comment = "/* */",
     .long_quotes = "\"'",
     .capitals = true},
    {.name = "plain"},
    {.name = "python",
     .keywords = "and as assert async await break class continue def del elif else except finally for from global if "
                 "import in is lambda match case nonlocal not or pass raise return try while with yield",
     .types = "True False None self cls int float str bool list dict set tuple bytes object range len print",
     .line_comments = "#",
     .quotes = "\"'",
     .capitals = true},
    {.name = "r",
     .keywords = "break else for function if in next repeat return while library require",
     .types = "TRUE FALSE NULL NA Inf NaN",
     .line_comments = "#",
     .long_quotes = "\"'"},
    {.name = "ruby",
     .keywords = "alias and begin break case class def defined do else elsif end ensure for if in module next not or "
                 "redo rescue retry return super then undef unless until when while yield require attr_accessor "
                 "attr_reader",
     .types = "true false nil self puts",
     .line_comments = "#",
     .long_quotes = "\"'",
     .capitals = true},
    {.name = "rust",
     .keywords = "as async await break const continue crate dyn else enum extern fn for if impl in let loop match mod "
                 "move mut pub ref return static struct super trait type unsafe use where while",
     .types = "bool char f32 f64 i8 i16 i32 i64 i128 isize str u8 u16 u32 u64 u128 usize self true false",
     .line_comments = "//",
     .block_comment = "/* */",
     .long_quotes = "\"",
     .capitals = true},
    {.name = "sql",
     .keywords =
         "add all alter and any as asc begin between by case check column commit constraint create cross "
         "database default delete desc distinct drop else end exists foreign from full group having if in index "
         "inner insert into is join key left like limit not null offset on or order outer primary references "
         "right rollback select set table then union unique update values view when where with",
     .types = "bigint boolean char date decimal double float int integer numeric real serial smallint text time "
              "timestamp varchar true false",
     .line_comments = "--",
     .block_comment = "/* */",
     .long_quotes = "'\"",
     .any_case = true},
    {.name = "swift",
     .keywords = "as associatedtype async await break case catch class continue default defer deinit do else enum "
                 "extension fallthrough fileprivate for func guard if import in init inout internal is let mutating "
                 "open operator override private protocol public repeat return self some static struct subscript super "
                 "switch throw throws try typealias var weak where while",
     .types = "true false nil",
     .line_comments = "//",
     .block_comment = "/* */",
     .quotes = "\"",
     .capitals = true},
    {.name = "toml", .types = "true false", .line_comments = "#", .quotes = "\"'", .key = '=', .dashes = true},
    {.name = "typescript",
     .keywords = ts_words,
     .types = "any bigint boolean never number object string symbol unknown true false null undefined console",
     .line_comments = "//",
     .block_comment = "/* */",
     .quotes = "\"'",
     .long_quotes = "`",
     .capitals = true},
    {.name = "yaml",
     .types = "true false null yes no",
     .line_comments = "#",
     .quotes = "\"'",
     .key = ':',
     .dashes = true},
};

bool same_letter(unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); }

}  // namespace

const CodeLanguage* find_code_language(std::string_view name) {
  const auto* at =
      std::find_if(std::begin(languages), std::end(languages), [&](const CodeLanguage& l) { return l.name == name; });
  return at == std::end(languages) ? nullptr : at;
}

std::string_view code_language_words() {
  static const std::string all = [] {
    std::string out;
    for (const CodeLanguage& l : languages) (out += out.empty() ? "" : "|") += l.name;
    return out;
  }();
  return all;
}

bool has_code_word(std::string_view list, std::string_view word, bool any_case) {
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(' ', at), list.size());
    const std::string_view one = list.substr(at, end - at);
    if (one == word || (any_case && std::equal(one.begin(), one.end(), word.begin(), word.end(), same_letter)))
      return true;
    at = end + 1;
  }
  return false;
}

}  // namespace betwixt
