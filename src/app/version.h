// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which version of the program this is. Its source alone is compiled anew when there is another commit.
#pragma once

#include <string>

namespace betwixt {

// "betwixt 0.4.0 (81a477b)"; without the commit where it was built from an archive.
std::string version_line();

}  // namespace betwixt
