// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// An event (keyframe): a value at a time, and how the track continues from there. (twixt notes, 3.2 and 4.6)
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "betwixt/time.h"
#include "betwixt/value.h"

namespace betwixt {

// Interpolators; twerpers.h has their rows. `unset` is the default of the type: smooth for numbers, linear for colours,
// slerp for orientations, hold for all others.
enum class Twerper : std::uint8_t { unset, hold, linear, smooth, bspline, hermite, bezier, slerp, squad };

// Numbers from here on are the document's own twerpers, by their place among its procedures.
inline constexpr std::uint8_t first_own_twerper = 56;
constexpr bool is_own(Twerper t) { return static_cast<std::uint8_t>(t) >= first_own_twerper; }

// A stop of linear(…): the time in percent, and the share of the way between the two values. In order of time.
using Stop = std::array<double, 2>;
using Stops = std::vector<Stop>;

// The arguments in brackets after a twerper; of bezier x1 y1 x2 y2.
struct TwerperArguments : std::array<double, 4> {
  TwerperArguments() : TwerperArguments(0.25, 0.1, 0.25, 1) {}
  TwerperArguments(const std::array<double, 4>& numbers) : array(numbers) {}
  TwerperArguments(double a, double b, double c, double d) : array{a, b, c, d} {}
  std::shared_ptr<const Stops> stops;  // of linear; null: none
  friend bool operator==(const TwerperArguments& a, const TwerperArguments& b) {
    return std::equal(a.begin(), a.end(), b.begin()) &&
           (a.stops == b.stops || (a.stops && b.stops && *a.stops == *b.stops));
  }
};

// The fields that few events have.
struct EventDetail {
  Time ease_in, ease_out;
  std::optional<Value> before;  // a cut: the value just before it; the event's value is the one after
  TwerperArguments arguments;
  std::optional<Value> tangent_in, tangent_out;  // hermite: per second; with a handle, its height in value
  std::optional<Time> handle_in, handle_out;     // fcurve: the length of its handles in time
  friend bool operator==(const EventDetail&, const EventDetail&) = default;
};

// A detail or none, in one word. Copies are deep.
class DetailBox {
 public:
  DetailBox() = default;
  DetailBox(const DetailBox& o) : at_(o.at_ ? std::make_unique<EventDetail>(*o.at_) : nullptr) {}
  DetailBox(DetailBox&&) noexcept = default;
  DetailBox& operator=(const DetailBox& o) {
    at_ = o.at_ ? std::make_unique<EventDetail>(*o.at_) : nullptr;
    return *this;
  }
  DetailBox& operator=(DetailBox&&) noexcept = default;
  explicit operator bool() const { return at_ != nullptr; }
  const EventDetail& operator*() const { return at_ ? *at_ : none(); }
  const EventDetail* operator->() const { return &**this; }
  EventDetail& edit() {
    if (!at_) at_ = std::make_unique<EventDetail>();
    return *at_;
  }
  // Equal in effect: an empty detail is no detail.
  friend bool operator==(const DetailBox& a, const DetailBox& b) { return *a == *b; }

 private:
  static const EventDetail& none() {
    static const EventDetail d;
    return d;
  }
  std::unique_ptr<EventDetail> at_;
};

struct Event {
  Time time;
  Value value;
  DetailBox detail;
  Twerper twerper = Twerper::unset;
  bool release = false;  // on a velocity track: the end of its reign; no value
  bool keep = false;     // changes the twerper only; the value is that of the track without this event
  friend bool operator==(const Event&, const Event&) = default;
};
static_assert(sizeof(Event) <= 64, "an event has grown; a document of a million of them notices");

}  // namespace betwixt
