// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// three.js: a box unfolds and a star rises out of it, as examples/unfold.bx.
import * as THREE from 'three';
import { Sky } from 'three/addons/objects/Sky.js';

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(1280, 720);
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = THREE.VSMShadowMap;
document.body.appendChild(renderer.domElement);
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(32, 1280 / 720, 0.1, 2000);
camera.position.set(5.5, 4.5, 7.5);
camera.lookAt(0, 1, -0.4);
const sun = new THREE.DirectionalLight('white', 3);
sun.position.set(-4, 7, 3);
sun.castShadow = true;
sun.shadow.mapSize.set(2048, 2048);
sun.shadow.radius = 6;
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

// A sheet that turns about its near edge.
function sheet(color) {
  const mesh = new THREE.Mesh(
    new THREE.BoxGeometry(2, 0.06, 2),
    new THREE.MeshStandardMaterial({ color }),
  );
  mesh.castShadow = mesh.receiveShadow = true;
  mesh.position.z = 1;
  const hinge = new THREE.Group();
  hinge.add(mesh);
  return hinge;
}
const floor = sheet('peru');
floor.position.set(0, 0.03, -1);
scene.add(floor);
const walls = [];
for (let i = 1; i <= 4; i++) {
  const side = new THREE.Group();
  side.rotation.y = (i * Math.PI) / 2;
  const wall = sheet('tan');
  wall.position.set(0, 0.03, 1);
  side.add(wall);
  scene.add(side);
  walls.push(wall);
}
const lid = sheet('peru');
lid.position.z = 2;
walls[1].add(lid);

const outline = new THREE.Shape();
for (let k = 0; k < 10; k++) {
  const angle = Math.PI / 2 + (k * Math.PI) / 5;
  const radius = k % 2 ? 0.22 : 0.5;
  outline[k ? 'lineTo' : 'moveTo'](radius * Math.cos(angle), radius * Math.sin(angle));
}
const star = new THREE.Mesh(
  new THREE.ExtrudeGeometry(outline, { depth: 0.2, bevelEnabled: false }),
  new THREE.MeshStandardMaterial({ color: 'gold', metalness: 1, roughness: 0.3 }),
);
star.castShadow = true;
scene.add(star);

const clamp = THREE.MathUtils.clamp;
const share = (t, from, to) => clamp((t - from) / (to - from), 0, 1);
const cubicInOut = (u) => (u < 0.5 ? 4 * u ** 3 : 1 - (2 - 2 * u) ** 3 / 2);
function bounceOut(u) {
  if (u < 1 / 2.75) return 7.5625 * u * u;
  if (u < 2 / 2.75) return 7.5625 * (u - 1.5 / 2.75) ** 2 + 0.75;
  if (u < 2.5 / 2.75) return 7.5625 * (u - 2.25 / 2.75) ** 2 + 0.9375;
  return 7.5625 * (u - 2.625 / 2.75) ** 2 + 0.984375;
}
const clock = new THREE.Clock();
renderer.setAnimationLoop(() => {
  const t = clock.getElapsedTime() % 5;
  lid.rotation.x = (-Math.PI / 2) * (1 - cubicInOut(share(t, 0.375, 1.5)));
  walls.forEach((wall, k) => {
    wall.rotation.x = (-Math.PI / 2) * (1 - bounceOut(share(t, 1.5 + 0.25 * k, 3 + 0.25 * k)));
  });
  star.position.y = 0.6 + cubicInOut(share(t, 1.2, 3.3));
  star.rotation.y = (t / 5) * 4 * Math.PI;
  renderer.render(scene, camera);
});
