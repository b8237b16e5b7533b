// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the motion of a glTF file, as assimp reads it, with the film. Interpolates linearly between keys, as
// programs that use assimp do.
//   assimp FILE.glb VALUES.json   VALUES.json is the output of `betwixt eval --json` for NAME.world of all objects
// Prints the largest difference of an element of a matrix, and its object and time.
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

namespace {

aiVector3D between(const aiVector3D& a, const aiVector3D& b, float u) { return a + (b - a) * u; }
aiQuaternion between(const aiQuaternion& a, const aiQuaternion& b, float u) {
  aiQuaternion out;
  aiQuaternion::Interpolate(out, a, b, u);
  return out.Normalize();
}

template <class Value, class Key>
Value at(const Key* keys, unsigned count, double t) {
  const Key* next = std::upper_bound(keys, keys + count, t, [](double time, const Key& k) { return time < k.mTime; });
  if (next == keys) return keys[0].mValue;
  if (next == keys + count) return keys[count - 1].mValue;
  const Key& last = next[-1];
  return between(last.mValue, next->mValue, static_cast<float>((t - last.mTime) / (next->mTime - last.mTime)));
}

// Scaled first: the constructor of three parts would turn first.
aiMatrix4x4 put_together(const aiVector3D& place, const aiQuaternion& turn, const aiVector3D& growth) {
  aiMatrix4x4 move, grow;
  aiMatrix4x4::Translation(place, move), aiMatrix4x4::Scaling(growth, grow);
  return move * aiMatrix4x4(turn.GetMatrix()) * grow;
}

struct Film {
  std::map<std::string, const aiNodeAnim*> channels;
  std::map<std::string, aiMatrix4x4> worlds;

  void place(const aiNode& n, const aiMatrix4x4& above, double ticks) {
    aiMatrix4x4 own = n.mTransformation;
    if (const auto c = channels.find(n.mName.C_Str()); c != channels.end())
      own = put_together(at<aiVector3D>(c->second->mPositionKeys, c->second->mNumPositionKeys, ticks),
                         at<aiQuaternion>(c->second->mRotationKeys, c->second->mNumRotationKeys, ticks),
                         at<aiVector3D>(c->second->mScalingKeys, c->second->mNumScalingKeys, ticks));
    const aiMatrix4x4 world = above * own;
    worlds[n.mName.C_Str()] = world;
    for (unsigned i = 0; i < n.mNumChildren; ++i) place(*n.mChildren[i], world, ticks);
  }
};

}  // namespace

int main(int, char** words) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(words[1], 0);
  if (!scene) return std::cerr << importer.GetErrorString() << '\n', 1;
  Film film;
  double per_second = 1000;
  for (unsigned a = 0; a < scene->mNumAnimations; ++a) {
    const aiAnimation& all = *scene->mAnimations[a];
    if (all.mTicksPerSecond > 0) per_second = all.mTicksPerSecond;
    for (unsigned i = 0; i < all.mNumChannels; ++i)
      film.channels[all.mChannels[i]->mNodeName.C_Str()] = all.mChannels[i];
  }
  std::ifstream in(words[2]);
  const auto answers = nlohmann::json::parse(in);
  double most = 0;
  std::string where;
  std::size_t compared = 0;
  for (const auto& frame : answers["times"]) {
    const double seconds = frame["seconds"].get<double>() - answers["from"].get<double>();
    film.place(*scene->mRootNode, {}, seconds * per_second);
    for (const auto& [target, world] : frame["values"].items()) {
      const std::string name = target.substr(0, target.size() - std::string(".world").size());
      auto found = film.worlds.find(name + " turned");
      if (found == film.worlds.end()) found = film.worlds.find(name);
      if (found == film.worlds.end()) continue;
      ++compared;
      for (unsigned r = 0; r < 3; ++r)
        for (unsigned c = 0; c < 4; ++c) {
          const double off = std::abs(found->second[r][c] - world[4 * r + c].get<double>());
          if (!(off <= most)) most = off, where = name + " at " + std::to_string(seconds) + " s";
        }
    }
  }
  std::cout << nlohmann::json{{"most", most}, {"where", where}, {"compared", compared}} << '\n';
}
