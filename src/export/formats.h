// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a film's motion can be written as, by the ending of the file's name. Each is a row.
#pragma once

#include "betwixt/export.h"

namespace betwixt {

struct ExportRow {
  std::string_view ending, sentence;
  // The bytes of the file; says in `made` what it is, and what is left out.
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
