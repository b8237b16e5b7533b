-- SPDX-FileCopyrightText: 2026 The Betwixt authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Writes what Neovim shows to the file SAID, a line for each check. BETWIXT is the program. editors_test.sh calls this.
local out = assert(io.open(vim.env.SAID, 'w'))
local function say(name, value)
  out:write(name, '\t', type(value) == 'string' and value or vim.inspect(value, { newline = '', indent = '' }), '\n')
end
local function wait(what)
  return vim.wait(20000, what, 10)
end
local function text()
  return table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '|')
end
local function ask(method, line, column, more)
  local params = { textDocument = vim.lsp.util.make_text_document_params(),
                   position = { line = line, character = column } }
  local answers = vim.lsp.buf_request_sync(0, method, vim.tbl_extend('force', params, more or {}), 20000)
  for _, answer in pairs(answers or {}) do
    return answer.result
  end
end

vim.cmd('filetype plugin indent on')
vim.cmd('syntax on')
require('betwixt').setup({ cmd = { vim.env.BETWIXT, 'lsp' } })
vim.cmd('edit')
say('filetype', vim.bo.filetype)
say('commentstring', vim.bo.commentstring)

-- Diagnostics, as vim.diagnostic has them: lines and bytes from 0.
wait(function() return #vim.diagnostic.get(0) > 0 end)
for _, d in ipairs(vim.diagnostic.get(0)) do
  say('diagnostic', string.format('%d:%d-%d %d %s', d.lnum, d.col, d.end_col, d.severity, d.message:gsub('\n', ' / ')))
end
-- The error is corrected by typing.
vim.api.nvim_buf_set_text(0, 4, 5, 4, 12, { 'position' })
say('mended', wait(function() return #vim.diagnostic.get(0) == 0 end))

local labels = {}
for _, item in ipairs(ask('textDocument/completion', 2, 15).items) do
  table.insert(labels, item.label)
end
say('completion', table.concat(labels, ' '))
say('hover', vim.split(ask('textDocument/hover', 4, 1).contents.value, '\n')[2])
vim.api.nvim_win_set_cursor(0, { 5, 1 })
vim.lsp.buf.definition()
say('definition', wait(function() return vim.api.nvim_win_get_cursor(0)[1] == 3 end) and vim.fn.expand('<cword>'))
vim.api.nvim_win_set_cursor(0, { 5, 1 })
vim.lsp.buf.rename('orb')
wait(function() return text():find('orb') end)
say('renamed', text())
vim.lsp.buf.formatting_sync(nil, 20000)
say('formatted', text())

-- The syntax groups of words.
local function group(line, word)
  local column = vim.fn.getline(line):find(word, 1, true)
  return vim.fn.synIDattr(vim.fn.synID(line, column, 1), 'name'):gsub('betwixt', '')
end
for _, w in ipairs({ { 1, '# a' }, { 2, 'rate' }, { 2, '24' }, { 3, 'create' }, { 3, 'sphere' }, { 3, 'color' },
                     { 3, 'gold' }, { 3, 'radius' }, { 5, 'position' }, { 6, '1f' }, { 7, '12f' }, { 7, 'linear' },
                     { 8, 'at' }, { 8, 'note' }, { 8, 'the' }, { 8, '# no' } }) do
  say('syntax', w[2] .. ' ' .. group(w[1], w[2]))
end

-- An event row is indented below its target.
vim.cmd('normal! Goorb.radius')
vim.api.nvim_feedkeys(vim.api.nvim_replace_termcodes('o1f 2<CR>3f 4<Esc>', true, false, true), 'tx', false)
say('indented', table.concat(vim.api.nvim_buf_get_lines(0, -4, -1, false), '|'))
out:close()
vim.cmd('qall!')
