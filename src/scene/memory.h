// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The memory of documents.
#pragma once

#include <cstddef>
#include <memory>
#include <unordered_set>

#include "betwixt/document.h"
#include "betwixt/linear_picture.h"
#include "betwixt/mesh.h"
#include "betwixt/setting.h"
#include "betwixt/sound.h"
#include "scene/outline.h"
#include "scene/spoken_words.h"

namespace betwixt {

struct Table;
class Video;

struct SceneSize {
  std::size_t bytes = 0;   // of objects, their names, values, tracks and events, without meshes and pictures
  std::size_t events = 0;  // of tracks
};
SceneSize size_of(const Scene&);
// Estimates the bytes that only `before` needs, where `after` is the result of an edit of it.
std::size_t bytes_apart(const Scene& before, const Scene& after);

std::size_t bytes_of(const Mesh&);  // without its pictures and its rig
std::size_t bytes_of(const Rig&);
// Adds up the bytes of the contents of files. What several share counts once.
class ContentBytes {
 public:
  void add(const std::shared_ptr<const Mesh>&);  // with its pictures and its rig
  void add(const std::shared_ptr<const Picture>&);
  void add(const std::shared_ptr<const LinearPicture>&);
  void add(const std::shared_ptr<const ColorTable>&);
  void add(const std::shared_ptr<const Sound>&);
  void add(const std::shared_ptr<const Video>&);
  void add(const std::shared_ptr<const SpokenWords>&);
  void add(const std::shared_ptr<const OwnFont>&);
  void add(const std::shared_ptr<const Outline>&);
  void add(const std::shared_ptr<const Table>&);
  std::size_t sum() const { return sum_; }

 private:
  bool first(const void* thing) { return thing != nullptr && seen_.insert(thing).second; }
  std::unordered_set<const void*> seen_;
  std::size_t sum_ = 0;
};

// Returns the bytes of texts, points, lists of names, code and the contents of files. What several share counts once.
// Reads the whole scene.
std::size_t bytes_of_values(const Scene&);

}  // namespace betwixt
