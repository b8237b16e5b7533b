// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt diff: what has changed in a film, in words; a diff driver of Git.
#include <fmt/format.h>

#include <algorithm>

#include "app/command.h"
#include "app/diff_page.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "base/counted.h"
#include "base/files.h"
#include "base/json.h"
#include "base/tell_user.h"
#include "base/utf8.h"
#include "language/values.h"

namespace betwixt {
namespace {

struct DiffCall {
  std::vector<std::string> files;
  bool json = false, pictures = false;
  std::string page;
  PictureCall picture;
};

enum DiffExit { no_difference = 0, differences = 1, trouble = 2 };

// One of the two scripts: where its text is, and the name by which it finds its files.
struct DiffSide {
  std::string file, name, text;
  Document film;
};

std::optional<DiffSide> read_side(const std::string& file, const std::string& name) {
  DiffSide side{file, name, {}, {}};
  if (file != "/dev/null") {  // Git's name for a script that does not exist
    const Result<std::string> text = script_text(file);
    if (!text) return complain(text.error(), trouble), std::nullopt;
    side.text = *text;
  }
  Loaded loaded = load_text(side.text, name, load_options());
  for (const Diagnostic& d : loaded.diagnostics)
    if (d.severity == Severity::error) tell_user(d);
  if (has_errors(loaded.diagnostics)) return std::nullopt;
  side.film = std::move(loaded.document);
  return side;
}

// The differing frames between which no others are, and the frame among them that differs most.
struct FrameRun {
  int first = 0, last = 0;
  FrameApart worst;
};
std::vector<FrameRun> runs_of(const std::vector<FrameApart>& apart) {
  std::vector<FrameRun> runs;
  const auto weight = [](const FrameApart& f) { return std::pair(f.by.most, f.by.pixels); };
  for (const FrameApart& f : apart) {
    if (runs.empty() || runs.back().last + 1 != f.index)
      runs.push_back({f.index, f.index, f});
    else
      runs.back().last = f.index;
    if (weight(f) > weight(runs.back().worst)) runs.back().worst = f;
  }
  return runs;
}

// The comparison of all frames.
class FramesCompared {
 public:
  static Result<FramesCompared> make(const DiffCall& call, const DiffSide& old, const DiffSide& now) {
    const auto [a, b] = old.film.range();
    const auto [c, d] = now.film.range();
    const auto frames = frames_between(std::min(a, c), std::max(b, d), now.film.rate());
    if (!frames) return frames.error();
    FramesCompared made{old.film, now.film, *frames, call.picture.of(now.film)};
    made.options_.linear = old.film.transparent() || now.film.transparent();
    catch_stops();
    const auto apart =
        frames_apart(made.old_, made.now_, made.frames_, made.options_, [] { return !stop_requested(); });
    release_stops();
    if (!apart) return apart.error();
    made.apart_ = *apart, made.runs_ = runs_of(*apart);
    return made;
  }

  bool same() const { return runs_.empty(); }
  std::string words() const {
    if (same())
      return frames_.count == 1 ? std::string("the frame is the same to the byte")
                                : fmt::format("all {} frames are the same to the byte", frames_.count);
    std::string all;
    std::size_t said = 0;
    constexpr std::size_t most = 8;
    for (const FrameRun& r : runs_) {
      if (said++ == most) return all + fmt::format("\n{} more runs of frames differ", runs_.size() - most);
      const std::string by = fmt::format("by {} of 255", r.worst.by.most);
      all += (all.empty() ? "" : "\n") + (r.first == r.last
                                              ? fmt::format("frame {} differs, {}", name(r.first), by)
                                              : fmt::format("frames {}..{} differ, most at {} ({})", name(r.first),
                                                            name(r.last), name(r.worst.index), by));
    }
    return all;
  }
  std::string json() const {
    std::string all;
    for (const FrameApart& f : apart_)
      all += fmt::format("{}{{\"frame\":{},\"most\":{},\"pixels\":{}}}", all.empty() ? "" : ",", name(f.index),
                         f.by.most, f.by.pixels);
    return fmt::format("{{\"compared\":{},\"width\":{},\"height\":{},\"differing\":[{}]}}", frames_.count,
                       options_.width, options_.height, all);
  }
  // Returns pictures of the frames that differ most, one of each run.
  Result<std::vector<DiffPicture>> pictures() const {
    constexpr std::size_t most = 6;
    std::vector<FrameRun> runs = runs_;
    std::ranges::stable_sort(runs, std::greater<>(), [](const FrameRun& r) { return r.worst.by.most; });
    if (runs.size() > most) runs.resize(most);
    std::ranges::sort(runs, {}, &FrameRun::first);
    std::vector<DiffPicture> all;
    for (const FrameRun& r : runs) {
      const Time t = frames_.time(r.worst.index);
      auto a = picture_at(old_, t, options_), b = picture_at(now_, t, options_);
      if (!a) return a.error();
      if (!b) return b.error();
      all.push_back(
          {fmt::format("Frame {}: {} {}, by up to {} of 255", name(r.worst.index), counted(r.worst.by.pixels, "pixel"),
                       r.worst.by.pixels == 1 ? "differs" : "differ", r.worst.by.most),
           *std::move(a), *std::move(b)});
    }
    return all;
  }

