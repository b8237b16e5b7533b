// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs the extension for Visual Studio Code with a mock editor: opens a script, types, makes every kind of request, and
// prints a line for each result.
//   vscode_extension.cjs EXTENSION PROGRAM SCRIPT
"use strict";
const fs = require("node:fs");
const Module = require("node:module");
const [extension, program, script] = process.argv.slice(2);

// The parts of the editor's interface that the extension uses.
class Position {
  constructor(line, character) {
    Object.assign(this, { line, character });
  }
}
class Range {
  constructor(start, end) {
    Object.assign(this, { start, end });
  }
  toString() {
    return `${this.start.line}:${this.start.character}-${this.end.line}:${this.end.character}`;
  }
}
const made = (...names) =>
  function (...values) {
    names.forEach((name, i) => (this[name] = values[i]));
  };
class WorkspaceEdit {
  all = [];
  set(uri, edits) {
    this.all.push(...edits);
  }
}
const happens = () => {
  const listeners = [];
  const event = (listener) => (listeners.push(listener), { dispose() {} });
  event.fire = (value) => listeners.forEach((listener) => listener(value));
  return event;
};
const uri = { parse: (text) => ({ toString: () => text }) };
const providers = {};
const provides = (name) => (language, provider) => ((providers[name] = provider), { dispose() {} });
const diagnostics = new Map();
const events = { open: happens(), change: happens(), save: happens(), close: happens(), settings: happens() };
const errors = [];
let settings = program;
const text = fs.readFileSync(script, "utf8");
const document = {
  languageId: "betwixt",
  version: 1,
  text,
  uri: uri.parse(`file://${script}`),
  getText() {
    return this.text;
  },
};
const vscode = {
  Position,
  Range,
  WorkspaceEdit,
  Uri: uri,
  Location: made("uri", "range"),
  TextEdit: made("range", "newText"),
  Diagnostic: made("range", "message", "severity"),
  CompletionItem: made("label", "kind"),
  CompletionList: made("items", "isIncomplete"),
  Hover: made("contents", "range"),
  MarkdownString: made("value"),
  SignatureHelp: made(),
  SignatureInformation: made("label", "documentation"),
  DocumentHighlight: made("range"),
  DocumentSymbol: made("name", "detail", "kind", "range", "selectionRange"),
  FoldingRange: made("start", "end", "kind"),
  FoldingRangeKind: { Comment: "comment" },
  ColorInformation: made("range", "color"),
  Color: made("red", "green", "blue", "alpha"),
  ColorPresentation: made("label"),
  CodeAction: made("title", "kind"),
  CodeActionKind: { QuickFix: "quickfix" },
  languages: new Proxy(
    {
      createDiagnosticCollection: () => ({
        set: (file, all) => diagnostics.set(file.toString(), all),
        clear: () => diagnostics.clear(),
      }),
    },
    { get: (own, name) => own[name] ?? provides(name.replace(/^register|Provider$/g, "")) },
  ),
  workspace: {
    textDocuments: [document],
    getConfiguration: () => ({ get: () => settings }),
    createFileSystemWatcher: () => ({ onDidChange: happens() }),
    onDidOpenTextDocument: events.open,
    onDidChangeTextDocument: events.change,
    onDidSaveTextDocument: events.save,
    onDidCloseTextDocument: events.close,
    onDidChangeConfiguration: events.settings,
  },
  window: { showErrorMessage: async (message) => void errors.push(message) },
  commands: { registerCommand: () => ({ dispose() {} }) },
};
const load = Module._load;
Module._load = (name, ...rest) => (name === "vscode" ? vscode : load(name, ...rest));

const say = (name, value) => console.log(`${name}\t${value}`);
const token = { onCancellationRequested() {} };
const until = async (holds) => {
  for (let n = 0; n < 1000 && !holds(); ++n) await new Promise((resolve) => setTimeout(resolve, 10));
};
const said = () => diagnostics.get(document.uri.toString());
function type(range, newText) {
  const lines = document.text.split("\n");
  const at = ({ line, character }) => lines.slice(0, line).reduce((n, l) => n + l.length + 1, 0) + character;
  document.text = document.text.slice(0, at(range.start)) + newText + document.text.slice(at(range.end));
  document.version += 1;
  events.change.fire({ document, contentChanges: [{ range, text: newText }] });
}

async function main() {
  const { activate, deactivate } = require(extension);
  await activate({ subscriptions: [] });
  await until(() => said()?.length);
  for (const d of said()) say("diagnostic", `${d.range} ${d.severity} ${d.message.replaceAll("\n", " / ")}`);
  const p = providers;
  const fix = await p.CodeActions.provideCodeActions(document, said()[0].range, { diagnostics: said() }, token);
  say("code action", fix[0].title);
  type(fix[0].edit.all[0].range, fix[0].edit.all[0].newText);
  await until(() => said().length === 0);
  say("mended", said().length === 0);
  const at = (line, character) => new Position(line, character);
  const words = await p.CompletionItem.provideCompletionItems(document, at(2, 15), token);
  say("completion", words.items.map((i) => `${i.label} ${i.range}`).join());
  say("hover", (await p.Hover.provideHover(document, at(4, 1), token)).contents.value.split("\n")[1]);
  const usage = await p.SignatureHelp.provideSignatureHelp(document, at(2, 15), token);
  say("usage", usage.signatures[0].label.slice(0, 16));
  say("definition", (await p.Definition.provideDefinition(document, at(4, 1), token))[0].range);
  const all = { includeDeclaration: true };
  say("references", (await p.Reference.provideReferences(document, at(4, 1), all, token)).length);
  say("highlights", (await p.DocumentHighlight.provideDocumentHighlights(document, at(4, 1), token)).length);
  say("can be renamed", (await p.Rename.prepareRename(document, at(4, 1), token)).placeholder);
  say("cannot", await p.Rename.prepareRename(document, at(1, 1), token).catch((why) => why.message));
  const renames = await p.Rename.provideRenameEdits(document, at(4, 1), "orb", token);
  say("renames", renames.all.map((e) => e.newText).join());
  const symbols = await p.DocumentSymbol.provideDocumentSymbols(document, token);
  say("symbols", symbols.map((s) => s.name).join());
  const folds = await p.FoldingRange.provideFoldingRanges(document, {}, token);
  say("folds", folds.map((f) => `${f.start}-${f.end}`).join());
  const colors = await p.Color.provideDocumentColors(document, token);
  say("colours", colors.map((c) => `${c.range} ${c.color.green.toFixed(3)}`).join());
  const ways = await p.Color.provideColorPresentations(colors[0].color, { document, range: colors[0].range }, token);
  say("ways", ways.map((w) => w.label).join());
  const edits = await p.DocumentFormattingEdit.provideDocumentFormattingEdits(document, { tabSize: 2 }, token);
  const part = await p.DocumentRangeFormattingEdit.provideDocumentRangeFormattingEdits(
    document, new Range(at(5, 0), at(5, 3)), { tabSize: 2 }, token);
  say("formatting", JSON.stringify(edits[0].newText));
  say("of a part", part[0].newText === edits[0].newText);
  settings = "/nowhere/betwixt";
  events.settings.fire({ affectsConfiguration: () => true });
  await until(() => errors.length > 0);
  say("no program", errors[0]);
  await deactivate();
}
main();
