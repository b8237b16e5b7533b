// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <betwixt/plugin.h>
static double same(double u, void* user) { return user ? 0 : u; }
BETWIXT_PLUGIN(host) {
  host->register_twerper(host, "same", "", same, 0);
  host->register_twerper(host, "same", "", same, 0);
  return 0;
}
