// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Uses of the player in TypeScript. The compiler must refuse each line after "wrong:".
import { engine, BetwixtEditor, BetwixtPlayer, type Diagnostic, type Value } from "betwixt-player";

const player = document.createElement("betwixt-player");
player.script = "create ball sphere\n";
player.files = { "words.txt": "words", "spot.obj": new Uint8Array(4), "more.glb": new ArrayBuffer(8) };
player.loop = player.controls = true;
player.playbackRate = -1;
player.addEventListener("diagnostics", (event) => {
  const all: Diagnostic[] = event.detail.diagnostics;
  for (const d of all) console.log(`${d.file}:${d.line}:${d.column}: ${d.severity}: ${d.text}`);
});
player.addEventListener("note", function (event) { console.log(this.currentTime, event.detail.text); });
player.addEventListener("ended", () => player.load());
const played: Promise<void> = player.play();
const value: Value = player.eval("ball.position", 1.5);
const [x, y]: number[] = player.eval<number[]>("ball.position");
const words: string = player.film ? player.film.eval("ball.position", "24f", { text: true }) : "";
const found: BetwixtPlayer | null = document.querySelector("betwixt-player");
const editor: BetwixtEditor | null = document.querySelector("betwixt-editor");
editor?.go(3, 2);
const frames: number = player.film ? player.film.lastFrame - player.film.firstFrame + 1 : 0;
const made = (await engine()).open("create ball sphere\n", { name: "ball.bx", files: player.files });
if (made.ok) made.draw(new OffscreenCanvas(640, 360), made.start);
const classic = new globalThis.Betwixt.Player();
export { played, value, x, y, words, found, frames, classic };

// wrong:
player.paused = true;
// wrong:
player.playbackRate = "fast";
// wrong:
player.eval();
// wrong:
const number: number = player.eval<string>("ball.radius");
// wrong:
player.addEventListener("note", (event) => event.detail.words);
