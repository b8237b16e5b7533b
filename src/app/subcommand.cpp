// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/subcommand.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <tuple>

#include "app/command.h"
#include "app/streams.h"
#include "base/names.h"
#include "base/tell_user.h"
#include "betwixt/language.h"
#include "scene/appearance.h"
#include "scene/pixel_filter.h"

namespace betwixt {
namespace {

// Subcommands register here while the program starts, in any order.
std::vector<std::function<Subcommand()>>& enlisted() {
  static std::vector<std::function<Subcommand()>> all;
  return all;
}

Status read_size(const std::string& text, std::optional<std::pair<int, int>>& to) {
  if (const auto size = parse_size(text)) return to = size, Nothing{};
  return fail(ErrorCode::range,
              fmt::format("\"{}\" is not a size such as 1280x720, from 1 to 8192 pixels a side", text));
}

Status read_colours(const std::string& text) {
  if (text != "auto" && text != "always" && text != "never")
    return fail(ErrorCode::range, fmt::format("\"{}\" is not auto, always or never", text));
  choose_color_mode(text == "auto" ? ColorMode::automatic : text == "always" ? ColorMode::always : ColorMode::never);
  return Nothing{};
}

Status read_let(const std::string& text) {
  const std::size_t is = text.find('=');
  if (is == text.npos || is == 0)
    return fail(ErrorCode::syntax, fmt::format("\"{}\" is not NAME=VALUE, as in --let size=2", text));
  const std::string name = text.substr(0, is);
  for (const GivenLet& given : load_options().lets)
    if (given.name == name) return fail(ErrorCode::name, fmt::format("'{}' is given twice", name));
  load_options().lets.push_back({name, text.substr(is + 1)});
  return Nothing{};
}

// Returns the sample counts of the styles, without duplicates: "1, 4, 9 or 16; traced: 1 to 4096".
std::string sample_counts() {
  std::string said;
  std::string_view last;
  for (const Style& s : styles()) {
    if (s.samples == last) continue;
    said += said.empty() ? std::string(s.samples) : fmt::format("; {}: {}", s.name, s.samples);
    last = s.samples;
  }
  return said;
}

// Reads a number of samples that the style allows, or any style if none is given.
Status read_samples(const std::string& text, PictureCall& to, const std::string& style = {}) {
  if (text == "auto") return to.samples = RenderOptions::auto_samples, Nothing{};
  int n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  const bool number = error == std::errc() && end == text.data() + text.size();
  const auto takes = [&](const Style& s) { return (style.empty() || s.name == style) && s.takes(n); };
  if (!number || std::none_of(styles().begin(), styles().end(), takes))
    return fail(ErrorCode::range,
                fmt::format("the number of samples must be auto or one of {}, not '{}'", sample_counts(), text));
  to.samples = n;
  return Nothing{};
}

}  // namespace

Enlisted::Enlisted(std::function<Subcommand()> make) { enlisted().push_back(std::move(make)); }

const std::vector<Subcommand>& subcommands() {
  static const std::vector<Subcommand> all = [] {
    std::vector<Subcommand> made;
    for (const auto& make : enlisted()) made.push_back(make());
    std::sort(made.begin(), made.end(), [](const Subcommand& a, const Subcommand& b) { return a.rank < b.rank; });
    return made;
  }();
  return all;
}

const std::vector<Parameter>& common_parameters() {
  static const std::vector<Parameter> all{
      {.name = "--color",
       .value = "WHEN",
       .sentence = "colours in errors: auto (on a terminal, unless NO_COLOR is set), always or never",
       .into = ReadValue(read_colours),
       .words = {"auto", "always", "never"}},
      {.name = "--read-anywhere",
       .sentence = "lets the script read files outside its own folder, and files that unpack to any size",
       .into = &load_options().read_anywhere},
      {.name = "--tex",
       .sentence = "lets LaTeX typeset the script's formulas, by the programs latex and dvisvgm",
       .into = &load_options().tex},
      {.name = "--let",
       .value = "NAME=VALUE",
       .sentence = "another value for a `let` of the script: --let size=2, --let title='The end'",
       .into = ReadValue(read_let),
       .repeated = true},
      {.name = "--language",
       .value = "FILE.po",
       .sentence = "shows the texts of the script as this catalogue has them; \"\" as they are written",
       .into = ReadValue([](const std::string& path) { return load_options().language = path, Status(Nothing{}); }),
       .offer = Offer::files},
      {.name = "--load",
       .value = "PLUGIN",
       .sentence = "a plug-in; the script can use its words",
       .into = ReadValue(use_plugin),
       .repeated = true,
       .offer = Offer::files}};
  return all;
}

Parameter script_parameter(std::string& file) {
  return {.name = "FILE",
          .sentence = "the script; - is standard input",
          .into = &file,
          .required = true,
          .offer = Offer::scripts};
}

Parameter targets_parameter(std::vector<std::string>& targets, const std::string& sentence, bool required) {
  return {.name = "TARGET", .sentence = sentence, .into = &targets, .required = required};
}

Parameter output_parameter(std::string& out, const std::string& value, const std::string& sentence,
                           const std::string& usual) {
  return {.name = "-o,--output",
          .value = value,
          .sentence = usual.empty() ? sentence : sentence + "; by default the script's name with ." + usual,
          .into = &out,
          .required = usual.empty(),
          .offer = Offer::files};
}

std::string output_or(const std::string& out, const std::string& script, const std::string& usual) {
  if (out.empty() && is_stream(script)) return "-";
  return out.empty() ? std::filesystem::path(script).stem().string() + "." + usual : out;
}

Parameter frames_parameter(std::string& frames, const std::string& examples) {
  return {.name = "--frames",
          .value = "A..B",
          .sentence = "only these frames, both ends included, or one frame: " + examples,
          .into = &frames};
}

Parameter section_parameter(std::string& frames) {
  return {.name = "--section",
          .value = "NAME",
          .sentence = "only this section of the film",
          .into = ReadValue(
              [&frames](const std::string& name) -> Status { return frames = section_frames(name), Nothing{}; }),
          .excludes = "--frames"};
}

Parameter option(const std::string& name, const std::string& value, const std::string& sentence, Into into,
                 const std::string& excludes) {
  return {.name = name, .value = value, .sentence = sentence, .into = std::move(into), .excludes = excludes};
}

Parameter file_option(const std::string& name, const std::string& value, const std::string& sentence, Into into,
                      const std::string& excludes) {
  Parameter made = option(name, value, sentence, std::move(into), excludes);
  made.offer = Offer::files;
  return made;
}

Parameter flag(const std::string& name, const std::string& sentence, bool& given) {
  return {.name = name, .sentence = sentence, .into = &given};
}

Parameter size_parameter(std::optional<std::pair<int, int>>& size, const std::string& sentence) {
  return {.name = "--size",
          .value = "WxH",
          .sentence = sentence,
          .into = ReadValue([&size](const std::string& text) { return read_size(text, size); }),
          .words = {"320x180", "640x360", "960x540", "1280x720", "1920x1080", "3840x2160"}};
}

RenderOptions PictureCall::of(const Document& document) const {
  RenderOptions made = options_for(document, otherwise, size, samples);
  if (!pixel_filter.empty()) made.pixel_filter = pixel_filter;
  return made;
}

Result<std::string> change_picture(PictureCall& to, const Document& document, const std::string& what,
                                   const std::string& value) {
  PictureCall made = to;
  if (what == "size" && !value.empty())
    if (Status s = read_size(value, made.size); !s) return s.error();
  if (what == "style" && !value.empty()) {
    std::vector<std::string_view> names;
    for (const Style& s : styles()) names.push_back(s.name);
    if (std::find(names.begin(), names.end(), value) == names.end()) {
      const Hint near = did_you_mean(value, names);
      return unknown_name("style", value, near.empty() ? fmt::format("styles are {}", fmt::join(names, ", ")) : near);
    }
    made.otherwise.style = value;
  }
  if (what == "samples" && !value.empty())
    if (Status s = read_samples(value, made, made.otherwise.style); !s) return s.error();
  to = made;
  const RenderOptions now = to.of(document);
  return what == "size"    ? fmt::format("size {}x{}\n", now.width, now.height)
         : what == "style" ? fmt::format("style {}\n", now.style)
                           : "samples " + (now.samples == 0 ? "auto" : std::to_string(now.samples)) + "\n";
}

Result<std::optional<Blur>> ExposureCall::of(const Document& document) const {
  if (!shutter) return blur_for(document, {}, subframes);
  const Result<double> read = parse_shutter(*shutter, document);
  if (!read) return fail(read.error().code, "--shutter: " + read.error().message, read.error().hint);
  return blur_for(document, *read, subframes);
}

std::vector<Parameter> exposure_parameters(ExposureCall& to) {
  return {option("--shutter", "LENGTH",
                 "the exposure time of each frame: 180deg (half a frame), 10ms or off; by default the camera's",
                 ReadValue([&to](const std::string& text) -> Status { return to.shutter = text, Nothing{}; })),
          {.name = "--subframes",
           .value = "N",
           .sentence = "the most subframes that are averaged for a blurred frame; by default the script's, or 16",
           .into = ReadValue([&to](const std::string& text) -> Status {
             int n = 0;
             const auto read = std::from_chars(text.data(), text.data() + text.size(), n);
             if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !subframes_fit(n))
               return fail(ErrorCode::range,
                           fmt::format("the number of subframes must be from 1 to 4096, not '{}'", text));
             to.subframes = n;
             return Nothing{};
           })}};
}

