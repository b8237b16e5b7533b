// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/svg_path.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace betwixt {

// ---- Numbers

bool PathNumbers::done() {
  const auto next = rest_.find_first_not_of(" ,\t\r\n");
  rest_.remove_prefix(std::min(next, rest_.size()));
  return rest_.empty();
}
bool PathNumbers::letter() { return !done() && std::isalpha(static_cast<unsigned char>(rest_[0])); }
char PathNumbers::take() {
  const char c = rest_[0];
  rest_.remove_prefix(1);
  return c;
}
std::optional<double> PathNumbers::number() {
  if (done()) return std::nullopt;
  if (rest_[0] == '+') take();
  double v = 0;
  const auto read = std::from_chars(rest_.data(), rest_.data() + rest_.size(), v);
  if (read.ec != std::errc() || !(std::abs(v) <= farthest_in_svg)) return std::nullopt;
  rest_.remove_prefix(static_cast<std::size_t>(read.ptr - rest_.data()));
  return v;
}
std::optional<double> PathNumbers::flag() {
  if (done() || (rest_[0] != '0' && rest_[0] != '1')) return std::nullopt;
  return take() - '0';
}

// ---- Transforms

bool Affine::sane() const {
  const auto small = [](double v) { return std::abs(v) <= farthest_in_svg; };
  return small(a) && small(b) && small(c) && small(d) && small(e) && small(f);
}

