#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# run.sh BUILD [NAME…]: imports films into Blender without a window, and compares them with Betwixt.
build=$(cd -- "$1" && pwd) || exit 3
shift
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
command -v blender >/dev/null || {
  printf 'left out: there is no Blender here\n0 passed, 0 failed\n'
  exit 0
}
export BETWIXT_PYTHON=$build/python BETWIXT_PROGRAM=$build/bin/betwixt PYTHONDONTWRITEBYTECODE=1
"$here/../../tools/blender.sh" -b --factory-startup --python-exit-code 3 --python "$here/run.py" -- "$@" 2>&1 |
  grep -vE '^(Blender 3|Read prefs|Blender quit|Fra:|Saved:| Time:|$)|^Info:'
exit "${PIPESTATUS[0]}"
