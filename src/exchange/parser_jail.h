// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a process gives up for good before it looks at a file of somebody else's.
#pragma once

#include <string>

#include "exchange/parser_messages.h"

namespace betwixt {

// Ceilings of memory, work and time; no core, no larger files, no way to open anything, no other processes, no network:
// by the kernel's filter of calls and by Landlock, each where the kernel has it. A process that breaks a ceiling is
// killed, or gets no more.
void give_up_all_but_reading(const ParserCeilings&);

// For a program of another author that this process becomes afterwards: it may read `file`, and the programs and
// libraries of the machine. It writes to what is open already and to no file, starts threads and no processes, and has
// no network. `most.wall` is for whoever waits for it.
void give_up_all_but_one_file(const std::string& file, const std::string& program, const ParserCeilings& most);

}  // namespace betwixt
