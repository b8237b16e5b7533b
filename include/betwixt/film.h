// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Movies from pictures: .mp4 .webm .mov .gif .apng through the ffmpeg program, or numbered PNG (frame-%04d.png) and
// OpenEXR (frame-%04d.exr). Opacity is straight in all but OpenEXR, where it is multiplied in.
//
// Room: film
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "betwixt/deep_picture.h"
#include "betwixt/program.h"
#include "betwixt/render.h"
#include "betwixt/result.h"
#include "betwixt/time.h"

namespace betwixt {

// Makes the picture of the k-th frame of the film, k from 0. Each job calls its own painter, from its own thread.
using Painter = std::function<Status(int k, Picture& out)>;

// The same as light.
using DeepPainter = std::function<Status(int k, DeepPicture& out)>;

// Fills a film's sound: left, right, left, …, `sound_rate` pairs a second. Called once, before the first picture.
using Sounds = std::function<Status(std::span<float> stereo)>;

// All sounds of a program from a time on, as they are heard, each to the next sample: at, from, until and the fades as
// they are at the beginning, gain as it changes. Errors: file (not there any more), machine (no ffmpeg).
Status mix_sounds(const Program&, Time from, std::span<float> stereo);
bool has_sounds(const Document&);
// What films can have whose names end so: sound; what is clear; more than 8 bits a channel (numbered PNG only where
// FilmOptions::bits says so, and OpenEXR light that does not roll off).
bool takes_sound(const std::string& path);
bool takes_alpha(const std::string& path);
bool takes_depth(const std::string& path);
bool takes_open_light(const std::string& path);

struct FilmOptions {
  std::string path;      // the ending says what is made
  int frames = 0;        // how many
  int first_number = 1;  // number of the first picture file
  Rate rate;
  int width = 1280, height = 720;
  int jobs = 0;  // painters at work; 0: as many as suits this machine
  bool overwrite = true;
  // Of numbered pictures: those that are there, whole and of this size stay; each other one is put in place when it is
  // made, whatever becomes of the rest.
  bool missing = false;
  bool alpha = false;  // what is clear in the pictures is clear in the film, where it can be
  int bits = 8;        // a channel of numbered PNG: 8 or 16
  Sounds sounds;       // none: it is silent
  int quality = 0;     // 1 to 100, of formats that lose something; 0: as is usual for the codec
  std::string codec;   // one of codecs_of(path); empty: the first of them
};

// What films can be coded as whose names end so, the usual one first; none where there is nothing to choose.
std::vector<std::string> codecs_of(const std::string& path);
// Whether quality and codec mean something for the path. Errors: range, name, with what may be said.
Status check_encoding(const FilmOptions&);

struct FilmStats {
  int frames = 0;
  int found = 0;        // of these: pictures that were there (FilmOptions::missing)
  double seconds = 0;   // wall clock, all of it
  double painting = 0;  // seconds inside painters, summed over jobs
  double encoding = 0;  // seconds in which the encoder or the disk was what was waited for
};

// Called now and then from one thread; returning false stops the film (nothing is left under its final name).
using Progress = std::function<bool(int done, int frames, double seconds)>;

// new_painter is called once by each job, from the job's own thread, one job at a time. At most twice as many pictures
// as jobs are held. The film (all its pictures, where it is made of these) gathers under a hidden name beside its own
// and is put in place when it is whole. Errors: range (an ending nobody knows, bad sizes, `missing` of a film in one
// file), file (no such folder, there already), machine (no ffmpeg, not writable, disk full, stopped), or the painter's
// own, unchanged.
Result<FilmStats> make_film(const FilmOptions&, const std::function<Result<Painter>()>& new_painter,
                            const Progress& = {});
Result<FilmStats> make_deep_film(const FilmOptions&, const std::function<Result<DeepPainter>()>& new_painter,
                                 const Progress& = {});

// A picture as JPEG, put in place when it is whole; what is clear is over black. `quality`: 1 to 100.
// Errors: file (there already), machine.
Status write_jpeg(const std::string& path, const Picture&, int quality, bool overwrite = true);

// The frames of a film: the k-th one's time.
struct FrameList {
  Time first, last;  // of the segment; the last frame may be before its end
  int count = 1;
  int number = 1;       // of the first frame
  bool on_grid = true;  // the first frame is a whole one
  Rate rate;
  Time time(int k) const { return on_grid ? rate.frame(number + k) : first + rate.span(k); }
};
// Those of a segment, both ends included, one at least. Errors: range (too many, too far from the beginning).
Result<FrameList> frames_between(Time first, Time last, Rate);

// A film of a program as `betwixt render` makes it: what is asked for, and all that follows from it.
struct Shoot {
  FrameList frames;
  RenderOptions pictures;
  std::optional<Exposure> exposure;  // none: nothing is blurred
  FilmOptions film;                  // painted as light where `pictures` are deep
};
Shoot shoot_of(const Program&, const std::string& path, const FrameList&, RenderOptions, std::optional<Exposure>,
               int bits = 8);
// They paint its frames, and say what procedures did wrong, each from its own thread.
using TellProblems = std::function<void(const std::vector<std::string>&)>;
Result<Painter> painter_of(const Program&, const Shoot&, const TellProblems& = {});
Result<DeepPainter> deep_painter_of(const Program&, const Shoot&, const TellProblems& = {});

}  // namespace betwixt
