// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The contents of a scene file in any format: a hierarchy of nodes, their meshes, cameras and lights, and tracks.
// tinygltf reads glTF; assimp reads BVH, FBX and Collada.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/finish.h"
#include "betwixt/shape.h"
#include "exchange/file_source.h"
#include "scene/rig.h"

namespace betwixt {

struct SceneNode {
  std::string name;          // unique; valid as a part of an object's name
  std::int32_t parent = -1;  // a node before this one
  Vec3 position;
  Quat rotation;
  Vec3 scale{1, 1, 1};
  std::int32_t mesh = -1, camera = -1, light = -1;
  std::vector<std::uint32_t> joints;  // nodes that the mesh follows, in the order of its rig
  std::vector<double> weights;        // of the mesh's targets
};

struct SceneMesh {
  std::string name;  // unique
  std::shared_ptr<const Mesh> mesh;
  Material material = Material::plastic;
  double shininess = 0, transparency = 0;
  std::shared_ptr<const Finish> finish;  // null if material and shininess say all of it
};

struct SceneCamera {
  double fov = 0;     // horizontal, radians; 0 if orthographic
  double height = 0;  // of an orthographic view
};

struct SceneLight {
  bool sun = false;  // directional: it shines along -z of its node
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
  // `width` numbers for each time, x y z w for rotations; for `cubic` the in-tangent, the value, the out-tangent.
  std::vector<double> values;
  std::size_t width() const { return times.empty() ? 0 : values.size() / times.size() / (way == cubic ? 3 : 1); }
};

struct SceneClip {
  std::string name;  // from the file; may be empty
  std::vector<SceneTrack> tracks;
};

struct SceneFile {
  std::vector<SceneNode> nodes;
  std::vector<SceneMesh> meshes;
  std::vector<SceneCamera> cameras;
  std::vector<SceneLight> lights;
  std::vector<SceneClip> clips;
  std::vector<std::string> left_out;  // sentences about features of the file that are not supported
};

inline constexpr std::size_t most_joints = 1000, most_nodes = 100'000, most_scene_numbers = 100'000'000;

// Reads a scene in a process of its own. Errors: file.
Result<std::shared_ptr<const SceneFile>> load_scene(const std::string& path, const MayRead& may_read,
                                                    bool any_size = false);
// Reads it in this process, without protection.
Result<std::shared_ptr<const SceneFile>> parse_scene(const std::string& path, FileSource&);
Result<std::shared_ptr<const SceneFile>> load_gltf_scene(const std::string& path, FileSource&);
Result<std::shared_ptr<const SceneFile>> load_scene_by_assimp(const std::string& path, FileSource&);

// Returns the mesh's scene from a path such as truck.glb#Wheels: the part before the mark, or the whole path without
// one.
std::string scene_of(const std::string& path);

// The pictures of a finish and their names in paths such as helmet.glb#Helmet/normals.
struct NamedPicture {
  std::string_view name;
  std::shared_ptr<const Picture> Finish::*is;
};
std::span<const NamedPicture> pictures_of_finish();

// Decomposes a matrix into position, rotation and scale. Returns false if it is skewed, which these cannot express.
bool put_transform(const Mat4&, SceneNode&);
// Returns whether all indices are in range and all numbers finite.
bool sound(const SceneFile&);

}  // namespace betwixt
