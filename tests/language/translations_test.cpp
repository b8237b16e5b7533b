// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/translations.h"

#include <gtest/gtest.h>

namespace betwixt {
namespace {

TEST(Translations, AreReadAsGettextWritesThem) {
  const auto read = read_po(
      "\xEF\xBB\xBF# by hand\r\nmsgid \"\"\r\nmsgstr \"Language: de\\n\"\r\n\r\n#: a.bx:1\r\nmsgid \"one\"\r\n"
      "msgstr \"eins\"\r\n\r\nmsgid \"\"\r\n\"two \"\r\n\"lines\\n\\t\\\"\\\\\"\r\nmsgstr \"\"\r\n\"zw\"\r\n\"ei\"\r\n"
      "#~ msgid \"old\"\r\n#~ msgstr \"alt\"\r\n",
      "de.po");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, (Translations{{"one", "eins"}, {"two lines\n\t\"\\", "zwei"}}));
}

TEST(Translations, GuessesAndEmptyOnesAreLeftOut) {
  const auto read =
      read_po("#, fuzzy\nmsgid \"a\"\nmsgstr \"b\"\n\nmsgid \"c\"\nmsgstr \"\"\n\nmsgid \"d\"\nmsgstr \"e\"\n", "");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, (Translations{{"d", "e"}}));
}

TEST(Translations, ErrorsHaveTheirLine) {
  const auto line = [](std::string_view text) {
    const auto read = read_po(text, "x.po");
    return read ? 0 : read.error().place.line;
  };
  EXPECT_EQ(line("msgid \"a\"\n\n\nmsgid \"b\"\nmsgstr \"c\"\n"), 1);
  EXPECT_EQ(line("msgid \"a\"\nmsgstr \"b\"\nmsgstr \"c\"\n"), 3);
  EXPECT_EQ(line("\"a\"\n"), 1);
  EXPECT_EQ(line("msgid \"a\"b\"\n"), 1);
  EXPECT_EQ(line("\nmsgid \"a\\x\"\n"), 2);
  EXPECT_EQ(line("msgctxt \"menu\"\nmsgid \"a\"\nmsgstr \"b\"\n"), 1);
  EXPECT_EQ(line("msgid \"a\"\nmsgstr \"\xff\"\n"), 2);
  EXPECT_EQ(line(""), 0);
}

TEST(Translations, TextsThatAreWrittenReadBack) {
  for (const std::string text : {"a", "two\nlines", "an end\n", "\t\"quotes\" and \\", "\n", "über"}) {
    const auto read = read_po("msgid " + write_po_text(text) + "\nmsgstr \"x\"\n", "");
    ASSERT_TRUE(read) << text << read.error().message;
    EXPECT_EQ(*read, (Translations{{text, "x"}}));
  }
}

}  // namespace
}  // namespace betwixt
