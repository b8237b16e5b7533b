// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <betwixt/plugin.h>
BETWIXT_PLUGIN(host) { return host ? 7 : 0; }
