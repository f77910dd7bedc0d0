-- Opens a robot that is wrong, asks about it, takes the first quick fix, and tells what came of it.

local PATIENCE = 60000

local function tell(name, value)
  io.stdout:write(name .. '\t' .. vim.fn.json_encode(value) .. '\n')
end

local function wait(condition)
  vim.wait(PATIENCE, condition, 20)
end

local function wrong()
  return vim.tbl_filter(function(each) return each.code == 'LIM001' end, vim.diagnostic.get(0))[1]
end

local function line(number)
  return vim.api.nvim_buf_get_lines(0, number, number + 1, false)[1]
end

local function drive()
  vim.cmd('edit leg.urdf')
  wait(wrong)
  local found = wrong()
  tell('marked', line(found.lnum):sub(found.col + 1, found.end_col))
  vim.api.nvim_win_set_cursor(0, { found.lnum + 1, found.col })

  vim.lsp.buf.hover()
  wait(function() return #vim.api.nvim_list_wins() > 1 end)
  for _, window in ipairs(vim.api.nvim_list_wins()) do
    if vim.api.nvim_win_get_config(window).relative ~= '' then
      local page = vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, false)
      tell('hover', table.concat(page, '\n'))
      vim.api.nvim_win_close(window, true)
    end
  end

  vim.ui.select = function(items, options, chosen)
    tell('actions', vim.tbl_map(options.format_item, items))
    chosen(items[1], 1)
  end
  local before = line(found.lnum)
  vim.lsp.buf.code_action()
  wait(function() return line(found.lnum) ~= before end)
  tell('line', line(found.lnum))
  wait(function() return not wrong() end)
  tell('mended', not wrong())
end

local ok, fault = pcall(drive)
if not ok then
  tell('fault', tostring(fault))
end
vim.cmd('qall!')
