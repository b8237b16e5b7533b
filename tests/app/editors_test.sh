#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the files for editors. Neovim shows the results of the language server,
# and the colours of the syntax file.
#   editors_test.sh PROGRAM
here=$(cd -- "$(dirname -- "$0")" && pwd) clients=$(cd -- "$(dirname -- "$0")/../../clients" && pwd)
. "$here/support.sh" || exit 3

is 'the grammar is JSON' "$(python3 -m json.tool "$clients/vscode/syntaxes/betwixt.tmLanguage.json" >/dev/null && echo yes)" yes

if command -v nvim >/dev/null; then
  printf '%s\n' '# a ball' 'rate 24' 'create ball sphere radius=1 color=gold' '' 'ball.positon' '  12f  (4 1 0) linear' \
    '  1f (0 1 0)' 'at 3f note "😀 the ball" # no' >film.bx
  SAID=$work/said BETWIXT=$program HOME=$work timeout 120 nvim --headless -u NONE -n --cmd "set rtp^=$clients/vim" film.bx \
    -S "$here/neovim.lua" >nvim.log 2>&1 </dev/null
  is 'Neovim ends' $? 0
  while IFS=$'\t' read -r name wanted; do
    is "Neovim: $name" "$(grep -F -- "$name	" said | cut -f2 | head -n 1)" "$wanted"
    sed -i "0,/^$name	/{/^$name	/d}" said
  done <<'END'
filetype	betwixt
commentstring	# %s
diagnostic	4:5-12 1 'ball', a sphere, has no function 'positon' / did you mean 'position'?
mended	true
completion	sphere
hover	ball, a sphere
definition	ball
renamed	# a ball|rate 24|create orb sphere radius=1 color=gold||orb.position|  12f  (4 1 0) linear|  1f (0 1 0)|at 3f note "😀 the ball" # no
formatted	# a ball|rate 24|create orb sphere radius=1 color=gold||orb.position|  1f   (0 1 0)|  12f  (4 1 0)  linear|at 3f note "😀 the ball"  # no
syntax	# a Comment
syntax	rate Verb
syntax	24 Number
syntax	create Verb
syntax	sphere Kind
syntax	color Function
syntax	gold Color
syntax	radius Function
syntax	position Function
syntax	1f Time
syntax	12f Time
syntax	linear Twerper
syntax	at Verb
syntax	note Verb
syntax	the Text
syntax	# no Comment
indented	orb.radius|  1f 2|  3f 4
END
  is 'nothing else is said' "$(cat said)" ''
else
  echo 'left out: there is no nvim'
fi

summary
