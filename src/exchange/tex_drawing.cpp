// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the small part of SVG that dvisvgm writes without fonts: paths, uses of them, and rectangles.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "exchange/svg_path.h"
#include "exchange/tex.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr double em = 10 * 72 / 72.27;  // TeX's 10pt, in the drawing's 1/72 in
constexpr double square_side = 72;
constexpr std::size_t deepest = 64, most_points = 1'000'000;

Error unreadable(std::string_view what) {
  return fail(ErrorCode::machine, fmt::format("the output of dvisvgm cannot be read: {}", what));
}

std::optional<double> number_in(std::string_view text) {
  PathNumbers n(text);
  const auto v = n.number();
  return v && n.done() ? v : std::nullopt;
}

// <name a='…' b="…">, </name>, <name/>
struct Tag {
  std::string_view name;
  std::map<std::string_view, std::string_view> attributes;
  bool opens = true, closes = false;

  std::string_view get(std::string_view a) const {
    const auto found = attributes.find(a);
    return found == attributes.end() ? std::string_view() : found->second;
  }
  // Returns 0 for a missing attribute.
  std::optional<double> number(std::string_view a) const { return attributes.contains(a) ? number_in(get(a)) : 0; }
};

bool skip(std::string_view& rest, std::string_view begin, std::string_view end) {
  if (!rest.starts_with(begin)) return false;
  const auto at = rest.find(end, begin.size());
  rest.remove_prefix(at == std::string_view::npos ? rest.size() : at + end.size());
  return true;
}

// Takes the next tag. Returns nullopt at the end, and false for an invalid tag.
std::optional<bool> next_tag(std::string_view& rest, Tag& tag) {
  constexpr std::string_view blanks = " \t\r\n";
  for (;;) {
    rest.remove_prefix(std::min(rest.find('<'), rest.size()));
    if (rest.empty()) return std::nullopt;
    if (!skip(rest, "<!--", "-->") && !skip(rest, "<![CDATA[", "]]>") && !skip(rest, "<!", ">") &&
        !skip(rest, "<?", "?>"))
      break;
  }
  tag = {};
  rest.remove_prefix(1);
  if (rest.starts_with("/")) tag.opens = false, tag.closes = true, rest.remove_prefix(1);
  const auto word = [&rest](std::string_view ends) {
    const std::string_view w = rest.substr(0, rest.find_first_of(ends));
    rest.remove_prefix(w.size());
    return w;
  };
  tag.name = word(" \t\r\n/>");
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    if (rest.starts_with(">")) return rest.remove_prefix(1), !tag.name.empty();
    if (rest.starts_with("/>")) return tag.closes = true, rest.remove_prefix(2), !tag.name.empty();
    const std::string_view name = word(" \t\r\n=/<>");
    if (name.empty() || rest.size() < 2 || rest[0] != '=' || (rest[1] != '"' && rest[1] != '\'')) return false;
    const auto end = rest.find(rest[1], 2);
    if (end == std::string_view::npos) return false;
    tag.attributes[name] = rest.substr(2, end - 2);
    rest.remove_prefix(end + 1);
  }
}

class DrawingReader {
 public:
  Result<Outline> read(std::string_view svg) {
    Tag tag;
    for (;;) {
      const auto more = next_tag(svg, tag);
      if (!more) break;
      if (!*more) return unreadable("broken SVG");
      if (Status s = tag.opens ? open(tag) : Status(Nothing{}); !s) return s.error();
      if (!tag.closes) continue;
      if (open_.empty() || open_.back().name != tag.name) return unreadable("broken SVG");
      open_.pop_back();
    }
    if (!open_.empty()) return unreadable("incomplete SVG");
    if (!baseline_) return unreadable("nothing");
    finish();
    return std::move(out_);
  }

 private:
  struct Open {
    std::string_view name;
    Affine to;
  };

  Status open(const Tag& tag) {
    const auto own = transform_in(tag.get("transform"));
    if (!own) return unreadable("a transformation that is not valid");
    const Affine to = (open_.empty() ? Affine{} : open_.back().to) * *own;
    if (!to.sane()) return unreadable("a number that is too large");
    if (open_.size() >= deepest) return unreadable("groups that are nested too deep");
    const bool defines = std::any_of(open_.begin(), open_.end(), [](const Open& o) { return o.name == "defs"; });
    open_.push_back({tag.name, to});
    if (tag.name == "path" && defines) return glyphs_[tag.get("id")] = tag.get("d"), Nothing{};
    if (tag.name == "path") return path(tag.get("d"), to);
    if (tag.name == "use" && !defines) return use(tag, to);
    if (tag.name == "rect" && !defines) return bar(tag, to);
    constexpr std::array<std::string_view, 7> others{"svg", "g", "defs", "style", "title", "desc", "metadata"};
    if (std::find(others.begin(), others.end(), tag.name) != others.end()) return Nothing{};
    return unreadable(fmt::format("<{}>", tag.name.substr(0, 20)));
  }

