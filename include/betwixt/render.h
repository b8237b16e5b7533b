// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures from frames. Needs no display and no GPU.
//
// Room: render
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/deep_picture.h"
#include "betwixt/evaluation.h"
#include "betwixt/result.h"

namespace betwixt {

struct RenderOptions {
  int width = 1280, height = 720;  // pixels, 1 to 8192
  int samples = 4;                 // a pixel, as many as the style takes
  std::string style = "shaded";    // one of styles()
  // Pictures of linear light can be had, and what has nothing behind it is clear where the film says so (elsewhere
  // black).
  bool deep = false;
  bool open = false;  // deep: light stays as bright as it is; else it rolls off as in all that is shown
};

// How a picture is taken that takes time.
struct Exposure {
  int subframes = 16;             // of so many at most it is added up, 1 to 4096
  std::optional<double> shutter;  // seconds; none: as long as the camera says
};

struct Style {
  std::string_view name, what;
  std::string_view samples;    // how many a pixel it takes: "1, 4, 9 or 16"
  bool (*takes)(int samples);  // whether it takes so many
  int usual;                   // where nobody says how many, at least
};
const std::vector<Style>& styles();

// One renderer belongs to one thread. The same frame gives the same picture, whatever was drawn before. What a picture
// shares with the one before it is kept: where nothing differs at all, nothing is drawn.
class Renderer {
 public:
  virtual ~Renderer() = default;
  // Draws into `out`, resizing it where needed.
  virtual Status render(const Frame&, Picture& out) = 0;
  // The picture of its frame(), for playing: what has not changed is not looked at, if every `to` is followed by a
  // picture.
  virtual Status render(const Evaluation&, Picture& out) = 0;
  // The same as light. Errors: range (RenderOptions::deep was not said).
  virtual Status render(const Frame&, DeepPicture& out) = 0;
  virtual Status render(const Evaluation&, DeepPicture& out) = 0;
  // The picture goes to what the graphics themselves show, of the same size, and is not read back. Errors: machine
  // (they show nothing: only in pages do they).
  virtual Status show(const Evaluation&);
  // The picture that is begun at a time, blurred as its camera's shutter and opening have it: the sum of pictures, as
  // light, at times spread over the shutter's, through points spread over the lens. For what jumps meanwhile the
  // shutter closes before it does. Where nothing would be blurred it is one picture. Moves the evaluation. Errors: as
  // above.
  virtual Status expose(Evaluation&, Time, const Exposure&, DeepPicture& out) = 0;
};

// Whether some camera of it has a shutter or an opening that is said.
bool has_exposure(const Document&);

// How pictures of a film are made: as is said here, else as its script says, else as `otherwise`.
RenderOptions options_for(const Document&, RenderOptions otherwise, std::optional<std::pair<int, int>> size = {},
                          std::optional<int> samples = {});
// How they are blurred; none: nothing is.
std::optional<Exposure> exposure_for(const Document&, std::optional<double> shutter = {},
                                     std::optional<int> subframes = {});

// Whether it can be drawn so. Errors: range, name, as below.
Status check_options(const RenderOptions&);
// Errors: range (options out of bounds), name (no such style), machine (no graphics to be had).
Result<std::unique_ptr<Renderer>> make_renderer(const RenderOptions&);

}  // namespace betwixt
