// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A cache of meshes; the key is the input that a mesh is made from.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "betwixt/mesh.h"
#include "betwixt/shape.h"

namespace betwixt {

inline std::size_t mixed(std::size_t h, std::size_t with) { return (h ^ with) * 0x9e3779b97f4a7c15ULL + (h >> 29); }
inline std::size_t mixed(std::size_t h, double with) { return mixed(h, std::hash<double>{}(with)); }
inline std::size_t mixed(std::size_t h, Vec3 with) { return mixed(mixed(mixed(h, with.x), with.y), with.z); }

inline std::size_t hash_of(const Shape& s) {
  std::size_t h = mixed(static_cast<std::size_t>(s.kind), std::hash<const Mesh*>{}(s.mesh.get()));
  h = mixed(h, std::hash<const Outline*>{}(s.formula.get()));
  h = mixed(mixed(h, std::hash<std::string>{}(*s.parts)), static_cast<std::size_t>(2 * s.only_parts + s.matches));
  h = mixed(h, s.size);
  for (const auto measure : shape_measures) h = mixed(h, s.*measure);
  h = mixed(mixed(h, s.stroke), static_cast<std::size_t>(s.filled));
  for (const auto* points : {&s.points, &s.holes})
    for (const Vec3 p : **points) h = mixed(h, p);
  return mixed(mixed(mixed(h, std::hash<std::string>{}(*s.text)),
                     std::hash<std::string>{}(*s.font) ^ std::hash<std::string>{}(*s.language)),
               std::size_t{s.letters.typed});
}

// A cache of meshes that someone holds. Removes expired entries whenever its size has doubled. Safe from any thread.
template <class Key, class KeyHash>
class HeldMeshes {
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

}  // namespace betwixt
