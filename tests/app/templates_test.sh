#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests `betwixt new`: it lists all files of templates/, each is a film without errors, warnings and notices, and no
# file is overwritten.
#   templates_test.sh PROGRAM
here=$(cd -- "$(dirname -- "$0")" && pwd)
. "$here/support.sh" || exit 3

templates=$(cd "$here/../../templates" && printf '%s\n' *.bx | sed 's/\.bx$//' | LC_ALL=C sort)
is 'all templates are listed' "$("$program" new | sed -nE 's/^  ([a-z0-9-]+) .*/\1/p' | LC_ALL=C sort)" "$templates"
for t in $templates; do
  "$program" new "$t" "$t.bx"
  is "$t is as its file" "$(cmp "$t.bx" "$here/../../templates/$t.bx" 2>&1)" ''
  is "$t is a film" "$("$program" check "$t.bx" 2>&1 | sed 's/: no errors, .*//')" "$t.bx"
  verdict "$t is short" "$([ "$(wc -l <"$t.bx")" -le 45 ] && echo yes)" "$(wc -l <"$t.bx") lines"
done
check 'no file is overwritten' 1 'already exists' new title title.bx
check 'a name that is misspelt' 2 "did you mean 'title'" new titel
check 'without a file it is printed' 0 'range 1f 120f' new title
summary
