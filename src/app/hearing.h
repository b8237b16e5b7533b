// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What is heard while a film plays.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "app/playhead.h"
#include "film/sound_stream.h"
#include "film/soundtrack.h"

namespace betwixt {

// Sound in step with a playhead, mixed in a thread of its own: pictures never wait for it.
class Hearing {
 public:
  // Null where the film has no sounds. The device is opened, and files begin to be read.
  static std::unique_ptr<Hearing> open(const Program&, const FrameList&, bool loop);
  Hearing(const Program&, const FrameList&, bool loop);
  ~Hearing();
  Hearing(const Hearing&) = delete;
  Hearing& operator=(const Hearing&) = delete;

  bool has_device() const { return output_ != nullptr; }
  // To begin with, waits for what is heard first, but not for long.
  void await_beginning();
  // `muted`: nothing is heard.
  void follow(const Program&, const Playhead::Place&, bool muted);

 private:
  void play();

  const double rate_;                          // frames a second
  const std::unique_ptr<SoundOutput> output_;  // none: there is no device
  Soundtrack track_;
  SoundStream stream_;
  std::mutex mutex_;
  std::condition_variable changed_;
  Program program_, heard_;               // as it is said, and as the thread has it
  std::optional<Playhead::Place> place_;  // none: nothing is to be heard
  bool begun_ = false, over_ = false;
  std::thread player_;
};

}  // namespace betwixt
