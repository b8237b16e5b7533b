// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Replaces functions that pages do not have by errors.
#include <fmt/format.h>

#include "base/files.h"
#include "editor/journal.h"
#include "exchange/pictures.h"
#include "exchange/scene_file.h"
#include "exchange/tex.h"
#include "procedure/plugins.h"
#include "render/plugin_renderer.h"
#include "render/traced.h"

namespace betwixt {
namespace {

Error not_here(const std::string& what) {
  return fail(ErrorCode::machine, what + " in a page", "the program betwixt does it");
}

}  // namespace

Result<std::shared_ptr<const SceneFile>> load_scene_by_assimp(const std::string& path, FileSource&) {
  return fail(ErrorCode::file, fmt::format("{} cannot be read in a page", path), "glTF (.gltf .glb) and .svg can be");
}

Result<LinearPicture> decode_exr(std::string_view, const std::string&) { return not_here("OpenEXR is not read"); }

Result<std::shared_ptr<const Outline>> set_by_tex(const std::string&, std::chrono::milliseconds) {
  return not_here("LaTeX does not set formulas");
}

std::string journal_path(const std::string&) { return {}; }  // a page keeps no journal

Result<Plugin> load_plugin(const std::string&) { return not_here("plug-ins are not loaded"); }
Result<std::unique_ptr<Renderer>> make_plugin_renderer(const RenderOptions&, int) {
  return not_here("plug-ins are not loaded");
}

Result<std::unique_ptr<Renderer>> make_traced(const RenderOptions&, unsigned) {
  return not_here("light is not traced");
}

}  // namespace betwixt
