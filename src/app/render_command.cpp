// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "app/code_errors.h"
#include "app/command.h"
#include "app/each.h"
#include "app/making.h"
#include "app/presentation.h"
#include "app/stats.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "base/counted.h"
#include "base/files.h"
#include "base/tell_user.h"
#include "betwixt/film.h"
#include "betwixt/program.h"
#include "film/formats.h"
#include "film/output.h"
#include "language/captions.h"
#include "language/cursor.h"
#include "language/values.h"

namespace betwixt {
namespace {

// Prints a description of the film, for programs that render it in parts.
int print_plan(const FilmOptions& o, const FrameList& frames) {
  const Result<Output> place = read_output(o.path);
  if (!place) return complain(place.error(), wrong_call);
  if (const Status s = check_place(place->format ? o.path : place->path(o.first_number), o.overwrite); !s)
    return complain(s.error(), wrong_call);
  const std::string rate = o.rate.den == 1 ? std::to_string(o.rate.num) : fmt::format("{}/{}", o.rate.num, o.rate.den);
  const std::string first = write_number(frames.rate.frame_number(frames.first));
  fmt::print("{{\"first\":{},\"frames\":{},\"rate\":\"{}\",\"width\":{},\"height\":{},", first, o.frames, rate, o.width,
             o.height);
  fmt::print("\"bits\":{},\"alpha\":{},\"sound\":{}}}\n",
             takes_16_bits(o.path) || o.colors != ColorCoding::srgb ? 16 : o.bits, o.alpha && takes_alpha(o.path),
             static_cast<bool>(o.sounds));
  return all_done;
}

void print_stats(const FilmStats& s, const Spending& spent, const Program& program) {
  const auto each = [&](double seconds) { return 1000 * seconds / s.frames; };
  fmt::print(
      stderr,
      "painting {:.2f} s ({:.1f} ms a frame), encoding {:.2f} s ({:.1f} ms a frame), in total {:.1f} ms a frame\n",
      s.painting, each(s.painting), s.encoding, each(s.encoding), each(s.seconds));
  spent.print("a frame",
              {Stage::tracks, Stage::procedures, Stage::environments, Stage::hierarchy, Stage::looks, Stage::gather,
               Stage::draw, Stage::read_back},
              s.encoding);
  print_sizes(program);
}

// Prints notices about features of the script that the film's format lacks.
void say_what_is_lost(const RenderCall& call, const Document& document) {
  if (!read_output(call.out)) return;  // the path is invalid, so no film is made
  if (document.transparent() && !takes_alpha(call.out)) say_not_clear(call.out);
  if (has_sounds(document) && !takes_sound(call.out))
    tell_user(fmt::format("betwixt: notice: {} cannot have sound; .mp4, .webm and .mov can\n", call.out));
}

// Writes what is spoken in these frames to the file of --captions.
int put_captions(const RenderCall& call, const Document& document, const FrameList& frames) {
  const std::string kind = ending(call.captions);
  if (kind != "vtt" && kind != "srt")
    return complain(fail(ErrorCode::range, fmt::format("captions are a .vtt or a .srt, not \"{}\"", call.captions)),
                    wrong_call);
  const double first = frames.time(0).seconds(), last = frames.time(frames.count).seconds();
  const std::vector<Caption> all = captions_between(captions_of_film(document.scene()), first, last);
  if (all.empty()) tell_user(fmt::format("betwixt: notice: nothing is spoken, so {} has no captions\n", call.captions));
  const Status s = write_whole(call.captions, kind == "vtt" ? write_webvtt(all) : write_srt(all), !call.keep_old);
  return s ? all_done : complain(s.error(), wrong_call);
}

// Writes the descriptions of the film, if the user asks for them.
Status write_descriptions(const RenderCall& call, const Document& document, const FrameList& frames) {
  if (call.descriptions.empty()) return Nothing{};
  const Time from = frames.time(0), until = frames.time(frames.count - 1) + frames.rate.span(1);
  return write_whole(call.descriptions, descriptions_vtt(document, from, until), !call.keep_old);
}

// The steps as pages.
int render_pdf(const RenderCall& call, const Program& program, const FrameList& frames) {
  const Result<int> pages =
      write_steps_as_pdf(program, frames, call.picture.of(program.document()), call.quality, call.out, !call.keep_old);
  if (!pages) return complain(pages.error(), wrong_input);
  tell_user(fmt::format("{}, {}\n", counted(static_cast<std::size_t>(*pages), "page"), call.out));
  return all_done;
}

int render(RenderCall& call) {
  if (!call.each.empty()) return render_each(call);
  call.out = output_or(call.out, call.file, "mp4");
  const Result<Outgoing> outgoing = Outgoing::begin(call.out, "mp4");
  if (!outgoing) return complain(outgoing.error(), wrong_call);
  const std::optional<Document> document = open_script(call.file);
  if (!document) return wrong_input;
  Result<FrameList> frames = read_frames(call.frames, *document);
  if (frames && call.rate) frames = frames_between(frames->first, frames->last, *call.rate);
  if (!frames) return complain(frames.error(), wrong_call);

  const Result<std::optional<Blur>> exposure = call.exposure.of(*document);
  if (!exposure) return complain(exposure.error(), wrong_call);

  const Program program = Program::compile(*document);
  if (ending(call.out) == "pdf" && call.colors != ColorCoding::srgb)
    return complain(fail(ErrorCode::range, "--colors: .pdf has the colors of sRGB only",
                         ".mp4, .webm, .mov, .png and .exr can have others"),
                    wrong_call);
  if (ending(call.out) == "pdf") return render_pdf(call, program, *frames);
  RenderJob job = render_job(program, call.out, *frames, call.picture.of(*document), *exposure, call.bits, call.colors);
  const Time last = frames->time(frames->count - 1);
  const Findings found = look_through(program, call.file, frames->time(0), last, frames->count);
  if (stopped_by(found, call.keep_going)) return wrong_input;
  Problems problems;
  for (const Diagnostic& d : found.errors) problems.known(d.what.message);
  const auto say = [&](const std::vector<std::string>& all) { problems.say(all); };
  Spending spent;
  const auto listened = [&]<class Out>(Result<std::function<Status(int, Out&)>> painter) {
    if (!painter || !call.stats) return painter;
    return Result(std::function([&, paint = *painter](int k, Out& out) {
      const Spending::Listening listening(&spent);
      return paint(k, out);
    }));
  };
  job.film.jobs = call.jobs;
  job.film.overwrite = !call.keep_old;
  job.film.only_missing = call.missing;
  job.film.quality = call.quality, job.film.codec = call.codec;
  if (const Status s = check_encoding(job.film); !s) return complain(s.error(), wrong_call);
  say_what_is_lost(call, *document);

  if (call.plan) {
    if (Status s = check_options(job.pictures); !s) return complain(s.error(), wrong_call);
    return print_plan(job.film, *frames);
  }
  if (!call.captions.empty())
    if (const int code = put_captions(call, *document, *frames); code != all_done) return code;
  const Result<FilmStats> made = job.pictures.linear
                                     ? make_linear_film(
                                           job.film, [&] { return listened(linear_painter_of(program, job, say)); },
                                           shown_progress(job.film, call.progress))
                                     : make_film(
                                           job.film, [&] { return listened(painter_of(program, job, say)); },
                                           shown_progress(job.film, call.progress));
  if (const Status sent = made ? outgoing->send() : Status(Nothing{}); !sent)
    return complain(sent.error(), machine_failed);
  FilmOptions said = job.film;
  if (*outgoing) said.path = "standard output";
  const int code = say_made(made, said);
  if (made)
    if (const Status s = write_descriptions(call, *document, *frames); !s) return complain(s.error(), wrong_call);
  if (made && call.stats) print_stats(*made, spent, program);
  return code;
}

std::string all_codecs() {
  std::string all;
  for (const Format& f : formats()) {
    const auto codecs = codecs_of("film" + std::string(f.ending));
    if (!codecs.empty()) all += fmt::format("{}{}: {}", all.empty() ? "" : "; ", f.ending, fmt::join(codecs, ", "));
  }
  return all;
}

Status read_rate(const std::string& text, std::optional<Rate>& to) {
  Cursor c(text);
  Rate rate;
  if (!c.per_second(rate, "pictures") || c.at != c.end)
    return fail(ErrorCode::range,
                fmt::format("\"{}\" is not a rate such as 24, 29.97 or 30000/1001, up to 100000", text));
  return to = rate, Nothing{};
}

const Enlisted enlisted_render(render, [](RenderCall& call) -> Subcommand {
  return {
      .rank = 10,
      .name = "render",
      .sentence = "makes a film: " + film_endings() + " or numbered pictures, .png .exr",
      .takes = joined(
          {{script_parameter(call.file),
            output_parameter(
                call.out, "OUT",
                "the film; its ending chooses the format; frame-%04d.png makes numbered pictures; .pdf has "
                "a page for each step; - is standard output, -.webm a film of that format there",
                "mp4"),
            frames_parameter(call.frames, "1f..24f, 1..24, 0.5s..2s"), section_parameter(call.frames),
            file_option("--descriptions", "OUT.vtt", "also writes the descriptions of the film, as WebVTT",
                        &call.descriptions)},
           picture_parameters(call.picture),
           exposure_parameters(call.exposure),
           {bits_parameter(call.bits),
            colors_parameter(call.colors),
            quality_parameter(call.quality, "the quality of .mp4 and .webm; by default that of the codec"),
            option("--codec", "NAME", "the codec; " + all_codecs(), &call.codec),
            file_option("--captions", "FILE", "writes what is spoken as captions too, .vtt or .srt", &call.captions),
            option("--fps", "RATE", "pictures a second, 24, 29.97 or 30000/1001; by default the script's rate",
                   ReadValue([&call](const std::string& text) { return read_rate(text, call.rate); })),
            {.name = "--jobs",
             .value = "N",
             .sentence = "frames rendered in parallel, with --each films; by default chosen for this machine",
             .into = &call.jobs,
             .range = {{1, 256}}},
            {.name = "--missing",
             .sentence = "makes only the numbered pictures that are missing or broken",
             .into = &call.missing,
             .excludes = "--no-overwrite"},
            flag("--no-overwrite", "keeps an existing file", call.keep_old),
            keep_going_flag(call.keep_going),
            flag("--progress", "prints the progress as lines of JSON, even without a terminal", call.progress),
            flag("--plan", "makes nothing; prints the plan as JSON: the frames, the rate and the size", call.plan),
            flag("--stats", "prints the times of the parts of a frame, and the memory of the film", call.stats)},
           each_parameters(call)}),
      .example = "betwixt render examples/bounce.bx -o small.gif --size 320x180 --frames 1f..24f",
      .manual =
          "All formats except numbered pictures need the program ffmpeg. With \"background transparent\", .webm, "
          ".mov (ProRes 4444), .apng and .png have straight alpha, .exr has premultiplied alpha, and .gif has "
          "transparent and opaque pixels only. .mov has more than 8 bits a channel, and so has .png with --bits 16. "
          ".exr has linear light in half floats. With --colors other than srgb, .mp4 has H.265 or AV1 and .webm AV1, "
          "both with 10 bits, .mov 10 and .png 16. In pq and hlg white is at 203 nits, and highlights have room up to "
          "1000. A terminal shows a progress bar with frames per second and the time "
          "left. If you stop a film, or if it fails, there is no file with the film's name. With --missing each "
          "picture gets its name when it is complete, so the next call continues with the missing ones. With --each, "
          "each film stays as soon as "
          "it is complete: run the same command again after a stop or a crash, and it makes the films that are missing "
          "or "
          "whose row, script or files have changed. At the end it says which films failed, and why."};
});

}  // namespace
}  // namespace betwixt
