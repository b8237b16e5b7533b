// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "film/output.h"

namespace betwixt {
namespace {

using Words = std::vector<std::string>;

// Drawings are about as large and as good with fewer trials, in three fifths of the time.
Words h264_words(const FilmOptions& o, const std::string& crf) {
  return {"-c:v", "libx264", "-preset", o.drawing ? "veryfast" : "fast", "-crf", crf, "-pix_fmt", "yuv420p"};
}

// How ffmpeg and its libraries call primaries, curve and matrix.
struct ColorNames {
  const char *primaries, *curve, *matrix;
};
ColorNames names_of(ColorCoding c) {
  constexpr ColorNames all[] = {{"bt709", "bt709", "bt709"},
                                {"smpte432", "iec61966-2-1", "bt709"},
                                {"bt2020", "iec61966-2-1", "bt2020nc"},
                                {"bt2020", "smpte2084", "bt2020nc"},
                                {"bt2020", "arib-std-b67", "bt2020nc"}};
  return all[static_cast<std::size_t>(c)];
}

const char* pixels_of(const FilmOptions& o) { return o.colors == ColorCoding::srgb ? "yuv420p" : "yuv420p10le"; }

// The screen that films in PQ are made for: 1000 nits, with the primaries of P3, as is usual; in the units of HEVC. How
// bright pictures are on the average is not known before they are made.
constexpr const char* hevc_screen =
    ":master-display=G(13250,34500)B(7500,3000)R(34000,16000)WP(15635,16450)L(10000000,50):max-cll=1000,0:hdr10=1:"
    "repeat-headers=1";
constexpr const char* av1_screen =
    "mastering-display=G(0.265,0.69)B(0.15,0.06)R(0.68,0.32)WP(0.3127,0.329)L(1000,0.005):content-light=1000,0";

// Apple's players need the tag.
Words h265_words(const FilmOptions& o, const std::string& crf) {
  std::string more = "log-level=error";
  if (o.colors == ColorCoding::pq) more += hevc_screen;
  return {"-c:v",     "libx265",    "-preset", "fast", "-crf",         crf,
          "-pix_fmt", pixels_of(o), "-tag:v",  "hvc1", "-x265-params", more};
}

Words av1_words(const FilmOptions& o, const std::string& crf) {
  Words all{"-c:v", "libsvtav1", "-preset", "7", "-crf", crf, "-pix_fmt", pixels_of(o)};
  if (o.colors == ColorCoding::pq) all.insert(all.end(), {"-svtav1-params", av1_screen});
  return all;
}

Words vp9_words(const FilmOptions& o, const std::string& crf) {
  Words w{"-c:v",      "libvpx-vp9", "-crf",    crf, "-b:v",          "0", "-deadline", "good",
          "-cpu-used", "4",          "-row-mt", "1", "-tile-columns", "2"};
  // With alpha, the encoder cannot make alternate reference frames.
  if (o.alpha) w.insert(w.end(), {"-auto-alt-ref", "0"});
  w.insert(w.end(), {"-pix_fmt", o.alpha ? "yuva420p" : "yuv420p"});
  return w;
}

Words mp4_words(const FilmOptions&) { return {"-movflags", "+faststart", "-f", "mp4"}; }
Words webm_words(const FilmOptions&) { return {"-f", "webm"}; }

// ProRes 4444: the format for editors. Straight alpha.
Words mov_words(const FilmOptions& o) {
  const ColorNames names = names_of(o.colors);
  return {"-vf",
          fmt::format("scale=out_color_matrix={}:out_range=tv:flags=accurate_rnd+full_chroma_int,"
                      "setparams=range=tv:colorspace={}:color_primaries={}:color_trc={}",
                      names.matrix == std::string_view("bt709") ? "bt709" : "bt2020", names.matrix, names.primaries,
                      names.curve),
          "-c:v",
          "prores_ks",
          "-profile:v",
          "4444",
          "-alpha_bits",
          o.alpha ? "16" : "0",
          "-vendor",
          "apl0",
          "-pix_fmt",
          o.alpha ? "yuva444p10le" : "yuv444p10le",
          "-f",
          "mov"};
}

// A good palette needs all pictures at once, which ffmpeg keeps in memory; a long film gets a palette for each
// picture instead.
Words gif_words(const FilmOptions& o) {
  constexpr double palette_memory = 1 << 30;
  const bool whole = 4.0 * o.width * o.height * o.frames <= palette_memory;
  // Players treat a delay below 2/100 s as 10/100 s.
  const std::string thin = o.rate.per_second() > 50 ? "fps=50," : "";
  const std::string filter =
      thin +
      (whole ? "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=sierra2_4a:diff_mode=rectangle"
             : "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=sierra2_4a");
  return {"-filter_complex", filter, "-loop", "0", "-f", "gif"};
}

Words apng_words(const FilmOptions&) { return {"-c:v", "apng", "-pred", "mixed", "-plays", "0", "-f", "apng"}; }

constexpr Codec in_mp4[] = {
    {"h264", 51, 18, h264_words}, {"h265", 51, 22, h265_words, false, true}, {"av1", 63, 30, av1_words, false, true}};
constexpr Codec in_webm[] = {{"vp9", 63, 28, vp9_words, true}, {"av1", 63, 30, av1_words, false, true}};

constexpr Format format_rows[] = {
    {".mp4", true, mp4_words, "-c:a aac -b:a 192k", false, false, "mov_text", true, in_mp4},
    {".webm", true, webm_words, "-c:a libopus -b:a 128k", true, false, "webvtt", true, in_webm},
    {".mov", false, mov_words, "-c:a pcm_s24le", true, true, "mov_text", true},
    {".gif", false, gif_words},
    {".apng", false, apng_words}};

const Codec* codec_of(const Format& format, const FilmOptions& o) {
  const auto at = std::find_if(format.codecs.begin(), format.codecs.end(), [&](const Codec& c) {
    return o.codec.empty() ? o.colors == ColorCoding::srgb || c.deep : c.name == o.codec;
  });
  return at == format.codecs.end() ? nullptr : &*at;
}

}  // namespace

// Quality 100 is nearly lossless (at crf 0 some results do not play), 1 is the worst possible; linear in between.
std::vector<std::string> arguments_of(const Format& format, const FilmOptions& o) {
  Words all;
  if (const Codec* codec = codec_of(format, o)) {
    const double lost = (100 - o.quality) / 99.0;
    const int crf = o.quality == 0 ? codec->usual : 1 + static_cast<int>(std::lround(lost * (codec->worst - 1)));
    all = codec->arguments(o, std::to_string(crf));
  }
  const Words rest = format.arguments(o);
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

std::vector<std::string> codecs_of(const std::string& path) {
  std::vector<std::string> all;
  if (const auto out = read_output(path); out && out->format)
    for (const Codec& c : out->format->codecs) all.emplace_back(c.name);
  return all;
}

Status check_encoding(const FilmOptions& o) {
  if (Status s = check_colors(o.path, o.colors, o.alpha); !s) return s;
  const auto out = read_output(o.path);
  if (!out || (o.quality == 0 && o.codec.empty())) return Nothing{};
  const std::string known = fmt::format("{}", fmt::join(codecs_of(o.path), ", "));
  if (known.empty())
    return fail(ErrorCode::range,
                fmt::format("--{} has no effect on {}", o.codec.empty() ? "quality" : "codec", o.path),
                "only the lossy codecs of .mp4 and .webm have a quality");
  const Codec* codec = codec_of(*out->format, o);
  if (!codec)
    return fail(ErrorCode::name, fmt::format("{} has no codec '{}'", out->format->ending, o.codec),
                fmt::format("it has {}", known));
  if (o.colors != ColorCoding::srgb && !codec->deep)
    return fail(ErrorCode::range, fmt::format("{} has 8 bits here, which is too few for --colors", codec->name),
                fmt::format("--codec {}", out->format->codecs.back().name));
  if (o.alpha && out->format->alpha && !codec->alpha)
    return fail(ErrorCode::range, fmt::format("{} cannot store transparency", codec->name),
                fmt::format("the codec {} of {} can", out->format->codecs.front().name, out->format->ending));
  return Nothing{};
}

std::vector<std::string> color_tags(ColorCoding colors) {
  const ColorNames names = names_of(colors);
  return {"-color_range",  "tv",         "-colorspace", names.matrix, "-color_primaries",
          names.primaries, "-color_trc", names.curve};
}

Status check_colors(const std::string& path, ColorCoding colors, bool alpha) {
  const auto out = read_output(path);
  if (!out || colors == ColorCoding::srgb) return Nothing{};
  const std::string_view name = color_coding_names[static_cast<std::size_t>(colors)];
  if (out->exr && has_highlights(colors))
    return fail(ErrorCode::range, fmt::format("--colors {}: OpenEXR has light without limit, not signals", name),
                "p3 and rec2020 choose its primaries");
  if (!out->format) return Nothing{};
  if (!out->format->wide)
    return fail(ErrorCode::range, fmt::format("--colors {}: {} has the colors of sRGB only", name, out->format->ending),
                ".mp4, .webm, .mov, .png and .exr can have others");
  const bool clear = out->format->codecs.empty() || std::any_of(out->format->codecs.begin(), out->format->codecs.end(),
                                                                [](const Codec& c) { return c.deep && c.alpha; });
  if (alpha && out->format->alpha && !clear)
    return fail(ErrorCode::range,
                fmt::format("--colors {}: {} cannot have transparency with it", name, out->format->ending),
                ".mov and .png can");
  return Nothing{};
}

std::span<const Format> formats() { return format_rows; }

const Format* find_format(std::string_view ending) {
  for (const Format& f : format_rows)
    if (f.ending == ending) return &f;
  return nullptr;
}

std::string film_endings() {
  std::string all;
  for (const Format& f : format_rows) all += (all.empty() ? "" : " ") + std::string(f.ending);
  return all;
}

}  // namespace betwixt
