// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/golden.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "app/command.h"
#include "base/counted.h"
#include "base/files.h"
#include "betwixt/picture.h"
#include "editor/plain_values.h"
#include "film/frames_apart.h"
#include "language/values.h"
#include "scene/appearance.h"
#include "scene/document.h"
#include "syntax/script_text.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

std::optional<double> number_in(std::string_view word) {
  double n = 0;
  const auto [end, wrong] = std::from_chars(word.data(), word.data() + word.size(), n);
  return wrong == std::errc() && end == word.data() + word.size() ? std::optional(n) : std::nullopt;
}
// Returns a number, or an angle in radians.
std::optional<double> tolerance_in(std::string_view word) {
  Cursor c(word);
  double n = 0;
  bool is_angle = false;
  return c.number_or_angle(n, is_angle) && c.at_line_end() ? std::optional(n) : std::nullopt;
}
bool is_blank(char c) { return c == ' ' || c == '\t'; }
// Returns an error's message and its hint.
std::string in_a_line(const Error& e) { return e.hint.empty() ? e.message : e.message + ": " + e.hint; }

std::string not_expected(const std::string& rest) {
  const std::string_view word = without_indent(rest);
  return fmt::format("'{}' is not expected{}", word, word.starts_with("with") ? ": did you mean 'within'?" : "");
}

// Reads one line. Errors: syntax.
class ExpectationReader {
 public:
  Result<std::optional<Expectation>> read(std::string_view line, int number) {
    std::string_view rest = without_comment(line);
    const Result<double> within = take_within(rest);
    if (!within) return within.error();
    const std::string_view word = take_piece(rest);
    if (word.empty()) return std::optional<Expectation>();
    if (word == "size") {
      size_ = parse_size(take_piece(rest));
      if (!size_) return wrong("size needs two numbers, as in size 320x180");
      return std::optional<Expectation>();
    }
    const std::string time(take_piece(rest)), name(take_piece(rest));
    if (word == "at") {
      const std::string value(without_indent(rest));
      if (value.empty()) return wrong("at needs a time, a target and a value, as in at 48f ball.position (1 2 3)");
      ExpectedValue e{time, name, value};
      if (*within >= 0) e.within = *within;
      return std::optional(Expectation{number, std::move(e)});
    }
    if (word != "frame") return wrong(fmt::format("'{}' is none of at, frame and size", word));
    if (name.size() < 3 || name.front() != '"' || name.back() != '"' || !without_indent(rest).empty())
      return wrong("frame needs a time and a picture, as in frame 48f \"bounce-48.png\"");
    ExpectedPicture e{time, name.substr(1, name.size() - 2), size_};
    if (*within >= 0) e.within = *within;
    return std::optional(Expectation{number, std::move(e)});
  }

 private:
  static Error wrong(std::string message) { return fail(ErrorCode::syntax, std::move(message)); }
  // Takes `within NUMBER` or `within ANGLE` from the end of a line. Returns -1 if there is none.
  static Result<double> take_within(std::string_view& line) {
    const std::size_t at = line.rfind(" within");
    if (at == std::string_view::npos || (at + 7 < line.size() && !is_blank(line[at + 7]))) return -1.0;
    std::string_view rest = line.substr(at + 7);
    const auto number = tolerance_in(take_piece(rest));
    if (!number || *number < 0)
      return wrong("within needs a number or an angle, not negative: within 0.001, within 0.1deg");
    line = line.substr(0, at);
    return *number;
  }
  std::optional<std::pair<int, int>> size_;
};

// The checks of one film.
class GoldenFilm {
 public:
  GoldenFilm(const std::string& file, bool update) : file_(file), update_(update) {}

  GoldenResult all() {
    const std::string script = fs::path(file_).replace_extension(".bx").string();
    const Result<std::string> text = read_whole(file_);
    if (!text) return failed(0, text.error().message);
    const auto expected = read_expectations(*text);
    if (!expected) return failed(expected.error().place.line, expected.error().message);
    const Loaded loaded = load_file(script, load_options());
    for (const Diagnostic& d : loaded.diagnostics)
      if (d.severity == Severity::error)
        result_.failures.push_back(fmt::format("{}:{}: {}", d.what.place.file, d.what.place.line, d.what.message));
    if (has_errors(loaded.diagnostics)) return ++result_.checks, std::move(result_);
    film_ = loaded.document;
    program_ = Program::compile(film_);
    for (const Expectation& e : *expected) {
      ++result_.checks;
      if (const auto* value = std::get_if<ExpectedValue>(&e.what))
        check(*value, e.line);
      else
        check(std::get<ExpectedPicture>(e.what), e.line);
    }
    return std::move(result_);
  }

 private:
  GoldenResult failed(int line, const std::string& why) {
    result_.failures.push_back(line > 0 ? fmt::format("{}:{}: {}", file_, line, why)
                                        : fmt::format("{}: {}", file_, why));
    return std::move(result_);
  }
  void fails(int line, const std::string& why) {
    result_.failures.push_back(fmt::format("{}:{}: {}", file_, line, why));
  }

