" SPDX-FileCopyrightText: 2026 The Betwixt authors
" SPDX-License-Identifier: Apache-2.0
if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1
" A comment is # and a blank. Names may contain a hyphen.
setlocal commentstring=#\ %s comments=b:# iskeyword+=-
setlocal expandtab shiftwidth=2 softtabstop=2 suffixesadd=.bx
setlocal include=^use
let b:undo_ftplugin = 'setlocal commentstring< comments< iskeyword< expandtab< shiftwidth< softtabstop<'
      \ . ' suffixesadd< include<'
