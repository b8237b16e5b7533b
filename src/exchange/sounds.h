// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sounds from files, through the ffmpeg program in a jail (parser_jail.h): it opens only the given file, and no list of
// other files.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "betwixt/result.h"
#include "betwixt/sound.h"

namespace betwixt {

// Receives the next samples: left and right alternately, `sound_rate` pairs a second. Returns false to stop.
using Listener = std::function<bool(std::span<const float> stereo)>;

constexpr double longest_sound = 4 * 3600;  // seconds

// Errors: file (missing, unreadable, without sound, or more work than `longest` seconds of sound need), machine (no
// ffmpeg).
Status decode_sound(const std::string& path, const Listener&, double longest = longest_sound);
// Reads a sound with the data that scripts can query. Errors: those, and range (above four hours; above five minutes
// and a second for every 100 bytes, unless any size is allowed).
Result<std::shared_ptr<const Sound>> read_sound(const std::string& path, bool any_size = false);

}  // namespace betwixt
