// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Permanently drops the rights of a process before it reads an untrusted file.
#pragma once

#include <string>

#include "exchange/parser_messages.h"

namespace betwixt {

// Limits memory, work and time. Forbids core files, larger files, opening anything, starting processes, and the
// network, by seccomp and by Landlock as far as the kernel has them. A process that exceeds a limit is killed, or its
// request fails.
void give_up_all_but_reading(const ParserCeilings&);

// Both prepare this process for becoming another author's program. That program may read the machine's programs and
// libraries, and may start threads but no processes. It has no network. The caller enforces `most.wall`.
// one_file: it may read `file`, and write only to files that are already open.
void give_up_all_but_one_file(const std::string& file, const std::string& program, const ParserCeilings& most);
// one_folder: it may read, write, make and remove files below `folder`, and read the files of TeX.
void give_up_all_but_one_folder(const std::string& folder, const std::string& program, const ParserCeilings& most);

}  // namespace betwixt
