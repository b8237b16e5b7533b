// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Makes movies from pictures: .mp4 .webm .mov .gif .apng with the ffmpeg program, or numbered PNG (frame-%04d.png) and
// OpenEXR (frame-%04d.exr) files. Alpha is straight in all formats but OpenEXR, where it is premultiplied.
//
// Room: film
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "betwixt/linear_picture.h"
#include "betwixt/program.h"
#include "betwixt/render.h"
#include "betwixt/result.h"
#include "betwixt/time.h"

namespace betwixt {

// Paints the k-th frame of the film, counted from 0. A film is painted by several threads, called jobs. Each job has
// its own painter and calls it from its own thread.
using Painter = std::function<Status(int k, Picture& out)>;

// The same, as linear light.
using LinearPainter = std::function<Status(int k, LinearPicture& out)>;

// Fills in a film's sound: left, right, left, …, 48,000 pairs a second (sound_rate in betwixt/sound.h), from -1 to 1;
// the encoder clips what is outside. Called once, before the first picture. All numbers of `stereo` are 0 before the
// call.
using Sounds = std::function<Status(std::span<float> stereo)>;

// Mixes all sounds of a program into `stereo`, which begins at the time `from` and has the layout of Sounds. The
// beginning of a sound is rounded to the nearest sample. The display functions `at`, `from`, `until` and the fades of a
// sound are read at time 0 only; `gain` follows its track. Errors: file (a sound file is missing), machine (no ffmpeg).
Status mix_sounds(const Program&, Time from, std::span<float> stereo);
bool has_sounds(const Document&);
// Return whether a format (by the extension of `path`) can hold sound, captions, transparency, more than 8 bits a
// channel, or unclamped light. Numbered PNG can hold 16 bits, and does if FilmOptions::bits is 16.
bool takes_sound(const std::string& path);
bool takes_captions(const std::string& path);
bool takes_alpha(const std::string& path);
bool takes_16_bits(const std::string& path);
bool takes_unclamped_light(const std::string& path);

// A chapter of a film: a part that players offer to jump to. Its times are seconds since the film's first frame.
struct Chapter {
  std::string title;
  double begin = 0, end = 0;
};
// Returns the sections of a document that lie between these times, as chapters.
std::vector<Chapter> chapters_of(const Document&, Time from, Time until);
// Returns the descriptions between these times as a WebVTT file. Each lasts until the next one, at most ten seconds.
std::string descriptions_vtt(const Document&, Time from, Time until);

struct FilmOptions {
  std::string path;      // the extension gives the format
  int frames = 0;        // how many, at least 1
  int first_number = 1;  // number of the first picture file
  Rate rate;
  int width = 1280, height = 720;
  int jobs = 0;  // threads that paint, at most 256; 0: as many as suits this machine
  bool overwrite = true;
  // For numbered pictures: keeps those that exist, are complete and have this size, and makes the others. Each is put
  // in place as soon as it is made, even if the film fails later.
  bool only_missing = false;
  bool alpha = false;    // keeps transparency, if the format can hold it
  bool drawing = false;  // a flat film: H.264 takes fewer trials, which show only in pictures of nature
  int bits = 8;          // bits a channel of numbered PNG: 8 or 16
  ColorCoding colors = ColorCoding::srgb;  // all others need make_linear_film, and have 10 bits or more
  Sounds sounds;                           // without it the film is silent
  std::string captions;                    // a text track in the form of SRT; "": none
  std::vector<Chapter> chapters;           // of .mp4, .webm and .mov
  int quality = 0;                         // 1 to 100, for lossy formats; 0: the codec's default
  std::string codec;                       // one of codecs_of(path); "": the first of them
};

// Returns the codecs that a format can use, the default first. Returns an empty list if there is no choice.
std::vector<std::string> codecs_of(const std::string& path);
// Checks that the format supports the quality and the codec that the options name. Errors (range, name) list the valid
// values.
Status check_encoding(const FilmOptions&);

struct FilmStats {
  int frames = 0;
  int found = 0;        // of these, pictures that existed already and were kept (FilmOptions::only_missing)
  double seconds = 0;   // wall clock, in total
  double painting = 0;  // seconds inside painters, summed over jobs
  double encoding = 0;  // seconds of waiting for the encoder or the disk
};

// Called now and then, from one thread: `done` of `frames` are made, `seconds` after the film was begun. Return false
// to stop the film; then no file is left under its final name, except the pictures made with `only_missing`.
using Progress = std::function<bool(int done, int frames, double seconds)>;

// Make a film. Each job calls new_painter once, from its own thread; these calls do not overlap. At most two pictures
// for each job are in memory. The film (or all its pictures) is written under a hidden name beside the final one and
// renamed when it is complete; with `only_missing` each picture is renamed when it is complete. OpenEXR and PNG of 16
// bits need make_linear_film. Errors: range (an unknown extension, options out of bounds, a picture of another size,
// `only_missing` or 16 bits for a format without it), file (no such folder, the file exists), machine (no ffmpeg, not
// writable, disk full, stopped), and the painter's errors, unchanged.
Result<FilmStats> make_film(const FilmOptions&, const std::function<Result<Painter>()>& new_painter,
                            const Progress& = {});
Result<FilmStats> make_linear_film(const FilmOptions&, const std::function<Result<LinearPainter>()>& new_painter,
                                   const Progress& = {});

// Returns a picture as JPEG over black. Errors: machine.
Result<std::string> jpeg_of(const Picture&, int quality);
// Writes a picture as JPEG over black, and renames it into place when it is complete. `quality` is 1 to 100.
// Errors: file (the file exists), machine.
Status write_jpeg(const std::string& path, const Picture&, int quality, bool overwrite = true);

// The frames of a film.
struct FrameList {
  Time first, last;  // of the segment; the last frame may be earlier than `last`
  int count = 1;
  int number = 1;       // the number of the first frame
  bool on_grid = true;  // whether `first` is exactly the time of a numbered frame; then `number` is valid
  Rate rate;
  Time time(int k) const { return on_grid ? rate.frame(number + k) : first + rate.span(k); }
};
// Returns the frames of a segment, both ends included, at least one. Errors: range (too many, too far from time 0).
Result<FrameList> frames_between(Time first, Time last, Rate);

// The settings with which `betwixt render` makes a film of a program, worked out from what the user asks for.
struct RenderJob {
  FrameList frames;
  RenderOptions pictures;
  std::optional<Blur> blur;  // nullopt: no blur
  FilmOptions film;          // for make_linear_film if `pictures.linear`, otherwise for make_film
};
RenderJob render_job(const Program&, const std::string& path, const FrameList&, RenderOptions, std::optional<Blur>,
                     int bits = 8, ColorCoding colors = ColorCoding::srgb);
// Return painters for the frames; call each from the thread that made it. After each frame, a painter calls
// TellProblems with the problems of that frame; the list may be empty. If there are several jobs, several threads may
// call it at the same time. Errors: those of make_renderer.
using TellProblems = std::function<void(const std::vector<std::string>&)>;
Result<Painter> painter_of(const Program&, const RenderJob&, const TellProblems& = {});
Result<LinearPainter> linear_painter_of(const Program&, const RenderJob&, const TellProblems& = {});

}  // namespace betwixt
