// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/soundtrack.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <new>
#include <thread>

#include "exchange/sounds.h"

namespace betwixt {

// The decoded part of a file. A thread decodes it, and stops some way ahead of the requested samples.
class Tape {
 public:
  explicit Tape(const Sound& sound)
      : length_(std::llround(sound.seconds * sound_rate)),
        samples_(new (std::nothrow) float[2 * static_cast<std::size_t>(length_)]),
        decoder_([this, path = sound.path] { decode(path); }) {}
  ~Tape() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    changed_.notify_all();
    decoder_.join();
  }
  // Requests everything before this sample.
  void want(std::int64_t until) {
    const std::lock_guard lock(mutex_);
    if (until <= wanted_) return;
    wanted_ = until;
    changed_.notify_all();
  }
  bool has(std::int64_t until, double seconds) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                             [&] { return ended_ || have_ >= std::min(until, length_); });
  }
  // Returns those of the samples that are decoded.
  std::span<const float> samples(std::int64_t first, std::int64_t last) {
    const std::lock_guard lock(mutex_);
    first = std::min(first, have_), last = std::min(last, have_);
    return {samples_.get() + 2 * first, static_cast<std::size_t>(2 * (last - first))};
  }

 private:
  static constexpr std::int64_t ahead = 30 * sound_rate;

  void decode(const std::string& path) {
    const auto keep = [this](std::span<const float> stereo) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return over_ || have_ < wanted_ + ahead; });
      const auto room = static_cast<std::size_t>(2 * (length_ - have_));
      std::copy_n(stereo.begin(), std::min(room, stereo.size()), samples_.get() + 2 * have_);
      have_ += static_cast<std::int64_t>(std::min(room, stereo.size()) / 2);
      changed_.notify_all();
      return !over_ && have_ < length_;
    };
    if (samples_)
      (void)decode_sound(path, keep, static_cast<double>(length_) / sound_rate);  // missing samples stay silent
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  const std::int64_t length_;
  const std::unique_ptr<float[]> samples_;  // memory is allocated as samples come
  std::mutex mutex_;
  std::condition_variable changed_;
  std::int64_t have_ = 0, wanted_ = 0;
  bool over_ = false, ended_ = false;
  std::thread decoder_;
};

Soundtrack::Soundtrack(Time first) : first_(first) {}
Soundtrack::~Soundtrack() = default;

Time Soundtrack::time(std::int64_t pair) const { return first_ + Time{pair * (flicks_per_second / sound_rate)}; }

Tape& Soundtrack::tape(const HeardSound& h) {
  std::unique_ptr<Tape>& there = tapes_[h.sound->path];
  if (!there) there = std::make_unique<Tape>(*h.sound);
  return *there;
}

bool Soundtrack::await(const Program& program, std::int64_t from, std::int64_t pairs, double seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun = Clock::now();
  const auto heard = sounds_heard(program, time(from), pairs);
  for (const HeardSound& h : heard) tape(h).want(h.last);
  return std::all_of(heard.begin(), heard.end(), [&](const HeardSound& h) {
    const double gone = std::chrono::duration<double>(Clock::now() - begun).count();
    return tape(h).has(h.last, std::max(0.0, seconds - gone));
  });
}

bool Soundtrack::mix(const Program& program, std::int64_t from, std::span<float> stereo) {
  const auto pairs = static_cast<std::int64_t>(stereo.size() / 2);
  std::vector<HeardSound> heard = sounds_heard(program, time(from), pairs + soon);
  for (HeardSound& h : heard) {
    tape(h).want(h.last);
    h.last = std::min(h.last, h.offset + pairs);
  }
  std::erase_if(heard, [](const HeardSound& h) { return h.first >= h.last; });
  if (!std::all_of(heard.begin(), heard.end(), [&](const HeardSound& h) { return tape(h).has(h.last, 0); }))
    return false;
  std::fill(stereo.begin(), stereo.end(), 0.0f);
  for (const HeardSound& h : heard)
    add_sound(program, h, h.first, tape(h).samples(h.first, h.last), time(from), stereo);
  return true;
}

}  // namespace betwixt
