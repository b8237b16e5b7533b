// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/handed_over.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "base/files.h"
#include "base/names.h"

namespace betwixt {
namespace {

// A header, then blocks, each preceded by its length.
enum class Holds : std::uint32_t { mesh = 1, picture = 2, error = 3, scene = 4, drawing = 5 };
struct Head {
  std::uint32_t holds = 0;
  std::uint32_t detail = 0;  // the code of an error
};
constexpr std::uint32_t no_picture = ~std::uint32_t{0};
struct FlatMesh {
  std::uint32_t closed = 0, pictures = 0, rigged = 0, targets = 0;
};
struct FlatPart {
  std::uint32_t first = 0, count = 0;
  std::array<float, 3> color{};
  std::uint32_t picture = no_picture;
};
struct FlatDrawing {
  double width = 1;
  std::uint64_t sentences = 0;
};
struct FlatThing {
  std::uint32_t above = 0, flags = 0;  // one bit each
  double at[3]{}, color[3]{}, stroke[3]{}, stroke_width = 0, transparency = 0, trim_to = 1, dash[2]{};
  std::uint64_t points = 0, holes = 0;  // the numbers of points and holes that follow
};
enum : std::uint32_t { is_group = 1, is_filled = 2, is_stroked = 4, is_round = 8 };
struct FlatSize {
  std::int32_t width = 0, height = 0;
};
struct FlatScene {
  std::uint64_t nodes = 0, meshes = 0, clips = 0, sentences = 0;
};
struct FlatNode {
  std::int32_t parent = -1, mesh = -1, camera = -1, light = -1;
  Vec3 position;
  Quat rotation;
  Vec3 scale;
};
struct FlatSurface {
  std::uint32_t material = 0, padding = 0;
  double shininess = 0, transparency = 0;
};
struct FlatLight {
  std::uint32_t sun = 0, padding = 0;
  Vec3 color;
  double intensity = 0, range = 0;
};
struct FlatTrack {
  std::uint32_t node = 0, path = 0, way = 0;
};

constexpr std::size_t longest_words = 4096, most_pictures = 100'000, most_pieces = 1'000'000;
constexpr int largest_side = 16384;

class Giver {
 public:
  explicit Giver(int memory) : memory_(memory) {}
  template <class T>
  void one(const T& value) {
    raw(&value, sizeof value);
  }
  template <class T>
  void block(const T& all) {
    one(static_cast<std::uint64_t>(all.size()));
    raw(all.data(), all.size() * sizeof(*all.data()));
  }
  void picture(const Picture& p) {
    one(FlatSize{p.width, p.height});
    block(p.rgba);
  }
  void mesh(const Mesh& m) {
    std::map<const Picture*, std::uint32_t> numbers;
    std::vector<const Picture*> pictures;
    std::vector<FlatPart> parts;
    for (const MeshPart& p : m.parts) {
      parts.push_back({p.first, p.count, p.color, no_picture});
      if (!p.texture) continue;
      const auto [at, fresh] = numbers.try_emplace(p.texture.get(), static_cast<std::uint32_t>(pictures.size()));
      if (fresh) pictures.push_back(p.texture.get());
      parts.back().picture = at->second;
    }
    one(FlatMesh{m.closed, static_cast<std::uint32_t>(pictures.size()), m.rig != nullptr,
                 m.rig ? static_cast<std::uint32_t>(m.rig->targets.size()) : 0});
    for (const Picture* p : pictures) picture(*p);
    block(parts), block(m.positions), block(m.normals), block(m.uvs), block(m.triangles), block(m.edges);
    if (!m.rig) return;
    block(m.rig->joints), block(m.rig->weights), block(m.rig->inverse_bind);
    for (const Rig::Target& t : m.rig->targets) block(t.name), block(t.positions), block(t.normals);
  }
  void scene(const SceneFile& s) {
    one(Head{static_cast<std::uint32_t>(Holds::scene), 0});
    one(FlatScene{s.nodes.size(), s.meshes.size(), s.clips.size(), s.left_out.size()});
    for (const SceneMesh& m : s.meshes) {
      one(FlatSurface{static_cast<std::uint32_t>(m.material), 0, m.shininess, m.transparency});
      block(m.name), mesh(*m.mesh);
    }
    for (const SceneNode& n : s.nodes) {
      one(FlatNode{n.parent, n.mesh, n.camera, n.light, n.position, n.rotation, n.scale});
      block(n.name), block(n.joints), block(n.weights);
    }
    block(s.cameras);
    std::vector<FlatLight> lights;
    for (const SceneLight& l : s.lights) lights.push_back({l.sun, 0, l.color, l.intensity, l.range});
    block(lights);
    for (const SceneClip& c : s.clips) {
      block(c.name.substr(0, longest_words)), one(static_cast<std::uint64_t>(c.tracks.size()));
      for (const SceneTrack& t : c.tracks) one(FlatTrack{t.node, t.path, t.way}), block(t.times), block(t.values);
    }
    for (const std::string& sentence : s.left_out) block(sentence.substr(0, longest_words));
  }
  void drawing(const DrawingFile& d) {
    std::vector<FlatThing> things;
    std::vector<Vec3> points;
    std::vector<char> names;
    for (const DrawnThing& t : d.things) {
      things.push_back({t.above,
                        (t.group ? is_group : 0U) | (t.fills ? is_filled : 0U) | (t.strokes ? is_stroked : 0U) |
                            (t.round ? is_round : 0U),
                        {t.at.x, t.at.y, t.at.z},
                        {t.color.r, t.color.g, t.color.b},
                        {t.stroke.r, t.stroke.g, t.stroke.b},
                        t.stroke_width,
                        t.transparency,
                        t.trim_to,
                        {t.dash.x, t.dash.y},
                        t.points.size(),
                        t.holes.size()});
      points.insert(points.end(), t.points.begin(), t.points.end());
      points.insert(points.end(), t.holes.begin(), t.holes.end());
      names.insert(names.end(), t.name.begin(), t.name.end());
      names.push_back('\n');
    }
    one(Head{static_cast<std::uint32_t>(Holds::drawing), 0});
    one(FlatDrawing{d.width, d.left_out.size()});
    block(things), block(points), block(names);
    for (const std::string& sentence : d.left_out) block(sentence.substr(0, longest_words));
  }
  void error(const Error& e) {
    one(Head{static_cast<std::uint32_t>(Holds::error), static_cast<std::uint32_t>(e.code)});
    block(e.message.substr(0, longest_words)), block(e.hint.substr(0, longest_words));
  }
  int reason() const { return reason_; }

