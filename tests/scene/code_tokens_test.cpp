// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the words of code and their classes.
#include <gtest/gtest.h>

#include <random>

#include "scene/code_languages.h"

namespace betwixt {
namespace {

// The words of one class, with blanks between.
std::string words(std::string_view text, std::string_view language, CodeClass is) {
  std::string out;
  for (const CodeToken& t : code_tokens(text, language))
    if (t.is == is) (out += out.empty() ? "" : " ") += text.substr(t.at, t.size);
  return out;
}

TEST(CodeTokens, HaveTheClassesThatReadersExpect) {
  const char* python =
      "@cached\ndef area(r):  # of a disc\n    '''if and while'''\n    return 3.14 * r ** 2 if r else \"for\"\n";
  EXPECT_EQ(words(python, "python", CodeClass::keyword), "def return if else");
  EXPECT_EQ(words(python, "python", CodeClass::function), "@cached area");
  EXPECT_EQ(words(python, "python", CodeClass::number), "3.14 2");
  EXPECT_EQ(words(python, "python", CodeClass::comment), "# of a disc");
  EXPECT_EQ(words(python, "python", CodeClass::string), "' ' ' if and while ' ' ' \" for \"");
  const char* cpp = "/* for\n all */ const Point p = make(0x1F); // end";
  EXPECT_EQ(words(cpp, "cpp", CodeClass::comment), "/ * for all * / / / end");
  EXPECT_EQ(words(cpp, "cpp", CodeClass::keyword), "const");
  EXPECT_EQ(words(cpp, "cpp", CodeClass::type), "Point");
  EXPECT_EQ(words(cpp, "cpp", CodeClass::function), "make");
  EXPECT_EQ(words(cpp, "cpp", CodeClass::number), "0x1F");
  EXPECT_EQ(words("<p class=\"a\">it's for <b>you</b></p><!-- x -->", "html", CodeClass::keyword), "p b b p");
  EXPECT_EQ(words("<p class=\"a\">it's</p>", "html", CodeClass::string), "\" a \"");
  EXPECT_EQ(words("{\"size\": [1, true], \"x\": \"y\"}", "json", CodeClass::function), "\" size \" \" x \"");
  EXPECT_EQ(words("{\"size\": [1, true], \"x\": \"y\"}", "json", CodeClass::string), "\" y \"");
  EXPECT_EQ(words("SELECT name FROM t WHERE x = 'it'", "sql", CodeClass::keyword), "SELECT FROM WHERE");
  EXPECT_EQ(words("a { margin-top: 2px; color: #ff0000 }", "css", CodeClass::function), "margin-top color");
  EXPECT_EQ(words("a { margin-top: 2px; color: #ff0000 }", "css", CodeClass::number), "2px #ff0000");
  EXPECT_EQ(words("s = \"not closed\nfor", "python", CodeClass::keyword), "for");
  EXPECT_EQ(words("s = `two\nfor", "javascript", CodeClass::keyword), "");
  EXPECT_EQ(words("for if", "plain", CodeClass::keyword), "");
}

TEST(CodeTokens, EveryLanguageIsKnownByItsName) {
  std::string_view all = code_language_words();
  int count = 0;
  while (!all.empty()) {
    const std::size_t end = std::min(all.find('|'), all.size());
    const CodeLanguage* l = find_code_language(all.substr(0, end));
    ASSERT_NE(l, nullptr);
    EXPECT_EQ(l->name, all.substr(0, end));
    all.remove_prefix(std::min(end + 1, all.size()));
    ++count;
  }
  EXPECT_GE(count, 26);
  EXPECT_EQ(find_code_language("cobol"), nullptr);
}

// Of any text in any language, the tokens have all that is no blank, once and in order.
TEST(CodeTokens, LeaveNothingOut) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  static constexpr std::string_view bits[] = {"for", " ",  "\n", "\"", "'",  "`",  "/*", "*/", "//", "#",  "<a",
                                              ">",   "</", "-",  "é",  "x1", "3.", "\\", "(",  ":",  "--", "[[",
                                              "]]",  "=",  "\t", "<!", "@b", "$",  "{-", "-}", "'''"};
  std::string_view languages = code_language_words();
  while (!languages.empty()) {
    const std::string_view language = languages.substr(0, languages.find('|'));
    languages.remove_prefix(std::min(language.size() + 1, languages.size()));
    for (int round = 0; round < 200; ++round) {
      std::string text;
      for (std::size_t i = below(40); i-- > 0;) text += bits[below(std::size(bits))];
      std::size_t next = 0;
      for (const CodeToken& t : code_tokens(text, language)) {
        ASSERT_GT(t.size, 0U);
        ASSERT_GE(t.at, next);
        EXPECT_EQ(text.find_first_not_of(" \t\n", next), t.at) << language << ": " << text;
        EXPECT_EQ(text.substr(t.at, t.size).find_first_of(" \t\n"), std::string::npos) << language << ": " << text;
        next = t.at + t.size;
      }
      EXPECT_EQ(text.find_first_not_of(" \t\n", next), std::string::npos) << language << ": " << text;
    }
  }
}

TEST(CodeTokens, ExtentCountsLettersAndLines) {
  EXPECT_EQ(code_extent("").lines, 1);
  EXPECT_EQ(code_extent("").columns, 0);
  EXPECT_EQ(code_extent("ab\nçdé\n").lines, 3);
  EXPECT_EQ(code_extent("ab\nçdé\n").columns, 3);
}

}  // namespace
}  // namespace betwixt
