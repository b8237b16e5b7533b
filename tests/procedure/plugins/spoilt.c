// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
/* A kind whose lines have an error. */
#include <betwixt/plugin.h>

BETWIXT_PLUGIN(host) {
  return host->register_kind(host, "spoilt", "has a wrong line", "create spoilt sphere\ncreate spoilt/x nothing\n");
}
