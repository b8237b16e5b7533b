// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
/* A filter whose name a built-in one has. */
#include <betwixt/plugin.h>

static int quantise(const struct betwixt_input* input, const struct betwixt_parameter* parameters, size_t count,
                    struct betwixt_value* out, void* user) {
  (void)parameters, (void)count, (void)user;
  return input->at(input->state, input->seconds, out);
}

BETWIXT_PLUGIN(host) {
  host->register_filter(host, "quantise", "", quantise, 0);
  return 0;
}
