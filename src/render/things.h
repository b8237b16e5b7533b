// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What is drawn, kept from picture to picture: meshes found, bounds known, matrices relative to the eye, rubbish left
// out. Only what differs from the picture before is worked out again; what there is depends on the columns alone.
#pragma once

#include <array>
#include <vector>

#include "render/columns.h"
#include "render/forms.h"
#include "render/view.h"

namespace betwixt {

// What goes to the graphics interface for each thing.
struct Instance {
  std::array<float, 12> rows;   // mesh space to eye space, row by row
  std::array<float, 9> normal;  // the same for normals, column by column; of about unit size
  std::array<float, 4> color;   // linear light and opacity
  std::array<float, 2> look;    // shininess, Material
};

struct Thing {
  // As the columns have it.
  Mat4 world;
  Evaluation::Look look;
  std::shared_ptr<const Shape> shape, toward;
  std::shared_ptr<const Picture> picture;

  bool there = false;  // it can be drawn; else nothing of the rest is known
  std::shared_ptr<Form> form;
  std::shared_ptr<const StoredTexture> texture;  // its own, or null
  Bounds bounds;                                 // in the world
  double size = 0;                               // its largest measure from its middle
  bool surface = false;                          // it has triangles
  bool transparent = false;
  bool mirrored = false;  // the matrix turns triangles inside out
  bool closed = false;    // its back faces are never seen
  bool round = false;     // a plain solid sphere, not flat
  bool casts = false;     // keeps light from others
  bool line = false;      // seen through once, also where it crosses itself

  bool visible = false;  // perhaps in the picture; else nothing of the rest is known
  bool ball = false;     // drawn as in balls.h; the mesh is a disc
  double depth = 0;      // of the centre
  StoredMesh* mesh = nullptr;
  Instance instance;
};

// What a thing's mesh looks like through that matrix.
Instance instance_of(const Thing&, const Mat4& mesh_space_to_drawn);

// For `surfaces` round things may come as balls, and meshes as fine as their pixels; for `lines` coarser ones, since
// lines close together make only a grey.
enum class Purpose : std::uint8_t { surfaces, lines };

class Things {
 public:
  Things(Purpose purpose, int width, int height) : purpose_(purpose), width_(width), height_(height) {}

  // Takes over what differs from the picture before; false: nothing does.
  bool take(const Columns&);

  const std::vector<Thing>& all() const { return things_; }
  const Thing& operator[](std::uint32_t i) const { return things_[i]; }
  // Fits depths to what is visible. Nothing is visible where the camera's numbers cannot be used.
  const View& view() const { return view_; }
  // Whose instance may differ from that of the picture before, in order; all where the view does.
  std::span<const std::uint32_t> changed() const { return changed_; }
  bool all_changed() const { return all_changed_; }
  // Another one where any thing that keeps light from others has changed.
  std::uint64_t casters() const { return casters_; }
  Store& store() { return store_; }

 private:
  bool same(const Thing&, const Columns&, std::uint32_t) const;
  void find_changed(const Columns&);
  void adopt(Thing&, const Columns&, std::uint32_t);
  void place(Thing&);
  void see(Thing&);

  const Purpose purpose_;
  const int width_, height_;
  Store store_;
  Forms forms_;
  std::vector<Thing> things_;
  std::optional<Camera> camera_;
  View view_;
  bool good_ = false, all_changed_ = false;
  std::vector<std::uint32_t> changed_;
  std::uint64_t casters_ = 0;
};

}  // namespace betwixt
