// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/words_file.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/cancellation.h"
#include "base/files.h"
#include "base/utf8.h"
#include "exchange/words_reading.h"

namespace betwixt {
namespace {

constexpr std::size_t largest_words_file = 64 << 20, most_words = 1'000'000, longest_word = 20'000;
constexpr double latest_word = 4 * 3600;  // as long as a sound can be
constexpr double late = 1e-6;             // times that files round may be apart by this

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::string said_piece(std::string_view piece) {
  return fmt::format("'{}{}'", visible(first_characters(piece, 40)), count_characters(piece) > 40 ? "…" : "");
}

bool digits_only(std::string_view s) {
  return !s.empty() && s.size() <= 9 && s.find_first_not_of("0123456789") == std::string_view::npos;
}

// UTF-16 and other files with zero bytes are not texts that we read.
bool readable(WordsReading& in) {
  const std::string_view text = in.text();
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    if (length == 0 || text[i] == '\0') return in.wrong(text.substr(i, 1), "this is not UTF-8 text");
    i += length;
  }
  return true;
}

bool has_cue_times(std::string_view text) { return text.find(" --> ") != std::string_view::npos; }

bool read_by_content(WordsReading& in, const std::string& name) {
  const std::string_view begin = without_blanks(in.text().substr(0, 200));
  const std::string end = ending(name);
  if (begin.starts_with('{') || begin.starts_with('[') || end == "json") return read_whisper(in);
  if (begin.starts_with("File type = \"ooTextFile") || end == "textgrid") return read_text_grid(in);
  if (begin.starts_with("WEBVTT") || end == "vtt" || end == "srt" || has_cue_times(in.text())) return read_cues(in);
  return read_word_lines(in);
}

}  // namespace

