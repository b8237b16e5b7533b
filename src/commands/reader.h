// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Carries out a text on a scene, line by line: commands, and the rows of sheets. A command that cannot be carried out
// changes nothing and says why.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "commands/script.h"

namespace betwixt {

// As if it stood where the author's script does; within the script, as if it stood in its place.
void read_file(Scene&, Script&, const std::string& path);
void read_text(Scene&, Script&, std::string_view text, const std::string& name);

// load_text of a text that somebody is writing: meshes, pictures and sounds that the film before named too are as they
// were when they were read for that.
Loaded load_text_again(std::string_view text, const std::string& name, const LoadOptions&, const Document& before);

// One logical line of a live author: a command, or a row of the sheet that an earlier one left open.
void read_line(Scene&, Script&, std::string_view line, const std::string& name);

// The names that a line makes, or would have made, had it not been refused, those that nothing had in the scene; and
// the name that an error of a name is about. Where they are the same, the one follows from the other. "title/" stands
// for all that `split title` makes.
std::vector<std::string> names_made(std::string_view line);
std::vector<std::string> names_missed(const Scene&, std::string_view line);
std::string_view name_missed(const Error&);
// "man/arm/hand" is below "man/arm/", "man/arm", "man/" and "man": all of them, itself first.
std::vector<std::string_view> with_those_above(std::string_view name);

}  // namespace betwixt
