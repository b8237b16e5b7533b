" SPDX-FileCopyrightText: 2026 The Betwixt authors
" SPDX-License-Identifier: Apache-2.0
autocmd BufNewFile,BufRead *.bx setfiletype betwixt
