// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The pieces of a diagram: nodes with their texts, and edges that follow them.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/names.h"
#include "base/utf8.h"
#include "commands/command.h"
#include "commands/connecting.h"
#include "commands/furniture_rows.h"
#include "language/values.h"
#include "scene/graph_layout.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr double node_em = 0.3, node_height = 0.7, node_margin = 0.5;
constexpr Vec3 usual_picture{14.5, 7.4, 0};  // what the usual camera sees, less a margin

// What an author says of a diagram.
struct SaidDiagram {
  std::string of, layout = "layered", direction = "down";
  bool circles = false;
  Vec3 apart;
  std::string fill;  // the color of nodes
};

struct PlacedNode {
  std::string name, text;
  Vec3 at;
};
struct PlacedDiagram {
  std::string fill, edge, ink;  // colors
  std::vector<PlacedNode> nodes;
  std::vector<Link> edges;
  double width = 0, height = 0;  // of each node; circles have this width
  bool circles = false;
};

// Returns a name that is not taken, made from a text.
std::string free_word(std::set<std::string>& taken, const std::string& from, const std::string& otherwise) {
  const std::string first = from.empty() ? otherwise : from;
  std::string name = first;
  for (int n = 2; !taken.insert(name).second; ++n) name = first + "-" + std::to_string(n);
  return name;
}

GraphLayout layout_of(std::string_view word) {
  return word == "tree"     ? GraphLayout::tree
         : word == "force"  ? GraphLayout::force
         : word == "circle" ? GraphLayout::circle
                            : GraphLayout::layered;
}

// Gives the labels of edges places where they cover no nodes, as far as there are such places.
void place_labels(PlacedDiagram& d) {
  std::map<std::string, LinkBorder> borders;
  LabelSurroundings all;
  for (const PlacedNode& n : d.nodes) {
    borders[n.name] = {n.at, d.width / 2, d.circles ? 0 : d.height / 2};
    all.nodes.push_back({n.at, d.width / 2, d.height / 2});
  }
  for (const Link& e : d.edges)
    all.lines.push_back(link_way(borders[e.from.name], borders[e.to.name], e.route, e.gap, e.tip()));
  for (std::size_t i = 0; i < d.edges.size(); ++i) {
    Link& e = d.edges[i];
    if (e.label.empty()) continue;
    const double half = half_of_label(e.label);
    e.beside = free_label(all, all.lines[i], half);
    all.labels.push_back({place_of_label(all.lines[i], half, e.beside), half, half_label_height});
  }
}

GraphWay way_of(std::string_view word) {
  return word == "right"  ? GraphWay::right
         : word == "left" ? GraphWay::left
         : word == "up"   ? GraphWay::up
                          : GraphWay::down;
}

// Returns half of the width of the widest label of an edge; 0: there is none.
double widest_label(const Graph& g) {
  double most = 0;
  for (const Graph::Edge& e : g.edges)
    if (!e.label.empty()) most = std::max(most, half_of_label(e.label));
  return most;
}

// Returns the usual distance of neighbours. Labels have room between nodes that stand side by side.
Vec3 usual_apart(const PlacedDiagram& d, const Graph& g, GraphLayout layout, GraphWay way) {
  const double label = 2 * widest_label(g), beside = label > 0 ? label + 0.6 : 0;
  if (layout == GraphLayout::circle || layout == GraphLayout::force)
    return {d.width + std::max(1.2, beside), d.width + 1.2, 0};
  if (goes_across(way)) return {d.width + std::max(1.0, beside), d.height + 0.5, 0};
  return {d.width + 0.7, d.height + 0.8, 0};
}

