// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures the time of a picture: two examples, in the styles shaded and traced, and ten thousand objects that move or
// rest. Compares some pictures, byte by byte, with those of a new renderer.
//
//   bench_drawing FOLDER-OF-EXAMPLES
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "betwixt/language.h"
#include "betwixt/render.h"
#include "timing.h"

using namespace betwixt;

namespace {

// Boxes and balls in a square, with a camera that may move.
std::string many(int count, int moving, bool camera_moves) {
  std::string text =
      "rate 60\nrange 1f 600f\ncreate sun light shines=sun position=(3 9 5)\n"
      "create eye camera position=(0 70 110) look-at=(0 0 0) lens=35mm\n";
  if (camera_moves) text += "eye.position\n  1f (0 70 110) linear\n  600f (60 70 90)\n";
  auto out = std::back_inserter(text);
  for (int k = 0; k < count; ++k) {
    const int x = k % 100 - 50, z = k / 100 - 50;
    fmt::format_to(out, "create o{} {} position=({} 0 {}) color=#{:02x}a0{:02x}\n", k,
                   k % 2 ? "box size=(0.7 0.7 0.7)" : "sphere radius=0.4", 1.2 * x, 1.2 * z, 60 + k % 190,
                   60 + k / 100);
    if (k < moving)
      fmt::format_to(out, "o{}.position.y\n  1f {} linear\n  {}f 3 linear\n  600f 0\n", k, k % 7 - 3, 200 + k % 97);
  }
  return text;
}

// Balls that move in circles, and the trace of one of them.
std::string going_round(bool traced) {
  const std::string text =
      "range 1f 600f\ncreate b{1..30} sphere radius=0.3\nset b*.color hsv(i/n 0.7 1)\ncreate arm{1..30} group\n"
      "set b*.position (1+i/6 i/10-1.5 0)\ncreate sun light shines=sun position=(3 6 5)\n"
      "create eye camera position=(0 3 18) look-at=(0 0 0)\ncouple b1 to arm1\narm*.rotation.z\n  1f 0deg linear\n"
      "  600f i*1turn\n";
  std::string all = text;
  for (int k = 2; k <= 30; ++k) all += fmt::format("couple b{0} to arm{0}\n", k);
  all += "arm1.rotation.y\n  1f 0deg linear\n  600f 7.3turn\n";
  return traced ? all + "create drawn trace of=b1 width=0.05 color=tomato\n" : all;
}

struct Row {
  const char* what;
  Document document;
  RenderOptions options;
  int pictures;
};

Picture by_itself(const Row& row, const Program& program, Time t) {
  const auto renderer = make_renderer(row.options);
  insist(static_cast<bool>(renderer), "no renderer");
  Picture p;
  insist(static_cast<bool>((*renderer)->render(program.frame(t), p)), "no picture");
  return p;
}

void measure(const Row& row) {
  const Program program = Program::compile(row.document);
  const auto renderer = make_renderer(row.options);
  insist(static_cast<bool>(renderer), "no renderer");
  Evaluation e(program);
  Picture picture;
  std::vector<double> all;
  for (int k = -3; k < row.pictures; ++k) {
    const Time t = row.document.rate().frame(k + 4);
    const double took = milliseconds([&] {
      e.to(t);
      insist(static_cast<bool>((*renderer)->render(e, picture)), "no picture");
    });
    if (k >= 0) all.push_back(took);
    if (k == row.pictures / 2) insist(by_itself(row, program, t).rgba == picture.rgba, "a picture");
  }
  std::sort(all.begin(), all.end());
  fmt::print("{:52} {:9.2f} {:9.2f}  ms\n", row.what, all.front(), all[all.size() / 2]);
  std::fflush(stdout);
}

// Draws pictures with motion blur and single pictures of the same frames in turns. Prints the ratio of their times.
void blur(const char* what, const Document& film, const RenderOptions& options, const Blur& how, int rounds) {
  const Program program = Program::compile(film);
  Evaluation evaluation(program);
  RenderOptions linear = options;
  linear.linear = true;
  const auto sharp = make_renderer(options), blurred = make_renderer(linear);
  insist(sharp && blurred, "no renderer");
  Picture one;
  LinearPicture sum;
  std::vector<double> ratios;
  for (int k = -1; k < rounds; ++k) {
    const Time t = film.rate().frame(k + 4);
    const double taken = processor_milliseconds(
        [&] { insist(static_cast<bool>((*blurred)->render_blurred(evaluation, t, how, sum)), "no picture"); });
    const double drawn = processor_milliseconds([&] {
      evaluation.to(t);
      insist(static_cast<bool>((*sharp)->render(evaluation, one)), "no picture");
    });
    if (k >= 0) ratios.push_back(taken / drawn);
  }
  std::sort(ratios.begin(), ratios.end());
  fmt::print("{:52} {:9.2f} {:9.2f}  pictures\n", what, ratios.front(), ratios[ratios.size() / 2]);
}

// Runs 600 frames of the film with a trace and of the film without it in turns, and draws every fifth.
void trace(const Document& without, const Document& with, const RenderOptions& options, int rounds) {
  std::vector<double> ratios;
  for (int round = 0; round < rounds; ++round) {
    double sums[2] = {};
    const Program programs[2] = {Program::compile(without), Program::compile(with)};
    Evaluation evaluations[2] = {Evaluation(programs[0]), Evaluation(programs[1])};
    std::unique_ptr<Renderer> renderers[2];
    for (auto& r : renderers) {
      auto made = make_renderer(options);
      insist(static_cast<bool>(made), "no renderer");
      r = *std::move(made);
    }
    Picture picture;
    for (int frame = 0; frame <= 600; frame += 5)  // the first picture does not count, because drivers compile in it
      for (int k = 0; k < 2; ++k) {
        const double took = processor_milliseconds([&] {
          evaluations[k].to(with.rate().frame(std::max(frame, 1)));
          insist(static_cast<bool>(renderers[k]->render(evaluations[k], picture)), "no picture");
        });
        if (frame > 0) sums[k] += took;
      }
    ratios.push_back(sums[1] / sums[0]);
  }
  std::sort(ratios.begin(), ratios.end());
  fmt::print("{:52} {:9.2f} {:9.2f}  times\n", "600 frames of 30 balls, beside them without a trace", ratios.front(),
             ratios[ratios.size() / 2]);
}

}  // namespace

