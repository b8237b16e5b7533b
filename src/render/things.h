// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The objects of a picture, kept from picture to picture: their meshes, bounds and matrices relative to the eye,
// without invalid ones. Only differences from the previous picture are computed; the result depends on the columns
// alone.
#pragma once

#include <array>
#include <vector>

#include "render/columns.h"
#include "render/forms.h"
#include "render/view.h"

namespace betwixt {

// The data of an object for the graphics interface.
struct Instance {
  std::array<float, 12> rows;   // mesh space to eye space, row by row
  std::array<float, 9> normal;  // the same for normals, column by column; about unit size
  std::array<float, 4> color;   // linear light and opacity
  std::array<float, 2> look;    // shininess, Material
};

struct Thing {
  // From the columns.
  Mat4 world;
  Evaluation::Look look;
  std::shared_ptr<const Shape> shape, toward;
  std::shared_ptr<const Picture> picture;
  std::shared_ptr<const Finish> finish;        // null if it has none
  std::shared_ptr<const Gradients> gradients;  // the same

  bool there = false;  // whether it can be drawn; if not, the rest has no meaning
  std::shared_ptr<Form> form;
  std::shared_ptr<const StoredTexture> texture;  // its own, or null
  struct Maps {
    std::shared_ptr<const StoredTexture> normals, roughness, metalness, occlusion, emission;
  };
  Maps maps;             // of its finish
  Box gradient_box;      // in object space, if it has gradients
  Bounds bounds;         // in the world
  double size = 0;       // its largest measure from its centre
  bool surface = false;  // whether it has triangles
  bool transparent = false;
  bool mirrored = false;  // whether the matrix mirrors
  bool closed = false;    // whether its back faces are never visible
  bool round = false;     // whether it is a plain opaque sphere, not flattened
  bool casts = false;     // whether it casts shadows
  bool line = false;      // whether it is transparent once, also where it crosses itself
  bool pressed = false;   // whether it is a line that is drawn flat

  bool visible = false;  // whether it may be in the picture; if not, the rest has no meaning
  bool ball = false;     // drawn as in balls.h; the mesh is a disc
  double depth = 0;      // of the centre
  StoredMesh* mesh = nullptr;
  Instance instance;
  Mat4 to_object;  // mesh space to object space
};

// Returns the instance of an object's mesh, given the matrix from mesh space to the drawing space.
Instance instance_of(const Thing&, const Mat4& mesh_space_to_drawn);

// For `surfaces`, round objects may be drawn as balls, and meshes are as fine as their pixels; for `lines` they are
// coarser, since close lines would make a grey.
enum class Purpose : std::uint8_t { surfaces, lines };

class Things {
 public:
  Things(Purpose purpose, int width, int height) : purpose_(purpose), width_(width), height_(height) {}

  // Takes over the differences from the previous picture; returns false if there are none.
  bool take(const Columns&);

  const std::vector<Thing>& all() const { return things_; }
  const Thing& operator[](std::uint32_t i) const { return things_[i]; }
  // Its depths fit the visible objects. If the camera's numbers are not valid, nothing is visible.
  const View& view() const { return view_; }
  // The objects whose instance may differ from that in the previous picture, in order; all if the view differs.
  std::span<const std::uint32_t> changed() const { return changed_; }
  bool all_changed() const { return all_changed_; }
  // Changes whenever an object that casts shadows has changed.
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
  bool flat_ = false;     // Surroundings::flat
  bool touched_ = false;  // whether contact shading darkens the floor
  std::vector<std::uint32_t> changed_;
  std::uint64_t casters_ = 0;
};

}  // namespace betwixt
