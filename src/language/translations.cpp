// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/translations.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "language/lines.h"

namespace betwixt {
namespace {

// One entry after another: comments, msgid, msgstr, each text in pieces on lines of their own.
class PoReader {
 public:
  PoReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<Translations> all() {
    for (std::size_t at = 0; at < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      std::string_view line = text_.substr(at, end - at);
      at = end + 1, ++line_;
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
      while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
      if (Status s = take(line); !s) return s.error();
    }
    if (Status s = keep(); !s) return s.error();
    return std::move(all_);
  }

 private:
  Error wrong(std::string message, std::string hint = {}) const {
    Error e = fail(ErrorCode::syntax, std::move(message), Hint(std::move(hint)));
    e.place = {name_, line_, 1};
    return e;
  }

  Status take(std::string_view line) {
    if (line.empty()) return Nothing{};
    if (line[0] == '#') {
      if (translated_)
        if (Status s = keep(); !s) return s;
      // Tools mark guesses so; whoever translates takes the mark away.
      if (line.starts_with("#,") && line.find("fuzzy") != line.npos) fuzzy_ = true;
      return Nothing{};
    }
    if (line[0] == '"') {
      std::string* into = translated_ ? &*translated_ : original_ ? &*original_ : nullptr;
      return into ? piece(line, *into) : Status(wrong("a text stands here without msgid or msgstr before it"));
    }
    const std::string_view word = line.substr(0, line.find_first_of(" \t\""));
    line.remove_prefix(word.size());
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    if (word == "msgid") {
      if (Status s = keep(); !s) return s;
      return begins_ = line_, piece(line, original_.emplace());
    }
    if (word == "msgstr") {
      if (!original_ || translated_) return wrong("msgstr stands here without a msgid before it");
      return piece(line, translated_.emplace());
    }
    if (word == "msgctxt" || word == "msgid_plural" || word.starts_with("msgstr["))
      return wrong(fmt::format("'{}' has no meaning here", word), "a film's catalogue has msgid and msgstr only");
    return wrong(fmt::format("expected msgid, msgstr, a text in quotes or a comment, not '{}'", word.substr(0, 40)));
  }

  // Adds "…" with its escapes.
  Status piece(std::string_view line, std::string& to) {
    if (line.size() < 2 || line.front() != '"' || line.back() != '"') return wrong("a text in quotes is missing here");
    line = line.substr(1, line.size() - 2);
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"') return wrong("a quote within a text needs a backslash", "write \\\"");
      if (line[i] != '\\') {
        to += line[i];
        continue;
      }
      static constexpr std::string_view written = "nt\"\\r", meant = "\n\t\"\\\r";
      const std::size_t known = ++i < line.size() ? written.find(line[i]) : written.npos;
      if (known == written.npos) return wrong("a backslash here has no meaning", "known are \\n \\t \\\" and \\\\");
      to += meant[known];
    }
    return Nothing{};
  }

  // Keeps the entry that ends here.
  Status keep() {
    if (!original_) {
      fuzzy_ = fuzzy_ && !translated_;
      return Nothing{};
    }
    if (!translated_) {
      line_ = begins_;
      return wrong("this msgid has no msgstr");
    }
    if (!seen_.insert(*original_).second) {
      line_ = begins_;
      return wrong(fmt::format("the text \"{}\" is translated twice", original_->substr(0, 60)));
    }
    // The entry of the empty text describes the file.
    if (!original_->empty() && !translated_->empty() && !fuzzy_) all_.emplace(*original_, *translated_);
    original_.reset(), translated_.reset(), fuzzy_ = false;
    return Nothing{};
  }

  std::string_view text_;
  const std::string& name_;
  int line_ = 0, begins_ = 0;
  bool fuzzy_ = false;
  std::optional<std::string> original_, translated_;
  std::set<std::string> seen_;
  Translations all_;
};

}  // namespace

Result<Translations> read_po(std::string_view text, const std::string& name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (const auto bad = unsound(text)) {
    Error e = bad->why;
    e.place = {
        name, static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bad->at), '\n')) + 1,
        1};
    return e;
  }
  return PoReader(text, name).all();
}

std::string write_po_text(std::string_view text) {
  std::string out = text.find('\n') < text.size() - 1 ? "\"\"\n\"" : "\"";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char ch = text[i];
    if (ch == '"' || ch == '\\') out += '\\';
    if (ch == '\n')
      out += i + 1 < text.size() ? "\\n\"\n\"" : "\\n";
    else if (ch == '\t')
      out += "\\t";
    else
      out += ch;
  }
  return out + '"';
}

}  // namespace betwixt