int main(int count, char** arguments) {
  const std::string examples = count > 1 ? arguments[1] : "examples";
  const auto example = [&](const char* name) { return load_file(examples + "/" + name + ".bx").document; };
  const auto script = [](const std::string& text) { return load_text(text, "bench.bx").document; };
  const RenderOptions small{480, 270, 4, "shaded"}, window{960, 540, 1, "shaded"}, smooth{960, 540, 4, "shaded"};
  fmt::print("{:52} {:>9} {:>9}\n", "a picture", "minimum", "median");
  measure({"funnel, 480x270, 4 samples", example("funnel"), small, 60});
  measure({"menagerie, 480x270, 4 samples", example("menagerie"), small, 60});
  const RenderOptions traced{480, 270, 16, "traced"};  // two million paths
  measure({"funnel, 480x270, 16 samples, traced", example("funnel"), traced, 6});
  measure({"menagerie, 480x270, 16 samples, traced", example("menagerie"), traced, 6});
  measure({"10,000 things move, 960x540, 1 sample", script(many(10000, 10000, false)), window, 30});
  measure({"10,000 things move, 960x540, 4 samples", script(many(10000, 10000, false)), smooth, 20});
  measure({"10,000 things rest, one moves, 960x540, 1 sample", script(many(10000, 1, false)), window, 20});
  measure({"10,000 things rest, the camera moves, 1 sample", script(many(10000, 0, true)), window, 20});
  measure({"10,000 things rest, nothing moves, 1 sample", script(many(10000, 0, false)), window, 20});
  const Blur eight{8, 0.5 / 24};
  blur("funnel, blurred, 8 subframes of 4 samples, beside one", example("funnel"), small, eight, 30);
  blur("menagerie, the same", example("menagerie"), small, eight, 30);
  blur("10,000 things rest, one moves, the same", script(many(10000, 1, false)), smooth, eight, 20);
  trace(script(going_round(false)), script(going_round(true)), small, 5);
}
