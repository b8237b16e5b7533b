// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Serializes the result of a parser process.
#include <cstring>
#include <map>

#include "base/files.h"
#include "exchange/wire_finish.h"
#include "exchange/wire_format.h"
#include "exchange/wire_layout.h"

namespace betwixt {
namespace {

using namespace wire;

std::uint32_t detail_of(const Error& e) {
  return static_cast<std::uint32_t>(e.code) | static_cast<std::uint32_t>(e.needs) << 8;
}

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
  template <class P>  // a Picture or a LinearPicture
  void picture(const P& p) {
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
  void finish(const Finish& f) {
    FlatFinish flat;
    for (std::size_t i = 0; i < std::size(finish_numbers); ++i) flat.numbers[i] = f.*finish_numbers[i].is;
    flat.emission = f.emission, flat.sheen = f.sheen;
    std::vector<const Picture*> pictures;
    for (std::size_t i = 0; i < std::size(finish_pictures); ++i) {
      const Picture* const p = (f.*finish_pictures[i]).get();
      if (p == nullptr) continue;
      const auto at = std::find(pictures.begin(), pictures.end(), p);
      flat.which[i] = static_cast<std::uint32_t>(at - pictures.begin());
      if (at == pictures.end()) pictures.push_back(p);
    }
    flat.pictures = static_cast<std::uint32_t>(pictures.size());
    one(flat);
    for (const Picture* p : pictures) picture(*p);
  }
  void scene(const SceneFile& s) {
    one(Head{static_cast<std::uint32_t>(Holds::scene), 0});
    one(FlatScene{s.nodes.size(), s.meshes.size(), s.clips.size(), s.left_out.size()});
    for (const SceneMesh& m : s.meshes) {
      one(FlatSurface{static_cast<std::uint32_t>(m.material), m.finish ? 1U : 0U, m.shininess, m.transparency});
      if (m.finish) finish(*m.finish);
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
  static FlatGradient flat_gradient(const DrawnGradient& g) {
    return {g.kind, g.spread, g.turn, {g.move_x, g.move_y}, g.size};
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
                        {flat_gradient(t.gradient), flat_gradient(t.stroke_gradient)},
                        t.points.size(),
                        t.holes.size()});
      points.insert(points.end(), t.points.begin(), t.points.end());
      points.insert(points.end(), t.holes.begin(), t.holes.end());
      for (const std::string* line : {&t.name, &t.gradient.stops, &t.stroke_gradient.stops}) {
        names.insert(names.end(), line->begin(), line->end());
        names.push_back('\n');
      }
    }
    one(Head{static_cast<std::uint32_t>(Holds::drawing), 0});
    one(FlatDrawing{d.width, d.left_out.size()});
    block(things), block(points), block(names);
    for (const std::string& sentence : d.left_out) block(sentence.substr(0, longest_words));
  }
  void letters(const ShapedLine& line) {
    one(Head{static_cast<std::uint32_t>(Holds::letters), 0});
    block(line.glyphs), one(static_cast<std::uint64_t>(line.outlines.size()));
    for (const auto& [number, contours] : line.outlines) {
      one(number), one(static_cast<std::uint64_t>(contours.size()));
      for (const auto& contour : contours) block(contour);
    }
  }
  void error(const Error& e) {
    one(Head{static_cast<std::uint32_t>(Holds::error), detail_of(e)});
    block(e.message.substr(0, longest_words)), block(e.hint.substr(0, longest_words));
  }
  int reason() const { return reason_; }

 private:
  void raw(const void* bytes, std::size_t size) {
    if (reason_ == 0) reason_ = write_all(memory_, {static_cast<const char*>(bytes), size});
  }
  int memory_, reason_ = 0;
};

}  // namespace

int write_parsed(const Parsed& parsed, int memory) {
  Giver to(memory);
  if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&parsed)) {
    to.one(Head{static_cast<std::uint32_t>(Holds::mesh), 0});
    to.mesh(**mesh);
  } else if (const auto* picture = std::get_if<std::shared_ptr<const Picture>>(&parsed)) {
    to.one(Head{static_cast<std::uint32_t>(Holds::picture), 0});
    to.picture(**picture);
  } else if (const auto* linear = std::get_if<std::shared_ptr<const LinearPicture>>(&parsed)) {
    to.one(Head{static_cast<std::uint32_t>(Holds::linear_picture), 0});
    to.picture(**linear);
  } else if (const auto* scene = std::get_if<std::shared_ptr<const SceneFile>>(&parsed)) {
    to.scene(**scene);
  } else if (const auto* drawing = std::get_if<std::shared_ptr<const DrawingFile>>(&parsed)) {
    to.drawing(**drawing);
  } else if (const auto* letters = std::get_if<std::shared_ptr<const ShapedLine>>(&parsed)) {
    to.letters(**letters);
  } else if (const auto* table = std::get_if<std::shared_ptr<const TableText>>(&parsed)) {
    to.one(Head{static_cast<std::uint32_t>(Holds::table), 0});
    to.block((*table)->text);
  } else if (const auto* colors = std::get_if<std::shared_ptr<const ColorTable>>(&parsed)) {
    const ColorTable& t = **colors;
    to.one(Head{static_cast<std::uint32_t>(Holds::colors), 0});
    to.one(FlatColors{t.takes, t.cube, static_cast<std::uint32_t>(t.size), t.least, t.most});
    to.block(t.signals);
  } else {
    to.error(std::get<Error>(parsed));
  }
  return to.reason();
}

}  // namespace betwixt
