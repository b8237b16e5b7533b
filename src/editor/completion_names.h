// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of names for completion.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/document.h"

namespace betwixt {

using Words = std::vector<std::string>;

void own_words(const Scene&, Role, Words& all);  // of procedures with this role
void filters(const Scene&, Words& all);
void files(const std::filesystem::path& folder, Words& all);
void objects_of(const Scene&, Kind, Words& all);
void columns_of_tables(const Scene&, Words& all);  // "pop.people"
// The names defined by `let`: those of colours, or all others, with the columns of tables.
void let_names(const Scene&, bool colors, Words& all);
// The parameters of a part, "height=", and the functions of its group. Returns false if there is no such part.
bool parameters_of_part(const Scene&, std::string_view part, Words& all);

}  // namespace betwixt
