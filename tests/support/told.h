// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Describes an error without its wording, so that tests do not depend on it: "CODE LINE:COLUMN SUBJECT", as in "type
// 1:26 (1 2)". The subject is the marked part of the script. Without a script it is the quoted part of the message.
#pragma once

#include <fmt/format.h>

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "base/utf8.h"
#include "betwixt/result.h"

namespace betwixt {

inline std::string_view code_name(ErrorCode code) {
  static constexpr std::string_view names[] = {"syntax", "name", "type", "range", "file", "machine"};
  return names[static_cast<int>(code)];
}

// Returns the text in the first pair of quotes, 'so' or "so", or "" if there is none. An apostrophe is no quote.
inline std::string_view in_quotes(std::string_view message) {
  const auto letter = [&](std::size_t i) {
    return i < message.size() &&
           (static_cast<unsigned char>(message[i]) >= 0x80 || std::isalnum(static_cast<unsigned char>(message[i])));
  };
  for (std::size_t from = 0; from < message.size(); ++from) {
    const char mark = message[from];
    if ((mark != '\'' && mark != '"') || (from > 0 && letter(from - 1))) continue;
    for (std::size_t to = from + 1; to < message.size(); ++to)
      if (message[to] == mark && !letter(to + 1)) return message.substr(from + 1, to - from - 1);
  }
  return {};
}

// Returns "CODE", then " LINE:COLUMN" if the place is known, then " SUBJECT" if the message quotes one.
inline std::string told(const Error& e) {
  std::string out(code_name(e.code));
  if (e.place.line > 0) out += fmt::format(" {}:{}", e.place.line, e.place.column);
  if (const std::string_view subject = in_quotes(e.message); !subject.empty()) out += fmt::format(" {}", subject);
  return out;
}

// Returns the error of a result, or "" if there is none.
template <class T>
std::string told(const Result<T>& r) {
  return r ? std::string() : told(r.error());
}

// Returns the same of a diagnostic. A notice or a warning begins with that word: "notice name 2:4 x".
inline std::string told(const Diagnostic& d) {
  static constexpr std::string_view severities[] = {"notice ", "warning ", ""};
  std::string out(severities[static_cast<int>(d.severity)]);
  const Place& at = d.what.place;
  if (at.line == 0 || d.line.empty()) return out + told(d.what);
  const auto before = first_characters(d.line, static_cast<std::size_t>(d.caret)).size();
  const auto subject = first_characters(std::string_view(d.line).substr(before), static_cast<std::size_t>(at.length));
  return out +
         fmt::format("{} {}:{}{}{}", code_name(d.what.code), at.line, at.column, subject.empty() ? "" : " ", subject);
}

// all_told returns all errors, remarks_told all warnings and notices.
inline std::vector<std::string> all_told(const Diagnostics& all) {
  std::vector<std::string> out;
  for (const Diagnostic& d : all)
    if (d.severity == Severity::error) out.push_back(told(d));
  return out;
}
inline std::vector<std::string> remarks_told(const Diagnostics& all) {
  std::vector<std::string> out;
  for (const Diagnostic& d : all)
    if (d.severity != Severity::error) out.push_back(told(d));
  return out;
}

// Returns the first error, or "" if there is none.
inline std::string told(const Diagnostics& all) {
  for (const Diagnostic& d : all)
    if (d.severity == Severity::error) return told(d);
  return {};
}

// Returns whether a message contains `what`: a name or a number that belongs into any wording of the message.
inline bool mentions(const Diagnostics& all, std::string_view what) {
  for (const Diagnostic& d : all)
    if (d.what.message.find(what) != std::string::npos) return true;
  return false;
}

template <class T>
bool mentions(const Result<T>& r, std::string_view what) {
  return !r && r.error().message.find(what) != std::string::npos;
}

// The same functions for a loaded script.
template <class Loaded>
requires requires(const Loaded& l) { l.document, l.diagnostics; }
std::string told(const Loaded& l) { return told(l.diagnostics); }
template <class Loaded>
requires requires(const Loaded& l) { l.document, l.diagnostics; }
std::vector<std::string> all_told(const Loaded& l) { return all_told(l.diagnostics); }
template <class Loaded>
requires requires(const Loaded& l) { l.document, l.diagnostics; }
std::vector<std::string> remarks_told(const Loaded& l) { return remarks_told(l.diagnostics); }
template <class Loaded>
requires requires(const Loaded& l) { l.document, l.diagnostics; }
bool mentions(const Loaded& l, std::string_view what) { return mentions(l.diagnostics, what); }

}  // namespace betwixt
