// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace betwixt {

// The manual page, as troff: packaging/betwixt.1.in with what the subcommands' rows say.
std::string manual_page();

}  // namespace betwixt
