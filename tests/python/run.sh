#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# run.sh BUILD [NAME…]: runs all or the named tests of the Python module in that build.
build=$(cd -- "$1" && pwd) || exit 3
shift
cd -- "$(dirname -- "${BASH_SOURCE[0]}")" || exit 3
export PYTHONPATH=$build/python:$PWD PYTHONDONTWRITEBYTECODE=1 BETWIXT_PROGRAM=$build/bin/betwixt
exec /usr/bin/python3 run.py "$@"
