// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace betwixt {

// Makes a font file available to films. Returns false if the file is no font.
bool add_font(const std::string& path);

}  // namespace betwixt
