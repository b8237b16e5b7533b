// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the objects of a .usda file in three.js with the film, at given times. Also checks that tinyusdz reads the
// file.
//   node usda.mjs FILE.usda VALUES.json     VALUES.json: output of betwixt eval --json for NAME.world, and `from` in s
import { readFileSync } from "node:fs";
import * as three from "three";
import { USDLoader } from "three/examples/jsm/loaders/USDLoader.js";

const text = readFileSync(process.argv[2], "utf8");
const values = JSON.parse(readFileSync(process.argv[3], "utf8"));

const scene = new USDLoader().parse(text);
const mixer = new three.AnimationMixer(scene);
for (const clip of scene.animations) {
  const action = mixer.clipAction(clip);
  action.setLoop(three.LoopOnce);
  action.clampWhenFinished = true;
  action.play();
}
// Returns the prim of an object, found by the name that the file stores with it.
const prims = new Map();
let prim = "";
for (const line of text.split("\n")) {
  const def = line.match(/def Xform "(.*)"/), name = line.match(/betwixt:name = "(.*)"/);
  if (def) prim = def[1];
  if (name) prims.set(name[1], prim);
}
let most = 0, worst = "", compared = 0;
for (const frame of values.times) {
  mixer.setTime(frame.seconds - values.from);
  scene.updateMatrixWorld(true);
  for (const [target, rows] of Object.entries(frame.values)) {
    const name = target.replace(/\.world$/, "");
    if (!prims.has(name)) continue;
    const node = scene.getObjectByName(prims.get(name));
    const at = rows.flat(), m = node.matrixWorld.elements;
    for (let i = 0; i < 12; ++i) {
      const column = i % 4, row = (i - column) / 4;
      // Differences of position are relative to the distance from the origin: most programs read numbers as 32-bit
      // floats.
      const off = Math.abs(at[i] - m[4 * column + row]) / Math.max(1, Math.abs(at[4 * row + 3]));
      if (off > most) most = off, worst = `${name} at ${frame.seconds} s`;
    }
    ++compared;
  }
}

// The library expects to run in a page.
globalThis.window = globalThis;
globalThis.document = { currentScript: null };
Object.defineProperty(process, "type", { value: "renderer" });
const { default: createTinyUSDZ } = await import("tinyusdz/tinyusdz.js");
const tiny = await createTinyUSDZ({ wasmBinary: readFileSync(new URL(import.meta.resolve("tinyusdz/tinyusdz.wasm"))) });
const loader = new tiny.TinyUSDZLoaderNative();
const read = loader.loadFromBinary(new TextEncoder().encode(text), "film.usda");
console.log(JSON.stringify({ most, worst, compared, tinyusdz: Boolean(read), error: read ? "" : String(loader.error?.() ?? "") }));
