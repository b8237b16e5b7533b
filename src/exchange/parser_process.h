// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Other people's files are read in a process of its own: what they do to the libraries that read them, they do there.
//
// A program, betwixt-parser, is started when the first file is read. It copies itself for each file; the copy gives up
// all but what it was handed (parser_jail.h), asks for the files that the file names, and hands over what it has read
// in memory (handed_over.h).
#pragma once

#include <optional>
#include <string>

#include "exchange/handed_over.h"
#include "exchange/parser_messages.h"
#include "exchange/shelf.h"

namespace betwixt {

// So much that no good file of this size comes near it. Unless any size is allowed, memory is what a file may unpack to
// (unpacking.h), twice, and a gigabyte to read it with.
ParserCeilings parser_ceilings(const std::string& path, std::uint64_t size, bool any_size);
// None: there is no such program on this machine. Errors: what the file is; machine. Ceilings of its own for tests.
std::optional<Parsed> parse_apart(ParserTask, const std::string& path, const MayRead&, bool any_size = false,
                                  std::optional<ParserCeilings> = {});

// The same in this process, whatever the file does to it.
Parsed parse_here(ParserTask, const std::string& path, Shelf&, bool any_size = false);

// Where the program is: $BETWIXT_PARSER; beside the program that runs, in libexec/betwixt beside its folder or that of
// the library, or beside a folder of $PATH. Empty: nowhere.
std::string find_parser();

}  // namespace betwixt