 private:
  FramesCompared(const Document& old, const Document& now, FrameList frames, RenderOptions options)
      : old_(Program::compile(old)), now_(Program::compile(now)), frames_(frames), options_(std::move(options)) {}
  std::string name(int index) const { return write_number(frames_.rate.frame_number(frames_.time(index))); }

  Program old_, now_;
  FrameList frames_;
  RenderOptions options_;
  std::vector<FrameApart> apart_;
  std::vector<FrameRun> runs_;
};

std::string json_of(const FilmChange& c, Rate rate) {
  const auto time = [&](const char* key, std::optional<Time> t) {
    return t ? fmt::format("\"{}\":{},", key, json_text(*t == earliest_time ? "beginning" : write_time(*t, rate)))
             : std::string();
  };
  std::string events;
  for (const EventChange& e : c.events)
    events += fmt::format("{}{{{}{}\"before\":{},\"after\":{}}}", events.empty() ? "" : ",", time("was", e.was),
                          time("is", e.is), json_text(e.before), json_text(e.after));
  return fmt::format("{{\"what\":{},\"part\":{},\"name\":{},\"before\":{},\"after\":{},\"events\":[{}],\"words\":{}}}",
                     json_text(to_string(c.what)), json_text(c.part), json_text(c.name), json_text(c.before),
                     json_text(c.after), events, json_text(c.words));
}

int print(const DiffCall& call, const DiffSide& old, const DiffSide& now) {
  const std::vector<FilmChange> all = compare(old.film, now.film);
  std::optional<FramesCompared> frames;
  if (call.pictures || !call.page.empty()) {
    auto made = FramesCompared::make(call, old, now);
    if (!made) return complain(made.error(), trouble);
    frames.emplace(*std::move(made));
  }
  if (call.json) {
    std::string changes;
    for (const FilmChange& c : all) changes += (changes.empty() ? "" : ",") + json_of(c, now.film.rate());
    fmt::print("{{\"same\":{},\"same_text\":{},\"changes\":[{}]{}}}\n", all.empty(), old.text == now.text, changes,
               frames ? ",\"frames\":" + frames->json() : "");
  } else {
    for (const FilmChange& c : all) fmt::print("{}\n", visible(c.words));
    if (all.empty() && old.text != now.text) fmt::print("only the text differs: the film is the same\n");
    if (frames) fmt::print("{}\n", frames->words());
  }
  if (!call.page.empty()) {
    const auto pictures = frames->pictures();
    if (!pictures) return complain(pictures.error(), trouble);
    const auto page = diff_page(fmt::format("{} and {}", old.name, now.name), all, frames->words(), *pictures);
    if (!page) return complain(page.error(), trouble);
    if (const Status s = write_whole(call.page, *page, true); !s) return complain(s.error(), trouble);
  }
  return all.empty() && (!frames || frames->same()) ? no_difference : differences;
}

// Git calls `betwixt diff PATH OLD HEX MODE NEW HEX MODE`, with two more if the file has another name now. It takes any
// exit code but 0 as a failure.
int diff_for_git(const DiffCall& call) {
  const std::string& path = call.files[0];
  fmt::print("{}\n", visible(path));
  const auto old = read_side(call.files[1], path), now = read_side(call.files[4], path);
  std::fflush(stderr);
  if (old && now)
    print(call, *old, *now);
  else
    fmt::print("a version has errors, so the films cannot be compared: git diff --no-ext-diff shows the lines\n");
  return all_done;
}

int diff(const DiffCall& call) {
  if (call.files.size() == 7 || call.files.size() == 9) return diff_for_git(call);
  if (call.files.size() != 2)
    return complain(fail(ErrorCode::range, fmt::format("diff compares two scripts, not {}", call.files.size()),
                         "as in betwixt diff old.bx new.bx"),
                    trouble);
  const auto old = read_side(call.files[0], call.files[0]), now = read_side(call.files[1], call.files[1]);
  return old && now ? print(call, *old, *now) : static_cast<int>(trouble);
}

const Enlisted enlisted_diff(diff, [](DiffCall& call) -> Subcommand {
  return {.rank = 72,
          .name = "diff",
          .sentence = "prints what has changed in a film, in words",
          .takes = joined(
              {{{.name = "FILES",
                 .sentence = "the old and the new script",
                 .into = &call.files,
                 .required = true,
                 .offer = Offer::scripts},
                flag("--json", "one JSON object", call.json),
                flag("--pictures", "also draws all frames of both, and prints which differ", call.pictures),
                file_option("--page", "PAGE", "also writes a web page with the pictures that differ most, side by side",
                            &call.page)},
               picture_parameters(call.picture)}),
          .example = "betwixt diff old.bx new.bx --page difference.html",
          .manual =
              "Films are compared by what they show: the order of lines, comments and layout make no difference. "
              "The exit code is 0 if the films are the same, 1 if they differ, and 2 if one cannot be read. As a "
              "diff driver of Git: git config diff.betwixt.command 'betwixt diff'"};
});

}  // namespace
}  // namespace betwixt
