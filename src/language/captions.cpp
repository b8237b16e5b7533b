// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/captions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/cancellation.h"
#include "base/utf8.h"

namespace betwixt {
namespace {

constexpr double pause_between = 0.5;  // seconds of silence that end a caption
constexpr double stays = 0.4;          // a caption stays this long after its last word, if none follows

bool ends_with_any(std::string_view word, std::string_view signs) {
  while (!word.empty() && (word.back() == '"' || word.back() == '\'' || word.back() == ')')) word.remove_suffix(1);
  return !word.empty() && signs.find(word.back()) != std::string_view::npos;
}

// Divides a word that is longer than a line.
std::vector<SpokenWord> pieces_of(const SpokenWord& word, std::size_t most) {
  std::vector<SpokenWord> all;
  const double count = static_cast<double>(count_characters(word.text));
  double done = 0;
  for (std::string_view rest = word.text; !rest.empty();) {
    const std::string_view piece = first_characters(rest, most);
    const auto at = [&](double n) { return word.start + (word.end - word.start) * n / count; };
    const double next = done + static_cast<double>(count_characters(piece));
    all.push_back({at(done), at(next), std::string(piece)});
    done = next;
    rest.remove_prefix(piece.size());
  }
  return all;
}

// Writes the words in one line, or in two of about the same length.
std::string in_lines(std::span<const SpokenWord> words, std::size_t most) {
  std::size_t whole = words.size() - 1;
  for (const SpokenWord& word : words) whole += count_characters(word.text);
  std::size_t best = 0, nearest = SIZE_MAX, before = 0;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    before += count_characters(words[i].text) + 1;
    const std::size_t longer = std::max(before, whole - before);
    if (whole > most && longer < nearest) nearest = longer, best = i + 1;
  }
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i == best ? "\n" : " ") + clean_text(words[i].text);
  return text;
}

// Returns whether a caption ends before the word `next`, which would make it this long.
bool ends_before(std::span<const SpokenWord> words, const SpokenWord& next, std::size_t length,
                 const CaptionStyle& style) {
  const SpokenWord& last = words.back();
  if (words.size() >= style.words || length > 2 * style.letters - 4) return true;
  if (next.start - last.end >= pause_between || ends_with_any(last.text, ".!?")) return true;
  return ends_with_any(last.text, ",;:") && length > style.letters;
}

std::string clock_of(double seconds, char point) {
  const auto ms = static_cast<std::int64_t>(std::llround(1000 * std::max(seconds, 0.0)));
  return fmt::format("{:02}:{:02}:{:02}{}{:03}", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60, point, ms % 1000);
}

// In WebVTT these signs begin tags, and --> belongs to times.
std::string escaped_caption(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c == '&' || c == '<' || c == '>')
      out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : "&gt;";
    else
      out += c;
  return out;
}

}  // namespace

std::vector<Caption> captions_of(std::span<const SpokenWord> said, const CaptionStyle& style) {
  std::vector<SpokenWord> words;
  for (const SpokenWord& word : said)
    if (count_characters(word.text) <= style.letters)
      words.push_back(word);
    else
      for (SpokenWord& piece : pieces_of(word, style.letters)) words.push_back(std::move(piece));
  std::vector<Caption> all;
  for (std::size_t from = 0; from < words.size();) {
    if (all.size() % 1024 == 0) Cancellation::check();
    std::size_t to = from + 1, length = count_characters(words[from].text);
    for (; to < words.size(); ++to) {
      length += 1 + count_characters(words[to].text);
      if (ends_before(std::span(words).subspan(from, to - from), words[to], length, style)) break;
    }
    const std::span<const SpokenWord> these = std::span(words).subspan(from, to - from);
    double end = these.back().end + stays;
    if (to < words.size()) end = std::max(these.back().start, std::min(end, words[to].start));
    all.push_back({these.front().start, end, in_lines(these, style.letters)});
    from = to;
  }
  return all;
}

std::vector<Caption> captions_of_film(const Scene& s) {
  std::vector<Caption> all;
  for (std::uint32_t i = 0; i < s.objects.size(); ++i) {
    const Object* const o = find_object(s, ObjectId{i});
    if (!o || o->kind != Kind::sound || o->hidden) continue;
    for (Caption& c : captions_of(words_heard(s, ObjectId{i}))) all.push_back(std::move(c));
  }
  std::stable_sort(all.begin(), all.end(), [](const Caption& a, const Caption& b) { return a.start < b.start; });
  return all;
}

std::vector<Caption> captions_between(const std::vector<Caption>& of, double first, double last) {
  std::vector<Caption> all;
  for (const Caption& c : of)
    if (c.end > first && c.start < last)
      all.push_back({std::max(c.start, first) - first, std::min(c.end, last) - first, c.text});
  return all;
}

std::string write_srt(const std::vector<Caption>& captions) {
  std::string out;
  for (std::size_t i = 0; i < captions.size(); ++i)
    out += fmt::format("{}\n{} --> {}\n{}\n\n", i + 1, clock_of(captions[i].start, ','), clock_of(captions[i].end, ','),
                       captions[i].text);
  return out;
}

std::string write_webvtt(const std::vector<Caption>& captions) {
  std::string out = "WEBVTT\n\n";
  for (const Caption& c : captions)
    out += fmt::format("{} --> {}\n{}\n\n", clock_of(c.start, '.'), clock_of(c.end, '.'), escaped_caption(c.text));
  return out;
}

}  // namespace betwixt
