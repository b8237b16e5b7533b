// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The formats of motion, by extension. Each is a row.
#pragma once

#include "betwixt/export.h"

namespace betwixt {

struct ExportRow {
  std::string_view ending, sentence;
  // Returns the bytes of the file; sets `made` to its counts and to everything that is left out.
  Result<std::string> (*make)(const Program&, const ExportOptions&, Exported& made) = nullptr;
  KeyStyle usual = KeyStyle::cubic;
};

std::span<const ExportRow> export_rows();

Result<std::string> make_glb(const Program&, const ExportOptions&, Exported&);
Result<std::string> make_gltf(const Program&, const ExportOptions&, Exported&);
Result<std::string> make_usda(const Program&, const ExportOptions&, Exported&);
Result<std::string> make_lottie(const Program&, const ExportOptions&, Exported&);
Result<std::string> make_css(const Program&, const ExportOptions&, Exported&);
Result<std::string> make_waapi(const Program&, const ExportOptions&, Exported&);
Result<std::string> make_svg(const Program&, const ExportOptions&, Exported&);

}  // namespace betwixt
