// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a document takes.
#pragma once

#include <cstddef>

#include "betwixt/document.h"

namespace betwixt {

struct SceneSize {
  std::size_t bytes = 0;   // of objects, their names, values, tracks and events; meshes and pictures are not counted
  std::size_t events = 0;  // of tracks
};
SceneSize size_of(const Scene&);
// About how many bytes are kept for the sake of `before` alone, where `after` is what an edit made of it.
std::size_t bytes_apart(const Scene& before, const Scene& after);

}  // namespace betwixt
