// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The extension for Visual Studio Code. It sends the editor's requests to `betwixt lsp` and converts the answers to the
// editor's types. It needs no other packages.
"use strict";
const vscode = require("vscode");
const { Server } = require("./server.js");

const language = "betwixt";
/** @type {Server | undefined} */
let server;
/** @type {vscode.DiagnosticCollection} */
let said;

// Conversions between the types of the Language Server Protocol and those of the editor

/** @param {any} p */
const toPosition = (p) => new vscode.Position(p.line, p.character);
/** @param {any} r */
const toRange = (r) => new vscode.Range(toPosition(r.start), toPosition(r.end));
/** @param {any} l */
const toLocation = (l) => new vscode.Location(vscode.Uri.parse(l.uri), toRange(l.range));
/** @param {any} e */
const toEdit = (e) => new vscode.TextEdit(toRange(e.range), e.newText);
/** @param {any} e */
function toWorkspaceEdit(e) {
  const all = new vscode.WorkspaceEdit();
  for (const [uri, edits] of Object.entries(e.changes)) all.set(vscode.Uri.parse(uri), edits.map(toEdit));
  return all;
}
/** @param {any} d */
function toDiagnostic(d) {
  const one = new vscode.Diagnostic(toRange(d.range), d.message, d.severity - 1);
  one.source = d.source;
  return one;
}
/** @param {vscode.Diagnostic} d */
const fromDiagnostic = (d) => ({ range: d.range, message: d.message, severity: d.severity + 1, source: d.source });
/** @param {any} i */
function toCompletion(i) {
  const one = new vscode.CompletionItem(i.label, i.kind - 1);
  one.documentation = i.documentation;
  one.range = toRange(i.textEdit.range);
  one.insertText = i.textEdit.newText;
  return one;
}
/** @param {any} s */
function toSymbol(s) {
  return new vscode.DocumentSymbol(s.name, s.detail, s.kind - 1, toRange(s.range), toRange(s.selectionRange));
}

/**
 * Sends a request about a document. Returns the result, or null if there is none or no server runs.
 * @param {string} what @param {vscode.TextDocument} document @param {object} more @param {any} token
 */
async function ask(what, document, more, token) {
  const params = { textDocument: { uri: document.uri.toString() }, ...more };
  return server ? server.ask(`textDocument/${what}`, params, token) : null;
}

/** @param {vscode.ExtensionContext} context */
function offer(context) {
  const all = [
    vscode.languages.registerCompletionItemProvider(
      language,
      {
        async provideCompletionItems(document, position, token) {
          const found = await ask("completion", document, { position }, token);
          return found && new vscode.CompletionList(found.items.map(toCompletion), found.isIncomplete);
        },
      },
      ".",
      "=",
    ),
    vscode.languages.registerHoverProvider(language, {
      async provideHover(document, position, token) {
        const found = await ask("hover", document, { position }, token);
        return found && new vscode.Hover(new vscode.MarkdownString(found.contents.value), toRange(found.range));
      },
    }),
    vscode.languages.registerSignatureHelpProvider(
      language,
      {
        async provideSignatureHelp(document, position, token) {
          const found = await ask("signatureHelp", document, { position }, token);
          if (!found) return null;
          const help = new vscode.SignatureHelp();
          help.signatures = found.signatures.map(
            (/** @type {any} */ s) => new vscode.SignatureInformation(s.label, s.documentation),
          );
          help.activeSignature = help.activeParameter = 0;
          return help;
        },
      },
      " ",
    ),
    vscode.languages.registerDefinitionProvider(language, {
      async provideDefinition(document, position, token) {
        return ((await ask("definition", document, { position }, token)) ?? []).map(toLocation);
      },
    }),
    vscode.languages.registerReferenceProvider(language, {
      async provideReferences(document, position, context, token) {
        return ((await ask("references", document, { position, context }, token)) ?? []).map(toLocation);
      },
    }),
    vscode.languages.registerDocumentHighlightProvider(language, {
      async provideDocumentHighlights(document, position, token) {
        const found = (await ask("documentHighlight", document, { position }, token)) ?? [];
        return found.map((/** @type {any} */ h) => new vscode.DocumentHighlight(toRange(h.range)));
      },
    }),
    vscode.languages.registerRenameProvider(language, {
      async prepareRename(document, position, token) {
        const found = await ask("prepareRename", document, { position }, token);
        return { range: toRange(found.range), placeholder: found.placeholder };
      },
      async provideRenameEdits(document, position, newName, token) {
        const found = await ask("rename", document, { position, newName }, token);
        return found && toWorkspaceEdit(found);
      },
    }),
    vscode.languages.registerDocumentSymbolProvider(language, {
      async provideDocumentSymbols(document, token) {
        return ((await ask("documentSymbol", document, {}, token)) ?? []).map(toSymbol);
      },
    }),
    vscode.languages.registerFoldingRangeProvider(language, {
      async provideFoldingRanges(document, _, token) {
        const found = (await ask("foldingRange", document, {}, token)) ?? [];
        return found.map((/** @type {any} */ f) => {
          const kind = f.kind === "comment" ? vscode.FoldingRangeKind.Comment : undefined;
          return new vscode.FoldingRange(f.startLine, f.endLine, kind);
        });
      },
    }),
    vscode.languages.registerColorProvider(language, {
      async provideDocumentColors(document, token) {
        const found = (await ask("documentColor", document, {}, token)) ?? [];
        return found.map((/** @type {any} */ c) => {
          const { red, green, blue, alpha } = c.color;
          return new vscode.ColorInformation(toRange(c.range), new vscode.Color(red, green, blue, alpha));
        });
      },
      async provideColorPresentations({ red, green, blue, alpha }, { document, range }, token) {
        const color = { red, green, blue, alpha };
        const found = (await ask("colorPresentation", document, { color, range }, token)) ?? [];
        return found.map((/** @type {any} */ p) => {
          const way = new vscode.ColorPresentation(p.label);
          way.textEdit = toEdit(p.textEdit);
          return way;
        });
      },
    }),
    vscode.languages.registerDocumentFormattingEditProvider(language, {
      async provideDocumentFormattingEdits(document, options, token) {
        return ((await ask("formatting", document, { options }, token)) ?? []).map(toEdit);
      },
    }),
    vscode.languages.registerDocumentRangeFormattingEditProvider(language, {
      async provideDocumentRangeFormattingEdits(document, range, options, token) {
        return ((await ask("rangeFormatting", document, { range, options }, token)) ?? []).map(toEdit);
      },
    }),
    vscode.languages.registerCodeActionsProvider(language, {
      async provideCodeActions(document, range, context, token) {
        const diagnostics = context.diagnostics.map(fromDiagnostic);
        const found = (await ask("codeAction", document, { range, context: { diagnostics } }, token)) ?? [];
        return found.map((/** @type {any} */ a) => {
          const one = new vscode.CodeAction(a.title, vscode.CodeActionKind.QuickFix);
          one.edit = toWorkspaceEdit(a.edit);
          one.isPreferred = true;
          return one;
        });
      },
    }),
  ];
  context.subscriptions.push(...all);
}

