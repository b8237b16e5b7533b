// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures the time from an edit to its picture for each example, as processor time of all threads. A command gives a
// visible object another colour, the document is compiled again, and a picture is drawn. Also measures what happens
// only once: reading the film, and starting graphics (making the renderer and its first picture, for which the driver
// compiles shaders).
//
//   bench_first_picture FOLDER-OF-EXAMPLES [ROUNDS]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "betwixt/render.h"
#include "editor/editor.h"
#include "timing.h"

using namespace betwixt;

namespace {

struct FilmCost {
  std::string film;
  double reading = 0, starting = 0;     // once
  std::vector<double> edits, drawings;  // the drawing is a part of the edit
  double least() const { return edits.front(); }
  double median() const { return edits[edits.size() / 2]; }
};

RenderOptions options_of(const Document& d) {
  RenderOptions r;
  if (const auto size = d.size()) std::tie(r.width, r.height) = *size;
  return d.samples() ? RenderOptions{r.width, r.height, *d.samples(), r.style} : r;
}

class Film {
 public:
  explicit Film(const std::filesystem::path& script) {
    cost_.film = script.stem().string();
    std::ifstream file(script, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    cost_.reading = processor_milliseconds([&] {
      insist(!has_errors(editor_.begin(text, script.string())), "a film");
      program_ = Program::compile(document());
    });
    const auto [first, last] = document().range();
    const Rate rate = document().rate();
    at_ = rate.frame(std::floor((rate.frame_number(first) + rate.frame_number(last)) / 2));
    cost_.starting = processor_milliseconds([&] {
      auto made = make_renderer(options_of(document()));
      insist(static_cast<bool>(made), "a renderer");
      renderer_ = *std::move(made);
      draw();
    });
  }
  FilmCost measure(int rounds) {
    const std::string seen = find_seen();
    for (int k = 0; k < rounds; ++k) {
      const Picture before = picture_;
      double drawing = 0;
      cost_.edits.push_back(processor_milliseconds([&] {
        edit(seen, k);
        drawing = processor_milliseconds([&] { draw(); });
      }));
      cost_.drawings.push_back(drawing);
      insist(picture_.rgba != before.rgba, (cost_.film + ": an edit that is seen").c_str());
    }
    std::sort(cost_.edits.begin(), cost_.edits.end());
    std::sort(cost_.drawings.begin(), cost_.drawings.end());
    return cost_;
  }

 private:
  const Document& document() const { return editor_.now().document; }
  void draw() { insist(static_cast<bool>(renderer_->render(program_.frame(at_), picture_)), "a picture"); }
  // Changes the colour of an object, or the exposure if `thing` is empty. Returns false if the command was refused.
  bool edit(const std::string& thing, int k) {
    const int some = 16 + 37 * k % 200;
    const std::string line =
        thing.empty() ? fmt::format("exposure {}/300", some) : fmt::format("at 1f {}.color #{:02x}40c0", thing, some);
    CommandResult deed = editor_.carry_out(editor_.now(), line);
    if (!deed.done || !editor_.take(std::move(deed.after), {{deed.line}, deed.sheet})) return false;
    program_ = Program::compile(document(), program_);
    return true;
  }
  // Returns the first object whose colour is visible in the picture, or "" if there is none.
  std::string find_seen() {
    const Picture before = picture_;
    for (const Item& i : program_.frame(at_).items) {
      const std::string name = document().name(i.id);
      if (name.empty() || !edit(name, 100)) continue;
      draw();
      if (picture_.rgba != before.rgba) return name;
    }
    return {};
  }

  Editor editor_;
  Program program_;
  Time at_;
  std::unique_ptr<Renderer> renderer_;
  Picture picture_;
  FilmCost cost_;
};

}  // namespace

int main(int count, char** arguments) {
  const std::string folder = count > 1 ? arguments[1] : "examples";
  const int rounds = count > 2 ? std::max(std::atoi(arguments[2]), 1) : 9;
  std::vector<FilmCost> all;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".bx") all.push_back(Film(entry.path()).measure(rounds));
  insist(!all.empty(), "examples");
  std::sort(all.begin(), all.end(), [](const FilmCost& a, const FilmCost& b) { return a.median() < b.median(); });
  fmt::print("{:16} {:>9} {:>9} {:>9} {:>9} {:>9}  ms\n", "film", "reading", "starting", "edit, min", "median",
             "drawing");
  for (const FilmCost& c : all)
    fmt::print("{:16} {:9.1f} {:9.1f} {:9.1f} {:9.1f} {:9.1f}\n", c.film, c.reading, c.starting, c.least(), c.median(),
               c.drawings[c.drawings.size() / 2]);
  std::vector<double> least;
  for (const FilmCost& c : all) least.push_back(c.least());
  std::sort(least.begin(), least.end());
  fmt::print("the median film: {:.1f} at least, {:.1f} in the median\n", least[least.size() / 2],
             all[all.size() / 2].median());
}
