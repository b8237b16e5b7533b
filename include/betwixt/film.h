// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Movies from pictures: .mp4 .webm .gif .apng through the ffmpeg program, or numbered PNG (frame-%04d.png).
//
// Room: film
#pragma once

#include <functional>
#include <string>

#include "betwixt/mesh.h"
#include "betwixt/result.h"
#include "betwixt/time.h"

namespace betwixt {

// Makes the picture of the k-th frame of the film, k from 0. Each job calls its own painter, from its own thread.
using Painter = std::function<Status(int k, Picture& out)>;

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
};

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

}  // namespace betwixt
