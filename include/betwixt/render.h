// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Renders frames to pictures. Needs no display and no GPU.
//
// Room: render
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/evaluation.h"
#include "betwixt/linear_picture.h"
#include "betwixt/result.h"

namespace betwixt {

// What draws pictures of the styles that use a graphics interface. `software` gives the same bits on every machine.
// `automatic` takes a graphics card if there is one; `gpu` fails without one.
enum class Device : std::uint8_t { software, automatic, gpu };
// In the order of Device.
inline constexpr std::array<std::string_view, 3> device_names{"software", "auto", "gpu"};

struct RenderOptions {
  int width = 1280, height = 720;  // pixels, 1 to 8192
  // Samples a pixel; Style::takes checks whether a number is valid. auto_samples: as many as each pixel needs
  // ("traced"), or as many as the style usually has.
  static constexpr int auto_samples = 0;
  int samples = 4;
  std::string style = "shaded";  // one of styles()
  // How the samples around a pixel are averaged to it: "box", "tent", "gaussian", "mitchell" or "lanczos".
  std::string pixel_filter = "box";
  // Allows pictures of linear light (LinearPicture). A background that the film makes transparent is transparent only
  // with this option; without it, it is black.
  bool linear = false;
  bool unclamped = false;  // for linear light: keeps light above white, which is otherwise rolled off
  // For linear light that is a picture: how bright its brightest light may be. 1 is white; screens with more have room
  // for highlights.
  double peak = 1;
  bool denoise = true;  // takes the noise out of pictures of "traced" with 4 samples or more
  Device device = Device::software;
  friend bool operator==(const RenderOptions&, const RenderOptions&) = default;
};

// Motion blur and depth of field.
struct Blur {
  int subframes = 16;             // how many pictures are averaged into one, at most; 1 to 4096
  std::optional<double> shutter;  // exposure time in seconds, 0 to 60; nullopt: that of the camera
};

struct Style {
  std::string_view name, what;
  std::string_view samples;    // valid numbers of samples a pixel: "1, 4, 9 or 16"
  bool (*takes)(int samples);  // whether this number of samples is valid
  int least_samples;           // options_for gives at least this many if no samples are set
};
const std::vector<Style>& styles();

// Use a renderer from one thread. The same frame gives the same picture, whatever was drawn before. A renderer reuses
// the parts that do not change from one picture to the next; if nothing changes it only copies the last picture.
class Renderer {
 public:
  virtual ~Renderer() = default;
  // Draws into `out` and resizes it if necessary. Errors: machine (a traced picture needs more memory than there is, or
  // no graphics are available; flat films need none).
  virtual Status render(const Frame&, Picture& out) = 0;
  // Draws the evaluation's frame, for playback. If you render after every `to`, only changed objects are examined.
  virtual Status render(const Evaluation&, Picture& out) = 0;
  // Draws the same, as linear light. Errors: range (RenderOptions::linear is false), machine.
  virtual Status render(const Frame&, LinearPicture& out) = 0;
  virtual Status render(const Evaluation&, LinearPicture& out) = 0;
  // Draws to the surface of the graphics system, in the size of RenderOptions, and reads nothing back. Errors: machine
  // (there is no surface; only web pages have one).
  virtual Status show(const Evaluation&);
  // Draws a picture with motion blur and depth of field, whose exposure begins at the given time. The picture is the
  // mean, in linear light, of pictures at times spread over the shutter time and from points spread over the lens. If
  // an object jumps during the exposure, all these pictures show it before the jump. If nothing would be blurred, draws
  // a single picture. Changes the time of the evaluation. Errors: range (RenderOptions::linear is false), machine.
  virtual Status render_blurred(Evaluation&, Time, const Blur&, LinearPicture& out) = 0;
};

// Returns whether any camera of the document sets a shutter or a lens opening.
bool has_blur(const Document&);

// Returns the options for a film. Size and samples are those given here; if they are not given, the script's; if it
// sets none, those of `otherwise`; the pixel filter likewise. The script's samples do not apply to a style whose
// `least_samples` is more than 1
// ("traced").
RenderOptions options_for(const Document&, RenderOptions otherwise, std::optional<std::pair<int, int>> size = {},
                          std::optional<int> samples = {});
// Returns the blur of a film, or std::nullopt if nothing is blurred, for example with one subframe. The default of
// `shutter` (in seconds) is the camera's. The default of `subframes` is the script's number, or 16 if it sets none.
std::optional<Blur> blur_for(const Document&, std::optional<double> shutter = {}, std::optional<int> subframes = {});

// Checks the options. Errors: range and name, as for make_renderer.
Status check_options(const RenderOptions&);
// Makes a renderer. Errors: range (options out of bounds), name (no such style or pixel filter), machine (no graphics
// available). A renderer of the style "shaded" may need graphics only for its first picture that is not flat; then
// render() has this error.
Result<std::unique_ptr<Renderer>> make_renderer(const RenderOptions&);

}  // namespace betwixt