Result<PlacedDiagram> placed_diagram(const Scene& s, const std::string& diagram, const SaidDiagram& said) {
  const auto graph = read_graph(said.of);
  if (!graph) return graph.error();
  PlacedDiagram out;
  out.circles = said.circles;
  out.fill = said.fill, out.edge = palette(s, 0), out.ink = theme_color(s, &Theme::ink);
  double letters = 1;
  for (const std::string& text : graph->nodes)
    letters = std::max(letters, static_cast<double>(std::count_if(text.begin(), text.end(), begins_character)));
  out.width = 0.62 * node_em * letters + node_margin, out.height = node_height;
  if (out.circles) out.width = out.height = std::max(out.width, node_height);
  const GraphLayout layout = layout_of(said.layout);
  const GraphWay way = way_of(said.direction);
  Vec3 apart = usual_apart(out, *graph, layout, way);
  if (said.apart.x > 0) apart.x = said.apart.x;
  if (said.apart.y > 0) apart.y = said.apart.y;
  const std::vector<Vec3> at = place_graph(*graph, layout, apart, way);
  std::set<std::string> taken;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::string& text = graph->nodes[i];
    out.nodes.push_back({diagram + "/" + free_word(taken, key_word(text), std::to_string(i + 1)), text, at[i]});
  }
  const auto word = [&](std::size_t i) { return out.nodes[i].name.substr(diagram.size() + 1); };
  for (const Graph::Edge& e : graph->edges) {
    const bool both = std::any_of(graph->edges.begin(), graph->edges.end(),
                                  [&](const Graph::Edge& other) { return other.from == e.to && other.to == e.from; });
    const auto end = [&](std::size_t i) {
      return LinkEnd{out.nodes[i].name, {}, out.width / 2, out.circles ? 0 : out.height / 2};
    };
    Link link;
    link.name = diagram + "/" + free_word(taken, word(e.from) + "-" + word(e.to), "edge");
    link.from = end(e.from), link.to = end(e.to);
    link.color = theme_color(s, &Theme::muted), link.label_color = theme_color(s, &Theme::label);
    link.route = e.from == e.to ? "loop" : both ? "curved" : "straight";
    link.arrow = e.arrow, link.label = e.label;
    out.edges.push_back(std::move(link));
  }
  place_labels(out);
  return out;
}

std::string place_of(Vec3 at) { return fmt::format("({} {})", write_metres(at.x), write_metres(at.y)); }

std::string lines_of_node(const PlacedDiagram& d, const PlacedNode& n) {
  const std::string form =
      d.circles ? fmt::format("circle radius={}", write_number(d.width / 2))
                : fmt::format("rectangle size=({} {}) corner=0.16", write_number(d.width), write_number(d.height));
  return fmt::format(
      "create {0} {1} color={2} stroke={3} stroke-width=0.03 position={4}\n"
      "create {0}/text text text={5} size={6} color={8} position=(0 {7} 0.01)\n",
      n.name, form, d.fill, d.edge, place_of(n.at), write_text(n.text), write_number(node_em),
      write_number(-0.36 * node_em), d.ink);
}

// Returns how much smaller a diagram must be to fit into the usual picture, with its loops.
double shrink_of(const PlacedDiagram& d) {
  double most = 1;
  for (const PlacedNode& n : d.nodes) {
    const bool loops = std::any_of(d.edges.begin(), d.edges.end(),
                                   [&](const Link& e) { return e.route == "loop" && e.from.name == n.name; });
    const double room = loops ? 1 : 0;
    most = std::max({most, (2 * std::abs(n.at.x) + d.width + room) / usual_picture.x,
                     (2 * std::abs(n.at.y) + d.height + room) / usual_picture.y});
  }
  return 1 / most;
}

SaidDiagram said_of(const Furnishing& f) {
  const std::string fill = f.colored() ? write_color(std::get<Color>(f.value("color"))) : f.panel();
  return {f.text("of"), f.text("layout"), f.text("direction"), f.text("nodes") == "circle", f.vector("apart"), fill};
}

// ---- rearrange

// Reads of="…", layout=WORD and direction=WORD.
bool said_again(Command& k, SaidDiagram& out, std::string_view& of_at) {
  Cursor& c = k.cursor;
  while (!c.at_line_end() && c.peek_word() != "for") {
    const std::string_view word = c.next_word();
    if (word != "of" && word != "layout" && word != "direction")
      return no_choice(c, word, "expected of=\"…\", layout=…, direction=… or for L");
    if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, fmt::format("'=' is missing after {}", word));
    if (word == "of") {
      of_at = word;
      if (!c.text(out.of)) return false;
      continue;
    }
    const std::string_view said = c.next_word();
    if (word == "direction") {
      if (said != "down" && said != "right" && said != "left" && said != "up")
        return no_choice(c, said, "direction is down, right, left or up");
      out.direction = said;
      continue;
    }
    if (said != "layered" && said != "tree" && said != "force" && said != "circle")
      return no_choice(c, said, "layout is layered, tree, force or circle");
    out.layout = said;
  }
  return true;
}

