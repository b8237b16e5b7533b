// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace betwixt {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

// Lengths of time that readers expect between ticks, in seconds.
constexpr std::array<double, 19> time_steps{0.1, 0.2, 0.5, 1,   2,    5,    10,   15,    30,   60,
                                            120, 300, 600, 900, 1800, 3600, 7200, 21600, 86400};

// Returns 1, 2 or 5 times a power of ten, not below the number.
double readable(double wanted) {
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double m : {1.0, 2.0, 5.0})
    if (m * power >= wanted * (1 - 1e-9)) return m * power;
  return 10 * power;
}

std::string superscript(int number) {
  static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(number))) out += digits[static_cast<std::size_t>(c - '0')];
  return out;
}

std::string with_minus(std::string digits) {
  if (digits.starts_with('-')) digits.replace(0, 1, "−");
  return digits;
}

// Separates thousands: 12,000.
std::string grouped(std::string digits) {
  const auto point = std::min(digits.find('.'), digits.size());
  const std::size_t first = digits.starts_with('-') ? 1 : 0;
  if (point - first < 5) return digits;
  for (std::size_t at = point; at > first + 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string as_power(double number) {
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(number)) + 1e-9));
  const double mantissa = number / std::pow(10.0, exponent);
  const double rounded = std::round(mantissa * 1000) / 1000;
  if (std::abs(rounded - 1) < 1e-9) return "10" + superscript(exponent);
  return with_minus(fmt::format("{:g}", rounded)) + "·10" + superscript(exponent);
}

std::string as_time(double seconds, double step) {
  const double whole = std::floor(std::abs(seconds) + 1e-9);
  const auto all = static_cast<long long>(whole);
  std::string out = seconds < 0 ? "−" : "";
  if (step < 1 && std::abs(seconds) < 60) return out + fmt::format("{:g} s", std::abs(seconds));
  if (step >= 86400) return out + fmt::format("{} d", all / 86400);
  if (all >= 3600) return out + fmt::format("{}:{:02}:{:02}", all / 3600, all / 60 % 60, all % 60);
  return out + fmt::format("{}:{:02}", all / 60, all % 60);
}

double step_of_time(double wanted) {
  const auto* at = std::lower_bound(time_steps.begin(), time_steps.end(), wanted * (1 - 1e-9));
  if (at != time_steps.end() && wanted > 0.05) return *at;
  return wanted > 1 ? 86400 * readable(wanted / 86400) : readable(wanted);
}

// Returns powers of ten, or every second or third of them if they are many; between them, 2 and 5 if they are few.
std::vector<double> log_ticks(const Axis& axis, double most) {
  const double a = std::log10(std::min(axis.low, axis.high)), b = std::log10(std::max(axis.low, axis.high));
  const double every = std::max(1.0, std::ceil((b - a) / std::max(1.0, most)));
  std::vector<double> out;
  const bool few = b - a < 2.5 && every == 1;
  for (double e = std::ceil(a / every - 1e-9) * every - (few ? 1 : 0); e <= b + 1e-9 && out.size() < most_ticks;
       e += every)
    for (const double m : {1.0, 2.0, 5.0}) {
      if (m > 1 && !few) break;
      const double number = m * std::pow(10.0, e);
      if (axis.holds(number)) out.push_back(number);
    }
  return out;
}

}  // namespace

bool Axis::good() const {
  if (!std::isfinite(low) || !std::isfinite(high) || low == high) return false;
  if (scale == AxisScale::log) return low > 0 && high > 0;
  return std::abs(high - low) > 1e-12 * std::max(std::abs(low), std::abs(high));
}

double Axis::share(double number) const {
  if (scale != AxisScale::log) return (number - low) / (high - low);
  return number > 0 ? std::log(number / low) / std::log(high / low) : nowhere;
}

double Axis::number_at(double share) const {
  return scale == AxisScale::log ? low * std::pow(high / low, share) : low + share * (high - low);
}

bool Axis::holds(double number) const {
  const double s = share(number);
  return s > -1e-9 && s < 1 + 1e-9;
}

