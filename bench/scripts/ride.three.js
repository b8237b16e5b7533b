// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// three.js: a camera that rides along a road through a wood, as examples/ride.bx.
import * as THREE from 'three';
import { Sky } from 'three/addons/objects/Sky.js';

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(1280, 720);
renderer.shadowMap.enabled = true;
document.body.appendChild(renderer.domElement);
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(43, 1280 / 720, 0.1, 2000);

const sun = new THREE.DirectionalLight('white', 3);
sun.position.set(25, 40, 15);
sun.castShadow = true;
sun.shadow.mapSize.set(4096, 4096);
Object.assign(sun.shadow.camera, { left: -50, right: 50, top: 50, bottom: -50, far: 150 });
scene.add(sun, new THREE.HemisphereLight('skyblue', 'gray', 1));
const sky = new Sky();
sky.scale.setScalar(1000);
sky.material.uniforms.sunPosition.value.copy(sun.position);
scene.add(sky);
const ground = new THREE.Mesh(
  new THREE.PlaneGeometry(1000, 1000),
  new THREE.MeshStandardMaterial({ color: 'darkgray' }),
);
ground.rotation.x = -Math.PI / 2;
ground.receiveShadow = true;
scene.add(ground);
scene.fog = new THREE.Fog('lightgray', 50, 400);

const curve = (points) => new THREE.CatmullRomCurve3(points.map((p) => new THREE.Vector3(...p)), true);
const road = new THREE.Mesh(
  new THREE.TubeGeometry(
    curve([[0, 0.06, 0], [0, 0.06, -14], [8, 0.06, -24], [20, 0.06, -26], [28, 0.06, -16], [22, 0.06, -4], [10, 0.06, 2]]),
    400, 0.06, 8, true,
  ),
  new THREE.MeshStandardMaterial({ color: 'white' }),
);
scene.add(road);

const trees = new THREE.InstancedMesh(
  new THREE.ConeGeometry(0.9, 3),
  new THREE.MeshStandardMaterial({ color: 'forestgreen' }),
  120,
);
trees.castShadow = true;
const tree = new THREE.Object3D();
for (let i = 0; i < 120; i++) {
  const size = Math.random();
  tree.position.set(Math.random() * 44 - 8, 1.5, Math.random() * 44 - 34);
  tree.scale.set(0.6 + size * 0.8, 0.7 + size * 0.9, 0.6 + size * 0.8);
  tree.updateMatrix();
  trees.setMatrixAt(i, tree.matrix);
}
scene.add(trees);

const track = curve([[0, 1, 0], [0, 1, -14], [8, 1, -24], [20, 1.6, -26], [28, 2, -16], [22, 1.2, -4], [10, 1, 2]]);
const clock = new THREE.Clock();
renderer.setAnimationLoop(() => {
  const u = (clock.getElapsedTime() / 8) % 1;
  camera.position.copy(track.getPointAt(u));
  camera.lookAt(camera.position.clone().add(track.getTangentAt(u)));
  renderer.render(scene, camera);
});