Parameter bits_parameter(int& bits) {
  return {.name = "--bits",
          .value = "N",
          .sentence = "the bits per channel of PNG: 8 or 16",
          .into = &bits,
          .words_only = true,
          .words = {"8", "16"}};
}

Parameter colors_parameter(ColorCoding& colors) {
  return {.name = "--colors",
          .value = "NAME",
          .sentence =
              "how the colors are coded: srgb; p3 or rec2020, for screens with more colors; pq or hlg, for "
              "screens with more light too (.mp4 .webm .mov .png; .exr takes p3 and rec2020)",
          .into = ReadValue([&colors](const std::string& text) -> Status {
            const auto* const at = std::find(color_coding_names.begin(), color_coding_names.end(), text);
            if (at == color_coding_names.end())
              return fail(ErrorCode::range,
                          fmt::format("--colors must be srgb, p3, rec2020, pq or hlg, not '{}'", text.substr(0, 60)));
            colors = static_cast<ColorCoding>(at - color_coding_names.begin());
            return Nothing{};
          }),
          .words_only = true,
          .words = {color_coding_names.begin(), color_coding_names.end()}};
}

Parameter quality_parameter(int& quality, const std::string& of) {
  return {.name = "--quality",
          .value = "N",
          .sentence = "from 1 (the worst) to 100: " + of,
          .into = &quality,
          .range = {{1, 100}}};
}

