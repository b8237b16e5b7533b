// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the shapes of an SVG as flat outlines, from back to front.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <unordered_map>

#include "base/names.h"
#include "exchange/drawing.h"
#include "exchange/outlines.h"
#include "exchange/scene_names.h"
#include "exchange/svg_path.h"
#include "exchange/svg_style.h"

namespace betwixt {
namespace {

using pugi::xml_node;

constexpr double svg_stray = 1e-4;           // the largest error of a flattened curve, relative to the drawing's height
constexpr std::size_t deepest_in_svg = 128;  // nested elements, including `use`
constexpr std::size_t most_elements = 500'000, most_named = 5;
constexpr double farthest_drawn = 1e6;  // in heights of the drawing

std::string_view local_name(xml_node node) {
  const std::string_view name = node.name();
  return name.starts_with("svg:") ? name.substr(4) : name;
}
std::string_view said_in(xml_node node, const char* name) { return node.attribute(name).value(); }
std::string_view reference_of(xml_node node) {
  const std::string_view plain = said_in(node, "href"), of = plain.empty() ? said_in(node, "xlink:href") : plain;
  return of.starts_with("#") ? of.substr(1) : std::string_view();
}
bool any_of_these(std::string_view word, std::initializer_list<std::string_view> all) {
  return std::find(all.begin(), all.end(), word) != all.end();
}

// The reference sizes of percentages, in user units.
struct Viewport {
  double width = 300, height = 150;
  double diagonal() const { return std::sqrt((width * width + height * height) / 2); }
};

// The state that an element inherits.
struct Around {
  Affine to;
  SvgStyle style;
  double opacity = 1;
  std::uint32_t group = DrawnThing::nothing;
  Viewport viewport;
  std::size_t depth = 0;
};

struct Paint {
  bool there = false;
  Color color;
  double opacity = 1;
};

void append_ring(std::vector<Vec3>& rings, const Contour& ring) {
  rings.insert(rings.end(), ring.begin(), ring.end());
  rings.push_back(ring[0]);
}

class SvgReader {
 public:
  explicit SvgReader(const std::string& path) : path_(path) {}

