// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs a text on a scene, line by line: commands, and the rows of sheets. A command that fails changes nothing and
// reports why.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "commands/script.h"

namespace betwixt {

// Read a text as if it were the author's script or, inside a script, as if its lines replaced the current one.
void read_file(Scene&, Script&, const std::string& path);
void read_text(Scene&, Script&, std::string_view text, const std::string& name);

// Reads a script; and again, if one of its sections waits for another one that is written below it. `make`: returns a
// Script of the scene. `ahead`: what the last reading knew of the sections.
template <class Make, class Read>
ReaderState read_settled(Scene& scene, Diagnostics& said, SectionsAhead& ahead, const Make& make, const Read& read) {
  const Scene before = scene;
  const auto heard = static_cast<std::ptrdiff_t>(said.size());
  for (;;) {
    said.erase(said.begin() + heard, said.end());
    Script script = make();
    script.ahead = ahead, script.ahead.whole = true;
    read(scene, script);
    SectionsAhead next;
    if (!look_ahead(scene, script, next)) return script;
    ahead = std::move(next);
    scene = before;
  }
}

// Like load_text, for a text that is being edited. Reuses the meshes, pictures and sounds that `before` had already
// read from the same files.
Loaded load_text_again(std::string_view text, const std::string& name, const LoadOptions&, const Document& before);

// Returns an empty scene with the contents of files that the other scene had read.
Scene with_files_of(const Scene&);

// Runs one logical line of a live author: a command, or a row of the sheet that an earlier line left open.
void read_line(Scene&, Script&, std::string_view line, const std::string& name);

// names_made(): the names that a line makes, or would have made if it had not failed. names_missed(): those of its
// names that the scene lacks. name_missed(): the name that an error of a name is about. If a missed name equals a made
// one, the error follows from the failed line. "title/" represents all names that `split title` makes.
std::vector<std::string> names_missed(const Scene&, std::string_view line);
std::string_view name_missed(const Error&);
// Returns whether the error is that the line's first word is no command, without a hint.
bool unknown_command(const Error&, std::string_view line);
// Returns the name and all names above it, itself first. For "man/arm/hand": also "man/arm/", "man/arm", "man/" and
// "man".
std::vector<std::string_view> with_those_above(std::string_view name);

}  // namespace betwixt
