// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the shapes of an SVG as flat outlines, from back to front.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>

#include "base/names.h"
#include "exchange/drawing.h"
#include "exchange/outlines.h"
#include "exchange/scene_names.h"
#include "exchange/svg_elements.h"
#include "exchange/svg_look.h"
#include "exchange/svg_outlines.h"
#include "exchange/svg_path.h"
#include "exchange/svg_style.h"
#include "exchange/unpacking.h"

namespace betwixt {
namespace {

using pugi::xml_node;

constexpr double svg_stray = 1e-4;           // the largest error of a flattened curve, relative to the drawing's height
constexpr std::size_t deepest_in_svg = 128;  // nested elements, including `use`
constexpr std::size_t most_elements = 500'000;

std::string_view name_in_file(xml_node node) {
  const std::string_view id = said_in(node, "id");
  return id.empty() ? local_name(node) : id;
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
      return broken(fmt::format("line {} is not XML", line));
    }
    const xml_node root = document_.document_element();
    if (local_name(root) != "svg")
      return broken(fmt::format("it begins with <{}>, not with <svg>", std::string_view(root.name()).substr(0, 40)));
    if (!prepare(root)) return *error_;
    if (!walk_root(root)) return *error_;
    if (out_.things.empty()) return broken("it draws nothing");
    place_in_middles(out_.things);
    left_out_.say(out_.left_out);
    return std::make_shared<const DrawingFile>(std::move(out_));
  }

 private:
  Error broken(const std::string& what, std::string hint = {}) const {
    return fail(ErrorCode::file, fmt::format("{} cannot be read: {}", path_, what), std::move(hint));
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
    if (rules_.passed_over())
      left_out_.add("a style rule with a selector other than tag, classes and id is left out", {});
    return true;
  }

  // ---- From element to element

  bool walk_root(xml_node root) {
    Viewport whole;
    fitted(root, whole, whole.width, whole.height);  // without a size of its own, its viewBox is its size
    const double width = svg_length(said_in(root, "width"), whole.width).value_or(whole.width);
    const double height = svg_length(said_in(root, "height"), whole.height).value_or(whole.height);
    if (!(width > 0) || !(height > 0)) return refuse(broken("its size is 0"));
    if (!(width / height <= farthest_drawn)) return refuse(broken("its size is not valid"));
    out_.width = width / height;
    SvgAround around;
    around.to =
        Affine{1 / height, 0, 0, -1 / height, -width / height / 2, 0.5} * fitted(root, around.viewport, width, height);
    return style_of(root, around) && walk_inside(root, around);
  }

  bool walk_inside(xml_node node, const SvgAround& around) {
    const bool first_only = local_name(node) == "switch";
    for (const xml_node child : node.children()) {
      if (child.type() != pugi::node_element) continue;
      if (!walk(child, around)) return false;
      if (first_only) break;
    }
    return true;
  }

  // Applies the element's own style. Sets `shown` to false if nothing of it is drawn.
  bool style_of(xml_node node, SvgAround& around, bool* shown = nullptr) {
    SvgStyle style = around.style.inherited();
    for (const pugi::xml_attribute a : node.attributes()) style.set(a.name(), a.value());
    rules_.apply({local_name(node), said_in(node, "id"), said_in(node, "class")}, style);
    style.read(said_in(node, "style"));
    around.style = style;
    around.opacity *= svg_opacity(style[Property::opacity]);
    if (shown) *shown = style[Property::display] != "none";
    const auto own = transform_in(said_in(node, "transform"));
    if (!own) left_out_.add("a transform that is not valid is left out", name_in_file(node));
    around.to = around.to * own.value_or(Affine{});
    const std::string_view name = name_in_file(node);
    for (const Property p : {Property::clip_path, Property::mask, Property::filter})
      if (!style[p].empty() && style[p] != "none") left_out_.add(fmt::format("{} is left out", name_of(p)), name);
    if (!style[Property::blend].empty() && style[Property::blend] != "normal")
      left_out_.add("mix-blend-mode is left out", name);
    return around.to.sane() || refuse(broken("a number in it is too large"));
  }

  bool walk(xml_node node, SvgAround around) {
    const std::string_view tag = local_name(node);
    if (tag.find(':') != std::string_view::npos) return true;  // an element of another program
    if (any_of_these(tag, {"defs", "symbol", "style", "title", "desc", "metadata", "linearGradient", "radialGradient",
                           "clipPath", "mask", "filter", "pattern", "marker", "view"}))
      return true;
    if (++elements_ > most_elements)
      return refuse(fail(ErrorCode::range, fmt::format("{} has more than {} elements", path_, most_elements)));
    if (++around.depth > deepest_in_svg)
      return refuse(broken(fmt::format("its groups are nested more than {} levels deep", deepest_in_svg)));
    bool shown = true;
    if (!style_of(node, around, &shown)) return false;
    if (!shown) return true;
    if (any_of_these(tag, {"g", "a", "switch"})) return group(node, around);
    if (tag == "svg") return nested(node, around, {});
    if (tag == "use") return use(node, around);
    if (tag == "text")
      return refuse(
          broken(fmt::format("the text '{}' may have another font here", name_in_file(node)),
                 "turn texts into paths (in Inkscape: Path > Object to Path), or write them as create title text …"));
    if (const auto d = path_of(node, tag, around.viewport)) return path(node, *d, around);
    if (any_of_these(tag, {"animate", "animateTransform", "animateMotion", "set"}))
      left_out_.add("SVG animation is left out", name_in_file(node.parent()));
    else
      left_out_.add(fmt::format("<{}> is left out", tag.substr(0, 40)), said_in(node, "id"));
    return true;
  }

