// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Films as motion, for other programs: not as pixels.
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
  std::string path;               // the ending says what is made: .glb .gltf …
  Time from, until;               // what of the film; it begins at 0 in the file
  KeyOptions keys;                // where its go_on says no, nothing is written
  std::vector<ObjectId> objects;  // whose motion; empty: everybody's
  bool overwrite = true;
};

struct Exported {
  std::size_t objects = 0;
  std::size_t channels = 0;         // that vary
  std::size_t keys = 0, baked = 0;  // of these; had all of them one a frame
  std::size_t bytes = 0;
  std::vector<std::string> left_out;  // what the format cannot say, in words, each once
};

// Errors: range (an ending that nobody knows, what the format has no way to say), file, machine.
Result<Exported> export_film(const Program&, const ExportOptions&);

struct ExportFormat {
  std::string_view ending;    // ".glb"
  std::string_view sentence;  // "glTF 2.0, all in one file"
};
std::vector<ExportFormat> export_formats();

// How a file of this name is written where nobody says otherwise: the style of keys that all programs which read the
// format play alike, or one that is asked for, and how far off that may be: a tenth of a millimetre, a whole one where
// keys go straight.
KeyOptions usual_keys(std::string_view path, std::optional<KeyStyle> asked = {});

}  // namespace betwixt