 private:
  void raw(const void* bytes, std::size_t size) {
    if (reason_ == 0) reason_ = write_all(memory_, {static_cast<const char*>(bytes), size});
  }
  int memory_, reason_ = 0;
};

// Copies everything out and reads no shared byte twice, because the other process may still be writing.
class Taker {
 public:
  Taker(int memory, std::uint64_t size) : memory_(memory), left_(size) {}
  template <class T>
  bool one(T& value) {
    return raw(&value, sizeof value);
  }
  template <class T>
  bool block(T& all) {
    std::uint64_t count = 0;
    if (!one(count) || count > left_ / sizeof(*all.data())) return false;
    all.resize(count);
    return raw(all.data(), count * sizeof(*all.data()));
  }
  bool done() const { return left_ == 0; }

 private:
  bool raw(void* to, std::uint64_t size) {
    if (size > left_) return false;
    left_ -= size;
    for (auto* at = static_cast<char*>(to); size > 0;) {
      const ssize_t n = ::pread(memory_, at, size, at_);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      at += n, at_ += n, size -= static_cast<std::uint64_t>(n);
    }
    return true;
  }
  int memory_;
  std::uint64_t left_;
  off_t at_ = 0;
};

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

std::shared_ptr<const Picture> take_picture(Taker& from) {
  FlatSize size;
  auto picture = std::make_shared<Picture>();
  if (!from.one(size) || size.width < 1 || size.height < 1 || size.width > largest_side || size.height > largest_side)
    return nullptr;
  picture->width = size.width, picture->height = size.height;
  const auto bytes = 4 * static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  return from.block(picture->rgba) && picture->rgba.size() == bytes ? picture : nullptr;
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
    pictures.push_back(take_picture(from));
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
    if (!from.one(surface) || surface.material > static_cast<std::uint32_t>(Material::glow) ||
        !take_words(from, m.name) || !is_name(m.name) || !names.insert(m.name).second || !(m.mesh = take_mesh(from)))
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

// Returns whether names are valid, groups precede their members, and all coordinates are finite.
bool sound(const DrawingFile& d) {
  std::set<std::string_view> names;
  const auto near = [](Vec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 1e9; };
  for (std::size_t i = 0; i < d.things.size(); ++i) {
    const DrawnThing& t = d.things[i];
    const bool owned = t.above == DrawnThing::nothing || (t.above < i && d.things[t.above].group);
    const auto part = [](double v) { return v >= 0 && v <= 1; };
    const auto color = [&](const Color& c) { return part(c.r) && part(c.g) && part(c.b); };
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
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos || !take_points(f.points, t.points) || !take_points(f.holes, t.holes))
      return nullptr;
    t.name = rest.substr(0, end);
    rest.remove_prefix(end + 1);
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

bool take(Taker& from, Parsed& out) {
  Head head;
  if (!from.one(head)) return false;
  if (head.holds == static_cast<std::uint32_t>(Holds::mesh)) {
    auto mesh = take_mesh(from);
    out = mesh;
    return mesh != nullptr;
  }
  if (head.holds == static_cast<std::uint32_t>(Holds::scene)) {
    auto scene = take_scene(from);
    out = scene;
    return scene != nullptr;
  }
  if (head.holds == static_cast<std::uint32_t>(Holds::drawing)) {
    auto drawing = take_drawing(from);
    out = drawing;
    return drawing != nullptr;
  }
  if (head.holds == static_cast<std::uint32_t>(Holds::picture)) {
    auto picture = take_picture(from);
    out = picture;
    return picture != nullptr;
  }
  Error e;
  if (head.holds != static_cast<std::uint32_t>(Holds::error) ||
      head.detail > static_cast<std::uint32_t>(ErrorCode::machine) || !take_words(from, e.message) ||
      !take_words(from, e.hint))
    return false;
  e.code = static_cast<ErrorCode>(head.detail);
  out = e;
  return true;
}

}  // namespace

int hand_over(const Parsed& parsed, int memory) {
  Giver to(memory);
  if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&parsed)) {
    to.one(Head{static_cast<std::uint32_t>(Holds::mesh), 0});
    to.mesh(**mesh);
  } else if (const auto* picture = std::get_if<std::shared_ptr<const Picture>>(&parsed)) {
    to.one(Head{static_cast<std::uint32_t>(Holds::picture), 0});
    to.picture(**picture);
  } else if (const auto* scene = std::get_if<std::shared_ptr<const SceneFile>>(&parsed)) {
    to.scene(**scene);
  } else if (const auto* drawing = std::get_if<std::shared_ptr<const DrawingFile>>(&parsed)) {
    to.drawing(**drawing);
  } else {
    to.error(std::get<Error>(parsed));
  }
  return to.reason();
}

int take_over(int memory, Parsed& out) {
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
