// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables in JSON: what they become, and what is wrong with a file.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "exchange/table_file.h"
#include "exchange/table_text.h"

namespace betwixt {
namespace {

std::string said(const std::string& json, std::string_view inside = {}) {
  const auto text = table_of_json(json, "t.json", inside);
  return text ? *text : text.error().message;
}

TEST(TableJson, ObjectsBecomeRows) {
  EXPECT_EQ(said(R"([{"city": "Bern", "n": 134000}, {"city": "Ulm", "who": null}])"),
            "\"city\",\"n\",\"who\"\n\"Bern\",134000,\n\"Ulm\",,\n");
}

TEST(TableJson, WhatIsWrongIsSaid) {
  const std::pair<std::string, std::string> cases[] = {
      {"[{\"a\": 1},\n {\"a\": }]", "line 2, column 8 of 't.json' is no JSON"},
      {"", "line 1, column 1 of 't.json' is no JSON"},
      {"\"a\xff\"", "line 1, column 3 of 't.json' is no JSON"},
      {"1.5e344", "'t.json' has a number that is too large"},
      {"[{\"a\": -1e999}]", "'t.json' has a number that is too large"},
      {std::string(100, '['), "'t.json' is nested too deep for a table"},
      {"7", "'t.json' is no table"},
      {"[[\"a\"], [1, 2]]", "'t.json' has a row 2 that is not as long as the first"},
  };
  for (const auto& [json, message] : cases) EXPECT_EQ(said(json), message) << json;
  EXPECT_EQ(said(R"({"a": [[1]], "b": [[2]]})"), "'t.json' has several tables");
  EXPECT_EQ(said(R"({"a": [[1]]})", "c"), "'t.json' has nothing named 'c'");
}

// The name of a column stays the same if it is read as a title again.
TEST(TableColumns, HaveNamesOfAtMost60Characters) {
  const std::pair<std::string, std::string> cases[] = {
      {"People (1000s)", "People_1000s"},
      {"  ", "column3"},
      {"7 days", "c7_days"},
      {std::string(70, '7'), "c" + std::string(59, '7')},
      {std::string(59, 'a') + " and more", std::string(59, 'a')},
      {"_", "c"},
  };
  for (const auto& [title, name] : cases) {
    EXPECT_EQ(column_word(title, 3), name) << title;
    EXPECT_EQ(column_word(name, 3), name) << title;
  }
}

}  // namespace
}  // namespace betwixt
