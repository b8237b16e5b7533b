// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sounds from files, through the ffmpeg program, in a jail (parser_jail.h): it opens the one file that it is given, and
// no list of others.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "betwixt/result.h"
#include "betwixt/sound.h"

namespace betwixt {

// The next samples, left and right in turns, `sound_rate` pairs a second. False: enough.
using Listener = std::function<bool(std::span<const float> stereo)>;

constexpr double longest_sound = 4 * 3600;  // seconds

// Errors: file (missing, not readable, silent, or slower to decode than `longest` seconds of sound should be),
// machine (no ffmpeg).
Status decode_sound(const std::string& path, const Listener&, double longest = longest_sound);
// What can be asked of it. Errors: those, and range (above four hours; above five minutes and a second for every 100
// bytes, unless any size is allowed).
Result<std::shared_ptr<const Sound>> read_sound(const std::string& path, bool any_size = false);

}  // namespace betwixt
