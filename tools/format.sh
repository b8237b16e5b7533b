#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Formats all C++ files by .clang-format. With `check` it changes nothing, and fails if a file is formatted differently.
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." || exit 3
command -v clang-format >/dev/null || { echo "format.sh: clang-format is missing: apt-get install clang-format" >&2; exit 3; }
how=(-i)
[ "$1" != check ] || how=(--dry-run -Werror)
git ls-files -z -- '*.h' '*.cpp' | xargs -0 -r clang-format "${how[@]}"
