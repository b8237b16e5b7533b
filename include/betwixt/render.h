// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Renders frames to pictures. Needs no display and no GPU.
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
  int samples = 4;                 // samples a pixel; Style::takes tells which numbers are valid
  std::string style = "shaded";    // one of styles()
  // Allows pictures of linear light. If the film says so, their background is transparent (otherwise black).
  bool deep = false;
  bool open = false;  // deep: keeps light above white; otherwise it is rolled off, as in all other pictures
};

// Motion blur and depth of field.
struct Exposure {
  int subframes = 16;             // the most pictures that one is averaged from, 1 to 4096
  std::optional<double> shutter;  // exposure time in seconds; nullopt: that of the camera
};

struct Style {
  std::string_view name, what;
  std::string_view samples;    // valid numbers of samples a pixel: "1, 4, 9 or 16"
  bool (*takes)(int samples);  // whether this number of samples is valid
  int usual;                   // the fewest samples if neither the caller nor the script sets them
};
const std::vector<Style>& styles();

// Use a renderer from one thread. The same frame gives the same picture, whatever was drawn before. A renderer reuses
// the parts that do not change from one picture to the next; if nothing changes it draws nothing.
class Renderer {
 public:
  virtual ~Renderer() = default;
  // Draws into `out` and resizes it if necessary.
  virtual Status render(const Frame&, Picture& out) = 0;
  // Draws the evaluation's frame, for playback. If you render after every `to`, only changed objects are examined.
  virtual Status render(const Evaluation&, Picture& out) = 0;
  // The same, as linear light. Errors: range (RenderOptions::deep is false).
  virtual Status render(const Frame&, DeepPicture& out) = 0;
  virtual Status render(const Evaluation&, DeepPicture& out) = 0;
  // Draws to the surface of the graphics system, at the same size, and reads nothing back. Errors: machine (there is no
  // surface; only web pages have one).
  virtual Status show(const Evaluation&);
  // Draws the picture whose exposure begins at a time, with motion blur and depth of field: the mean, in linear light,
  // of pictures at times spread over the shutter's and from points spread over the lens. Objects that jump in that time
  // are exposed only up to the jump. If nothing would be blurred, draws a single picture. Moves the evaluation. Errors:
  // as above.
  virtual Status expose(Evaluation&, Time, const Exposure&, DeepPicture& out) = 0;
};

// Returns whether any camera of the document sets a shutter or a lens opening.
bool has_exposure(const Document&);

// Returns the options for a film: those given here, or else the script's, or else `otherwise`.
RenderOptions options_for(const Document&, RenderOptions otherwise, std::optional<std::pair<int, int>> size = {},
                          std::optional<int> samples = {});
// Returns the exposure of a film, or std::nullopt if nothing is blurred.
std::optional<Exposure> exposure_for(const Document&, std::optional<double> shutter = {},
                                     std::optional<int> subframes = {});

// Checks the options. Errors: those of make_renderer but machine.
Status check_options(const RenderOptions&);
// Makes a renderer. Errors: range (options out of bounds), name (no such style), machine (no graphics available).
Result<std::unique_ptr<Renderer>> make_renderer(const RenderOptions&);

}  // namespace betwixt
