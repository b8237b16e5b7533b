// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the readers of scene files share: the scene that they make, unique names, and what is left out, each once.
#pragma once

#include <set>
#include <string>

#include "exchange/scene_file.h"
#include "exchange/scene_names.h"

namespace betwixt {

class SceneMaker {
 protected:
  void leave_out(std::string sentence) {
    if (said_.insert(sentence).second) out_.left_out.push_back(std::move(sentence));
  }

  SceneFile out_;
  SceneNames names_;

 private:
  std::set<std::string> said_;
};

// Opens a file as a Model and reads it by a Reader.
template <class Model, class Reader>
Result<std::shared_ptr<const SceneFile>> read_scene(const std::string& path, FileSource& files) {
  auto file = Model::open(path, files, "scene");
  if (!file) return file.error();
  return Reader(**file).read();
}

}  // namespace betwixt