// Notifications about documents

/** @param {vscode.TextDocument} document */
function opened(document) {
  if (document.languageId !== language) return;
  const { version, languageId } = document;
  const textDocument = { uri: document.uri.toString(), version, languageId, text: document.getText() };
  server?.tell("textDocument/didOpen", { textDocument });
}

/** @param {vscode.TextDocumentChangeEvent} event */
function changed({ document, contentChanges }) {
  if (document.languageId !== language || contentChanges.length === 0) return;
  server?.tell("textDocument/didChange", {
    textDocument: { uri: document.uri.toString(), version: document.version },
    contentChanges: contentChanges.map(({ range, text }) => ({ range, text })),
  });
}

/** @param {string} what @param {vscode.TextDocument} document */
function tell(what, document) {
  if (document.languageId !== language) return;
  server?.tell(`textDocument/${what}`, { textDocument: { uri: document.uri.toString() } });
}

async function begin() {
  await server?.stop();
  const program = vscode.workspace.getConfiguration(language).get("path", "betwixt");
  server = new Server(program, {
    told(method, params) {
      if (method !== "textDocument/publishDiagnostics") return;
      said.set(vscode.Uri.parse(params.uri), params.diagnostics.map(toDiagnostic));
    },
    ended(why) {
      said.clear();
      const again = "Start it again";
      vscode.window
        .showErrorMessage(`'${program} lsp' tells nothing of scripts any more: ${why}`, again)
        .then((answer) => (answer === again ? begin() : undefined));
    },
  });
  server.ask("initialize", { processId: process.pid, rootUri: null, capabilities: {} }).catch(() => {});
  server.tell("initialized", {});
  vscode.workspace.textDocuments.forEach(opened);
}

/** @param {vscode.ExtensionContext} context */
async function activate(context) {
  said = vscode.languages.createDiagnosticCollection(language);
  const files = vscode.workspace.createFileSystemWatcher("**/*.bx");
  const looked = () => server?.tell("workspace/didChangeWatchedFiles", { changes: [] });
  context.subscriptions.push(
    said,
    files,
    files.onDidChange(looked),
    vscode.workspace.onDidOpenTextDocument(opened),
    vscode.workspace.onDidChangeTextDocument(changed),
    vscode.workspace.onDidSaveTextDocument((document) => tell("didSave", document)),
    vscode.workspace.onDidCloseTextDocument((document) => tell("didClose", document)),
    vscode.workspace.onDidChangeConfiguration((event) => event.affectsConfiguration("betwixt.path") && begin()),
    vscode.commands.registerCommand("betwixt.restart", begin),
  );
  offer(context);
  await begin();
}

const deactivate = () => server?.stop();

module.exports = { activate, deactivate };
