// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The lights and the cameras of a glTF file.
#pragma once

#include "export/gltf_nodes.h"

namespace betwixt::gltf {

class Views {
 public:
  Views(const Program& program, const ExportOptions& options, Timeline& film, Nodes& nodes)
      : program_(program), document_(program.document()), options_(options), film_(film), nodes_(nodes) {}

  void add_lights();
  void add_cameras();

  Json lights = Json::array(), cameras = Json::array();

 private:
  std::size_t sun(ObjectId);
  std::size_t add_camera(std::size_t node, const std::string& name, Json camera);

  const Program& program_;
  const Document& document_;
  const ExportOptions& options_;
  Timeline& film_;
  Nodes& nodes_;
};

}  // namespace betwixt::gltf
