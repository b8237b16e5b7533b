// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/plot_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/markup.h"

namespace betwixt {
namespace {

constexpr double left = 76, right = 28, top = 56, below = 66, width = 960, height = 540, legend_row = 22;
constexpr std::array<const char*, 10> colors{"#2f6fb3", "#d9822b", "#3f9b5f", "#c23b4b", "#7c5bb0",
                                             "#8a6248", "#c5629f", "#5d6670", "#a0a12f", "#2aa3b5"};

std::string label(double v) { return fmt::format("{:.10g}", std::abs(v) < 1e-12 ? 0 : v); }

// Maps values to the paper.
struct Paper {
  double x0, x1, y0, y1, bottom;
  double x(double frame) const { return left + (frame - x0) / (x1 - x0) * (width - left - right); }
  double y(double value) const { return bottom - (value - y0) / (y1 - y0) * (bottom - top); }
};

// Returns the smallest step of 1, 2 or 5 times a power of ten that is at least `least`.
double round_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double s : {1.0, 2.0, 5.0})
    if (s * power >= least * (1 - 1e-9)) return s * power;
  return 10 * power;
}

std::pair<double, double> extent(const Plot& plot) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const DrawnCurve& c : plot.curves)
    for (const Stroke& s : c.strokes)
      for (const auto& [frame, v] : s) low = std::min(low, v), high = std::max(high, v);
  if (!(low <= high)) return {0, 1};
  if (high - low < 1e-9 * std::max(1.0, std::abs(high))) return {low - 1, high + 1};
  const double air = 0.06 * (high - low);
  return {low - air, high + air};
}

// Returns the path of a stroke, without points that are within a twentieth of a pixel of the line between others.
std::string path(const Stroke& stroke, const Paper& paper) {
  std::vector<std::pair<double, double>> at;
  for (const auto& [frame, v] : stroke) at.emplace_back(paper.x(frame), paper.y(v));
  std::string out;
  std::size_t kept = 0;
  const auto put = [&](std::size_t i) {
    out += fmt::format("{}{:.2f} {:.2f}", i == 0 ? "M" : "L", at[i].first, at[i].second);
  };
  const auto straight = [&](std::size_t to) {
    const auto [ax, ay] = at[kept];
    const auto [bx, by] = at[to];
    for (std::size_t i = kept + 1; i < to; ++i)
      if (std::abs(ay + (by - ay) * (bx > ax ? (at[i].first - ax) / (bx - ax) : 0) - at[i].second) > 0.05) return false;
    return true;
  };
  constexpr std::size_t longest = 64;  // limits the search
  put(0);
  for (std::size_t i = 1; i < at.size(); ++i)
    if (i + 1 == at.size() || i - kept >= longest || !straight(i + 1)) put(i), kept = i;
  return out;
}

std::string axes(const Plot& plot, const Paper& paper) {
  std::string s = "<g stroke=\"#e4e6ea\" stroke-width=\"1\">\n";
  const auto xs = ticks(paper.x0, paper.x1, 12), ys = ticks(paper.y0, paper.y1, 8);
  for (const double y : ys) s += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", left, paper.y(y), width - right);
  for (const double x : xs) s += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", paper.x(x), top, paper.bottom);
  s += "</g>\n<g stroke=\"#8b929c\" stroke-width=\"1.2\" fill=\"none\">\n";
  s += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\"/>\n", left, top, paper.bottom, width - right);
  if (paper.y0 < 0 && paper.y1 > 0)
    s += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", left, paper.y(0), width - right);
  s += "</g>\n<g font-size=\"13\" fill=\"#3b4048\">\n";
  for (const double y : ys)
    s += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", left - 10, paper.y(y) + 4.5,
                     label(y));
  for (const double x : xs)
    s += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}f</text>\n", paper.x(x),
                     paper.bottom + 18, label(x));
  s += "</g>\n<g font-size=\"11\" fill=\"#848b95\" stroke=\"none\">\n";
  // Seconds have ticks of their own, at round numbers.
  const double rate = plot.rate.per_second();
  for (const double t : ticks((paper.x0 - 1) / rate, (paper.x1 - 1) / rate, 8)) {
    const double x = paper.x(1 + t * rate);
    s += fmt::format(
        "<path d=\"M{0:.1f} {1:.1f}v4\" stroke=\"#848b95\"/>\n"
        "<text x=\"{0:.1f}\" y=\"{2:.1f}\" text-anchor=\"middle\">{3} s</text>\n",
        x, paper.bottom + 24, paper.bottom + 39, label(t));
  }
  return s + "</g>\n";
}