Vec3 AxesSpace::place(Vec3 n) const {
  switch (kind) {
    case Kind::number_line:
      return {(x.share(n.x) - 0.5) * size.x, n.y, n.z};
    case Kind::polar_axes: {
      const double r = x.share(n.x) * size.x / 2;
      return {r * std::cos(n.y), r * std::sin(n.y), n.z};
    }
    case Kind::plane_grid: {
      const double unit = size.x / (x.high - x.low);
      const Vec3 p = n.x * right + n.y * up;
      return {unit * p.x, unit * p.y, n.z};
    }
    default:
      return {(x.share(n.x) - 0.5) * size.x, (y.share(n.y) - 0.5) * size.y,
              size.z > 0 ? (z.share(n.z) - 0.5) * size.z : n.z};
  }
}

std::optional<Vec3> AxesSpace::numbers_at(Vec3 p) const {
  if (!x.good() || !(size.x > 0)) return std::nullopt;
  switch (kind) {
    case Kind::number_line:
      return Vec3{x.number_at(p.x / size.x + 0.5), p.y, p.z};
    case Kind::polar_axes:
      return Vec3{x.number_at(2 * std::hypot(p.x, p.y) / size.x), std::atan2(p.y, p.x), p.z};
    case Kind::plane_grid: {
      const double unit = size.x / (x.high - x.low), area = right.x * up.y - right.y * up.x;
      if (!(std::abs(area) > 1e-12)) return std::nullopt;
      const double px = p.x / unit, py = p.y / unit;
      return Vec3{(px * up.y - py * up.x) / area, (py * right.x - px * right.y) / area, p.z};
    }
    default:
      if (!y.good() || !(size.y > 0)) return std::nullopt;
      return Vec3{x.number_at(p.x / size.x + 0.5), y.number_at(p.y / size.y + 0.5),
                  size.z > 0 ? z.number_at(p.z / size.z + 0.5) : p.z};
  }
}

double tick_step(const Axis& axis, double length, double apart) {
  if (axis.step > 0) return axis.step;
  const double most = std::max(1.0, length / apart), wanted = std::abs(axis.high - axis.low) / most;
  return axis.scale == AxisScale::time ? step_of_time(wanted) : readable(wanted);
}

std::vector<double> ticks_of(const Axis& axis, double length, double apart) {
  if (!axis.good()) return {};
  if (axis.scale == AxisScale::log) return log_ticks(axis, length / apart);
  const double low = std::min(axis.low, axis.high), high = std::max(axis.low, axis.high);
  double step = tick_step(axis, length, apart);
  if (!((high - low) / step < most_ticks)) step = readable((high - low) / (most_ticks / 2.0));
  std::vector<double> out;
  // A given step counts from 0 if the axis has it, otherwise from the low end, as in (1 13 3).
  const bool counts = axis.step > 0 && (low > 0 || high < 0);
  const double phase = counts ? std::remainder(axis.low, step) : 0;
  const double from = std::abs(phase) < 1e-9 * step ? 0 : axis.low;
  for (auto k = static_cast<long long>(std::ceil((low - from) / step - 1e-9));; ++k) {
    const double number = from + static_cast<double>(k) * step;
    if (number > high + 1e-9 * step) break;
    out.push_back(std::abs(number) < 1e-9 * step ? 0 : number);
  }
  return out;
}

std::string tick_label(const Axis& axis, double number, double step) {
  if (!std::isfinite(number)) return "";
  if (axis.scale == AxisScale::time) return as_time(number, step);
  if (number == 0) return "0";
  if (std::abs(number) >= 1e6 || std::abs(number) < 1e-4 || (step > 0 && step < 1e-5)) return as_power(number);
  if (axis.scale == AxisScale::log) return with_minus(fmt::format("{:g}", number));
  // As many decimals as the number and the step need; three digits of a step that has no end, such as a quarter of pi.
  int decimals = 0;
  const auto is_whole = [](double v) { return std::abs(v - std::round(v)) <= 1e-6 * std::max(1.0, std::abs(v)); };
  for (double by = 1; decimals <= 4 && !(is_whole(step * by) && is_whole(number * by)); by *= 10) ++decimals;
  if (decimals > 4) decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(step))), 0, 6);
  return with_minus(grouped(fmt::format("{:.{}f}", number, decimals)));
}

}  // namespace betwixt
