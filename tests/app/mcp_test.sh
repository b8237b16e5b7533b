#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# mcp_test.sh PROGRAM: an assistant makes a film over the Model Context Protocol, sees it, and tries what it must not do.
# Also checks what `check --json` and `help --json` print.
exec python3 "$(dirname -- "$0")/mcp_session.py" "$(realpath -- "$1")"
