// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// All or nothing: restores a scene at the end of a scope, unless `keep` has been called.
#pragma once

#include <utility>

#include "scene/document.h"

namespace betwixt {

class [[nodiscard]] Rollback {
 public:
  explicit Rollback(Scene& scene) : scene_(scene), before_(scene) {}
  Rollback(const Rollback&) = delete;
  Rollback& operator=(const Rollback&) = delete;
  ~Rollback() {
    if (!kept_) scene_ = std::move(before_);
  }

  const Scene& before() const { return before_; }  // as it was, kept or not
  void keep() { kept_ = true; }

 private:
  Scene& scene_;
  Scene before_;
  bool kept_ = false;
};

}  // namespace betwixt