std::string_view take_line_of(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(std::min(rest.size(), end + 1));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view without_blanks(std::string_view s) {
  while (!s.empty() && is_blank(s.front())) s.remove_prefix(1);
  while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
  return s;
}

std::string plain_cue(std::string_view cue) {
  constexpr std::pair<std::string_view, std::string_view> entities[] = {
      {"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&nbsp;", " "}, {"&quot;", "\""}, {"&lrm;", ""}, {"&rlm;", ""}};
  std::string out;
  for (std::size_t i = 0; i < cue.size();) {
    const char close = cue[i] == '<' ? '>' : cue[i] == '{' ? '}' : 0;
    const std::size_t end = close ? cue.find(close, i) : std::string_view::npos;
    if (end != std::string_view::npos && (close == '>' || cue[i + 1] == '\\')) {
      i = end + 1;
      continue;
    }
    const auto known = std::find_if(std::begin(entities), std::end(entities),
                                    [&](const auto& e) { return cue.substr(i).starts_with(e.first); });
    if (known != std::end(entities))
      out += known->second, i += known->first.size();
    else
      out += cue[i++];
  }
  return out;
}

bool WordsReading::wrong(std::string_view at, const std::string& what) {
  if (error_) return false;
  const auto place = static_cast<std::size_t>(at.data() - text_.data());
  const std::string_view before = text_.substr(0, std::min(place, text_.size()));
  const std::size_t line_at = before.rfind('\n') + 1;
  error_ = fail(ErrorCode::file, fmt::format("{}:{}:{}: {}", name_, 1 + std::count(before.begin(), before.end(), '\n'),
                                             1 + count_characters(before.substr(line_at)), what));
  return false;
}

bool WordsReading::add(double start, double end, std::string_view word, std::string_view at) {
  word = without_blanks(word);
  if (word.empty()) return true;
  if (words_.words.size() % 4096 == 0) Cancellation::check();
  if (word.size() > longest_word) return wrong(at, fmt::format("a word can have at most {} bytes", longest_word));
  if (words_.words.size() == most_words)
    return wrong(at, fmt::format("a recording can have at most {} words", most_words));
  if (!(start >= 0) || !(end <= latest_word)) return wrong(at, "a word's time must be from 0 to four hours");
  if (end < start) return wrong(at, fmt::format("{} ends before it begins", said_piece(word)));
  if (!words_.words.empty() && start < words_.words.back().start - late)
    return wrong(at, fmt::format("the words are out of order: {} begins before {}", said_piece(word),
                                 said_piece(words_.words.back().text)));
  words_.add({start, end, std::string(word)});
  return true;
}

bool WordsReading::add_sentence(double start, double end, std::string_view sentence, std::string_view at) {
  std::vector<std::string_view> words;
  std::size_t sum = 0;
  for (std::string_view rest = without_blanks(sentence); !rest.empty(); rest = without_blanks(rest)) {
    const auto stop = std::find_if(rest.begin(), rest.end(), is_blank);
    words.push_back(rest.substr(0, static_cast<std::size_t>(stop - rest.begin())));
    sum += 1 + count_characters(words.back());
    rest.remove_prefix(words.back().size());
  }
  double from = start;
  std::size_t until = 0;
  for (const std::string_view word : words) {
    until += 1 + count_characters(word);
    const double to = start + (end - start) * static_cast<double>(until) / static_cast<double>(sum);
    if (!add(from, to, word, at)) return false;
    from = to;
  }
  return true;
}

bool WordsReading::seconds(std::string_view piece, double& out) {
  const auto r = fast_float::from_chars(piece.data(), piece.data() + piece.size(), out);
  if (r.ec == std::errc{} && r.ptr == piece.data() + piece.size() && std::isfinite(out)) return true;
  return wrong(piece, fmt::format("{} is not a time in seconds", said_piece(piece)));
}

bool WordsReading::clock(std::string_view piece, double& out) {
  const auto bad = [&] {
    return wrong(piece, fmt::format("{} is not a time such as 00:01:02.500", said_piece(piece)));
  };
  std::string_view rest = piece;
  double whole = 0;
  for (int parts = 1; parts <= 3; ++parts) {
    const std::size_t stop = std::min(rest.find_first_of(":.,"), rest.size());
    if (!digits_only(rest.substr(0, stop))) return bad();
    double number = 0;
    fast_float::from_chars(rest.data(), rest.data() + stop, number);
    if (parts > 1 && number >= 60) return bad();
    whole = whole * 60 + number;
    rest.remove_prefix(stop);
    if (!rest.starts_with(':')) {
      if (parts < 2 || (!rest.empty() && !digits_only(rest.substr(1)))) return bad();
      double part = 0;
      if (!rest.empty()) fast_float::from_chars(rest.data() + 1, rest.data() + rest.size(), part);
      out = whole + (rest.empty() ? 0 : part / std::pow(10, static_cast<double>(rest.size() - 1)));
      return true;
    }
    rest.remove_prefix(1);
  }
  return bad();
}

Result<std::shared_ptr<const SpokenWords>> WordsReading::result() {
  if (!error_ && words_.words.empty()) error_ = fail(ErrorCode::file, fmt::format("{} has no words", name_));
  if (error_) return *error_;
  return std::make_shared<const SpokenWords>(std::move(words_));
}

Result<std::shared_ptr<const SpokenWords>> read_words(std::string_view text, const std::string& name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  WordsReading in(text, name);
  if (readable(in)) read_by_content(in, name);
  return in.result();
}

Result<std::shared_ptr<const SpokenWords>> load_words(const std::string& path) {
  const FileContents in = read_contents(path, {.largest = largest_words_file});
  if (in.problem == ReadProblem::too_large)
    return fail(ErrorCode::range, fmt::format("{} has more than {} MiB", path, largest_words_file >> 20));
  if (in.problem != ReadProblem::none) {
    const auto whole = read_whole(path);  // for its message
    return whole ? fail(ErrorCode::file, fmt::format("{} cannot be read", path)) : whole.error();
  }
  return read_words(in.text, path);
}

std::string write_words(const SpokenWords& words) {
  std::string out;
  for (const SpokenWord& word : words.words) out += fmt::format("{:.3f} {:.3f} {}\n", word.start, word.end, word.text);
  return out;
}

}  // namespace betwixt
