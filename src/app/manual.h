// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace betwixt {

// Returns the manual page as troff: packaging/betwixt.1.in, filled in from the subcommands' rows.
std::string manual_page();

}  // namespace betwixt
