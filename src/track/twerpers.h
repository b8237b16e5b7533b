// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Twerpers: how a track goes from one event to the next. Each is a row with its blend function; reading, help, fitting
// and evaluating follow from the rows. (twixt notes, 4.6; R-T4, R-T7, R-T8)
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "betwixt/math.h"
#include "track/cubic.h"
#include "track/event.h"

namespace betwixt {

// What a blend function sees of a track: a segment, how far in it, and what is beside it.
struct Blend {
  const double *from = nullptr, *to = nullptr;       // the numbers at its two ends
  const double *before = nullptr, *after = nullptr;  // and at the events beside it; null behind a cut, a hold or an end
  std::uint32_t channels = 1;                        // numbers in each
  double s = 0;                                      // 0 to 1, eases in it
  double length = 1, length_before = 1, length_after = 1;      // flicks
  const double *tangent_out = nullptr, *tangent_in = nullptr;  // per second; null where nobody says
  const double *handle_out = nullptr, *handle_in = nullptr;    // as differences; null where nobody says
  double handle_out_length = 0, handle_in_length = 0;          // flicks
  double left(std::uint32_t i) const { return before ? before[i] : 2 * from[i] - to[i]; }  // else it is reflected
  double right(std::uint32_t i) const { return after ? after[i] : 2 * to[i] - from[i]; }
};

// What stands in brackets behind a twerper.
struct TwerperArgument {
  std::string_view name;  // as in "NAME is from 1 to 9"
  double low = 0, high = 0;
  bool whole = false;
};

// A twerper's place among the rows is its number: the first are named in `Twerper`, any others by their rows only.
struct TwerperRow {
  std::string_view name = {};
  std::string_view sentence = {}, written = {},
                   example = {};  // for help; `written`: where there is more to write than the name
  // How far the blend between two values is at s; null: s itself.
  double (*factor)(double s, const std::array<double, 4>& arguments) = nullptr;
  // Of a segment of numbers the cubic of s of each channel, and of one of orientations, where the two ends and a factor
  // are not all that counts.
  void (*cubics)(const Blend&, Cubic* out) = nullptr;
  void (*numbers)(const Blend&, double* out) = nullptr;  // at g.s, where it is no cubic of s
  Quat (*turn)(const Blend&) = nullptr;
  // The one that stands for it where orientations are blended, or numbers (then it turns orientations only); unset:
  // itself.
  // All of its arguments are said, and one of the words may be; its place is the next argument.
  std::span<const TwerperArgument> arguments = {};
  std::span<const std::string_view> words = {};
  bool steps = false;              // it is the same all along each of as many equal parts of s as the first one says
  bool stops = false;              // or in their place stops, any number of them
  std::string_view reversed = {};  // the one that goes the same way back; empty: see reverse()
  Twerper for_orientations = Twerper::unset, for_numbers = Twerper::unset;
};

std::span<const TwerperRow> twerpers();                      // by their numbers; the first is `unset`
const TwerperRow& row_of(Twerper);                           // of a built-in one
std::optional<Twerper> find_twerper(std::string_view name);  // not `unset`
std::string_view name_of(Twerper);                           // of a built-in one

// By their numbers.
inline const std::vector<std::string_view> twerper_names = [] {
  std::vector<std::string_view> names;
  for (const TwerperRow& row : twerpers()) names.push_back(row.name);
  return names;
}();

inline bool takes_arguments(Twerper t) { return !is_own(t) && !row_of(t).arguments.empty(); }
// The twerper that goes the same way back.
void reverse(Twerper&, TwerperArguments&);

// Stops as they are said, some without their places in time: these lie evenly between their neighbours' (CSS Easing 2).
struct SaidStop {
  double value = 0;
  std::optional<double> place;
};
Stops placed(const std::vector<SaidStop>&);
std::vector<SaidStop> as_said(const Stops&);  // the other way round: as few places as say the same
double through(const Stops&, double s);       // where between two values straight lines through them are

double bezier_factor(double u, const std::array<double, 4>& xy);
Quat slerp(Quat a, Quat b, double s);  // no sign is changed: the caller has chosen

}  // namespace betwixt