  bool group(xml_node node, SvgAround& around) {
    // A group without a name is not kept: its contents belong to the group around it.
    const bool named = !said_in(node, "id").empty();
    const auto own = static_cast<std::uint32_t>(out_.things.size());
    if (named) add_group(node, around);
    const std::size_t before = drawn_;
    if (!walk_inside(node, around)) return false;
    if (named && out_.things.size() == own + 1) out_.things.pop_back();  // the group is empty
    if (around.style[Property::opacity].empty() || drawn_ < before + 2) return true;
    if (svg_opacity(around.style[Property::opacity]) < 1)
      left_out_.add("the elements of a transparent group show through each other", name_in_file(node));
    return true;
  }

  void add_group(xml_node node, SvgAround& around) {
    DrawnThing thing;
    thing.name = names_.give(said_in(node, "id").substr(0, 100), local_name(node));
    thing.above = around.group;
    thing.group = true;
    around.group = static_cast<std::uint32_t>(out_.things.size());
    out_.things.push_back(std::move(thing));
  }

  // Draws an inner svg or a symbol. `wanted`: the size from `use`.
  bool nested(xml_node node, SvgAround& around, std::array<std::string_view, 2> wanted) {
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
    return around.to.sane() ? group(node, around) : refuse(broken("a number in it is too large"));
  }

  bool use(xml_node node, SvgAround& around) {
    const std::string_view of = reference_of(node);
    const auto found = ids_.find(of);
    if (found == ids_.end()) {
      left_out_.add(fmt::format("a use of '{}', which does not exist, is left out", of.substr(0, 60)), {});
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
      SvgAround inside = around;
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

  bool path(xml_node node, const std::string& d, const SvgAround& around) {
    if (any_of_these(around.style[Property::visibility], {"hidden", "collapse"})) return true;
    const SvgLook look = svg_look(around, name_in_file(node), ids_, rules_, left_out_);
    if (!look.fill.there && !look.stroke.there) return true;
    Flattener lines(svg_stray);
    if (!PathReader(around.to, lines).read(d))
      left_out_.add("a path with an error is drawn up to the error", name_in_file(node));
    const auto runs = lines.take_runs();
    std::size_t count = 0;
    for (const auto& run : runs) {
      count += run.points.size();
      for (const Vec3 p : run.points)
        if (!(std::max(std::abs(p.x), std::abs(p.y)) <= farthest_drawn))
          return refuse(broken(fmt::format("'{}' is too large", name_in_file(node))));
    }
    if ((points_ += count) > most_drawn_points || out_.things.size() > most_drawn_things)
      return refuse(
          fail(ErrorCode::range, fmt::format("{} is too large: at most {} elements and {} points are supported", path_,
                                             most_drawn_things, most_drawn_points)));
    std::vector<DrawnThing> drawn = outlined(runs, look);
    if (look.fill.gradient || look.stroke.gradient) add_gradients(look, around, d, drawn);
    for (const DrawnThing& thing : drawn)
      if (const Status fits = unpack(sizeof thing + (thing.points.size() + thing.holes.size()) * sizeof(Vec3), path_);
          !fits)
        return refuse(fits.error());
    add(node, around, std::move(drawn));
    return true;
  }

  static void add_gradients(const SvgLook& look, const SvgAround& around, const std::string& d,
                            std::vector<DrawnThing>& drawn) {
    Flattener lines(svg_stray);
    PathReader(Affine{}, lines).read(d);
    Box element;
    for (const auto& run : lines.take_runs())
      for (const Vec3 p : run.points) element.add(p);
    for (DrawnThing& thing : drawn) {
      Box own;
      for (const Vec3 p : thing.points) own.add(p);
      const SvgPaint& paint = thing.fills ? look.fill : look.stroke;
      if (paint.gradient) thing.gradient = laid_on(own, *paint.gradient, around.to, element);
      if (thing.strokes && look.stroke.gradient)
        thing.stroke_gradient = laid_on(own, *look.stroke.gradient, around.to, element);
    }
  }

  void add(xml_node node, const SvgAround& around, std::vector<DrawnThing> parts) {
    if (parts.empty()) return;
    ++drawn_;
    SvgAround inside = around;
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

  const std::string& path_;
  pugi::xml_document document_;
  SvgIds ids_;
  SvgRules rules_;
  DrawingFile out_;
  SvgLeftOut left_out_;
  std::vector<xml_node> used_;
  SceneNames names_;
  std::size_t elements_ = 0, points_ = 0, drawn_ = 0;
  std::optional<Error> error_;
};

}  // namespace

Result<std::shared_ptr<const DrawingFile>> read_svg(const std::string& text, const std::string& path) {
  return SvgReader(path).read(text);
}

Result<std::shared_ptr<const DrawingFile>> parse_drawing(const std::string& path, FileSource& files) {
  const auto text = files.read(path);
  return text ? read_svg(*text, path) : text.error();
}

}  // namespace betwixt
