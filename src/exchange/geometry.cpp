// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/geometry.h"

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <tuple>
#include <unordered_map>

#include "exchange/outlines.h"
#include "exchange/shapes.h"
#include "exchange/simplify.h"
#include "scene/kinds.h"
#include "scene/primitives.h"
#include "scene/strokes.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

std::size_t mixed(std::size_t h, std::size_t with) { return (h ^ with) * 0x9e3779b97f4a7c15ULL + (h >> 29); }
std::size_t mixed(std::size_t h, double with) { return mixed(h, std::hash<double>{}(with)); }
std::size_t mixed(std::size_t h, Vec3 with) { return mixed(mixed(mixed(h, with.x), with.y), with.z); }

// The input of a mesh.
struct Key {
  Shape shape;
  Detail detail;
  friend bool operator==(const Key&, const Key&) = default;
};
struct KeyHash {
  std::size_t operator()(const Key& k) const {
    const Shape& s = k.shape;
    std::size_t h =
        mixed(static_cast<std::size_t>(s.kind), static_cast<std::size_t>(2 * k.detail.around + k.detail.even));
    h = mixed(h, std::hash<const Mesh*>{}(s.mesh.get()));
    h = mixed(h, std::hash<const Outline*>{}(s.formula.get()));
    h = mixed(h, s.size);
    for (const auto measure : shape_measures) h = mixed(h, s.*measure);
    h = mixed(mixed(h, s.stroke), static_cast<std::size_t>(s.filled));
    for (const auto* points : {&s.points, &s.holes})
      for (const Vec3 p : **points) h = mixed(h, p);
    return mixed(mixed(mixed(h, std::hash<std::string>{}(*s.text)), std::hash<std::string>{}(*s.font)),
                 std::size_t{s.letters.typed});
  }
};

// A cache of meshes that someone holds. Removes expired entries whenever its size has doubled.
class Held {
 public:
  template <class Make>
  std::shared_ptr<const Mesh> get(const Key& key, Make make) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto i = meshes_.find(key); i != meshes_.end())
        if (auto mesh = i->second.lock()) return mesh;
    }
    auto made = std::make_shared<const Mesh>(make());  // outside the lock, because it may take long
    const std::lock_guard lock(mutex_);
    auto& place = meshes_[key];
    if (auto mesh = place.lock()) return mesh;  // another thread was faster
    place = made;
    if (meshes_.size() > limit_) {
      std::erase_if(meshes_, [](const auto& m) { return m.second.expired(); });
      limit_ = std::max<std::size_t>(64, 2 * meshes_.size());
    }
    return made;
  }

 private:
  std::mutex mutex_;
  std::unordered_map<Key, std::weak_ptr<const Mesh>, KeyHash> meshes_;
  std::size_t limit_ = 64;
};

// Returns an invertible scale: a flat shape gets an invisible thickness, so that its normals have a direction.
std::optional<Mat4> stretch(Vec3 s) {
  const double most = std::max({std::abs(s.x), std::abs(s.y), std::abs(s.z)});
  if (!sane(s) || !(most > 0)) return {};
  for (int i = 0; i < 3; ++i) s[i] = std::max(std::abs(s[i]), 1e-5 * most);
  return scaling(s);
}

// Filled glyphs at 1 m an em, shared by all texts.
class FilledGlyphs {
 public:
  std::shared_ptr<const Mesh> get(const Typeface& face, const SetText::Glyph& glyph, double depth) {
    const auto key = std::tuple(face, glyph.number, depth);
    {
      const std::lock_guard lock(mutex_);
      if (const auto known = meshes_.find(key); known != meshes_.end()) return known->second;
    }
    auto made = std::make_shared<const Mesh>(fill(glyph.outline, depth));
    const std::lock_guard lock(mutex_);
    if (meshes_.size() >= most) meshes_.clear();
    return meshes_.emplace(key, std::move(made)).first->second;
  }

 private:
  static constexpr std::size_t most = 4096;
  std::mutex mutex_;
  std::map<std::tuple<Typeface, std::uint32_t, double>, std::shared_ptr<const Mesh>> meshes_;
};

