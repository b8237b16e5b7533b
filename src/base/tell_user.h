// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Words for whoever runs the program, on standard error. Where nobody reads there any more, they are lost, and nothing
// else happens.
#pragma once

#include <cstdio>
#include <string_view>

namespace betwixt {

inline void tell_user(std::string_view text) { (void)std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace betwixt