std::string drawn(const DrawnCurve& c, const char* color, const Paper& paper) {
  std::string s = fmt::format(
      "<g stroke=\"{}\" fill=\"none\" stroke-width=\"2.2\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n",
      color);
  for (std::size_t i = 0; i < c.strokes.size(); ++i) {
    if (c.strokes[i].empty()) continue;
    s += "<path d=\"" + path(c.strokes[i], paper) + "\"/>\n";
    if (i == 0 || c.strokes[i - 1].empty()) continue;
    const auto& [x, from] = c.strokes[i - 1].back();
    s += fmt::format("<path d=\"M{0:.2f} {1:.2f}V{2:.2f}\" stroke-width=\"1\" stroke-dasharray=\"1 4\"/>\n", paper.x(x),
                     paper.y(from), paper.y(c.strokes[i].front().second));
  }
  s += fmt::format("</g>\n<g fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"1.4\">\n", color);
  for (const auto& [frame, v] : c.events)
    s += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\"/>\n", paper.x(frame), paper.y(v));
  return s + "</g>\n";
}

// Draws the names with their colours, in rows below the axis.
std::string legend(const Plot& plot, double bottom, std::size_t columns) {
  std::string s = "<g font-size=\"13\" fill=\"#3b4048\">\n";
  const double column = (width - left - right) / static_cast<double>(columns);
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const double x = left + column * static_cast<double>(i % columns);
    const double y = bottom + below + legend_row * static_cast<double>(i / columns);
    s += fmt::format(
        "<path d=\"M{:.1f} {:.1f}h20\" stroke=\"{}\" stroke-width=\"3\" stroke-linecap=\"round\"/>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
        x, y - 4.5, colors[i % colors.size()], x + 28, y, escaped(plot.curves[i].name));
  }
  return s + "</g>\n";
}

std::size_t legend_columns(const Plot& plot) {
  std::size_t longest = 1;
  for (const DrawnCurve& c : plot.curves) longest = std::max(longest, c.name.size());
  return std::clamp<std::size_t>(
      static_cast<std::size_t>((width - left - right) / (44 + 7.4 * static_cast<double>(longest))), 1, 4);
}

}  // namespace

std::vector<double> ticks(double low, double high, int most) {
  const double step = round_step((high - low) / most);
  std::vector<double> all;
  for (double k = std::ceil(low / step - 1e-9); k <= high / step + 1e-9 && all.size() < 100; ++k)
    all.push_back(k * step);
  return all;
}

std::string to_svg(const Plot& plot) {
  const auto [low, high] = extent(plot);
  const Paper paper{plot.first, std::max(plot.last, plot.first + 1e-3), low, high, height - below};
  const std::size_t columns = legend_columns(plot), rows = (plot.curves.size() + columns - 1) / columns;
  const double tall = height + legend_row * static_cast<double>(rows) + 6;
  std::string s = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"#fdfdfc\"/>\n"
      "<text x=\"{2:.0f}\" y=\"34\" font-size=\"17\" font-weight=\"bold\" fill=\"#23272d\">{3}</text>\n",
      width, tall, left, escaped(plot.title));
  s += axes(plot, paper);
  for (std::size_t i = 0; i < plot.curves.size(); ++i) s += drawn(plot.curves[i], colors[i % colors.size()], paper);
  return s + legend(plot, paper.bottom, columns) + "</svg>\n";
}

}  // namespace betwixt
