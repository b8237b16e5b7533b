// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/geometry.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <tuple>

#include "exchange/held_meshes.h"
#include "exchange/outlines.h"
#include "exchange/shapes.h"
#include "exchange/simplify.h"
#include "scene/code_languages.h"
#include "scene/kinds.h"
#include "scene/primitives.h"
#include "scene/strokes.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

// The input of a mesh.
struct Key {
  Shape shape;
  Detail detail;
  friend bool operator==(const Key&, const Key&) = default;
};
struct KeyHash {
  std::size_t operator()(const Key& k) const {
    return mixed(hash_of(k.shape), static_cast<std::size_t>(2 * k.detail.around + k.detail.even));
  }
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
  const SetText set = set_text(*s.text, font_of(s), letters_of(s));
  const Typeface face = typeface_of(font_of(s), s.letters);
  std::vector<std::shared_ptr<const Mesh>> glyphs;
  for (const SetText::Glyph& g : set.glyphs) glyphs.push_back(filled.get(face, g, std::max(s.depth / size, 0.0)));
  for (const SetText::Place& p : set.places) append(all, *glyphs[p.glyph], size, p.at);
  all.closed = !glyphs.empty() && std::all_of(set.places.begin(), set.places.end(),
                                              [&](const SetText::Place& p) { return glyphs[p.glyph]->closed; });
  return all;
}

// Gives a rectangle, or a video, the texture coordinates of a picture that fills it.
void lay_picture(Mesh& mesh, const Shape& s) {
  if (s.kind != Kind::rectangle && s.kind != Kind::video) return;
  const Vec3 size = s.kind == Kind::video ? s.height * s.size : s.size;
  if (!(size.x > 0) || !(size.y > 0)) return;
  for (const auto& p : mesh.positions)
    mesh.uvs.push_back({static_cast<float>(0.5 + p[0] / size.x), static_cast<float>(0.5 - p[1] / size.y)});
}

Mesh made(const KindRow& row, const Shape& s, const Detail& detail) {
  if (!by_contours(s)) return row.mesh(s, detail);
  const Pen pen = pen_of(s);
  if (!row.contours && !s.formula && s.language->empty() && pen.fills && !(pen.width > 0)) return text_mesh(s);
  // A contour that crosses itself is filled wherever it encloses something. Holes are always cut out.
  Mesh mesh =
      drawn(outline_of(s), pen, sane(s.depth) ? s.depth : 0, s.holes->empty() ? Winding::nonzero : Winding::positive);
  lay_picture(mesh, s);
  return mesh;
}

// Gives the letters of code the classes of their words, and leaves out those that other parts draw.
void take_code_apart(Outline& outline, const Shape& s) {
  const auto tokens = code_tokens(*s.text, *s.language);
  for (Letter& letter : outline.letters) {
    const auto behind = std::upper_bound(tokens.begin(), tokens.end(), letter.at,
                                         [](std::size_t at, const CodeToken& t) { return at < t.at; });
    if (behind != tokens.begin()) letter.part = code_class_names[static_cast<std::size_t>((behind - 1)->is)];
  }
  keep_shown_parts(outline, s);
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
  Outline outline = text_outline(*s.text, font_of(s), letters_of(s));
  if (!s.language->empty()) take_code_apart(outline, s);
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
  static HeldMeshes<Key, KeyHash> held;
  const KindRow& row = row_of(shape.kind);
  if (row.fill == Fill::nothing) return {empty, {}};
  if (row.fill == Fill::file) return {shape.mesh ? simplified(shape.mesh, detail) : empty, {}};
  Geometry g;
  const bool outlined = by_contours(shape);
  Key key{shape, detailed(shape) && !outlined ? detail : Detail{}};
  if (row.measures && !outlined && !(row.own && row.own(shape))) {
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
