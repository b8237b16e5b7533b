// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads untrusted files in a separate process, so that an attack on a parsing library stays in that process.
//
// The first file starts a program, betwixt-parser, which forks for each file. The child drops all rights except to its
// open files (parser_jail.h), requests the files that the file names, and returns its result in shared memory
// (handed_over.h).
#pragma once

#include <optional>
#include <string>

#include "exchange/file_source.h"
#include "exchange/parser_messages.h"
#include "exchange/wire_format.h"

namespace betwixt {

// Returns limits far above the needs of any valid file of this size. Memory: twice the permitted unpacked size
// (unpacking.h), unless any size is allowed, and a gigabyte for the parser.
ParserCeilings parser_ceilings(const std::string& path, std::uint64_t size, bool any_size);
// Returns nullopt if this machine has no such program. Errors: those of the kind of file; machine. Tests pass limits of
// their own. `inside`: of a table.
std::optional<Parsed> parse_apart(ParserTask, const std::string& path, const MayRead&, bool any_size = false,
                                  std::optional<ParserCeilings> = {}, std::string_view inside = {});

// Shapes a line with the font in an open file, whose position it changes. `name`: for errors.
std::optional<Parsed> shape_apart(const std::string& name, int file, std::string_view line, const ParserCeilings&);

// Reads it in this process, without protection. `line`: for letters, and what is inside for a table.
Parsed parse_here(ParserTask, const std::string& path, FileSource&, bool any_size = false, std::string_view line = {});

// Returns the program's path: $BETWIXT_PARSER; beside the running program; in libexec/betwixt beside its folder or the
// library's; or beside a folder of $PATH. Returns "" if it is in none of these.
std::string find_parser();

}  // namespace betwixt
