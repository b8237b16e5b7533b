// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The memory of documents.
#pragma once

#include <cstddef>

#include "betwixt/document.h"

namespace betwixt {

struct SceneSize {
  std::size_t bytes = 0;   // of objects, their names, values, tracks and events, without meshes and pictures
  std::size_t events = 0;  // of tracks
};
SceneSize size_of(const Scene&);
// Estimates the bytes that only `before` needs, where `after` is the result of an edit of it.
std::size_t bytes_apart(const Scene& before, const Scene& after);

}  // namespace betwixt
