// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The program's version. Only its source is compiled again for each new commit.
#pragma once

#include <string>

namespace betwixt {

// "betwixt 1.0.0 (81a477b)"; without the commit if it was built from an archive.
std::string version_line();

}  // namespace betwixt
