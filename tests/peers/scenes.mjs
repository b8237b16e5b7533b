// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Prints the nodes and the vertices of scenes at random times, as three.js has them. The tests of imported scenes use
// it.
//   node scenes.mjs FILE.glb|FILE.bvh… >OUT   lines: world TIME NODE 16 numbers, column by column; vertex TIME NODE NUMBER x y z
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import * as three from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { BVHLoader } from "three/examples/jsm/loaders/BVHLoader.js";

globalThis.self = globalThis;

async function load(path) {
  const bytes = readFileSync(path);
  if (path.endsWith(".bvh")) {
    const { skeleton, clip } = new BVHLoader().parse(bytes.toString());
    const scene = new three.Group();
    scene.add(skeleton.bones[0]);
    return { scene, clip };
  }
  const whole = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const gltf = await new GLTFLoader().parseAsync(whole, "");
  return { scene: gltf.scene, clip: gltf.animations[0] };
}

let seed = 12345;
const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;

for (const path of process.argv.slice(2)) {
  const { scene, clip } = await load(path);
  console.log(`file ${basename(path)}`);
  const mixer = new three.AnimationMixer(scene);
  const action = mixer.clipAction(clip);
  action.setLoop(three.LoopOnce);
  action.clampWhenFinished = true;
  action.play();
  for (let i = 0; i < 8; ++i) {
    const time = Math.round(clip.duration * random() * 1000) / 1000;
    mixer.setTime(time);
    scene.updateMatrixWorld(true);
    scene.traverse((node) => {
      if (node === scene || node.name === "ENDSITE") return;
      if (!node.isSkinnedMesh) console.log("world", time, node.name, node.matrixWorld.elements.join(" "));
      if (!node.isMesh || i % 2) return;
      const count = node.geometry.attributes.position.count, place = new three.Vector3();
      for (let v = 0; v < count; v += Math.ceil(count / 24)) {
        node.getVertexPosition(v, place).applyMatrix4(node.matrixWorld);
        console.log("vertex", time, node.name, v, place.toArray().join(" "));
      }
    });
  }
}
