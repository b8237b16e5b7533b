// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt render --each: one film for each row of a table.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "app/subcommand.h"
#include "betwixt/film.h"

namespace betwixt {

struct RenderCall {
  std::string file, out, frames, descriptions;
  PictureCall picture;
  ExposureCall exposure;
  int jobs = 0, bits = 8, quality = 0;
  ColorCoding colors = ColorCoding::srgb;
  std::string codec, captions;
  std::optional<Rate> rate;
  bool missing = false, keep_old = false, keep_going = false, stats = false, plan = false, progress = false;
  std::string each;                                         // the table
  std::optional<std::pair<std::size_t, std::size_t>> rows;  // only these, both ends included, from 1
  std::optional<std::pair<std::size_t, std::size_t>> part;  // K of N
  bool json = false;
};

// Makes the films, several at once. Returns the exit code.
int render_each(RenderCall&);
std::vector<Parameter> each_parameters(RenderCall&);  // --each, --rows, --part, --json

}  // namespace betwixt
