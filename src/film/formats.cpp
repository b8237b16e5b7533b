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

// Apple's players need the tag.
Words h265_words(const FilmOptions&, const std::string& crf) {
  return {"-c:v",     "libx265", "-preset", "fast", "-crf",         crf,
          "-pix_fmt", "yuv420p", "-tag:v",  "hvc1", "-x265-params", "log-level=error"};
}

Words av1_words(const FilmOptions&, const std::string& crf) {
  return {"-c:v", "libsvtav1", "-preset", "7", "-crf", crf, "-pix_fmt", "yuv420p"};
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
  return {"-vf",
          "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,"
          "setparams=range=tv:colorspace=bt709:color_primaries=bt709:color_trc=bt709",
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

constexpr Codec in_mp4[] = {{"h264", 51, 18, h264_words}, {"h265", 51, 22, h265_words}, {"av1", 63, 30, av1_words}};
constexpr Codec in_webm[] = {{"vp9", 63, 28, vp9_words, true}, {"av1", 63, 30, av1_words}};

constexpr Format format_rows[] = {{".mp4", true, mp4_words, "-c:a aac -b:a 192k", false, false, "mov_text", in_mp4},
                                  {".webm", true, webm_words, "-c:a libopus -b:a 128k", true, false, "webvtt", in_webm},
                                  {".mov", false, mov_words, "-c:a pcm_s24le", true, true, "mov_text"},
                                  {".gif", false, gif_words},
                                  {".apng", false, apng_words}};

const Codec* codec_of(const Format& format, const std::string& name) {
  if (name.empty()) return format.codecs.empty() ? nullptr : &format.codecs.front();
  const auto at =
      std::find_if(format.codecs.begin(), format.codecs.end(), [&](const Codec& c) { return c.name == name; });
  return at == format.codecs.end() ? nullptr : &*at;
}

}  // namespace

// Quality 100 is nearly lossless (at crf 0 some results do not play), 1 is the worst possible; linear in between.
std::vector<std::string> arguments_of(const Format& format, const FilmOptions& o) {
  Words all;
  if (const Codec* codec = codec_of(format, o.codec)) {
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
  const auto out = read_output(o.path);
  if (!out || (o.quality == 0 && o.codec.empty())) return Nothing{};
  const std::string known = fmt::format("{}", fmt::join(codecs_of(o.path), ", "));
  if (known.empty())
    return fail(ErrorCode::range,
                fmt::format("--{} has no effect on {}", o.codec.empty() ? "quality" : "codec", o.path),
                "only the lossy codecs of .mp4 and .webm have a quality");
  const Codec* codec = codec_of(*out->format, o.codec);
  if (!codec)
    return fail(ErrorCode::name, fmt::format("{} has no codec '{}'", out->format->ending, o.codec),
                fmt::format("it has {}", known));
  if (o.alpha && out->format->alpha && !codec->alpha)
    return fail(ErrorCode::range, fmt::format("{} cannot store transparency", codec->name),
                fmt::format("the codec {} of {} can", out->format->codecs.front().name, out->format->ending));
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
