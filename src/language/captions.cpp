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
constexpr double longest_shown = 5;    // seconds of a last caption that nothing ends
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

// Returns whether a caption must end between two words, however short it is.
bool parts_thoughts(const SpokenWord& last, const SpokenWord& next) {
  return next.start - last.end >= pause_between || ends_with_any(last.text, ".!?");
}

// Returns where the captions of these words end, if each takes what it can: at most `letters`.
std::vector<std::size_t> filled(std::span<const SpokenWord> words, std::size_t letters, const CaptionStyle& style) {
  std::vector<std::size_t> ends;
  std::size_t first = 0, length = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t more = count_characters(words[i].text) + (i > first ? 1 : 0);
    const bool full = i - first >= style.words || length + more > letters ||
                      (i > first && ends_with_any(words[i - 1].text, ",;:") && length + more > style.letters);
    if (i > first && full)
      ends.push_back(i), first = i, length = count_characters(words[i].text);
    else
      length += more;
  }
  ends.push_back(words.size());
  return ends;
}

// Returns where `count` captions of about the same length end, preferably at commas; nothing if one would be too long.
std::vector<std::size_t> shared_evenly(std::span<const SpokenWord> words, std::size_t count,
                                       const CaptionStyle& style) {
  std::vector<std::size_t> before{0};  // letters and blanks
  for (const SpokenWord& word : words) before.push_back(before.back() + count_characters(word.text) + 1);
  std::vector<std::size_t> ends;
  std::size_t first = 0;
  for (std::size_t n = 1; n <= count; ++n) {
    const double aim = static_cast<double>(before.back() * n) / static_cast<double>(count);
    const auto before_limit = static_cast<std::size_t>(aim) + style.letters;
    const auto away = [&](std::size_t end) {
      const double comma = ends_with_any(words[end - 1].text, ",;:") ? static_cast<double>(style.letters) / 3 : 0;
      return std::abs(static_cast<double>(before[end]) - aim) - comma;
    };
    std::size_t best = n == count ? words.size() : first + 1;
    for (std::size_t end = first + 1; n < count && end < words.size() && before[end] < before_limit; ++end)
      if (away(end) < away(best)) best = end;
    if (best <= first || best - first > style.words || before[best] - before[first] > 2 * style.letters - 3) return {};
    ends.push_back(best), first = best;
  }
  return ends;
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
    Cancellation::check();
    std::size_t to = from + 1;
    while (to < words.size() && !parts_thoughts(words[to - 1], words[to])) ++to;
    const std::span<const SpokenWord> thought = std::span(words).subspan(from, to - from);
    std::size_t begin = 0;
    // As few captions as hold the words, and none with a single word beside a full one.
    std::vector<std::size_t> ends = filled(thought, 2 * style.letters - 4, style);
    if (auto even = shared_evenly(thought, ends.size(), style); !even.empty()) ends = std::move(even);
    for (const std::size_t stop : ends) {
      const std::span<const SpokenWord> these = thought.subspan(begin, stop - begin);
      const std::size_t next = from + stop;
      double end = these.back().end + stays;
      if (next < words.size()) end = std::max(these.back().start, std::min(end, words[next].start));
      all.push_back({these.front().start, end, in_lines(these, style.letters)});
      begin = stop;
    }
    from = to;
  }
  return all;
}

std::string captions_name(std::string_view sound) { return std::string(sound) + "-captions"; }

namespace {

// Returns the captions that a text of the film shows, or none if there is no such text.
std::vector<Caption> shown_captions(const Scene& s, const std::string& sound) {
  std::vector<Caption> all;
  const ObjectId id = s.names.find(captions_name(sound));
  const Object* const o = id ? find_object(s, id) : nullptr;
  const Slot* const slot = o && o->kind == Kind::text && !o->hidden ? o->find(fn::text) : nullptr;
  if (!slot || !slot->track) return all;
  bool shows = false, told = true;
  slot->track->events.each([&](const Event& e) {
    const Text* const text = std::get_if<Text>(&e.value);
    told = told && text;  // code may say it
    if (!told) return;
    const double t = e.time.seconds();
    if (shows) all.back().end = t;
    shows = !(*text)->empty();
    if (shows) all.push_back({t, t + longest_shown, **text});
  });
  if (!told) all.clear();
  return all;
}

}  // namespace

std::vector<Caption> captions_of_film(const Scene& s) {
  std::vector<Caption> all;
  for (std::uint32_t i = 0; i < s.objects.size(); ++i) {
    const Object* const o = find_object(s, ObjectId{i});
    if (!o || o->kind != Kind::sound || o->hidden) continue;
    std::vector<Caption> of = shown_captions(s, o->name);
    if (of.empty()) of = captions_of(words_heard(s, ObjectId{i}));
    for (Caption& c : of) all.push_back(std::move(c));
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
