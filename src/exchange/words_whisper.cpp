// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Words from the JSON of Whisper and of programs like it: segments with words, segments alone, or words alone.
#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>

#include "exchange/words_reading.h"

namespace betwixt {
namespace {

constexpr int deepest_json = 64;

// Walks through JSON once, and keeps nothing of what it passes over.
class JsonWalk {
 public:
  JsonWalk(WordsReading& in, std::string_view rest) : in_(in), rest_(rest) {}

  std::string_view here() const { return rest_.substr(0, rest_.empty() ? 0 : 1); }
  std::string_view rest() const { return rest_; }
  bool wrong(const std::string& what) { return in_.wrong(here(), what); }
  char peek() {
    rest_ = without_blanks_before(rest_);
    return rest_.empty() ? '\0' : rest_[0];
  }
  // Calls f(key) for each member; f passes the value. Calls f() for each item.
  template <class F>
  bool object(F&& f) {
    return listed('{', '}', [&] {
      std::string key;
      if (!text(key)) return false;
      if (peek() != ':') return wrong("':' is missing here");
      rest_.remove_prefix(1);
      return f(std::string_view(key));
    });
  }
  template <class F>
  bool array(F&& f) {
    return listed('[', ']', f);
  }
  bool text(std::string& out) {
    out.clear();
    if (peek() != '"') return wrong("a text in quotes is missing here");
    rest_.remove_prefix(1);
    while (!rest_.empty() && rest_[0] != '"') {
      if (rest_[0] == '\n') return wrong("this text is not closed");
      if (rest_[0] != '\\')
        out += rest_[0], rest_.remove_prefix(1);
      else if (!escape(out))
        return false;
    }
    if (rest_.empty()) return wrong("this text is not closed");
    return rest_.remove_prefix(1), true;
  }
  bool number(double& out) {
    peek();
    const auto r = fast_float::from_chars(rest_.data(), rest_.data() + rest_.size(), out);
    if (r.ec != std::errc{}) return wrong("a number is missing here");
    return rest_.remove_prefix(static_cast<std::size_t>(r.ptr - rest_.data())), true;
  }
  bool pass() {
    std::string ignored;
    double number_ignored = 0;
    const char c = peek();
    if (c == '{') return object([&](std::string_view) { return pass(); });
    if (c == '[') return array([&] { return pass(); });
    if (c == '"') return text(ignored);
    for (const std::string_view word : {"true", "false", "null", "NaN"})
      if (rest_.starts_with(word)) return rest_.remove_prefix(word.size()), true;
    return number(number_ignored);
  }

 private:
  static std::string_view without_blanks_before(std::string_view s) {
    s.remove_prefix(std::min(s.find_first_not_of(" \t\r\n"), s.size()));
    return s;
  }
  template <class F>
  bool listed(char open, char close, F&& each) {
    if (peek() != open) return wrong(fmt::format("'{}' is missing here", open));
    if (++depth_ > deepest_json) return wrong("this JSON is nested too deeply");
    rest_.remove_prefix(1);
    for (bool first = true; peek() != close; first = false) {
      if (!first && peek() != ',') return wrong(fmt::format("',' or '{}' is missing here", close));
      if (!first) rest_.remove_prefix(1);
      if (!each()) return false;
    }
    --depth_;
    return rest_.remove_prefix(1), true;
  }
  bool unit(std::size_t at, unsigned& out) const {
    out = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
      if (i >= rest_.size() || !std::isxdigit(static_cast<unsigned char>(rest_[i]))) return false;
      out = 16 * out + static_cast<unsigned>(rest_[i] <= '9' ? rest_[i] - '0' : (rest_[i] | 0x20) - 'a' + 10);
    }
    return true;
  }
  bool escape(std::string& out) {
    constexpr std::string_view letters = "\"\\/bfnrt", means = "\"\\/\b\f\n\r\t";
    if (rest_.size() < 2) return wrong("this text is not closed");
    if (const std::size_t at = letters.find(rest_[1]); at != std::string_view::npos)
      return out += means[at], rest_.remove_prefix(2), true;
    unsigned c = 0, low = 0;
    if (rest_[1] != 'u' || !unit(2, c)) return wrong("JSON has no such escape");
    std::size_t length = 6;
    if (c >= 0xD800 && c < 0xDC00 && rest_.substr(6, 2) == "\\u" && unit(8, low) && low >= 0xDC00 && low < 0xE000)
      c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00), length = 12;
    if ((c >= 0xD800 && c < 0xE000) || c == 0) c = 0xFFFD;
    const auto put = [&](unsigned byte) { out += static_cast<char>(byte); };
    if (c < 0x80)
      put(c);
    else if (c < 0x800)
      put(0xC0 | c >> 6), put(0x80 | (c & 63));
    else if (c < 0x10000)
      put(0xE0 | c >> 12), put(0x80 | (c >> 6 & 63)), put(0x80 | (c & 63));
    else
      put(0xF0 | c >> 18), put(0x80 | (c >> 12 & 63)), put(0x80 | (c >> 6 & 63)), put(0x80 | (c & 63));
    rest_.remove_prefix(length);
    return true;
  }

