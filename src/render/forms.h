// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes as meshes: each is looked up once for each requested detail.
#pragma once

#include "exchange/geometry.h"
#include "render/store.h"

namespace betwixt {

// Returns whether the mesh of a shape, or of its blend, has more triangles where it is larger in the picture.
bool has_details(const Shape&, const Shape* toward);

// A shape, or its blend with another.
class Form {
 public:
  struct Realised {
    Detail detail;
    std::shared_ptr<StoredMesh> mesh;
    Mat4 local;  // mesh space to object space
  };

  Form(std::shared_ptr<const Shape> shape, std::shared_ptr<const Shape> toward, double blend);
  const Realised& at(const Detail&, Store&);
  const Realised& plain(Store& store) {
    return at({24, true}, store);
  }  // for its box, and for everything that does not depend on detail
  const Shape& shape() const { return *shape_; }
  bool blends() const { return toward_ != nullptr; }

 private:
  const std::shared_ptr<const Shape> shape_, toward_;
  const double blend_;
  const bool detailed_;
  std::vector<std::shared_ptr<const Realised>> known_;
};

class Forms {
 public:
  std::shared_ptr<Form> find(const std::shared_ptr<const Shape>&, const std::shared_ptr<const Shape>& toward,
                             double blend);
  // Drops details that were not used for some pictures.
  void next_picture();

 private:
  struct Kept {
    std::shared_ptr<Form> form;
    std::uint64_t used = 0;
  };
  std::unordered_map<const Shape*, Kept> all_;
  const Shape* latest_ = nullptr;
  std::shared_ptr<Form> latest_form_;
  std::uint64_t picture_ = 0;
};

}  // namespace betwixt