std::vector<Parameter> picture_parameters(PictureCall& to) {
  std::vector<std::string> names;
  for (const Style& s : styles()) names.emplace_back(s.name);
  std::vector<std::string> filters;
  for (const PixelFilter& f : pixel_filters()) filters.emplace_back(f.name);
  return {size_parameter(to.size, fmt::format("the size in pixels; by default the script's, or {}x{}",
                                              to.otherwise.width, to.otherwise.height)),
          {.name = "--style",
           .value = "STYLE",
           .sentence = fmt::format("the style, one of {}; by default {}", fmt::join(names, ", "), to.otherwise.style),
           .into = &to.otherwise.style,
           .words = names},
          {.name = "--samples",
           .value = "N",
           .sentence = fmt::format(
               "the samples per pixel: {}; auto: as many as each pixel needs (traced); by default the script's, or "
               "{}, traced {}",
               sample_counts(), to.otherwise.samples, options_for(Document(), {.style = "traced"}).samples),
           .into = ReadValue([&to](const std::string& text) { return read_samples(text, to); }),
           .words = {"auto", "1", "4", "9", "16", "64", "256", "1024"}},
          {.name = "--denoise",
           .value = "on|off",
           .sentence = "whether the noise is taken out of traced pictures; by default on",
           .into = ReadValue([&to](const std::string& text) -> Status {
             if (text != "on" && text != "off")
               return fail(ErrorCode::range, fmt::format("--denoise must be on or off, not '{}'", text));
             to.otherwise.denoise = text == "on";
             return Nothing{};
           }),
           .words_only = true,
           .words = {"on", "off"}},
          {.name = "--device",
           .value = "NAME",
           .sentence = fmt::format("what draws: software, with the same bits on every machine; gpu, a graphics card; "
                                   "auto, a card if there is one; by default {}",
                                   device_names[static_cast<std::size_t>(to.otherwise.device)]),
           .into = ReadValue([&to](const std::string& text) -> Status {
             const auto* const at = std::find(device_names.begin(), device_names.end(), text);
             if (at == device_names.end())
               return fail(ErrorCode::range,
                           fmt::format("--device must be software, auto or gpu, not '{}'", text.substr(0, 60)));
             to.otherwise.device = static_cast<Device>(at - device_names.begin());
             return Nothing{};
           }),
           .words_only = true,
           .words = {device_names.begin(), device_names.end()}},
          {.name = "--pixel-filter",
           .value = "NAME",
           .sentence = fmt::format("how the samples are averaged to pixels: {}; by default the script's, or {}",
                                   fmt::join(filters, ", "), filters.front()),
           .into = &to.pixel_filter,
           .words_only = true,
           .words = filters}};
}

std::vector<Parameter> joined(std::initializer_list<std::vector<Parameter>> parts) {
  std::vector<Parameter> all;
  for (const std::vector<Parameter>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace betwixt
