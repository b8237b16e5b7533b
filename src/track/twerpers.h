// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Twerpers: how a track moves from one event to the next. Each is a row with its blend function; reading, help, fitting
// and evaluation follow from the rows. (twixt notes, 4.6)
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "betwixt/math.h"
#include "track/cubic.h"
#include "track/ease.h"
#include "track/event.h"

namespace betwixt {

// The input of a blend function: a segment of a track, the fraction, and the neighbours.
struct Blend {
  const double *from = nullptr, *to = nullptr;  // the numbers at its two ends
  const double *before = nullptr,
               *after = nullptr;  // and at the events beside it; null after a cut or a hold, and at an end
  std::uint32_t channels = 1;     // numbers in each
  double s = 0;                   // 0 to 1, with eases
  double length = 1, length_before = 1, length_after = 1;      // flicks
  const double *tangent_out = nullptr, *tangent_in = nullptr;  // per second; null if not given
  const double *handle_out = nullptr, *handle_in = nullptr;    // as differences; null if not given
  double handle_out_length = 0, handle_in_length = 0;          // flicks
  double left(std::uint32_t i) const { return before ? before[i] : 2 * from[i] - to[i]; }  // reflected if missing
  double right(std::uint32_t i) const { return after ? after[i] : 2 * to[i] - from[i]; }
};

// An argument in brackets after a twerper.
struct TwerperArgument {
  std::string_view name;  // as in "NAME is from 1 to 9"
  double low = 0, high = 0;
  bool whole = false;
};

// A row of a twerper; its index is the number. The first have names in `Twerper`, the others are known by their rows.
struct TwerperRow {
  std::string_view name = {};
  std::string_view sentence = {}, written = {},
                   example = {};  // for help; `written`: usage, if it is more than the name
  // Returns the blending factor at s; null: s itself.
  double (*factor)(double s, const std::array<double, 4>& arguments) = nullptr;
  bool costly = false;  // the factor is worth a table (ease.h)
  // Sets the cubic of s for each channel, or returns an orientation, if a factor between the two ends is not enough.
  void (*cubics)(const Blend&, Cubic* out) = nullptr;
  void (*numbers)(const Blend&, double* out) = nullptr;  // at g.s, if it is not a cubic of s
  Quat (*turn)(const Blend&) = nullptr;
  // All arguments must be given. One of the words may follow; its index is the next argument.
  std::span<const TwerperArgument> arguments = {};
  std::span<const std::string_view> words = {};
  bool steps = false;              // constant in equal parts of s, as many as the first argument says
  bool matches = false;            // for texts only: glyph by glyph
  bool stops = false;              // takes stops in place of arguments, any number of them
  std::string_view reversed = {};  // the twerper that runs the same way back; "": see reverse()
  // The twerpers that replace this one for orientations, or for numbers (then this one is for orientations only);
  // unset: none.
  Twerper for_orientations = Twerper::unset, for_numbers = Twerper::unset;
};

std::span<const TwerperRow> twerpers();  // by their numbers; the first is `unset`
const TwerperRow& row_of(Twerper);       // for built-in ones
// Returns the ease of a built-in twerper that takes no arguments; null if its factor is the share of the time.
const Ease* ease_of(Twerper);
std::optional<Twerper> find_twerper(std::string_view name);  // never returns `unset`
std::string_view name_of(Twerper);                           // for built-in ones

// The names, by number.
inline const std::vector<std::string_view> twerper_names = [] {
  std::vector<std::string_view> names;
  for (const TwerperRow& row : twerpers()) names.push_back(row.name);
  return names;
}();

inline bool takes_arguments(Twerper t) { return !is_own(t) && !row_of(t).arguments.empty(); }
// Replaces a twerper by the one that runs the same way back.
void reverse(Twerper&, TwerperArguments&);

// A stop as written. Stops without a time are evenly spaced between their neighbours (CSS Easing 2).
struct SaidStop {
  double value = 0;
  std::optional<double> place;
};
Stops placed(const std::vector<SaidStop>&);
std::vector<SaidStop> as_said(const Stops&);  // the inverse: omits the times that are evenly spaced
double through(const Stops&, double s);       // the value at s of the straight lines through the stops

double bezier_factor(double u, const std::array<double, 4>& xy);
Quat slerp(Quat a, Quat b, double s);  // keeps the signs, which the caller has chosen

}  // namespace betwixt