  Status path(std::string_view d, const Affine& to) {
    if (!baseline_) return unreadable("no baseline");
    Flattener lines(fineness * em);
    if (!PathReader(to, lines).read(d)) return unreadable("a path that is not valid");
    return add(lines, fmt::format("{:x}", std::hash<std::string_view>{}(d)));
  }

  Status use(const Tag& tag, const Affine& to) {
    const std::string_view id = tag.attributes.contains("xlink:href") ? tag.get("xlink:href") : tag.get("href");
    const auto glyph = id.starts_with("#") ? glyphs_.find(id.substr(1)) : glyphs_.end();
    const auto x = tag.number("x"), y = tag.number("y");
    if (glyph == glyphs_.end() || !x || !y) return unreadable("a glyph that is not valid");
    return path(glyph->second, to * Affine{1, 0, 0, 1, *x, *y});
  }

  Status bar(const Tag& tag, const Affine& to) {
    const auto x = tag.number("x"), y = tag.number("y"), w = tag.number("width"), h = tag.number("height");
    if (!x || !y || !w || !h || *w < 0 || *h < 0) return unreadable("a bar that is not valid");
    const auto is_side = [](double side) { return std::abs(side - square_side) < 0.01; };
    if (!baseline_ && is_side(*w) && is_side(*h)) {
      baseline_ = to({*x + *w, *y + *h, 0});
      return Nothing{};
    }
    if (!baseline_) return unreadable("no baseline");
    Flattener lines(fineness * em);
    lines.move(to({*x, *y, 0}));
    for (const Vec3 p : {Vec3{*x + *w, *y, 0}, Vec3{*x + *w, *y + *h, 0}, Vec3{*x, *y + *h, 0}}) lines.line(to(p));
    return add(lines, "bar");
  }

  Status add(Flattener& lines, std::string name) {
    std::vector<Contour> contours = lines.take();
    if (contours.empty()) return Nothing{};
    out_.letters.push_back({out_.contours.size(), std::move(name)});
    for (Contour& c : contours) {
      for (const Vec3 p : c)
        if (!(std::max(std::abs(p.x), std::abs(p.y)) <= farthest_in_svg))
          return unreadable("a point that is too far away");
      points_ += c.size();
      out_.contours.push_back(std::move(c));
    }
    if (points_ > most_points || out_.letters.size() > most_letters)
      return fail(ErrorCode::range, "the formula is too large: too many letters and points");
    return Nothing{};
  }

  // Converts 1/72 in downwards to em upwards; the outer contours of each letter become counter-clockwise.
  void finish() {
    for (Contour& contour : out_.contours)
      for (Vec3& p : contour) p = {(p.x - baseline_->x) / em, (baseline_->y - p.y) / em, 0};
    for (std::size_t i = 0; i < out_.letters.size(); ++i) {
      const std::size_t first = out_.letters[i].first;
      const std::size_t end = i + 1 < out_.letters.size() ? out_.letters[i + 1].first : out_.contours.size();
      double area = 0;
      for (std::size_t k = first; k < end; ++k)
        for (std::size_t j = 0, n = out_.contours[k].size(); j < n; ++j)
          area += cross(out_.contours[k][j] - out_.contours[first][0],
                        out_.contours[k][(j + 1) % n] - out_.contours[first][0])
                      .z;
      for (std::size_t k = first; area < 0 && k < end; ++k)
        std::reverse(out_.contours[k].begin(), out_.contours[k].end());
    }
  }

  std::vector<Open> open_;
  std::map<std::string_view, std::string_view> glyphs_;  // paths by name
  std::optional<Vec3> baseline_;                         // its start on the baseline
  Outline out_;
  std::size_t points_ = 0;
};

}  // namespace

Result<Outline> read_tex_drawing(std::string_view svg) { return DrawingReader().read(svg); }

}  // namespace betwixt