void append(Mesh& all, const Mesh& one, double size, Vec3 at) {
  const auto base = static_cast<std::uint32_t>(all.positions.size());
  for (const auto& p : one.positions) all.positions.push_back(narrow(size * (Vec3{p[0], p[1], p[2]} + at)));
  all.normals.insert(all.normals.end(), one.normals.begin(), one.normals.end());
  for (const std::uint32_t i : one.triangles) all.triangles.push_back(base + i);
  for (const std::uint32_t i : one.edges) all.edges.push_back(base + i);
}

Mesh text_mesh(const Shape& s) {
  static FilledGlyphs filled;
  Mesh all;
  const double size = s.size.y;
  if (!sane(s.size.y) || !(size > 0) || !sane(s.depth)) return all;
  const SetText set = set_text(*s.text, *s.font, s.letters);
  const Typeface face{*s.font, s.letters.weight, s.letters.italic};
  std::vector<std::shared_ptr<const Mesh>> glyphs;
  for (const SetText::Glyph& g : set.glyphs) glyphs.push_back(filled.get(face, g, std::max(s.depth / size, 0.0)));
  for (const SetText::Place& p : set.places) append(all, *glyphs[p.glyph], size, p.at);
  all.closed = !glyphs.empty() && std::all_of(set.places.begin(), set.places.end(),
                                              [&](const SetText::Place& p) { return glyphs[p.glyph]->closed; });
  return all;
}

Mesh made(const KindRow& row, const Shape& s, const Detail& detail) {
  if (!by_contours(s)) return row.mesh(s, detail);
  const Pen pen = pen_of(s);
  if (!row.contours && !s.formula && pen.fills && !(pen.width > 0)) return text_mesh(s);
  // A contour that crosses itself is filled wherever it encloses something. Holes are always cut out.
  return drawn(outline_of(s), pen, sane(s.depth) ? s.depth : 0,
               s.holes->empty() ? Winding::nonzero : Winding::positive);
}

}  // namespace

Outline outline_of(const Shape& s) {
  const KindRow& row = row_of(s.kind);
  if (row.fill != Fill::outline && !row.contours) return {};
  if (row.contours) {
    Outline outline{row.contours(s), {}};
    if (!outline.contours.empty()) outline.letters.emplace_back();
    return outline;
  }
  if (!sane(s.size.y) || !(s.size.y > 0) || !sane(s.depth)) return {};
  if (s.formula) return set_formula(s);
  Outline outline = text_outline(*s.text, *s.font, s.letters);
  for (auto& contour : outline.contours)
    for (auto& p : contour) p = s.size.y * p;
  return outline;
}

Geometry geometry_of(const Item& item, int around) {
  const Detail detail{around, true};
  return item.toward ? realise_blend(*item.shape, *item.toward, item.blend, detail) : realise(*item.shape, detail);
}

Geometry realise(const Shape& shape, const Detail& detail) {
  static const auto empty = std::make_shared<const Mesh>();
  static Held held;
  const KindRow& row = row_of(shape.kind);
  if (row.fill == Fill::nothing) return {empty, {}};
  if (row.fill == Fill::file) return {shape.mesh ? simplified(shape.mesh, detail) : empty, {}};
  Geometry g;
  const bool outlined = by_contours(shape);
  Key key{shape, row.detailed && !outlined ? detail : Detail{}};
  if (row.measures && !outlined) {
    const Vec3 m = row.measures(shape);
    const auto local = stretch(m);
    if (!local) return {empty, {}};
    g.local = *local;
    key.shape = {};  // all shapes of the kind share a mesh
    key.shape.kind = shape.kind;
    // The circles of these kinds are about y.
    if (row.detailed && !detail.even) key.detail.around = detail.around_thin(m.x / std::max({m.x, m.y / 2, m.z}));
  }
  g.mesh = held.get(key, [&] { return made(row, key.shape, key.detail); });
  return g;
}

}  // namespace betwixt
