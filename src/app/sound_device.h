// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sound device, through ALSA, which also reaches the devices of sound servers.
#pragma once

#include <memory>

#include "film/sound_stream.h"

namespace betwixt {

// Returns null if there is no device, or it accepts no more streams.
std::unique_ptr<SoundOutput> open_sound_device();

}  // namespace betwixt
