#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Writes what the program prints of itself: the reference, the page of its command line, and the grammars for editors.
#   tools/reference.sh [PROGRAM]    the default is ./betwixt, which first builds the program
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
program=${1:-$root/betwixt}
while read -r page file; do
  "$program" help --print "$page" >"$root/$file.new" && mv "$root/$file.new" "$root/$file" || exit
done <"$root/tools/printed.txt"
