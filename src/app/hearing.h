// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sound during playback.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "betwixt/film.h"
#include "film/sound_stream.h"
#include "film/soundtrack.h"
#include "playback/playhead.h"

namespace betwixt {

// Plays sound in step with a playhead. A thread of its own mixes it, so pictures never wait for it.
class Hearing {
 public:
  // Opens the device and starts to read the sound files. Returns null if the film has no sounds.
  static std::unique_ptr<Hearing> open(const Program&, const FrameList&, bool loop);
  Hearing(const Program&, const FrameList&, bool loop);
  ~Hearing();
  Hearing(const Hearing&) = delete;
  Hearing& operator=(const Hearing&) = delete;

  bool has_device() const { return output_ != nullptr; }
  // Waits a short time for the first sounds to be ready.
  void await_beginning();
  // `muted`: plays silence.
  void follow(const Program&, const Playhead::Place&, bool muted);

 private:
  void play();

  const double rate_;                          // frames a second
  const std::unique_ptr<SoundOutput> output_;  // null if there is no device
  Soundtrack track_;
  SoundStream stream_;
  std::mutex mutex_;
  std::condition_variable changed_;
  Program program_, heard_;               // the latest program, and the one that the thread uses
  std::optional<Playhead::Place> place_;  // nullopt plays silence
  bool begun_ = false, over_ = false;
  std::thread player_;
};

}  // namespace betwixt
