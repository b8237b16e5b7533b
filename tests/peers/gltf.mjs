// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks exported files with Khronos' validator and with the loader and mixer of three.js.
//   node gltf.mjs FILE.glb VALUES.json   VALUES.json: output of `betwixt eval --json` for NAME.world of all objects
// Prints errors, warnings, the largest difference of an element of a matrix, and its object and time.
import { readFileSync } from 'node:fs';
import validator from 'gltf-validator';

const [file, values] = process.argv.slice(2);
const bytes = new Uint8Array(readFileSync(file));
const report = await validator.validateBytes(bytes, { maxIssues: 20 });
for (const m of report.issues.messages) if (m.severity < 2) console.error(m.code, m.pointer, m.message);

// A fake loader of textures: it loads nothing, but reports success.
globalThis.self = globalThis;
globalThis.createImageBitmap = async () => ({ width: 1, height: 1, close() {} });
const { AnimationMixer, Matrix4, Quaternion, Vector3 } = await import('three');
const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
const quiet = console.warn;
console.warn = () => {};
const gltf = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), '');
console.warn = quiet;

const nodes = new Map();
gltf.scene.traverse((n) => nodes.set(n.userData.name ?? n.name, n));
const mixer = new AnimationMixer(gltf.scene), actions = [];
for (const clip of gltf.animations) {
  const action = mixer.clipAction(clip);
  action.setLoop(2200, 1); // once
  action.clampWhenFinished = true;
  action.play();
  actions.push(action);
  actions.push(action);
}
let most = 0, where = '';
const answers = JSON.parse(readFileSync(values));
for (const { seconds, values: all } of answers.times) {
  for (const action of actions) action.reset(); // an action that has ended stays at its end
  mixer.setTime(seconds - (answers.from ?? 0));
  gltf.scene.updateMatrixWorld(true);
  for (const [target, world] of Object.entries(all)) {
    const name = target.replace(/\.world$/, '');
    const node = nodes.get(name + ' turned') ?? nodes.get(name);
    if (!node) { most = Infinity, where = `there is no ${name}`; continue; }
    const e = node.matrixWorld.elements; // by columns; ours by rows
    for (let r = 0; r < 4; ++r) for (let c = 0; c < 4; ++c) {
      const off = Math.abs(e[c * 4 + r] - world[r * 4 + c]);
      if (!(off <= most)) most = off, where = `${name} at ${seconds} s, [${r}][${c}]: ${e[c * 4 + r]} for ${world[r * 4 + c]}`;
    }
  }
}
console.log(JSON.stringify({ errors: report.issues.numErrors, warnings: report.issues.numWarnings, most, where }));
