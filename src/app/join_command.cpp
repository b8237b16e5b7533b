// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <numeric>
#include <string_view>

#include "app/command.h"
#include "app/making.h"
#include "app/subcommand.h"
#include "base/tell_user.h"
#include "betwixt/film.h"
#include "betwixt/picture.h"
#include "betwixt/program.h"
#include "film/formats.h"
#include "film/numbered.h"
#include "language/captions.h"

namespace betwixt {
namespace {

struct JoinCall {
  std::string pictures, out, sound;
  std::optional<std::pair<int, int>> numbers;
  std::optional<Rate> rate = {};
  int jobs = 0;
  ColorCoding colors = ColorCoding::srgb;
  bool alpha = false, keep_old = false;
};

// Reads two whole numbers with a separator. Returns nullopt on an error.
std::optional<std::pair<int, int>> two_numbers(std::string_view text, std::string_view between) {
  int a = 0, b = 0;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, a);
  if (first.ec != std::errc() || !std::string_view(first.ptr, end).starts_with(between)) return std::nullopt;
  const auto second = std::from_chars(first.ptr + between.size(), end, b);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return std::pair(a, b);
}

Status read_numbers(const std::string& text, JoinCall& to) {
  to.numbers = two_numbers(text, "..");
  if (to.numbers && to.numbers->first <= to.numbers->second) return Nothing{};
  return fail(ErrorCode::range, fmt::format("'{}' is not a range of numbers such as 1..48", text));
}

Status read_rate(const std::string& text, JoinCall& to) {
  const auto ratio = two_numbers(text.find('/') == std::string::npos ? text + "/1" : text, "/");
  if (!ratio || ratio->first < 1 || ratio->second < 1 || ratio->first / ratio->second > 1000)
    return fail(ErrorCode::range, fmt::format("'{}' is not a rate such as 24 or 30000/1001", text));
  to.rate = Rate{ratio->first, ratio->second};
  return Nothing{};
}

Error holes(const JoinCall& call, const std::vector<int>& missing, std::size_t of) {
  return fail(ErrorCode::file,
              fmt::format("{} of {} pictures {} missing or broken: {}", missing.size(), of,
                          missing.size() == 1 ? "is" : "are", runs(missing)),
              fmt::format("to make them: betwixt render SCRIPT -o {} --missing", call.pictures));
}

// Returns the numbers of the film's pictures. Errors: range, file (missing pictures).
Result<std::vector<int>> numbers(const JoinCall& call, const Output& pictures) {
  if (pictures.format)
    return fail(ErrorCode::range, fmt::format("\"{}\" is not a name of numbered pictures", call.pictures),
                "as in frame-%04d.png");
  const auto there = numbers_there(pictures);
  if (!there) return there.error();
  if (there->empty() && !call.numbers)
    return fail(ErrorCode::file, fmt::format("there are no pictures {}", call.pictures));
  const auto [first, last] = call.numbers.value_or(std::pair(0, 0));
  const int from = call.numbers ? first : *there->begin(), to = call.numbers ? last : *there->rbegin();
  if (static_cast<std::int64_t>(to) - from >= 10'000'000)
    return fail(ErrorCode::range, "a film can have at most 10,000,000 pictures");
  std::vector<int> all(static_cast<std::size_t>(to - from + 1)), missing;
  std::iota(all.begin(), all.end(), from);
  for (const int n : all)
    if (!there->contains(n)) missing.push_back(n);
  if (!missing.empty()) return holes(call, missing, all.size());
  return all;
}

// Returns the numbers of intact pictures that differ in size from the first.
std::vector<int> other_sizes(const Output& pictures, const std::vector<int>& all, const FilmOptions& options) {
  std::vector<int> others;
  for (const int n : all)
    if (const auto p = read_linear_picture(pictures.path(n));
        p && (p->width != options.width || p->height != options.height))
      others.push_back(n);
  return others;
}

// Returns all broken pictures. Called only after one was found.
std::vector<int> broken_ones(const Output& pictures, const std::vector<int>& all, const FilmOptions& options) {
  std::vector<int> broken;
  for (const int n : all)
    if (!whole_picture(pictures.path(n), options.width, options.height)) broken.push_back(n);
  return broken;
}

bool has_clear(const LinearPicture& picture) {
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
    if (picture.rgba[i] < 1) return true;
  return false;
}

// Loads the script with the film's sounds, if the call names one. Prints errors and returns the exit code.
int open_sounds(const JoinCall& call, std::optional<Program>& heard) {
  if (call.sound.empty()) return all_done;
  if (!takes_sound(call.out))
    return complain(
        fail(ErrorCode::range, fmt::format("--sound: {} cannot have sound; .mp4, .webm and .mov can", call.out)),
        wrong_call);
  const std::optional<Document> script = open_script(call.sound);
  if (!script) return wrong_input;
  heard = Program::compile(*script);
  return all_done;
}

int join(const JoinCall& call) {
  const Result<Output> pictures = read_output(call.pictures);
  if (!pictures) return complain(pictures.error(), wrong_call);
  if (call.out == call.pictures)
    return complain(fail(ErrorCode::range, "the film would overwrite its own pictures"), wrong_call);
  const Result<std::vector<int>> all = numbers(call, *pictures);
  if (!all) return complain(all.error(), all.error().code == ErrorCode::range ? wrong_call : wrong_input);
  std::optional<Program> heard;
  if (const int code = open_sounds(call, heard); code != all_done) return code;
  if (Status s = check_colors(call.out, call.colors, call.alpha); !s) return complain(s.error(), wrong_call);
  const bool linear = pictures->exr || takes_16_bits(call.out) || call.colors != ColorCoding::srgb;
  const auto first = read_linear_picture(pictures->path(all->front()));

  FilmOptions options;
  options.path = call.out;
  options.frames = static_cast<int>(all->size());
  options.rate = call.rate.value_or(heard ? heard->document().rate() : Rate{24, 1});
  if (heard && !(options.rate == heard->document().rate()))
    tell_user(fmt::format("betwixt: notice: {} has another rate, so its sounds will be out of sync\n", call.sound));
  if (first) options.width = first->width, options.height = first->height;
  options.alpha = call.alpha || (first && has_clear(*first));
  if (options.alpha && !takes_alpha(call.out)) say_not_clear(call.out);
  options.jobs = call.jobs, options.colors = call.colors;
  options.overwrite = !call.keep_old;
  if (heard && has_sounds(heard->document()))
    options.sounds = [&](std::span<float> stereo) {
      return mix_sounds(*heard, heard->document().rate().frame(all->front()), stereo);
    };
  if (heard && takes_captions(call.out)) {
    const Rate rate = heard->document().rate();
    options.captions =
        write_srt(captions_between(captions_of_film(heard->document().scene()), rate.frame(all->front()).seconds(),
                                   rate.frame(all->back() + 1).seconds()));
  }
  const auto path = [&](int k) { return pictures->path((*all)[static_cast<std::size_t>(k)]); };
  const LinearPainter linear_painter = [&](int k, LinearPicture& out) -> Status {
    auto read = read_linear_picture(path(k));
    if (!read) return read.error();
    out = *std::move(read);
    return Nothing{};
  };
  const Painter painter = [&](int k, Picture& out) -> Status {
    const auto read = read_picture(path(k));
    if (!read) return read.error();
    out = **read;
    return Nothing{};
  };
  const Result<FilmStats> made =
      linear ? make_linear_film(
                   options, [&]() -> Result<LinearPainter> { return linear_painter; }, shown_progress(options))
             : make_film(
                   options, [&]() -> Result<Painter> { return painter; }, shown_progress(options));
  if (made || stop_requested()) return say_made(made, options);
  if (const std::vector<int> others = other_sizes(*pictures, *all, options); first && !others.empty())
    return complain(
        fail(ErrorCode::range, fmt::format("the first picture has {}x{} pixels, but these have another size: {}",
                                           options.width, options.height, runs(others))),
        wrong_input);
  const std::vector<int> broken = broken_ones(*pictures, *all, options);
  return broken.empty() ? say_made(made, options) : complain(holes(call, broken, all->size()), wrong_input);
}

const Enlisted enlisted_join(join, [](JoinCall& call) -> Subcommand {
  return {
      .rank = 15,
      .name = "join",
      .sentence = "makes a film of numbered pictures",
      .takes = {{.name = "PICTURES",
                 .sentence = "the name of the pictures, as in frame-%04d.png",
                 .into = &call.pictures,
                 .required = true,
                 .offer = Offer::files},
                output_parameter(call.out, "OUT", "the film; its ending chooses the format"),
                {.name = "--frames",
                 .value = "A..B",
                 .sentence = "the numbers of the pictures; by default from the first to the last",
                 .into = ReadValue([&call](const std::string& text) { return read_numbers(text, call); })},
                {.name = "--rate",
                 .value = "N",
                 .sentence = "pictures a second, 24 or 30000/1001; by default the rate of the script of --sound, or 24",
                 .into = ReadValue([&call](const std::string& text) { return read_rate(text, call); })},
                colors_parameter(call.colors),
                {.name = "--jobs",
                 .value = "N",
                 .sentence = "pictures read in parallel; by default chosen for this machine",
                 .into = &call.jobs,
                 .range = {{1, 256}}},
                {.name = "--sound",
                 .value = "SCRIPT",
                 .sentence = "a script; the film gets its sounds and captions, starting at the first picture's frame",
                 .into = &call.sound,
                 .offer = Offer::scripts},
                flag("--alpha", "gives the film an alpha channel, even if the first picture is opaque", call.alpha),
                flag("--no-overwrite", "keeps an existing file", call.keep_old)},
      .example = "betwixt join frame-%04d.png -o film.mp4 --rate 25",
      .manual = "If pictures are missing or broken, join makes no film and lists them."};
});

}  // namespace
}  // namespace betwixt
