// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a file of a scene holds, whatever its format: nodes that hang on each other, what is seen of them, and tracks.
// glTF is read by tinygltf; BVH, FBX and Collada by assimp.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "betwixt/shape.h"
#include "exchange/shelf.h"
#include "scene/rig.h"

namespace betwixt {

struct SceneNode {
  std::string name;          // a part of an object's name; no two are the same
  std::int32_t parent = -1;  // a node before this one
  Vec3 position;
  Quat rotation;
  Vec3 scale{1, 1, 1};
  std::int32_t mesh = -1, camera = -1, light = -1;
  std::vector<std::uint32_t> joints;  // nodes that the mesh follows, by the numbers of its rig
  std::vector<double> weights;        // of the mesh's targets
};

struct SceneMesh {
  std::string name;  // no two are the same
  std::shared_ptr<const Mesh> mesh;
  Material material = Material::plastic;
  double shininess = 0, transparency = 0;
};

struct SceneCamera {
  double fov = 0;     // horizontal, radians; 0: it is orthographic
  double height = 0;  // that it then sees
};

struct SceneLight {
  bool sun = false;  // it shines along -z of its node
  Vec3 color{1, 1, 1};
  double intensity = 1;
  double range = 20;
};

struct SceneTrack {
  enum Path : std::uint32_t { position, rotation, scale, weights };
  enum Way : std::uint32_t { step, linear, cubic };
  std::uint32_t node = 0;
  Path path = position;
  Way way = linear;
  std::vector<double> times;  // seconds, rising
  std::vector<double>
      values;  // `width` of each time, of turns x y z w; of `cubic` the tangent in, the value, the tangent out
  std::size_t width() const { return times.empty() ? 0 : values.size() / times.size() / (way == cubic ? 3 : 1); }
};

struct SceneClip {
  std::string name;  // as the file has it, may be empty
  std::vector<SceneTrack> tracks;
};

struct SceneFile {
  std::vector<SceneNode> nodes;
  std::vector<SceneMesh> meshes;
  std::vector<SceneCamera> cameras;
  std::vector<SceneLight> lights;
  std::vector<SceneClip> clips;
  std::vector<std::string> left_out;  // sentences: what of it cannot come through
};

inline constexpr std::size_t most_joints = 1000, most_nodes = 100'000, most_scene_numbers = 100'000'000;

// Reads a scene in a process of its own. Errors: file.
Result<std::shared_ptr<const SceneFile>> load_scene(const std::string& path, const MayRead& may_read,
                                                    bool any_size = false);
// The same in this process, whatever the file does to it.
Result<std::shared_ptr<const SceneFile>> parse_scene(const std::string& path, Shelf&);
Result<std::shared_ptr<const SceneFile>> load_gltf_scene(const std::string& path, Shelf&);
Result<std::shared_ptr<const SceneFile>> load_scene_by_assimp(const std::string& path, Shelf&);

// The mesh of a scene that a path with a mark names: truck.glb#Wheels. The part before the mark; or all, without one.
std::string scene_of(const std::string& path);

// Takes a matrix apart into place, turn and scale. False: it is skewed, which these cannot be.
bool put_transform(const Mat4&, SceneNode&);
// Whether all indices lead somewhere, and all numbers are some.
bool sound(const SceneFile&);

}  // namespace betwixt