  WordsReading& in_;
  std::string_view rest_;
  int depth_ = 0;
};

// A word, or a segment that may have words of its own.
struct WhisperItem {
  std::optional<double> start, end;
  std::string said;
  bool divided = false;
};

bool read_whisper_item(WordsReading& in, JsonWalk& walk, double& last);

bool read_whisper_items(WordsReading& in, JsonWalk& walk, double& last, bool& any) {
  return walk.array([&] { return any = true, read_whisper_item(in, walk, last); });
}

// {"from": 0, "to": 1200}: milliseconds, as whisper.cpp writes them.
bool read_offsets(JsonWalk& walk, WhisperItem& item) {
  return walk.object([&](std::string_view key) {
    double ms = 0;
    if (key != "from" && key != "to") return walk.pass();
    if (!walk.number(ms)) return false;
    (key == "from" ? item.start : item.end) = ms / 1000;
    return true;
  });
}

bool read_moment(JsonWalk& walk, std::optional<double>& out) {
  double seconds = 0;
  if (walk.peek() == 'n') return walk.pass();  // null
  if (!walk.number(seconds)) return false;
  return out = seconds, true;
}

// A word without a time, such as a number that the aligner does not know, is at the end of the word before it.
bool read_whisper_item(WordsReading& in, JsonWalk& walk, double& last) {
  walk.peek();
  const std::string_view at = walk.here();
  WhisperItem item;
  const bool read = walk.object([&](std::string_view key) {
    if (key == "start") return read_moment(walk, item.start);
    if (key == "end") return read_moment(walk, item.end);
    if (key == "offsets" && walk.peek() == '{') return read_offsets(walk, item);
    if (key == "words" && walk.peek() == '[') return read_whisper_items(in, walk, last, item.divided);
    if ((key == "word" || key == "text") && walk.peek() == '"') return walk.text(item.said);
    return walk.pass();
  });
  if (!read) return false;
  if (item.divided || without_blanks(item.said).empty()) return true;
  const double start = item.start.value_or(last);
  last = item.end.value_or(start);
  return in.add_sentence(start, last, item.said, at);
}

}  // namespace

bool read_whisper(WordsReading& in) {
  JsonWalk walk(in, in.text());
  std::string_view words, segments;
  double last = 0;
  bool any = false;
  if (walk.peek() == '[') return read_whisper_items(in, walk, last, any);
  const bool read = walk.object([&](std::string_view key) {
    if (walk.peek() == '[' && key == "words") words = walk.rest();
    if (walk.peek() == '[' && (key == "segments" || key == "transcription")) segments = walk.rest();
    return walk.pass();
  });
  if (!read) return false;
  if (walk.peek() != '\0') return walk.wrong("nothing more is expected here");
  if (!words.empty()) {
    JsonWalk listed(in, words);
    if (!read_whisper_items(in, listed, last, any)) return false;
  }
  if (any) return true;
  if (segments.empty()) return in.wrong(in.text(), "this JSON has neither \"segments\" nor \"words\"");
  JsonWalk listed(in, segments);
  return read_whisper_items(in, listed, last, any);
}

}  // namespace betwixt
