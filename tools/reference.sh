#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Writes docs/reference.md and docs/command-line.md from the help texts of the program.
#   tools/reference.sh [PROGRAM]    the default is ./betwixt, which first builds the program
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
program=${1:-$root/betwixt}
for page in reference command-line; do
  "$program" help --print "$page" >"$root/docs/$page.md.new" && mv "$root/docs/$page.md.new" "$root/docs/$page.md" || exit
done