  Result<std::shared_ptr<const DrawingFile>> read(const std::string& text) {
    const auto parsed = document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_auto);
    if (text.starts_with("\x1f\x8b")) return broken("it is compressed", "unpack it with gunzip first");
    if (!parsed) {
      const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, parsed.offset));
      const auto line =
          1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size())), '\n');
      return broken(fmt::format("line {} is no XML", line));
    }
    const xml_node root = document_.document_element();
    if (local_name(root) != "svg")
      return broken(
          fmt::format("it begins with <{}>, and not with <svg>", std::string_view(root.name()).substr(0, 40)));
    if (!prepare(root)) return *error_;
    if (!walk_root(root)) return *error_;
    if (out_.things.empty()) return broken("it draws nothing");
    place_all();
    say_all();
    return std::make_shared<const DrawingFile>(std::move(out_));
  }

 private:
  Error broken(const std::string& what, std::string hint = {}) const {
    return fail(ErrorCode::file, fmt::format("{} cannot be taken: {}", path_, what), std::move(hint));
  }
  bool refuse(Error e) {
    if (!error_) error_ = std::move(e);
    return false;
  }

  // ---- Collects ids and styles before anything is drawn

  bool prepare(xml_node root) {
    // Not recursive, because an attacker may nest a file as deep as he likes.
    for (xml_node n = root; n;) {
      if (const std::string_view id = said_in(n, "id"); !id.empty()) ids_.try_emplace(id, n);
      if (local_name(n) == "style")
        for (const xml_node text : n.children()) rules_.read(text.value());
      if (n.first_child()) {
        n = n.first_child();
        continue;
      }
      while (n != root && !n.next_sibling()) n = n.parent();
      n = n == root ? xml_node() : n.next_sibling();
    }
    if (rules_.passed_over()) left_out("a rule of <style> that asks for more than a tag, classes and an id", {});
    return true;
  }

  void left_out(const std::string& what, std::string_view of) {
    auto& [count, names] = left_out_[what];
    if (++count <= most_named && !of.empty()) names.emplace_back(of.substr(0, 60));
  }
  void say_all() {
    for (const auto& [what, of] : left_out_) {
      const auto& [count, names] = of;
      std::string all;
      for (const std::string& name : names) all += fmt::format("{}'{}'", all.empty() ? "" : ", ", name);
      if (count > names.size() && !names.empty()) all += fmt::format(" and {} more", count - names.size());
      out_.left_out.push_back(what + (all.empty() ? "" : fmt::format(" (of {})", all)));
    }
  }

  // ---- From element to element

  // Returns the transform from the space of an element's viewBox to its viewport.
  static Affine fitted(xml_node node, Viewport& inner, double width, double height) {
    PathNumbers n(said_in(node, "viewBox"));
    std::array<double, 4> box{};
    inner = {width, height};
    for (double& v : box) {
      const auto one = n.number();
      if (!one) return {};
      v = *one;
    }
    if (!(box[2] > 0) || !(box[3] > 0)) return {};
    inner = {box[2], box[3]};
    double sx = width / box[2], sy = height / box[3];
    const std::string_view how = said_in(node, "preserveAspectRatio");
    if (how.find("none") == std::string_view::npos)
      sx = sy = how.find("slice") != std::string_view::npos ? std::max(sx, sy) : std::min(sx, sy);
    const auto share = [&](const char* first, const char* last) {
      return how.find(first) != std::string_view::npos ? 0.0 : how.find(last) != std::string_view::npos ? 1.0 : 0.5;
    };
    const double x = share("xMin", "xMax") * (width - box[2] * sx), y = share("YMin", "YMax") * (height - box[3] * sy);
    return {sx, 0, 0, sy, x - box[0] * sx, y - box[1] * sy};
  }

  bool walk_root(xml_node root) {
    Viewport whole;
    fitted(root, whole, whole.width, whole.height);  // without a size of its own, its viewBox is its size
    const double width = svg_length(said_in(root, "width"), whole.width).value_or(whole.width);
    const double height = svg_length(said_in(root, "height"), whole.height).value_or(whole.height);
    if (!(width > 0) || !(height > 0)) return refuse(broken("its size is nothing"));
    if (!(width / height <= farthest_drawn)) return refuse(broken("its size is no size"));
    out_.width = width / height;
    Around around;
    around.to =
        Affine{1 / height, 0, 0, -1 / height, -width / height / 2, 0.5} * fitted(root, around.viewport, width, height);
    return style_of(root, around) && walk_inside(root, around);
  }

  bool walk_inside(xml_node node, const Around& around) {
    const bool first_only = local_name(node) == "switch";
    for (const xml_node child : node.children()) {
      if (child.type() != pugi::node_element) continue;
      if (!walk(child, around)) return false;
      if (first_only) break;
    }
    return true;
  }

  // Applies the element's own style. Sets `shown` to false if nothing of it is drawn.
  bool style_of(xml_node node, Around& around, bool* shown = nullptr) {
    SvgStyle style = around.style.inherited();
    for (const pugi::xml_attribute a : node.attributes()) style.set(a.name(), a.value());
    rules_.apply({local_name(node), said_in(node, "id"), said_in(node, "class")}, style);
    style.read(said_in(node, "style"));
    around.style = style;
    around.opacity *= svg_opacity(style[Property::opacity]);
    if (shown) *shown = style[Property::display] != "none";
    const auto own = transform_in(said_in(node, "transform"));
    if (!own) left_out("a transform that is none", name_in_file(node));
    around.to = around.to * own.value_or(Affine{});
    const std::string_view name = name_in_file(node);
    for (const Property p : {Property::clip_path, Property::mask, Property::filter})
      if (!style[p].empty() && style[p] != "none") left_out(fmt::format("{} is left out", name_of(p)), name);
    if (!style[Property::blend].empty() && style[Property::blend] != "normal")
      left_out("mix-blend-mode is left out", name);
    return around.to.sane() || refuse(broken("something in it is too large"));
  }

  static std::string_view name_in_file(xml_node node) {
    const std::string_view id = said_in(node, "id");
    return id.empty() ? local_name(node) : id;
  }

  bool walk(xml_node node, Around around) {
    const std::string_view tag = local_name(node);
    if (tag.find(':') != std::string_view::npos) return true;  // an element of another program
    if (any_of_these(tag, {"defs", "symbol", "style", "title", "desc", "metadata", "linearGradient", "radialGradient",
                           "clipPath", "mask", "filter", "pattern", "marker", "view"}))
      return true;
    if (++elements_ > most_elements)
      return refuse(fail(ErrorCode::range, fmt::format("{} draws more than {} things", path_, most_elements)));
    if (++around.depth > deepest_in_svg)
      return refuse(broken(fmt::format("things lie in each other more than {} deep", deepest_in_svg)));
    bool shown = true;
    if (!style_of(node, around, &shown)) return false;
    if (!shown) return true;
    if (any_of_these(tag, {"g", "a", "switch"})) return group(node, around);
    if (tag == "svg") return nested(node, around, {});
    if (tag == "use") return use(node, around);
    if (tag == "text")
      return refuse(
          broken(fmt::format("'{}' is a text, and its font may be another one here", name_in_file(node)),
                 "turn texts into paths (in Inkscape: Path > Object to Path), or write them as create title text …"));
    if (const auto d = path_of(node, tag, around.viewport)) return path(node, *d, around);
    if (any_of_these(tag, {"animate", "animateTransform", "animateMotion", "set"}))
      left_out("its own animation is left out", name_in_file(node.parent()));
    else
      left_out(fmt::format("<{}> is left out", tag.substr(0, 40)), said_in(node, "id"));
    return true;
  }

  bool group(xml_node node, Around& around) {
    // A group without a name is not kept: its contents belong to the group around it.
    const bool named = !said_in(node, "id").empty();
    const auto own = static_cast<std::uint32_t>(out_.things.size());
    if (named) add_group(node, around);
    const std::size_t before = drawn_;
    if (!walk_inside(node, around)) return false;
    if (named && out_.things.size() == own + 1) out_.things.pop_back();  // the group is empty
    if (around.style[Property::opacity].empty() || drawn_ < before + 2) return true;
    if (svg_opacity(around.style[Property::opacity]) < 1)
      left_out("what lies behind each other in a transparent group is seen through it", name_in_file(node));
    return true;
  }

  void add_group(xml_node node, Around& around) {
    DrawnThing thing;
    thing.name = names_.give(said_in(node, "id").substr(0, 100), local_name(node));
    thing.above = around.group;
    thing.group = true;
    around.group = static_cast<std::uint32_t>(out_.things.size());
    out_.things.push_back(std::move(thing));
  }

  // Draws an inner svg or a symbol. `wanted`: the size from `use`.
  bool nested(xml_node node, Around& around, std::array<std::string_view, 2> wanted) {
    const auto side = [&](std::string_view said, const char* own, double whole) {
      const auto size = svg_length(said.empty() ? said_in(node, own) : said, whole);
      return std::max(0.0, size.value_or(whole));
    };
    const double width = side(wanted[0], "width", around.viewport.width);
    const double height = side(wanted[1], "height", around.viewport.height);
    const double x = svg_length(said_in(node, "x"), around.viewport.width).value_or(0);
    const double y = svg_length(said_in(node, "y"), around.viewport.height).value_or(0);
    Viewport inner;
    around.to = around.to * Affine{1, 0, 0, 1, x, y} * fitted(node, inner, width, height);
    around.viewport = inner;
    return around.to.sane() ? group(node, around) : refuse(broken("something in it is too large"));
  }

  bool use(xml_node node, Around& around) {
    const std::string_view of = reference_of(node);
    const auto found = ids_.find(of);
    if (found == ids_.end()) {
      left_out(fmt::format("a use of '{}', which is not there, is left out", of.substr(0, 60)), {});
      return true;
    }
    const xml_node meant = found->second;
    if (std::find(used_.begin(), used_.end(), meant) != used_.end())
      return refuse(broken(fmt::format("'{}' uses itself", of.substr(0, 60))));
    used_.push_back(meant);
    const double x = svg_length(said_in(node, "x"), around.viewport.width).value_or(0);
    const double y = svg_length(said_in(node, "y"), around.viewport.height).value_or(0);
    around.to = around.to * Affine{1, 0, 0, 1, x, y};
    if (!said_in(node, "id").empty()) add_group(node, around);
    const auto own = out_.things.size();
    const std::string_view tag = local_name(meant);
    bool fine = true, shown = true;
    if (tag == "symbol" || tag == "svg") {
      Around inside = around;
      fine = style_of(meant, inside, &shown) &&
             (!shown || nested(meant, inside, {said_in(node, "width"), said_in(node, "height")}));
    } else {
      fine = walk(meant, around);
    }
    if (!said_in(node, "id").empty() && out_.things.size() == own) out_.things.pop_back();
    used_.pop_back();
    return fine;
  }

  // ---- Shapes

  // Returns the equivalent path, or nullopt if the element is no shape.
  std::optional<std::string> path_of(xml_node node, std::string_view tag, const Viewport& v) const {
    const auto length = [&](const char* name, double whole) { return svg_length(said_in(node, name), whole); };
    const auto x = [&](const char* name) { return length(name, v.width).value_or(0); };
    const auto y = [&](const char* name) { return length(name, v.height).value_or(0); };
    if (tag == "path") return std::string(said_in(node, "d"));
    if (tag == "line") return fmt::format("M{} {}L{} {}", x("x1"), y("y1"), x("x2"), y("y2"));
    if (tag == "polyline") return fmt::format("M{}", said_in(node, "points"));
    if (tag == "polygon") return fmt::format("M{}Z", said_in(node, "points"));
    if (tag == "circle" || tag == "ellipse") {
      const double r = length("r", v.diagonal()).value_or(0);
      const auto rx = tag == "circle" ? r : length("rx", v.width), ry = tag == "circle" ? r : length("ry", v.height);
      const double a = rx.value_or(ry.value_or(0)), b = ry.value_or(rx.value_or(0)), cx = x("cx"), cy = y("cy");
      if (!(a > 0) || !(b > 0)) return "";
      return fmt::format("M{} {}A{} {} 0 0 1 {} {}A{} {} 0 0 1 {} {}Z", cx + a, cy, a, b, cx - a, cy, a, b, cx + a, cy);
    }
    if (tag == "rect") {
      const double w = x("width"), h = y("height"), left = x("x"), top = y("y");
      if (!(w > 0) || !(h > 0)) return "";
      const auto rx = length("rx", v.width), ry = length("ry", v.height);
      const double a = std::clamp(rx.value_or(ry.value_or(0)), 0.0, w / 2);
      const double b = std::clamp(ry.value_or(rx.value_or(0)), 0.0, h / 2);
      const double right = left + w, bottom = top + h;
      if (!(a > 0) || !(b > 0)) return fmt::format("M{} {}H{}V{}H{}Z", left, top, right, bottom, left);
      return fmt::format("M{} {}H{}A{} {} 0 0 1 {} {}V{}A{} {} 0 0 1 {} {}H{}A{} {} 0 0 1 {} {}V{}A{} {} 0 0 1 {} {}Z",
                         left + a, top, right - a, a, b, right, top + b, bottom - b, a, b, right - a, bottom, left + a,
                         a, b, left, bottom - b, top + b, a, b, left + a, top);
    }
    return std::nullopt;
  }

  Paint paint_of(Property which, std::string_view otherwise, Property opacity, const Around& around, xml_node node) {
    std::string_view said = around.style[which];
    if (said.empty()) said = otherwise;
    const double seen = around.opacity * svg_opacity(around.style[opacity]);
    if (said == "none") return {};
    if (const std::string_view of = svg_reference(said); !of.empty()) {
      if (const auto middle = middle_of_gradient(of)) {
        left_out("a gradient is one colour, its middle one", name_in_file(node));
        return {true, middle->color, middle->opacity * seen};
      }
      const std::string_view behind = trimmed(said.substr(std::min(said.find(')') + 1, said.size())));
      if (behind.empty() || behind == "none") {
        left_out(fmt::format("a {} by '{}', which is no gradient, is left out", name_of(which), of.substr(0, 60)),
                 name_in_file(node));
        return {};
      }
      said = behind;
    }
    const auto color = svg_color(said, around.style[Property::color]);
    if (!color) {
      left_out(fmt::format("a {} of '{}' is left out", name_of(which), said.substr(0, 40)), name_in_file(node));
      return {};
    }
    return {color->opacity > 0, color->color, color->opacity * seen};
  }

  std::optional<SvgColor> middle_of_gradient(std::string_view id) const {
    for (int steps = 0; steps < 16; ++steps) {  // a gradient may take its stops from another
      const auto found = ids_.find(id);
      if (found == ids_.end()) return std::nullopt;
      const xml_node node = found->second;
      if (!any_of_these(local_name(node), {"linearGradient", "radialGradient"})) return std::nullopt;
      std::vector<std::pair<double, SvgColor>> stops;
      for (const xml_node stop : node.children()) {
        if (local_name(stop) != "stop") continue;
        SvgStyle style;
        for (const pugi::xml_attribute a : stop.attributes()) style.set(a.name(), a.value());
        rules_.apply({"stop", said_in(stop, "id"), said_in(stop, "class")}, style);
        style.read(said_in(stop, "style"));
        const std::string_view said = style[Property::stop_color];
        SvgColor color =
            svg_color(said.empty() ? "black" : said, style[Property::color]).value_or(SvgColor{{0, 0, 0}, 1});
        color.opacity *= svg_opacity(style[Property::stop_opacity]);
        stops.emplace_back(svg_length(said_in(stop, "offset"), 1).value_or(0), color);
      }
      if (!stops.empty()) return at_middle(stops);
      id = reference_of(node);
    }
    return std::nullopt;
  }
  static SvgColor at_middle(const std::vector<std::pair<double, SvgColor>>& stops) {
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const auto& [at, color] = stops[i];
      if (at < 0.5) continue;
      if (i == 0 || at == 0.5) return color;
      const auto& [from, before] = stops[i - 1];
      const double s = (0.5 - from) / (at - from);
      const auto mixed = [s](double a, double b) { return (1 - s) * a + s * b; };
      return {{mixed(before.color.r, color.color.r), mixed(before.color.g, color.color.g),
               mixed(before.color.b, color.color.b)},
              mixed(before.opacity, color.opacity)};
    }
    return stops.back().second;
  }

  struct Look {
    Paint fill, stroke;
    double width = 0;
    bool round = false, square = false, even_odd = false;
    double dash = 0, gap = 0;
  };
  Look look_of(xml_node node, const Around& around) {
    Look look;
    const SvgStyle& style = around.style;
    const auto said = [&](Property p, std::string_view word) { return style[p] == word; };
    look.fill = paint_of(Property::fill, "black", Property::fill_opacity, around, node);
    look.stroke = paint_of(Property::stroke, "none", Property::stroke_opacity, around, node);
    look.even_odd = said(Property::fill_rule, "evenodd");
    // A stroke has a single width, so take the average scale.
    const Affine& m = around.to;
    const double stretch = std::sqrt(std::abs(m.a * m.d - m.b * m.c));
    const double across = std::hypot(m.a, m.b), up = std::hypot(m.c, m.d);
    const double whole = around.viewport.diagonal();
    look.width = svg_length(style[Property::stroke_width], whole).value_or(1) * stretch;
    look.width = std::min(look.width, farthest_drawn);
    look.stroke.there = look.stroke.there && look.width > 0;
    if (!look.stroke.there) return look;
    if (std::max(std::abs(across - up) / stretch, std::abs(m.a * m.c + m.b * m.d) / (stretch * stretch)) > 0.02)
      left_out("a stroke that is stretched is as wide everywhere", name_in_file(node));
    const std::string_view name = name_in_file(node);
    const bool round_ends = said(Property::linecap, "round"), round_joins = said(Property::linejoin, "round");
    look.round = round_ends || round_joins;
    look.square = said(Property::linecap, "square");
    if (said(Property::linejoin, "bevel")) left_out("bevelled corners of strokes are pointed", name);
    dashes_of(style, stretch, whole, look, name);
    for (const Property p : {Property::marker_start, Property::marker_mid, Property::marker_end})
      if (!style[p].empty() && style[p] != "none") left_out("markers are left out", name);
    return look;
  }
  void dashes_of(const SvgStyle& style, double stretch, double whole, Look& look, std::string_view name) {
    std::string_view all = style[Property::dasharray];
    std::vector<double> lengths;
    while (!(all = trimmed(all)).empty() && lengths.size() < 1000) {
      const std::size_t end = std::min(all.find_first_of(" ,\t\r\n"), all.size());
      if (const auto one = svg_length(all.substr(0, end), whole)) lengths.push_back(std::max(0.0, *one));
      all.remove_prefix(std::min(end + 1, all.size()));
    }
    if (lengths.empty()) return;
    look.dash = std::min(lengths[0] * stretch, farthest_drawn);
    look.gap = std::min(lengths[lengths.size() > 1 ? 1 : 0] * stretch, farthest_drawn);
    for (std::size_t i = 2; i < lengths.size(); ++i)
      if (lengths[i] != lengths[i % 2] || lengths.size() % 2 != 0) {
        left_out("dashes of several lengths are all as the first one", name);
        break;
      }
    if (svg_length(style[Property::dashoffset], whole).value_or(0) != 0)
      left_out("dashes begin where the line does", name);
  }

  bool path(xml_node node, const std::string& d, const Around& around) {
    if (any_of_these(around.style[Property::visibility], {"hidden", "collapse"})) return true;
    const Look look = look_of(node, around);
    if (!look.fill.there && !look.stroke.there) return true;
    Flattener lines(svg_stray);
    if (!PathReader(around.to, lines).read(d)) left_out("a path that breaks off is drawn so far", name_in_file(node));
    const auto runs = lines.take_runs();
    std::size_t count = 0;
    for (const auto& run : runs) {
      count += run.points.size();
      for (const Vec3 p : run.points)
        if (!(std::max(std::abs(p.x), std::abs(p.y)) <= farthest_drawn))
          return refuse(broken(fmt::format("'{}' reaches too far", name_in_file(node))));
    }
    if ((points_ += count) > most_drawn_points || out_.things.size() > most_drawn_things)
      return refuse(fail(ErrorCode::range, fmt::format("{} has too much in it: at most {} things and {} points", path_,
                                                       most_drawn_things, most_drawn_points)));
    add(node, around, outlined(runs, look));
    return true;
  }

  static DrawnThing with_stroke(DrawnThing thing, const Look& look) {
    thing.strokes = true;
    thing.stroke = look.stroke.color, thing.stroke_width = look.width;
    thing.round = look.round, thing.dash = {look.dash, look.gap, 0};
    return thing;
  }
  static DrawnThing filled(const Look& look) {
    DrawnThing thing;
    thing.color = look.fill.color;
    thing.transparency = 1 - look.fill.opacity;
    return thing;
  }

  // Returns the outlines that a path fills and strokes. If one outline can express both, returns that one.
  std::vector<DrawnThing> outlined(const std::vector<Flattener::Run>& runs, const Look& look) const {
    std::vector<DrawnThing> out;
    Contours closed;
    std::size_t points = 0;
    bool all_closed = true;
    for (const auto& run : runs) {
      if (run.points.size() > 2) closed.push_back(run.points), points += run.points.size();
      all_closed = all_closed && run.closed && run.points.size() > 2;
    }
    if (!look.fill.there) return stroked(runs, look);
    const std::vector<Island> all = islands(closed, look.even_odd ? Winding::odd : Winding::nonzero);
    std::size_t left = 0;  // of the points: all of them, if no lines cross
    for (const Island& island : all) {
      left += island.outer.size();
      for (const Contour& hole : island.holes) left += hole.size();
    }
    const bool as_it_is = left == points, one = as_it_is && runs.size() == 1 && all.size() == 1;
    const bool both = look.stroke.there && look.stroke.opacity == look.fill.opacity && as_it_is && !look.square &&
                      (all_closed || one);
    for (const Island& island : all) {
      DrawnThing thing = filled(look);
      thing.points = island.outer;
      for (const Contour& hole : island.holes) append_ring(thing.holes, hole);
      if (both) thing = with_stroke(std::move(thing), look);
      out.push_back(std::move(thing));
    }
    if (one) {  // keeps the start of the path, where its drawing begins
      out[0].points = runs[0].points;
      if (both && !runs[0].closed) out[0].trim_to = share_of_open(runs[0].points);
    }
    if (look.stroke.there && !both)
      for (DrawnThing& thing : stroked(runs, look)) out.push_back(std::move(thing));
    return out;
  }

  // Returns the path's share in the length that includes the way back to the first point.
  static double share_of_open(const Contour& points) {
    double length_open = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length_open += length(points[i] - points[i - 1]);
    const double back = length(points[0] - points.back());
    return length_open > 0 ? length_open / (length_open + back) : 1;
  }

  // All closed strokes become one object, because they are one area, and all open ones another. An open stroke goes
  // there and back, and is trimmed to the first half.
  std::vector<DrawnThing> stroked(const std::vector<Flattener::Run>& runs, const Look& look) const {
    std::vector<DrawnThing> out;
    if (!look.stroke.there) return out;
    DrawnThing closed = with_stroke({}, look);
    closed.fills = closed.strokes = false;  // its fill has the stroke's colour
    closed.color = look.stroke.color;
    closed.transparency = 1 - look.stroke.opacity;
    DrawnThing open = closed;
    open.trim_to = 0.5;
    for (const auto& run : runs) {
      Contour points = run.points;
      if (points.size() < 2) continue;
      if (look.square && !run.closed) lengthen(points, look.width / 2);
      if (points.size() == 2) points.insert(points.begin() + 1, 0.5 * (points[0] + points[1]));
      DrawnThing& to = run.closed ? closed : open;
      if (!run.closed)
        for (std::size_t i = points.size() - 1; i-- > 1;) points.push_back(points[i]);
      if (to.points.empty())
        to.points = std::move(points);
      else
        append_ring(to.holes, points);
    }
    for (DrawnThing* thing : {&closed, &open})
      if (!thing->points.empty()) out.push_back(std::move(*thing));
    return out;
  }
  static void lengthen(Contour& points, double by) {
    const auto beyond = [by](Vec3 end, Vec3 before) { return end + by * normalize(end - before); };
    const Vec3 first = beyond(points[0], points[1]);
    points.back() = beyond(points.back(), points[points.size() - 2]);
    points[0] = first;
  }

  void add(xml_node node, const Around& around, std::vector<DrawnThing> parts) {
    if (parts.empty()) return;
    ++drawn_;
    Around inside = around;
    if (parts.size() > 1) {
      add_group(node, inside);
      std::size_t number = 0;
      for (DrawnThing& part : parts) {
        part.name = fmt::format("{}/part-{}", out_.things[inside.group].name, ++number);
        part.above = inside.group;
        out_.things.push_back(std::move(part));
      }
      return;
    }
    parts[0].name = names_.give(said_in(node, "id").substr(0, 100), local_name(node));
    parts[0].above = around.group;
    out_.things.push_back(std::move(parts[0]));
  }

  // ---- Names and places

  // Puts each object's origin into the middle of its shapes, so that it turns about it, and each a little in front of
  // the earlier ones.
  void place_all() {
    auto& all = out_.things;
    const double thick = std::min(1e-3, 0.1 / static_cast<double>(all.size()));
    std::vector<Vec3> low(all.size(), Vec3{INFINITY, INFINITY, 0}), high(all.size(), Vec3{-INFINITY, -INFINITY, 0});
    for (std::size_t i = all.size(); i-- > 0;) {
      for (const Vec3 p : all[i].points) grow(low[i], high[i], p);
      const std::uint32_t above = all[i].above;
      if (above == DrawnThing::nothing) continue;
      grow(low[above], high[above], low[i]), grow(low[above], high[above], high[i]);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vec3 middle = 0.5 * (low[i] + high[i]);
      all[i].at = {middle.x, middle.y, all[i].group ? 0 : static_cast<double>(i) * thick};
      for (Vec3& p : all[i].points) p = p - middle;
      for (Vec3& p : all[i].holes) p = p - middle;
    }
    for (std::size_t i = all.size(); i-- > 0;)
      if (all[i].above != DrawnThing::nothing) all[i].at = all[i].at - all[all[i].above].at;
  }
  static void grow(Vec3& low, Vec3& high, Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
  }

  const std::string& path_;
  pugi::xml_document document_;
  std::unordered_map<std::string_view, xml_node> ids_;
  SvgRules rules_;
  DrawingFile out_;
  std::map<std::string, std::pair<std::size_t, std::vector<std::string>>> left_out_;
  std::vector<xml_node> used_;
  SceneNames names_;
  std::size_t elements_ = 0, points_ = 0, drawn_ = 0;
  std::optional<Error> error_;
};

}  // namespace

Result<std::shared_ptr<const DrawingFile>> read_svg(const std::string& text, const std::string& path) {
  return SvgReader(path).read(text);
}

Result<std::shared_ptr<const DrawingFile>> parse_drawing(const std::string& path, Shelf& shelf) {
  const auto text = shelf.read(path);
  return text ? read_svg(*text, path) : text.error();
}

}  // namespace betwixt
