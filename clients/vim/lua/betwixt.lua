-- SPDX-FileCopyrightText: 2026 The Betwixt authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Starts the language server for scripts in Neovim 0.7 and later: require('betwixt').setup()
-- The options of setup({ cmd = { '/opt/bin/betwixt', 'lsp' }, on_attach = … }) go to vim.lsp.start_client.
local M = {}
local clients = {} -- ids of clients, one for each folder: a script may read the files of its folder

local function attach(buffer, options)
  local folder = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(buffer), ':p:h')
  local running = clients[folder] and vim.lsp.get_client_by_id(clients[folder])
  if not running or running.is_stopped() then
    local config = { name = 'betwixt', cmd = { 'betwixt', 'lsp' }, root_dir = folder }
    clients[folder] = vim.lsp.start_client(vim.tbl_extend('force', config, options))
  end
  if clients[folder] then
    vim.lsp.buf_attach_client(buffer, clients[folder])
    if vim.bo[buffer].omnifunc == '' then -- so that Ctrl-X Ctrl-O completes; later versions of Neovim do it themselves
      vim.bo[buffer].omnifunc = 'v:lua.vim.lsp.omnifunc'
    end
  end
end

function M.setup(options)
  options = options or {}
  vim.api.nvim_create_autocmd('FileType', {
    pattern = 'betwixt',
    group = vim.api.nvim_create_augroup('betwixt', {}),
    callback = function(event)
      attach(event.buf, options)
    end,
  })
  for _, buffer in ipairs(vim.api.nvim_list_bufs()) do
    if vim.bo[buffer].filetype == 'betwixt' then
      attach(buffer, options)
    end
  end
end

return M
