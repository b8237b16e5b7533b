// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Videos of scripts.
#pragma once

#include <filesystem>
#include <string>

#include "commands/command.h"

namespace betwixt {

// Loads a video, the value of a function, into the scene, by its path in the script.
bool video_of_file(Command&, FunctionId, const std::string& path, const std::filesystem::path& where,
                   std::string_view about);
// Checks a video that `create` makes. It shows its own colours, unless the script says another material.
bool complete_video(Command&, Object&, std::string_view about);

}  // namespace betwixt
