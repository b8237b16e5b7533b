// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sounds from files, through the ffmpeg program: it opens the one file that it is given, and no list of others.
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

// Errors: file (missing, not readable, nothing to be heard in it), machine (no ffmpeg).
Status decode_sound(const std::string& path, const Listener&);
// What can be asked of it. Errors: those, and range (above four hours).
Result<std::shared_ptr<const Sound>> read_sound(const std::string& path);

}  // namespace betwixt
