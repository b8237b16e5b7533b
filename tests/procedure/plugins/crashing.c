// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <betwixt/plugin.h>
#include <stdlib.h>
BETWIXT_PLUGIN(host) {
  if (host) abort();
  return 0;
}
