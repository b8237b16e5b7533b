// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/hearing.h"

#include <algorithm>
#include <cmath>

#include "app/sound_device.h"
#include "betwixt/film.h"

namespace betwixt {

std::unique_ptr<Hearing> Hearing::open(const Program& program, const FrameList& frames, bool loop) {
  return has_sounds(program.document()) ? std::make_unique<Hearing>(program, frames, loop) : nullptr;
}

Hearing::Hearing(const Program& program, const FrameList& frames, bool loop)
    : rate_(frames.rate.per_second()),
      output_(open_sound_device()),
      track_(frames.time(0)),
      stream_([this](std::int64_t from, std::span<float> stereo) { return track_.mix(heard_, from, stereo); },
              std::max<std::int64_t>(std::llround(frames.count / rate_ * sound_rate), 1), loop),
      program_(program),
      heard_(program) {
  if (!output_) return;
  (void)track_.await(heard_, 0, Soundtrack::soon, 0);
  player_ = std::thread([this] { play(); });
}

Hearing::~Hearing() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  if (player_.joinable()) player_.join();
}

void Hearing::await_beginning() {
  constexpr double patience = 1;  // seconds
  if (output_) (void)track_.await(heard_, 0, Soundtrack::soon, patience);
}

void Hearing::follow(const Program& program, const Playhead::Place& place, bool muted) {
  {
    const std::lock_guard lock(mutex_);
    program_ = program;
    place_ = place.playing && !muted ? std::optional(place) : std::nullopt;
    begun_ = true;
  }
  changed_.notify_all();
}

void Hearing::play() {
  constexpr std::chrono::milliseconds pause(10);
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return begun_ || over_; });
  while (!over_) {
    heard_ = program_;
    const std::optional<Playhead::Place> place = place_;
    lock.unlock();
    std::optional<std::int64_t> now;
    if (place) now = std::llround((place->frame / rate_ + Playhead::seconds_since(place->since)) * sound_rate);
    stream_.fill(*output_, now);
    lock.lock();
    changed_.wait_for(lock, pause);
  }
}

}  // namespace betwixt
