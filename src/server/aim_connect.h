// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace betwixt {

// Returns a connected socket that is closed on exec. If no server listens there, returns -1 and sets `why`.
int connect_unix(const std::string& path, std::string& why);
int connect_tcp(const std::string& host, const std::string& port, std::string& why);

}  // namespace betwixt