template <class All>
bool has_part(const All& all, const std::string& name) {
  return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
}

// Writes what turns one diagram into another.
struct Rearranging {
  const Scene& scene;
  const PlacedDiagram &before, &after;
  const std::string when, length;
  std::string lines;

  void last(const std::string& what) { lines += fmt::format("at {} {} for {}\n", when, what, length); }
  void all() {
    for (const PlacedNode& n : after.nodes) {
      const bool known = static_cast<bool>(scene.names.find(n.name));
      if (!known) lines += lines_of_node(after, n);
      if (known) last(n.name + ".position " + place_of(n.at));
      if (!has_part(before.nodes, n.name)) last("fade-in " + n.name);
    }
    for (const Link& e : after.edges) {
      if (!scene.names.find(e.name)) lines += lines_of_link(e);
      if (!has_part(before.edges, e.name)) last("fade-in " + e.name);
      const std::string label = e.name + "/label";
      const auto was = std::find_if(before.edges.begin(), before.edges.end(),
                                    [&](const Link& other) { return other.name == e.name; });
      if (was != before.edges.end() && was->label != e.label && scene.names.find(label))
        last(label + ".text " + write_text(e.label));
    }
    for (const PlacedNode& n : before.nodes)
      if (!has_part(after.nodes, n.name)) last("fade-out " + n.name);
    for (const Link& e : before.edges)
      if (!has_part(after.edges, e.name)) last("fade-out " + e.name);
  }
};

bool rearrange(Command& k) {
  auto& [s, c, time, layer, script] = k;
  ObjectId id;
  c.space();
  const std::string_view word = c.peek_word();
  if (!values(k).object(id)) return false;
  const std::string name = s.objects[id.index].name;
  if (const Kind kind = s.objects[id.index].kind; kind != Kind::diagram)
    return c.fail(ErrorCode::type, fmt::format("'{}' is {}, not a diagram", name, a_kind(kind)), word);
  const Furniture nothing;
  const Furnishing f{s, id, name, nothing, {}, {}, {}, 0};
  SaidDiagram said = said_of(f);
  const auto before = placed_diagram(s, name, said);
  std::string_view of_at = word;
  if (!said_again(k, said, of_at)) return false;
  Time length = from_seconds(1);
  if (!lasting(k, length, word)) return false;
  const auto after = placed_diagram(s, name, said);
  if (!after) return c.fail(after.error().code, after.error().message, of_at, after.error().hint);
  Rearranging change{
      s, before ? *before : PlacedDiagram(), *after, write_time(time.value_or(Time{}), s.rate), write_seconds(length),
      {}};
  change.all();
  change.lines += fmt::format("set {0}.of {1}\nset {0}.layout {2}\nset {0}.direction {3}\n", name, write_text(said.of),
                              said.layout, said.direction);
  return all_or_none(k, change.lines, word);
}

constexpr Verb diagrams_rows[] = {
    {"rearrange",
     "at TIME rearrange DIAGRAM [of=\"…\"] [layout=tree|layered|force|circle] [direction=right|left|up|down] [for L]",
     "Turns a diagram into another: nodes that stay glide, others fade in or out.",
     "create d diagram of=\"a -> b -> c\"\nat 24f rearrange d of=\"a -> c; a -> d\" layout=tree", Verb::timed,
     rearrange, "OBJECT; of layout direction for…"},
};

}  // namespace

void make_diagram(Furnishing& f) {
  const auto placed = placed_diagram(f.scene, f.name, said_of(f));
  if (!placed) {
    f.problem = placed.error().message, f.hint = placed.error().hint, f.problem_at = placed.error().place.column;
    return;
  }
  for (const PlacedNode& n : placed->nodes) f.lines += lines_of_node(*placed, n);
  for (const Link& e : placed->edges) f.lines += lines_of_link(e);
  if (const double by = shrink_of(*placed); by < 1 && !f.says("scale"))
    f.line("set {0}.scale ({1} {1} {1})", f.name, write_number(std::floor(by * 100) / 100));
}

std::span<const Verb> diagrams_verbs() { return diagrams_rows; }

}  // namespace betwixt
