// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace betwixt {

// A socket to whoever listens there, closed with the program that this one becomes; -1, and why, where nobody does.
int connect_unix(const std::string& path, std::string& why);
int connect_tcp(const std::string& host, const std::string& port, std::string& why);

}  // namespace betwixt
