// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads what look files (.cube and others) and OpenColorIO configurations make of colours.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "betwixt/result.h"
#include "betwixt/setting.h"
#include "exchange/file_source.h"

namespace betwixt {

// What is asked of the file.
struct ColorQuery {
  std::string display = {}, through = {}, look = {}, space = {};  // of a configuration; "": its default
  bool of_light = false;                                          // a look file takes light, instead of signals
};

bool is_configuration(std::string_view path);
// Reads it in a process of its own. A configuration can name files in its own folder only. Errors: file, name (a
// display, a view or a look that it has not), range (a table too large), machine (no OpenColorIO).
Result<std::shared_ptr<const ColorTable>> load_colors(const std::string& path, const ColorQuery&, const MayRead&);
// Reads it in this process. `asked`: a query as text.
Result<std::shared_ptr<const ColorTable>> parse_colors(const std::string& path, FileSource&, std::string_view asked);
// Returns what parse_colors() reads as this table, under any name: for pages, which have no OpenColorIO.
std::string packed_colors(const ColorTable&);

std::string text_of_query(const ColorQuery&);
ColorQuery query_of_text(std::string_view);

// What reads all files but .cube: betwixt-parser has it, where it was built with OpenColorIO (color_program.cpp).
using BakeColors = Result<std::shared_ptr<const ColorTable>> (*)(const std::string& path, FileSource&,
                                                                 const ColorQuery&);
inline BakeColors bake_colors = nullptr;

}  // namespace betwixt