namespace {

// Returns one function of a list, with `count` numbers.
std::optional<Affine> transform_of(std::string_view name, std::size_t count, const std::array<double, 6>& v) {
  constexpr double degree = pi / 180;
  if (name == "matrix" && count == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (count == 1 || count == 2)) return Affine{1, 0, 0, 1, v[0], v[1]};
  if (name == "scale" && (count == 1 || count == 2)) return Affine{v[0], 0, 0, count == 2 ? v[1] : v[0], 0, 0};
  if (name == "skewX" && count == 1) return Affine{1, 0, std::tan(v[0] * degree), 1, 0, 0};
  if (name == "skewY" && count == 1) return Affine{1, std::tan(v[0] * degree), 0, 1, 0, 0};
  if (name == "rotate" && (count == 1 || count == 3)) {
    const double c = std::cos(v[0] * degree), s = std::sin(v[0] * degree);
    return Affine{1, 0, 0, 1, v[1], v[2]} * Affine{c, s, -s, c, 0, 0} * Affine{1, 0, 0, 1, -v[1], -v[2]};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Affine> transform_in(std::string_view text) {
  constexpr std::string_view between = " ,\t\r\n";
  Affine all;
  for (std::size_t open; (open = text.find('(')) != std::string_view::npos;) {
    const auto close = text.find(')', open);
    if (close == std::string_view::npos) return std::nullopt;
    std::string_view name = text.substr(0, open);
    name.remove_prefix(std::min(name.find_first_not_of(between), name.size()));
    name = name.substr(0, name.find_last_not_of(between) + 1);
    PathNumbers n(text.substr(open + 1, close - open - 1));
    std::array<double, 6> v{};
    std::size_t count = 0;
    for (; count < v.size() && !n.done(); ++count) {
      const auto one = n.number();
      if (!one) return std::nullopt;
      v[count] = *one;
    }
    const auto step = n.done() ? transform_of(name, count, v) : std::nullopt;
    if (!step) return std::nullopt;
    all = all * *step;
    text.remove_prefix(close + 1);
  }
  return text.find_first_not_of(between) == std::string_view::npos ? std::optional(all) : std::nullopt;
}

// ---- Paths

namespace {
constexpr std::string_view path_commands = "MLHVCSQTZA";
constexpr std::array<std::size_t, 10> path_counts{2, 2, 1, 1, 6, 4, 4, 2, 0, 7};
}  // namespace

bool PathReader::numbers(PathNumbers& n, char command) {
  const std::size_t count = path_counts[path_commands.find(command)];
  for (std::size_t i = 0; i < count; ++i) {
    const auto v = command == 'A' && (i == 3 || i == 4) ? n.flag() : n.number();
    if (!v) return false;
    v_[i] = *v;
  }
  return true;
}

bool PathReader::read(std::string_view d) {
  PathNumbers n(d);
  char command = 0;
  while (!n.done()) {
    if (n.letter())
      command = n.take();
    else if (command == 0 || command == 'Z' || command == 'z')
      return false;
    const bool relative = command >= 'a';
    const char upper = relative ? static_cast<char>(command - 'a' + 'A') : command;
    if (path_commands.find(upper) == std::string_view::npos || !numbers(n, upper)) return false;
    if (upper != 'M' && !into_.begun()) return false;
    from_ = relative ? at_ : Vec3{};
    draw(upper);
    before_ = upper;
    if (upper == 'M') command = relative ? 'l' : 'L';  // numbers without a letter continue as lines
  }
  return true;
}

// Returns the last control point, mirrored, if the last command was one of these two.
Vec3 PathReader::smooth(char one, char other) const {
  return before_ == one || before_ == other ? 2 * at_ - control_ : at_;
}

void PathReader::draw(char command) {
  if (command == 'M') return begin(point(0));
  if (command == 'Z') return close();
  if (before_ == 'Z') begin(start_);
  if (command == 'L') return line(point(0));
  if (command == 'H') return line({from_.x + v_[0], at_.y, 0});
  if (command == 'V') return line({at_.x, from_.y + v_[0], 0});
  if (command == 'C') return cubic(point(0), point(2), point(4));
  if (command == 'S') return cubic(smooth('C', 'S'), point(0), point(2));
  if (command == 'Q') return conic(point(0), point(2));
  if (command == 'T') return conic(smooth('Q', 'T'), point(0));
  arc(std::abs(v_[0]), std::abs(v_[1]), v_[2] * pi / 180, v_[3] != 0, v_[4] != 0, point(5));
}

void PathReader::close() {
  into_.close();
  at_ = start_;
}
void PathReader::cubic(Vec3 b, Vec3 c, Vec3 d) {
  into_.cubic(to_(b), to_(c), to_(d));
  control_ = c, at_ = d;
}
void PathReader::conic(Vec3 b, Vec3 c) {
  into_.conic(to_(b), to_(c));
  control_ = b, at_ = c;
}

// Converts the end points of an arc to its centre, as in the appendix on arcs of SVG's specification, then draws cubics
// of an eighth of a turn, which are within 5e-6 of the radius.
void PathReader::arc(double rx, double ry, double turn, bool large, bool forward, Vec3 end) {
  const Vec3 begin = at_;
  if (begin == end) return;
  if (!(rx > 0) || !(ry > 0)) return line(end);
  const double cosine = std::cos(turn), sine = std::sin(turn);
  const Vec3 half = 0.5 * (begin - end), middle = 0.5 * (begin + end);
  // In the space where the ellipse is a circle of radius 1.
  Vec3 p{(cosine * half.x + sine * half.y) / rx, (cosine * half.y - sine * half.x) / ry, 0};
  const double too_far = length(p);
  if (too_far > 1) rx *= too_far, ry *= too_far, p = (1 / too_far) * p;
  const double reach = dot(p, p), away = std::sqrt(std::max(0.0, 1 - reach) / reach) * (large == forward ? -1 : 1);
  const Vec3 centre{away * p.y, -away * p.x, 0};
  const Vec3 first = p - centre, last = -p - centre;
  double from = std::atan2(first.y, first.x), sweep = std::atan2(last.y, last.x) - from;
  if (forward && sweep < 0) sweep += 2 * pi;
  if (!forward && sweep > 0) sweep -= 2 * pi;
  const auto at = [&](Vec3 u) {
    const double x = rx * (u.x + centre.x), y = ry * (u.y + centre.y);
    return Vec3{middle.x + cosine * x - sine * y, middle.y + sine * x + cosine * y, 0};
  };
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (pi / 4) - 1e-9)));
  const double step = sweep / pieces, handle = 4.0 / 3 * std::tan(step / 4);
  for (int i = 0; i < pieces; ++i, from += step) {
    const Vec3 a{std::cos(from), std::sin(from), 0}, d{std::cos(from + step), std::sin(from + step), 0};
    const Vec3 b = a + handle * Vec3{-a.y, a.x, 0}, c = d - handle * Vec3{-d.y, d.x, 0};
    cubic(at(b), at(c), i + 1 == pieces ? end : at(d));
  }
}

}  // namespace betwixt
