// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/sound_device.h"

#include <alsa/asoundlib.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "betwixt/sound.h"

namespace betwixt {
namespace {

class Device final : public SoundOutput {
 public:
  explicit Device(snd_pcm_t* pcm) : pcm_(pcm) {}
  ~Device() override {
    snd_pcm_drop(pcm_);
    snd_pcm_close(pcm_);
  }

  std::int64_t waiting() override {
    if (by_clock_) {
      const std::int64_t played =
          std::llround(std::chrono::duration<double>(Clock::now() - begun_).count() * sound_rate);
      return std::max<std::int64_t>(given_ - played, 0);
    }
    snd_pcm_sframes_t pairs = 0;
    return snd_pcm_delay(pcm_, &pairs) == 0 ? std::max<std::int64_t>(pairs, 0) : 0;
  }
  void write(std::span<const float> stereo) override {
    const auto pairs = static_cast<snd_pcm_uframes_t>(stereo.size() / 2);
    if (waiting() == 0) given_ = 0, begun_ = Clock::now();
    given_ += static_cast<std::int64_t>(pairs);
    // Recover after an underrun, a suspend or forget().
    if (const auto done = snd_pcm_writei(pcm_, stereo.data(), pairs); done < 0) {
      if (snd_pcm_recover(pcm_, static_cast<int>(done), 1) == 0) (void)snd_pcm_writei(pcm_, stereo.data(), pairs);
    }
    if (snd_pcm_state(pcm_) != SND_PCM_STATE_PREPARED) return;
    snd_pcm_start(pcm_);
    // Some devices take everything at once, such as ALSA's own `null`. Then the clock counts the time.
    if (waiting() == 0) by_clock_ = true;
  }
  void forget() override {
    given_ = 0;
    snd_pcm_drop(pcm_);
    snd_pcm_prepare(pcm_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  snd_pcm_t* const pcm_;
  bool by_clock_ = false;
  std::int64_t given_ = 0;  // pairs written since begun_
  Clock::time_point begun_ = Clock::now();
};

void say_nothing(const char*, int, const char*, int, const char*, ...) {}

}  // namespace

std::unique_ptr<SoundOutput> open_sound_device() {
  // ALSA would print errors to the terminal that shows the film.
  snd_lib_error_set_handler(say_nothing);
  snd_pcm_t* pcm = nullptr;
  if (snd_pcm_open(&pcm, "default", SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK) != 0) return nullptr;
  // Room for more than the sound thread ever writes ahead, so that no write waits.
  constexpr unsigned microseconds = 4 * 1'000'000 * SoundStream::ahead / sound_rate;
  if (snd_pcm_set_params(pcm, SND_PCM_FORMAT_FLOAT_LE, SND_PCM_ACCESS_RW_INTERLEAVED, 2, sound_rate, 1, microseconds) !=
      0) {
    snd_pcm_close(pcm);
    return nullptr;
  }
  return std::make_unique<Device>(pcm);
}

}  // namespace betwixt
