// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <system_error>
#include <thread>

#include "film/sink.h"
#include "server/frame_clock.h"

namespace betwixt {
namespace {

constexpr std::size_t most_pictures_waiting = 8;  // for the encoder

// The encoder has its own thread, so the clock never waits for it. If it is too slow, pictures are dropped and the one
// before is shown longer: the film's time stays right.
class Film final : public Screen {
 public:
  Film(std::unique_ptr<Renderer> renderer, std::unique_ptr<Sink> sink, Rate rate, std::function<void(const Error&)> t)
      : renderer_(std::move(renderer)), sink_(std::move(sink)), rate_(rate), trouble_(std::move(t)) {
    thread_ = std::thread([this] { encode(); });
  }
  ~Film() override {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
      end_ = first_ < 0 ? 0 : frame_at(monotonic_now()) + 1;
    }
    changed_.notify_all();
    thread_.join();
  }

  Status draw(const Evaluation& e) override { return renderer_->render(e, picture_); }
  Status show(const Shown& s) override {
    const Nanos moment = monotonic_now() - s.late;
    if (first_ < 0) first_ = moment;
    {
      const std::lock_guard lock(mutex_);
      if (failed_) return *failed_;
      if (waiting_.size() < most_pictures_waiting) waiting_.emplace_back(frame_at(moment), std::exchange(picture_, {}));
    }
    changed_.notify_all();
    return Nothing{};
  }

 private:
  std::int64_t frame_at(Nanos moment) const {
    return std::llround(static_cast<double>(moment - first_) / 1e9 * rate_.per_second());
  }

  void encode() {
    Parcel standing;
    std::int64_t next = 0;  // frame of the film
    Status s = Nothing{};
    const auto until = [&](std::int64_t frame) {
      for (; s && !standing.picture.rgba.empty() && next < frame; ++next)
        s = sink_->take(standing, [] { return true; });
    };
    while (s) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return over_ || !waiting_.empty(); });
      if (waiting_.empty()) break;
      auto [frame, picture] = std::move(waiting_.front());
      waiting_.pop_front();
      lock.unlock();
      until(frame);
      standing.picture = std::move(picture);
      if (s) s = sink_->pack(0, standing);
    }
    until(end_);
    if (s && next == 0) s = fail(ErrorCode::range, "no frame was shown, so there is no film");
    if (s) s = sink_->finish([] { return true; });
    if (s) return;
    trouble_(s.error());
    const std::lock_guard lock(mutex_);
    failed_ = s.error();
  }

  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<Sink> sink_;
  const Rate rate_;
  const std::function<void(const Error&)> trouble_;
  Picture picture_;
  Nanos first_ = -1;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::pair<std::int64_t, Picture>> waiting_;
  bool over_ = false;
  std::int64_t end_ = 0;
  std::optional<Error> failed_;
  std::thread thread_;
};

}  // namespace

NewScreen film_screen(const std::string& path, const RenderOptions& picture, Rate rate,
                      std::function<void(const Error&)> trouble) {
  return [=]() -> Result<std::unique_ptr<Screen>> {
    FilmOptions o;
    // The length is unknown; this number only decides how palettes are made.
    o.path = path, o.rate = rate, o.frames = 1'000'000;
    o.width = picture.width, o.height = picture.height;
    const Result<Output> place = read_output(path);
    if (!place) return place.error();
    if (!place->format)
      return fail(ErrorCode::range, "a server cannot make single pictures", "make a film: " + film_endings());
    auto renderer = make_renderer(picture);
    if (!renderer) return renderer.error();
    auto sink = make_sink(o);
    if (!sink) return sink.error();
    try {
      return std::unique_ptr<Screen>(std::make_unique<Film>(*std::move(renderer), *std::move(sink), rate, trouble));
    } catch (const std::system_error& e) {
      return fail(ErrorCode::machine, fmt::format("cannot start a thread for the film: {}", e.what()));
    }
  };
}

}  // namespace betwixt
