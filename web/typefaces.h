// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace betwixt {

// A font's file, from now on among those that films find. False: it is none.
bool add_font(const std::string& path);

}  // namespace betwixt
