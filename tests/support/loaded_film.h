// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers for tests of the language: they load a script, and read its values and errors.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "support/told.h"

namespace betwixt {

inline std::string said(const Diagnostics& all) {
  std::string out;
  for (const Diagnostic& d : all) out += to_string(d);
  return out;
}

// A loaded and compiled script. The test fails if the script has errors.
struct LoadedFilm {
  explicit LoadedFilm(std::string_view text) : loaded(load_text(text, "test.bx")) {
    EXPECT_FALSE(has_errors(loaded.diagnostics)) << text << "\n" << said(loaded.diagnostics);
    program = Program::compile(loaded.document);
  }
  Value read(std::string_view target, std::string_view time) const {
    const auto t = parse_time(time, loaded.document);
    const auto found = find_targets(target, loaded.document);
    if (!t || !found || found->size() != 1) {
      ADD_FAILURE() << "cannot read " << target << " at " << time;
      return 0.0;
    }
    return program.read(found->front(), *t);
  }
  std::vector<double> numbers(std::string_view target, std::string_view time) const {
    return betwixt::numbers(read(target, time));
  }
  std::string text(std::string_view target, std::string_view time) const {
    return **std::get_if<Text>(&static_cast<const Value&>(read(target, time)));
  }
  Frame frame(std::string_view time) const { return program.frame(*parse_time(time, loaded.document)); }
  Loaded loaded;
  Program program;
};

inline void expect_numbers(const LoadedFilm& s, std::string_view target, std::string_view time,
                           const std::vector<double>& wanted, double within = 1e-12) {
  const auto is = s.numbers(target, time);
  ASSERT_EQ(is.size(), wanted.size()) << target << " at " << time;
  for (std::size_t i = 0; i < is.size(); ++i)
    EXPECT_NEAR(is[i], wanted[i], within) << target << " at " << time << ", number " << i;
}

struct Wanted {
  std::string_view target, time;
  std::vector<double> numbers;
};
inline void expect_numbers(const LoadedFilm& s, const std::vector<Wanted>& table, double within = 1e-12) {
  for (const Wanted& w : table) expect_numbers(s, w.target, w.time, w.numbers, within);
}

// Returns the position of an object in the world.
inline Vec3 place(const LoadedFilm& s, std::string_view object, std::string_view time) {
  return translation_of(*std::get<Matrix>(s.read(std::string(object) + ".world", time)));
}
inline void expect_place(const LoadedFilm& s, std::string_view object, std::string_view time, Vec3 wanted,
                         double within = 1e-9) {
  const Vec3 is = place(s, object, time);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(is[i], wanted[i], within) << object << " at " << time << ", " << i;
}

struct Passed {
  std::string_view time;
  Vec3 place;
};
inline void expect_places(const LoadedFilm& s, std::string_view object, const std::vector<Passed>& way) {
  for (const Passed& p : way) expect_place(s, object, p.time, p.place);
}

// Returns "line:column: message" for each error.
inline std::vector<std::string> errors(const Loaded& loaded) {
  std::vector<std::string> out;
  for (const Diagnostic& d : loaded.diagnostics)
    if (d.severity == Severity::error)
      out.push_back(fmt::format("{}:{}: {}", d.what.place.line, d.what.place.column, d.what.message));
  return out;
}

inline Loaded read(std::string_view text) { return load_text(text, "test.bx"); }

// The functions of told.h for the text of a script.
inline std::string told(std::string_view text) { return told(read(text)); }
inline std::vector<std::string> all_told(std::string_view text) { return all_told(read(text)); }
inline std::vector<std::string> remarks_told(std::string_view text) { return remarks_told(read(text)); }
inline bool mentions(std::string_view text, std::string_view what) { return mentions(read(text), what); }

// Returns the first error of a text in the form of errors(), or "" if there is none.
inline std::string first_error(const std::string& text) {
  const auto all = errors(read(text));
  return all.empty() ? std::string() : all[0];
}

// Expects that a line after good lines is refused with one error, "CODE 1:COLUMN SUBJECT" or its beginning, and changes
// nothing.
inline void expect_refused(const std::string& good, const std::string& line, const std::string& wanted) {
  const Loaded bad = read(good + line + "\n");
  const auto all = all_told(bad);
  ASSERT_EQ(all.size(), 1u) << line << "\n" << said(bad.diagnostics);
  std::string is = all[0];
  const auto place = is.find(' ') + 1, colon = is.find(':');
  is.replace(place, colon - place, "1");
  EXPECT_TRUE(is.starts_with(wanted)) << line << "\n" << is << "\n" << said(bad.diagnostics);
  EXPECT_EQ(bad.document, read(good).document) << line;
}

}  // namespace betwixt
