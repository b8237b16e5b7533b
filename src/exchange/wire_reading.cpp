// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes the serialized result of a parser process and validates all of it.
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <set>

#include "base/names.h"
#include "exchange/wire_finish.h"
#include "exchange/wire_format.h"
#include "exchange/wire_layout.h"
#include "exchange/wire_taker.h"
#include "scene/gradient_stops.h"

namespace betwixt {
namespace {

using namespace wire;

constexpr std::size_t most_pictures = 100'000, most_pieces = 1'000'000;
constexpr int largest_side = 16384;

template <std::size_t N>
bool finite(const std::vector<std::array<float, N>>& all) {
  return std::all_of(all.begin(), all.end(), [](const auto& v) {
    return std::all_of(v.begin(), v.end(), [](float f) { return std::isfinite(f); });
  });
}

bool below(const std::vector<std::uint32_t>& indices, std::size_t per, std::size_t count) {
  return indices.size() % per == 0 &&
         std::all_of(indices.begin(), indices.end(), [&](std::uint32_t i) { return i < count; });
}

bool sound(const Mesh& m) {
  const std::size_t count = m.positions.size();
  return m.normals.size() == count && (m.uvs.empty() || m.uvs.size() == count) && finite(m.positions) &&
         finite(m.normals) && finite(m.uvs) && !m.triangles.empty() && below(m.triangles, 3, count) &&
         below(m.edges, 2, count);
}

// The parts must cover the triangles in order.
bool take_parts(const std::vector<FlatPart>& flat, const std::vector<std::shared_ptr<const Picture>>& pictures,
                Mesh& m) {
  std::uint64_t covered = 0;
  for (const FlatPart& f : flat) {
    const bool known = f.picture == no_picture || f.picture < pictures.size();
    if (f.first != covered || f.count % 3 != 0 || !known || !finite(std::vector{f.color})) return false;
    covered += f.count;
    m.parts.push_back({f.first, f.count, f.color, f.picture == no_picture ? nullptr : pictures[f.picture]});
  }
  return flat.empty() || covered == m.triangles.size();
}

// Takes a Picture or a LinearPicture.
template <class P>
std::shared_ptr<const P> take_picture(Taker& from) {
  FlatSize size;
  auto picture = std::make_shared<P>();
  if (!from.one(size) || size.width < 1 || size.height < 1 || size.width > largest_side || size.height > largest_side)
    return nullptr;
  picture->width = size.width, picture->height = size.height;
  const auto channels = 4 * static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  return from.block(picture->rgba) && picture->rgba.size() == channels ? picture : nullptr;
}

// parse_table() checks the text itself.
std::shared_ptr<const TableText> take_table(Taker& from) {
  auto table = std::make_shared<TableText>();
  return from.block(table->text) ? table : nullptr;
}

std::shared_ptr<const ColorTable> take_colors(Taker& from) {
  FlatColors flat;
  auto t = std::make_shared<ColorTable>();
  if (!from.one(flat) || !from.block(t->signals) || flat.takes > ColorTable::stops || flat.cube > 1 || flat.size < 2 ||
      flat.size > static_cast<std::uint32_t>(flat.cube ? ColorTable::most_side : ColorTable::most_curve))
    return nullptr;
  t->takes = static_cast<ColorTable::Takes>(flat.takes), t->cube = flat.cube != 0;
  t->size = static_cast<int>(flat.size), t->least = flat.least, t->most = flat.most;
  const std::uint64_t side = flat.size, colors = t->cube ? side * side * side : side;
  for (std::size_t c = 0; c < 3; ++c)
    if (!(std::abs(t->least[c]) <= 1e5F && std::abs(t->most[c]) <= 1e5F && t->least[c] < t->most[c])) return nullptr;
  return t->signals.size() == 3 * colors ? t : nullptr;
}

// Accepts only text that is safe to print on a terminal.
bool take_words(Taker& from, std::string& words) {
  if (!from.block(words) || words.size() > longest_words) return false;
  std::replace_if(
      words.begin(), words.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
  return true;
}

bool sound(const Rig& rig, std::size_t count) {
  const std::size_t joints = rig.inverse_bind.size();
  if (rig.joints.size() != rig.weights.size() || (joints == 0) != rig.joints.empty() || joints > most_joints ||
      (joints > 0 && rig.joints.size() != count) || !finite(rig.weights))
    return false;
  for (const auto& four : rig.joints)
    for (const std::uint16_t j : four)
      if (j >= joints) return false;
  for (const Mat4& m : rig.inverse_bind)
    if (!betwixt::finite(m)) return false;
  for (const Rig::Target& t : rig.targets)
    for (const auto* all : {&t.positions, &t.normals})
      if ((!all->empty() && all->size() != count) || !finite(*all)) return false;
  return true;
}

std::shared_ptr<const Rig> take_rig(Taker& from, std::uint32_t targets, std::size_t count) {
  auto rig = std::make_shared<Rig>();
  if (!from.block(rig->joints) || !from.block(rig->weights) || !from.block(rig->inverse_bind)) return nullptr;
  for (std::uint32_t i = 0; i < targets; ++i) {
    Rig::Target& t = rig->targets.emplace_back();
    if (!take_words(from, t.name) || !is_name(t.name) || !from.block(t.positions) || !from.block(t.normals))
      return nullptr;
  }
  return sound(*rig, count) ? rig : nullptr;
}

std::shared_ptr<const Mesh> take_mesh(Taker& from) {
  FlatMesh flat;
  if (!from.one(flat) || flat.closed > 1 || flat.pictures > most_pictures || flat.targets > most_pieces) return nullptr;
  std::vector<std::shared_ptr<const Picture>> pictures;
  while (pictures.size() < flat.pictures) {
    pictures.push_back(take_picture<Picture>(from));
    if (!pictures.back()) return nullptr;
  }
  std::vector<FlatPart> parts;
  auto mesh = std::make_shared<Mesh>();
  mesh->closed = flat.closed == 1;
  const bool whole = from.block(parts) && from.block(mesh->positions) && from.block(mesh->normals) &&
                     from.block(mesh->uvs) && from.block(mesh->triangles) && from.block(mesh->edges);
  if (!whole || !sound(*mesh) || !take_parts(parts, pictures, *mesh)) return nullptr;
  if (flat.rigged && !(mesh->rig = take_rig(from, flat.targets, mesh->positions.size()))) return nullptr;
  return mesh;
}

std::shared_ptr<const Finish> take_finish(Taker& from) {
  FlatFinish flat;
  auto finish = std::make_shared<Finish>();
  if (!from.one(flat) || flat.pictures > std::size(finish_pictures)) return nullptr;
  for (std::size_t i = 0; i < std::size(finish_numbers); ++i) {
    const auto& [is, low, high] = finish_numbers[i];
    if (!(flat.numbers[i] >= low && flat.numbers[i] <= high)) return nullptr;
    (*finish).*is = flat.numbers[i];
  }
  for (const Vec3& c : {flat.emission, flat.sheen})
    if (!betwixt::finite(c) || std::min({c.x, c.y, c.z}) < 0 || std::max({c.x, c.y, c.z}) > 1e10) return nullptr;
  finish->emission = flat.emission, finish->sheen = flat.sheen;
  std::vector<std::shared_ptr<const Picture>> pictures;
  while (pictures.size() < flat.pictures) {
    pictures.push_back(take_picture<Picture>(from));
    if (!pictures.back()) return nullptr;
  }
  for (std::size_t i = 0; i < std::size(finish_pictures); ++i) {
    if (flat.which[i] == no_picture) continue;
    if (flat.which[i] >= pictures.size()) return nullptr;
    (*finish).*finish_pictures[i] = pictures[flat.which[i]];
  }
  return finish;
}

bool take_node(Taker& from, SceneNode& n) {
  FlatNode flat;
  if (!from.one(flat) || !take_words(from, n.name) || !is_name(n.name) || n.name.find('/') != n.name.npos ||
      !from.block(n.joints) || !from.block(n.weights))
    return false;
  n.parent = flat.parent, n.mesh = flat.mesh, n.camera = flat.camera, n.light = flat.light;
  n.position = flat.position, n.rotation = flat.rotation, n.scale = flat.scale;
  return true;
}

bool take_clip(Taker& from, SceneClip& c) {
  std::uint64_t tracks = 0;
  if (!take_words(from, c.name) || !from.one(tracks) || tracks > most_pieces) return false;
  for (std::uint64_t i = 0; i < tracks; ++i) {
    FlatTrack flat;
    SceneTrack& t = c.tracks.emplace_back();
    if (!from.one(flat) || flat.path > SceneTrack::weights || flat.way > SceneTrack::cubic || !from.block(t.times) ||
        !from.block(t.values))
      return false;
    t.node = flat.node, t.path = SceneTrack::Path{flat.path}, t.way = SceneTrack::Way{flat.way};
  }
  return true;
}

std::shared_ptr<const SceneFile> take_scene(Taker& from) {
  auto s = std::make_shared<SceneFile>();
  FlatScene flat;
  if (!from.one(flat) || flat.nodes > most_nodes || flat.meshes > most_nodes || flat.clips > most_pieces ||
      flat.sentences > 1000)
    return nullptr;
  std::set<std::string> names;
  for (std::uint64_t i = 0; i < flat.meshes; ++i) {
    FlatSurface surface;
    SceneMesh& m = s->meshes.emplace_back();
    if (!from.one(surface) || surface.material > static_cast<std::uint32_t>(Material::glow) || surface.finished > 1 ||
        (surface.finished && !(m.finish = take_finish(from))) || !take_words(from, m.name) || !is_name(m.name) ||
        !names.insert(m.name).second || !(m.mesh = take_mesh(from)))
      return nullptr;
    m.material = Material{static_cast<std::uint8_t>(surface.material)};
    m.shininess = surface.shininess, m.transparency = surface.transparency;
  }
  names.clear();
  for (std::uint64_t i = 0; i < flat.nodes; ++i)
    if (!take_node(from, s->nodes.emplace_back()) || !names.insert(s->nodes.back().name).second) return nullptr;
  std::vector<FlatLight> lights;
  if (!from.block(s->cameras) || !from.block(lights)) return nullptr;
  for (const FlatLight& l : lights) s->lights.push_back({l.sun != 0, l.color, l.intensity, l.range});
  for (std::uint64_t i = 0; i < flat.clips; ++i)
    if (!take_clip(from, s->clips.emplace_back())) return nullptr;
  for (std::uint64_t i = 0; i < flat.sentences; ++i)
    if (!take_words(from, s->left_out.emplace_back())) return nullptr;
  return sound(*s) ? s : nullptr;
}

bool sound(const DrawnGradient& g) {
  if (g.kind == 0) return g.stops.empty();
  const auto near = [](double v, double low, double high) { return v >= low && v <= high; };
  return g.kind <= static_cast<std::uint32_t>(GradientKind::conic) &&
         g.spread <= static_cast<std::uint32_t>(GradientSpread::reflect) && near(g.turn, -10, 10) &&
         near(g.move_x, -1e6, 1e6) && near(g.move_y, -1e6, 1e6) && near(g.size, 0.001, 1e6) &&
         static_cast<bool>(read_stops(g.stops));
}

// Returns whether names are valid, groups precede their members, and all coordinates are finite.
bool sound(const DrawingFile& d) {
  std::set<std::string_view> names;
  const auto near = [](Vec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 1e9; };
  for (std::size_t i = 0; i < d.things.size(); ++i) {
    const DrawnThing& t = d.things[i];
    const bool owned = t.above == DrawnThing::nothing || (t.above < i && d.things[t.above].group);
    const auto part = [](double v) { return v >= 0 && v <= 1; };
    const auto color = [&](const Color& c) { return part(c.r) && part(c.g) && part(c.b); };
    if (!sound(t.gradient) || !sound(t.stroke_gradient)) return false;
    if (!is_name(t.name) || !names.insert(t.name).second || !owned || !near(t.at) || !color(t.color) ||
        !color(t.stroke) || !part(t.transparency) || !part(t.trim_to) || !near({t.stroke_width, t.dash.x, t.dash.y}) ||
        std::min({t.stroke_width, t.dash.x, t.dash.y}) < 0 || !std::all_of(t.points.begin(), t.points.end(), near) ||
        !std::all_of(t.holes.begin(), t.holes.end(), near))
      return false;
  }
  return d.width > 0 && d.width <= 1e9 && !d.things.empty() && d.things.size() <= 2 * most_drawn_things;
}

std::shared_ptr<const DrawingFile> take_drawing(Taker& from) {
  auto drawing = std::make_shared<DrawingFile>();
  FlatDrawing flat;
  std::vector<FlatThing> things;
  std::vector<Vec3> points;
  std::string names;
  if (!from.one(flat) || flat.sentences > longest_words || !from.block(things) || !from.block(points) ||
      !from.block(names))
    return nullptr;
  drawing->width = flat.width;
  std::uint64_t at = 0;
  std::string_view rest = names;
  const auto take_points = [&](std::uint64_t count, std::vector<Vec3>& to) {
    if (count > points.size() - at) return false;
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(at);
    to.assign(first, first + static_cast<std::ptrdiff_t>(count));
    at += count;
    return true;
  };
  for (const FlatThing& f : things) {
    DrawnThing t;
    if (!take_points(f.points, t.points) || !take_points(f.holes, t.holes)) return nullptr;
    for (std::string* line : {&t.name, &t.gradient.stops, &t.stroke_gradient.stops}) {
      const std::size_t end = rest.find('\n');
      if (end == std::string_view::npos) return nullptr;
      *line = rest.substr(0, end);
      rest.remove_prefix(end + 1);
    }
    for (const auto& [from_flat, to] :
         {std::pair(&f.gradients[0], &t.gradient), std::pair(&f.gradients[1], &t.stroke_gradient)}) {
      to->kind = from_flat->kind, to->spread = from_flat->spread, to->turn = from_flat->turn;
      to->move_x = from_flat->move[0], to->move_y = from_flat->move[1], to->size = from_flat->size;
    }
    t.above = f.above;
    t.group = f.flags & is_group, t.fills = f.flags & is_filled;
    t.strokes = f.flags & is_stroked, t.round = f.flags & is_round;
    t.at = {f.at[0], f.at[1], f.at[2]};
    t.color = {f.color[0], f.color[1], f.color[2]}, t.stroke = {f.stroke[0], f.stroke[1], f.stroke[2]};
    t.stroke_width = f.stroke_width, t.transparency = f.transparency, t.trim_to = f.trim_to;
    t.dash = {f.dash[0], f.dash[1], 0};
    drawing->things.push_back(std::move(t));
  }
  for (std::uint64_t i = 0; i < flat.sentences; ++i)
    if (!take_words(from, drawing->left_out.emplace_back())) return nullptr;
  return at == points.size() && rest.empty() && sound(*drawing) ? drawing : nullptr;
}

// Returns whether all are numbers that letters can have.
bool sound(const ShapedLine& line) {
  const auto near = [](double v) { return std::abs(v) <= 1e6; };
  const auto point = [&](const Vec3& p) { return near(p.x) && near(p.y) && near(p.z); };
  for (const ShapedGlyph& g : line.glyphs)
    if (!near(g.advance) || !point(g.shift)) return false;
  for (const auto& [number, contours] : line.outlines)
    for (const auto& contour : contours)
      if (!std::all_of(contour.begin(), contour.end(), point)) return false;
  return true;
}

std::shared_ptr<const ShapedLine> take_letters(Taker& from) {
  auto line = std::make_shared<ShapedLine>();
  std::uint64_t outlines = 0, contours = 0;
  if (!from.block(line->glyphs) || !from.one(outlines) || outlines > line->glyphs.size()) return nullptr;
  for (std::uint64_t i = 0; i < outlines; ++i) {
    auto& [number, outline] = line->outlines.emplace_back();
    if (!from.one(number) || !from.one(contours) || contours > most_pieces) return nullptr;
    for (std::uint64_t k = 0; k < contours; ++k)
      if (!from.block(outline.emplace_back())) return nullptr;
  }
  return sound(*line) ? line : nullptr;
}

// Returns false if nothing valid was read.
template <class T>
bool keep(std::shared_ptr<const T> read, Parsed& out) {
  out = read;
  return read != nullptr;
}

bool take_error(Taker& from, std::uint32_t detail, Parsed& out) {
  const std::uint32_t code = detail & 0xff, needs = detail >> 8;
  Error e;
  if (code > static_cast<std::uint32_t>(ErrorCode::machine) || needs > static_cast<std::uint32_t>(Permission::tex) ||
      !take_words(from, e.message) || !take_words(from, e.hint))
    return false;
  e.code = static_cast<ErrorCode>(code), e.needs = static_cast<Permission>(needs);
  return out = std::move(e), true;
}

bool take(Taker& from, Parsed& out) {
  Head head;
  if (!from.one(head)) return false;
  switch (static_cast<Holds>(head.holds)) {
    case Holds::mesh:
      return keep(take_mesh(from), out);
    case Holds::picture:
      return keep(take_picture<Picture>(from), out);
    case Holds::error:
      return take_error(from, head.detail, out);
    case Holds::scene:
      return keep(take_scene(from), out);
    case Holds::drawing:
      return keep(take_drawing(from), out);
    case Holds::linear_picture:
      return keep(take_picture<LinearPicture>(from), out);
    case Holds::letters:
      return keep(take_letters(from), out);
    case Holds::table:
      return keep(take_table(from), out);
    case Holds::colors:
      return keep(take_colors(from), out);
  }
  return false;
}

}  // namespace

int read_parsed(int memory, Parsed& out) {
  struct stat about {};
  if (::fstat(memory, &about) != 0) return errno;
  // Its size must be backed by allocated memory.
  const auto size = static_cast<std::uint64_t>(about.st_size);
#ifndef __EMSCRIPTEN__  // there, files are always in memory
  if (static_cast<std::uint64_t>(about.st_blocks) * 512 < size) return EBADMSG;
#endif
  if (!S_ISREG(about.st_mode)) return EBADMSG;
  Taker from(memory, size);
  return take(from, out) && from.done() ? 0 : EBADMSG;
}

}  // namespace betwixt
