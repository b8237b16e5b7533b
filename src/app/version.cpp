// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/version.h"

#include "app/commit.h"

namespace betwixt {

std::string version_line() {
  const std::string commit = BETWIXT_COMMIT;
  return "betwixt " BETWIXT_VERSION + (commit.empty() ? "" : " (" + commit + ")");
}

}  // namespace betwixt
