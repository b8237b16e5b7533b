// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// three.js: fifteen pendulums that fall out of step and find back together, as examples/pendulum-wave.bx.
import * as THREE from 'three';

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(1280, 720);
document.body.appendChild(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color('lightgray');
const camera = new THREE.PerspectiveCamera(40, 1280 / 720, 0.1, 100);
camera.position.set(4.5, 1.2, 5.5);
camera.lookAt(0, 0.9, 0);
scene.add(new THREE.HemisphereLight('white', 'gray', 1));
const sun = new THREE.DirectionalLight('white', 2);
sun.position.set(5, 8, 3);
scene.add(sun);

const swing = THREE.MathUtils.degToRad(30);
const pendulums = [];
for (let i = 1; i <= 15; i++) {
  const period = 20 / (16 + i);
  const length = (9.81 * (period / (2 * Math.PI)) ** 2) * 5;
  const pendulum = new THREE.Group();
  pendulum.position.set(0, 2, (i - 8) * 0.35);
  const string = new THREE.Mesh(
    new THREE.CylinderGeometry(0.0075, 0.0075, length),
    new THREE.MeshStandardMaterial({ color: 'silver' }),
  );
  string.position.y = -length / 2;
  const ball = new THREE.Mesh(
    new THREE.SphereGeometry(0.14, 32, 16),
    new THREE.MeshStandardMaterial({ color: new THREE.Color().setHSL(i / 15, 0.7, 0.6), roughness: 0.2 }),
  );
  ball.position.y = -length;
  pendulum.add(string, ball);
  scene.add(pendulum);
  pendulums.push({ pendulum, period });
}

const clock = new THREE.Clock();
renderer.setAnimationLoop(() => {
  const t = clock.getElapsedTime() % 20;
  for (const { pendulum, period } of pendulums) {
    pendulum.rotation.z = swing * Math.cos((2 * Math.PI * t) / period);
  }
  renderer.render(scene, camera);
});
