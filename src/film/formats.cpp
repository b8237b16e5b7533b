// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/formats.h"

namespace betwixt {
namespace {

using Words = std::vector<std::string>;

Words mp4_words(const FilmOptions&) {
  return {"-c:v",     "libx264", "-preset",   "fast",       "-crf", "18",
          "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",   "mp4"};
}

Words webm_words(const FilmOptions& o) {
  Words w{"-c:v",      "libvpx-vp9", "-crf",    "28", "-b:v",          "0", "-deadline", "good",
          "-cpu-used", "4",          "-row-mt", "1",  "-tile-columns", "2"};
  // Of films with opacity the encoder can make no frames that are seen later.
  if (o.alpha) w.insert(w.end(), {"-auto-alt-ref", "0"});
  w.insert(w.end(), {"-pix_fmt", o.alpha ? "yuva420p" : "yuv420p", "-f", "webm"});
  return w;
}

// ProRes 4444: what editors take. Opacity is not multiplied in.
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

// A good palette needs all pictures at once, and ffmpeg keeps them; a long film gets a palette for each picture
// instead.
Words gif_words(const FilmOptions& o) {
  constexpr double palette_memory = 1 << 30;
  const bool whole = 4.0 * o.width * o.height * o.frames <= palette_memory;
  // Players take a delay below 2/100 s for 10/100 s.
  const std::string thin = o.rate.per_second() > 50 ? "fps=50," : "";
  const std::string filter =
      thin +
      (whole ? "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=sierra2_4a:diff_mode=rectangle"
             : "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=sierra2_4a");
  return {"-filter_complex", filter, "-loop", "0", "-f", "gif"};
}

Words apng_words(const FilmOptions&) { return {"-c:v", "apng", "-pred", "mixed", "-plays", "0", "-f", "apng"}; }

constexpr Format format_rows[] = {{".mp4", true, mp4_words, "-c:a aac -b:a 192k", false},
                                  {".webm", true, webm_words, "-c:a libopus -b:a 128k"},
                                  {".mov", false, mov_words, "-c:a pcm_s24le", true, true},
                                  {".gif", false, gif_words},
                                  {".apng", false, apng_words}};

}  // namespace

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
