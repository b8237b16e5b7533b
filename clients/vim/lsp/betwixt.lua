-- SPDX-FileCopyrightText: 2026 The Betwixt authors
-- SPDX-License-Identifier: Apache-2.0
--
-- For vim.lsp.enable('betwixt'), from Neovim 0.11 on.
return { cmd = { 'betwixt', 'lsp' }, filetypes = { 'betwixt' } }
