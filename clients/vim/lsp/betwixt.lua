-- SPDX-FileCopyrightText: 2026 The Betwixt authors
-- SPDX-License-Identifier: Apache-2.0
--
-- The configuration for vim.lsp.enable('betwixt'), which Neovim has since 0.11.
return { cmd = { 'betwixt', 'lsp' }, filetypes = { 'betwixt' } }
