// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sound device, through ALSA, which has the sound servers' devices too.
#pragma once

#include <memory>

#include "film/sound_stream.h"

namespace betwixt {

// Null: there is none, or it has no room for one more.
std::unique_ptr<SoundOutput> open_sound_device();

}  // namespace betwixt