  void check(const ExpectedValue& e, int line) {
    const auto time = read_time(e.time, film_, "at");
    if (!time) return fails(line, in_a_line(time.error()));
    const auto targets = find_targets(e.target, film_);
    if (!targets) return fails(line, in_a_line(targets.error()));
    if (targets->size() != 1)
      return fails(line, fmt::format("{} names {} targets, not one", e.target, targets->size()));
    const Target target = targets->front();
    std::vector<std::string> problems;
    const Value found = program_.read(std::vector{target}, *time, &problems).front();
    if (!problems.empty()) return fails(line, problems.front());
    std::string unreadable;
    if (agrees(found, target, e, unreadable)) return;
    if (unreadable.empty())
      fails(line, fmt::format("{} at {}: expected {}{}, found {}", e.target, e.time, e.value,
                              numbers(found).empty() || e.within == ExpectedValue().within
                                  ? ""
                                  : fmt::format(" within {}", write_number(e.within)),
                              plain_value(found, target, film_)));
    else
      fails(line, fmt::format("{} at {}: expected {}: {}; found {}", e.target, e.time, e.value, unreadable,
                              plain_value(found, target, film_)));
  }
  // `unreadable`: why the expected value is none of this target.
  bool agrees(const Value& found, const Target& target, const ExpectedValue& e, std::string& unreadable) const {
    const std::vector<double> is = numbers(found);
    std::vector<double> wanted;
    if (!target.query()) {
      Cursor c(e.value);
      c.rate = film_.rate(), c.ticks = film_.ticks();
      ValueReader reader{c, film_.scene(), nullptr, nullptr, nullptr};
      Value value;
      FunctionSpec spec = unbounded(spec_of(film_.scene(), target.function));
      const bool read = reader.value(spec, target.component, value);
      if (!read || !c.at_line_end()) {
        if (plain_value(found, target, film_) == e.value) return true;
        unreadable = !read && c.error ? in_a_line(*c.error) : not_expected(std::string(c.at, c.end));
        return false;
      }
      wanted = numbers(value);
      if (wanted.empty() || is.empty()) return value == found;
    } else {
      std::string plain = e.value;
      std::ranges::replace_if(
          plain, [](char c) { return c == '(' || c == ')'; }, ' ');
      std::string_view rest = plain;
      for (std::string_view word = take_piece(rest); !word.empty(); word = take_piece(rest)) {
        const auto n = number_in(word);
        if (!n) return plain_value(found, target, film_) == e.value;
        wanted.push_back(*n);
      }
    }
    return std::ranges::equal(is, wanted, [&](double a, double b) { return std::abs(a - b) <= e.within; });
  }

  void check(const ExpectedPicture& e, int line) {
    const auto time = read_time(e.time, film_, "frame");
    if (!time) return fails(line, time.error().message);
    const fs::path path = fs::path(file_).parent_path() / e.path;
    const std::string found_path = beside(path, ".found.png"), difference_path = beside(path, ".difference.png");
    RenderOptions options = options_for(film_, {}, e.size);
    options.linear = film_.transparent();
    const auto picture = picture_at(program_, *time, options);
    if (!picture) return fails(line, picture.error().message);
    std::error_code ignored;
    fs::remove(found_path, ignored), fs::remove(difference_path, ignored);
    if (update_) {
      const auto old = read_picture(path.string());
      if (old && difference(**old, *picture).pixels == 0) return;
      if (const Status s = write_png(path.string(), *picture); !s) return fails(line, s.error().message);
      return result_.written.push_back(path.string());
    }
    const auto wanted = read_picture(path.string());
    if (!wanted) return fails(line, wanted.error().message + ": betwixt test --update makes it");
    const PictureDifference d = difference(**wanted, *picture);
    if (d.most <= e.within) return;
    const Status kept = write_png(found_path, *picture);
    std::string see = kept ? ": see " + found_path : ": " + kept.error().message;
    const bool same_size = (*wanted)->width == picture->width && (*wanted)->height == picture->height;
    if (kept && same_size && write_png(difference_path, picture_of_difference(**wanted, *picture)))
      see += " and " + difference_path;
    if (!same_size)
      return fails(line, fmt::format("{}: expected {}x{} pixels, found {}x{}{}", e.path, (*wanted)->width,
                                     (*wanted)->height, picture->width, picture->height, see));
    fails(line, fmt::format("{} at {}: expected within {}, found {} of 255 in {}{}", e.path, e.time,
                            write_number(e.within), d.most, counted(d.pixels, "pixel"), see));
  }
  static std::string beside(fs::path path, const char* end) { return path.replace_extension().string() + end; }

  std::string file_;
  bool update_;
  Document film_;
  Program program_;
  GoldenResult result_;
};

}  // namespace

Result<std::vector<Expectation>> read_expectations(std::string_view text) {
  std::vector<Expectation> all;
  ExpectationReader reader;
  int number = 0;
  for (const std::size_t at : line_starts(text)) {
    auto one = reader.read(line_at(text, at), ++number);
    if (!one) {
      Error e = one.error();
      e.place.line = number;
      return e;
    }
    if (*one) all.push_back(**std::move(one));
  }
  return all;
}

GoldenResult check_golden(const std::string& expect_file, bool update) { return GoldenFilm(expect_file, update).all(); }

std::vector<std::string> golden_files(const std::string& path) {
  std::error_code wrong;
  if (!fs::is_directory(path, wrong)) {
    const std::string file = fs::path(path).replace_extension(".expect").string();
    return fs::exists(file, wrong) ? std::vector{file} : std::vector<std::string>();
  }
  std::vector<std::string> all;
  for (fs::recursive_directory_iterator at(path, fs::directory_options::skip_permission_denied, wrong), end;
       !wrong && at != end; at.increment(wrong)) {
    const std::string name = at->path().filename().string();
    if (at->is_directory(wrong) && name.size() > 1 && name[0] == '.') at.disable_recursion_pending();
    if (at->path().extension() == ".expect") all.push_back(at->path().lexically_normal().string());
  }
  std::ranges::sort(all);
  return all;
}

}  // namespace betwixt
