// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Exports films as motion, not as pixels, for other programs.
//
// Room: export
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/keys.h"

namespace betwixt {

struct ExportOptions {
  std::string path;               // the extension gives the format: .glb .gltf …
  Time from, until;               // the segment to export; in the file it begins at time 0
  KeyOptions keys;                // if its go_on returns false, no file is written
  std::vector<ObjectId> objects;  // the objects to export; all if empty
  bool overwrite = true;
};

struct Exported {
  std::size_t objects = 0;
  std::size_t channels = 0;         // channels that vary
  std::size_t keys = 0, baked = 0;  // keys: their keys; baked: how many one key a frame would make
  std::size_t bytes = 0;
  std::vector<std::string> left_out;  // what the format cannot express, each once, in words
};

// Writes the file. Errors: range (an unknown extension, something that the format cannot hold), file, machine.
Result<Exported> export_film(const Program&, const ExportOptions&);

struct ExportFormat {
  std::string_view ending;    // ".glb"
  std::string_view sentence;  // "glTF 2.0, all in one file"
};
std::vector<ExportFormat> export_formats();

// Returns the default options for a file of this name. The style is `asked`. If that is not given, it is the style that
// all programs play alike which read the format. The tolerance is 0.1 mm, and 1 mm for straight keys.
KeyOptions usual_keys(std::string_view path, std::optional<KeyStyle> asked = {});

}  // namespace betwixt
