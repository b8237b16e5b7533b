// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <betwixt/plugin.h>
#undef BETWIXT_PLUGIN_VERSION
#define BETWIXT_PLUGIN_VERSION 3
BETWIXT_PLUGIN(host) { return host->version; }
