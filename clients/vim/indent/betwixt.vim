" SPDX-FileCopyrightText: 2026 The Betwixt authors
" SPDX-License-Identifier: Apache-2.0
" Event rows are indented below their target (such as ball.position), and drawing commands below make and edit. All
" other lines are not indented.
if exists('b:did_indent')
  finish
endif
let b:did_indent = 1
setlocal indentexpr=BetwixtIndent() indentkeys=o,O nosmartindent
let b:undo_indent = 'setlocal indentexpr< indentkeys< smartindent<'

if exists('*BetwixtIndent')
  finish
endif
function BetwixtIndent() abort
  let above = getline(v:lnum - 1)
  if above =~# '^\%(on\s\+\S\+\s\+\)\=[A-Za-z*{][^ \t"=()]*\.[^ \t"=()]*\s*\%(#\s.*\)\=$'
    return shiftwidth()
  endif
  return above =~# '^\%(at\s\+\S\+\s\+\)\=\%(make\|edit\)\s\+\S\+\s*$' ? shiftwidth() : indent(v:lnum - 1)
endfunction
