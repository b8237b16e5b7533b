// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs the TextMate grammar on a script with the engine of Visual Studio Code. Prints a line for each word: the word
// and its scope.
//   vscode_grammar.mjs PEERS GRAMMAR SCRIPT
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [peers, grammar, script] = process.argv.slice(2);
const require = createRequire(`${peers}/package.json`);
const oniguruma = require("vscode-oniguruma");
const { Registry, parseRawGrammar, INITIAL } = require("vscode-textmate");
await oniguruma.loadWASM(readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")).buffer);
const registry = new Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async () => parseRawGrammar(readFileSync(grammar, "utf8"), grammar),
});
const betwixt = await registry.loadGrammar("source.betwixt");
let state = INITIAL;
for (const line of readFileSync(script, "utf8").split("\n")) {
  const { tokens, ruleStack } = betwixt.tokenizeLine(line, state);
  for (const { startIndex, endIndex, scopes } of tokens) {
    const word = line.slice(startIndex, endIndex).trim();
    if (word) console.log(`${word}\t${scopes.length > 1 ? scopes[1].replace(".betwixt", "") : ""}`);
  }
  state = ruleStack;
}
