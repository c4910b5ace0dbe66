-- The session of session.json in neovim, with its own buffer, columns, changes and edits: nvim -l is not needed, as in
-- nvim --headless -u NONE -c 'luafile session.lua', with TIP, SESSION, FILE and LOG in the environment.
local util = vim.lsp.util
local session = vim.json.decode(table.concat(vim.fn.readfile(vim.env.SESSION), "\n"))
-- What its columns count: from version 0.10 on it would rather have bytes.
local encoding
local lines = {}

local function log(...)
  local words = {}
  for _, word in ipairs({ ... }) do
    local text = tostring(word):gsub("\r\n", "⏎"):gsub("\n", " | ")
    table.insert(words, text)
  end
  table.insert(lines, table.concat(words, " "))
end

local function buffer_lines()
  return vim.api.nvim_buf_get_lines(0, 0, -1, true)
end

local function text()
  return table.concat(buffer_lines(), "⏎") .. "⏎"
end

local function byte(line, column)
  return encoding == "utf-8" and column or vim.str_byteindex(line, column, true)
end

local function slice(range)
  local line = buffer_lines()[range.start.line + 1] or ""
  if range.start.line ~= range["end"].line then
    error("a range of several lines")
  end
  local from = byte(line, range.start.character)
  local to = byte(line, range["end"].character)
  return line:sub(from + 1, to)
end

-- Puts the cursor at the nth place of a text.
local function go(step)
  local left = step.nth or 0
  for number, line in ipairs(buffer_lines()) do
    local from = 1
    while true do
      local at = line:find(step.find, from, true)
      if not at then break end
      if left == 0 then
        vim.api.nvim_win_set_cursor(0, { number, at - 1 })
        return
      end
      left, from = left - 1, at + 1
    end
  end
  error("there is no " .. step.find)
end

local found, judged = {}, nil
vim.lsp.handlers["textDocument/publishDiagnostics"] = function(_, params)
  found, judged = params.diagnostics, params.version
end

-- An edit in several places is several changes: the findings that count are those of the last one.
local function codes()
  local buffer = vim.api.nvim_get_current_buf()
  vim.wait(5000, function() return judged == util.buf_versions[buffer] end, 5)
  return unpack(vim.tbl_map(function(one) return one.code end, found))
end

local function main()
  vim.o.fileformats = "unix,dos"
  vim.cmd("edit " .. vim.fn.fnameescape(vim.env.FILE))
  local id = vim.lsp.start_client({
    name = "tip", cmd = { vim.env.TIP, "lsp" }, flags = { debounce_text_changes = 0 },
    get_language_id = function() return "tip" end,
  })
  vim.lsp.buf_attach_client(0, id)
  vim.wait(5000, function() return judged ~= nil end, 5)
  local client = vim.lsp.get_client_by_id(id)
  encoding = client.offset_encoding
  local legend = client.server_capabilities.semanticTokensProvider.legend.tokenTypes
  local document = { uri = vim.uri_from_bufnr(0) }

  local function send(method, params)
    local answer = client.request_sync("textDocument/" .. method, params, 5000, 0)
    return answer.result, answer.err
  end
  local function ask(method, more)
    return send(method, vim.tbl_extend("force", { textDocument = document }, more or {}))
  end
  local function at(method, step, more)
    go(step)
    return send(method, vim.tbl_extend("force", util.make_position_params(0, encoding), more or {}))
  end
  local function each(list, show)
    return unpack(vim.tbl_map(show, list))
  end

  local steps = {}
  function steps.hover(step)
    local hover = at("hover", step)
    log("hover", slice(hover.range), hover.contents.value)
  end
  function steps.definition(step)
    local place = at("definition", step)
    log("definition", place.range.start.line, slice(place.range))
  end
  function steps.references(step)
    local places = at("references", step, { context = { includeDeclaration = true } })
    log("references", each(places, function(it) return it.range.start.line .. ":" .. slice(it.range) end))
  end
  function steps.completion(step)
    local items = vim.tbl_filter(function(it) return vim.startswith(it.label, step.prefix) end, at("completion", step))
    log("completion", each(items, function(it) return it.label .. "/" .. slice(it.textEdit.range) end))
  end
  function steps.signature(step)
    local help = at("signatureHelp", step)
    local form = help.signatures[help.activeSignature + 1]
    local label = form.parameters[help.activeParameter + 1].label
    local from, to = vim.str_byteindex(form.label, label[1], true), vim.str_byteindex(form.label, label[2], true)
    log("signature", form.label, "/", form.label:sub(from + 1, to))
  end
  function steps.symbols()
    log("symbols", each(ask("documentSymbol"), function(one) return one.name .. "/" .. slice(one.selectionRange) end))
  end
  function steps.folds()
    log("folds", each(ask("foldingRange"), function(one) return one.startLine .. "-" .. one.endLine end))
  end
  function steps.hints()
    local last = { line = #buffer_lines(), character = 0 }
    for _, one in ipairs(ask("inlayHint", { range = { start = { line = 0, character = 0 }, ["end"] = last } })) do
      log("hint", one.position.line, one.label)
    end
  end
  function steps.tokens()
    local data, line, character = ask("semanticTokens/full").data, 0, 0
    for token = 1, #data, 5 do
      local down, right = data[token], data[token + 1]
      line, character = line + down, down > 0 and right or character + right
      local range = {
        start = { line = line, character = character },
        ["end"] = { line = line, character = character + data[token + 2] },
      }
      log("token", slice(range), legend[data[token + 3] + 1], data[token + 4])
    end
  end
  function steps.refused(step)
    local _, err = at("rename", step, { newName = step.name })
    log("refused", err.message)
  end
  function steps.rename(step)
    local edit = at("rename", step, { newName = step.name })
    util.apply_workspace_edit(edit, encoding)
    local after = { codes() }
    log("renamed", text(), unpack(after))
  end
  function steps.fix(step)
    go(step)
    local place = util.make_position_params(0, encoding).position
    local actions = ask("codeAction", { range = { start = place, ["end"] = place }, context = { diagnostics = {} } })
    util.apply_workspace_edit(actions[1].edit, encoding)
    log("fixed", actions[1].title, codes())
  end
  function steps.format()
    local edits = ask("formatting", { options = { tabSize = 2, insertSpaces = true } })
    util.apply_text_edits(edits, vim.api.nvim_get_current_buf(), encoding)
    local after = { codes() }
    log("formatted", text(), unpack(after))
  end

  for _, one in ipairs(found) do
    local place = slice(one.range)
    log("finding", one.code, place == "" and "nothing" or place, one.message)
  end
  for _, step in ipairs(session.steps) do
    steps[step.ask](step)
  end
  vim.lsp.stop_client(id)
end

local is_well, reason = pcall(main)
if not is_well then
  table.insert(lines, "failed: " .. tostring(reason))
end
vim.fn.writefile(lines, vim.env.LOG)
vim.cmd("qall!")
