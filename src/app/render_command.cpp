// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/command.h"
#include "betwixt/film.h"
#include "betwixt/program.h"

namespace betwixt {
namespace {

struct Call {
  std::string file, out, frames;
  RenderOptions picture;
  int jobs = 0;
  bool keep_old = false, stats = false;
};

// "1.9 s", "4 min 12 s", "2 h 05 min"
std::string duration(double seconds) {
  if (seconds < 60) return fmt::format("{:.1f} s", seconds);
  const int whole = static_cast<int>(std::min(seconds, 1e9));
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

// One line on a terminal that says how far the film is; silent where there is none.
class Bar {
 public:
  explicit Bar(int frames) : shown_(::isatty(STDERR_FILENO) == 1), frames_(frames) {}
  ~Bar() { wipe(); }
  void show(int done, double seconds) {
    if (!shown_ || seconds < next_) return;
    next_ = seconds + 0.1;
    const double rate = seconds > 0 ? done / seconds : 0;
    std::string tail = fmt::format(" {}/{}", done, frames_);
    if (done == frames_) tail += "  finishing the file";
    if (done > 0 && done < frames_)
      tail += fmt::format("  {:.1f} frames/s  {} left", rate, duration((frames_ - done) / rate));
    const int wide = std::clamp(columns() - static_cast<int>(tail.size()) - 4, 0, 40);
    const int full = static_cast<int>(static_cast<double>(wide) * done / frames_);
    fmt::print(stderr, "\r\x1b[K[{:#>{}}{: >{}}]{}", "", full, "", wide - full, tail);
    std::fflush(stderr);
    drawn_ = true;
  }
  void wipe() {
    if (drawn_) fmt::print(stderr, "\r\x1b[K");
    drawn_ = false;
  }

 private:
  static int columns() {
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
  }
  const bool shown_;
  const int frames_;
  double next_ = 0;
  bool drawn_ = false;
};

void print_stats(const FilmStats& s) {
  const auto each = [&](double seconds) { return 1000 * seconds / s.frames; };
  fmt::print(stderr,
             "painting {:.2f} s ({:.1f} ms a frame), encoding {:.2f} s ({:.1f} ms a frame), in all {:.1f} ms a frame\n",
             s.painting, each(s.painting), s.encoding, each(s.encoding), each(s.seconds));
}

int render(const Call& call) {
  const std::optional<Document> document = open_script(call.file);
  if (!document) return wrong_input;
  const Result<FrameList> frames = read_frames(call.frames, *document);
  if (!frames) return complain(frames.error(), wrong_call);

  const Program program = Program::compile(*document);
  Problems problems;
  const auto new_painter = [&]() -> Result<Painter> {
    Result<std::unique_ptr<Renderer>> made = make_renderer(call.picture);
    if (!made) return made.error();
    return Painter([&, renderer = std::shared_ptr<Renderer>(*std::move(made))](int k, Picture& out) {
      const Frame frame = program.frame(frames->time(k));
      problems.say(frame.problems);
      return renderer->render(frame, out);
    });
  };
  FilmOptions options;
  options.path = call.out;
  options.frames = frames->count;
  options.first_number = frames->number;
  options.rate = frames->rate;
  options.width = call.picture.width, options.height = call.picture.height;
  options.jobs = call.jobs;
  options.overwrite = !call.keep_old;

  catch_stops();
  Bar bar(options.frames);
  const Result<FilmStats> made = make_film(options, new_painter, [&](int done, int, double seconds) {
    bar.show(done, seconds);
    return !stop_requested();
  });
  bar.wipe();
  if (!made && stop_requested()) {
    fmt::print(stderr, "betwixt: stopped; {} was not made\n", call.out);
    return interrupted;
  }
  if (!made) return complain(made.error(), wrong_call);
  fmt::print(stderr, "{} frame{} in {}, {}\n", made->frames, made->frames == 1 ? "" : "s", duration(made->seconds),
             call.out);
  if (call.stats) print_stats(*made);
  return all_done;
}

}  // namespace

void add_render(CLI::App& app, int& exit_code) {
  const auto call = std::make_shared<Call>();
  CLI::App* sub = app.add_subcommand("render", "makes a film: .mp4 .webm .gif .apng or numbered pictures");
  sub->add_option("FILE", call->file, "the script")->required()->type_name("");
  sub->add_option("-o,--output", call->out, "the film; its ending says what is made, frame-%04d.png: numbered pictures")
      ->required()
      ->type_name("OUT");
  sub->add_option("--frames", call->frames, "these only, ends included: 1f..24f, 1..24, 0.5s..2s")->type_name("A..B");
  add_picture_options(*sub, call->picture);
  sub->add_option("--jobs", call->jobs, "pictures made at once; if not said, what suits this machine")
      ->type_name("N")
      ->check(CLI::Range(1, 256).description(""));
  sub->add_flag("--no-overwrite", call->keep_old, "leave a film alone that is there already");
  sub->add_flag("--stats", call->stats, "say how long painting and encoding took");
  sub->footer("Example:\n  betwixt render examples/bounce.bx -o small.gif --size 320x180 --frames 1f..24f");
  sub->callback([call, &exit_code] { exit_code = render(*call); });
}

}  // namespace betwixt
