// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Prints the bounding box of the vertices of each skin of a file, as three.js has them.
//   node usda_skin.mjs FILE.usda|FILE.glb SECONDS…
import { readFileSync } from "node:fs";
import * as three from "three";
import { USDLoader } from "three/examples/jsm/loaders/USDLoader.js";

import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const file = process.argv[2], bytes = readFileSync(file);
globalThis.self = globalThis;
globalThis.createImageBitmap = async () => ({ width: 1, height: 1, close() {} });
let scene, clips;
if (file.endsWith(".glb")) {
  const quiet = console.warn;
  console.warn = () => {};
  const data = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  ({ scene, animations: clips } = await new GLTFLoader().parseAsync(data, ""));
  console.warn = quiet;
} else {
  scene = new USDLoader().parse(bytes.toString());
  clips = scene.animations;
}
const mixer = new three.AnimationMixer(scene);
for (const clip of clips) {
  const action = mixer.clipAction(clip);
  action.setLoop(three.LoopOnce);
  action.clampWhenFinished = true;
  action.play();
}
const skins = [];
scene.traverse((n) => { if (n.isSkinnedMesh) skins.push(n); });
const answer = process.argv.slice(3).map((seconds) => {
  mixer.setTime(Number(seconds));
  scene.updateMatrixWorld(true);
  return skins.map((s) => {
    s.skeleton.update();
    const box = new three.Box3(), v = new three.Vector3(), p = s.geometry.attributes.position;
    for (let i = 0; i < p.count; ++i) {
      s.applyBoneTransform(i, v.fromBufferAttribute(p, i));
      box.expandByPoint(v.applyMatrix4(s.matrixWorld));
    }
    return [box.min.toArray(), box.max.toArray()];
  });
});
console.log(JSON.stringify(answer));
