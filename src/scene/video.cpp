// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/video.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/files.h"
#include "betwixt/time.h"

namespace betwixt {
namespace {

constexpr double flicks_a_second = flicks_per_second;
constexpr double most_seconds = 1e9;

// Returns the number of pictures that have begun at a flick.
std::size_t begun(const Video& v, std::int64_t flick) {
  return static_cast<std::size_t>(std::upper_bound(v.begins.begin(), v.begins.end(), flick) - v.begins.begin());
}
std::int64_t flick_of(double second) {
  return std::llround(std::clamp(second, -most_seconds, most_seconds) * flicks_a_second);
}

}  // namespace

double Video::seconds() const { return static_cast<double>(end) / flicks_a_second; }

std::size_t Video::picture_at(double second) const {
  return std::max<std::size_t>(begun(*this, flick_of(second) + slack), 1) - 1;
}

std::size_t picture_shown(const Video& v, const VideoPart& part, double film) {
  const double until = std::min(part.until, v.seconds()), from = std::min(part.from, until), length = until - from;
  const double gone = std::max(0.0, film - part.at) * part.speed;
  double away = std::abs(gone);
  // A film's time at a seam is rounded: a flick before it belongs behind it.
  constexpr double flick = 1 / flicks_a_second;
  if (part.loop && length > 0) away = std::max(0.0, std::fmod(away + flick, length) - flick);
  // The picture that begins at the end of the part is not shown any more; played backwards, that is so at any time.
  const auto before = [&](double second) {
    return std::max<std::size_t>(begun(v, flick_of(second) - v.slack - 1), 1) - 1;
  };
  const std::size_t first = v.picture_at(from), last = std::max(first, before(until));
  const std::size_t now = part.speed < 0 ? before(until - away) : v.picture_at(from + away);
  return std::clamp(now, first, last);
}

std::size_t picture_at_time(const Video& v, double second, bool loop) {
  const double length = v.seconds();
  if (loop && length > 0 && second >= length) second = std::fmod(second, length);
  return v.picture_at(second);
}

bool names_video(const std::string& path) {
  static constexpr std::string_view endings[] = {"mp4", "m4v", "mov", "webm", "mkv", "avi", "ogv"};
  const std::string is = ending(path);
  return std::find(std::begin(endings), std::end(endings), is) != std::end(endings);
}

}  // namespace betwixt
