// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// three.js: two gears that mesh, as examples/gears.bx (with trapezoids for the involutes of its teeth).
import * as THREE from 'three';

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(1280, 720);
document.body.appendChild(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color('lightgray');
const camera = new THREE.PerspectiveCamera(40, 1280 / 720, 0.1, 100);
camera.position.set(2, 3, 10);
camera.lookAt(0.6, 0, 0);
scene.add(new THREE.HemisphereLight('white', 'gray', 1));
const sun = new THREE.DirectionalLight('white', 2);
sun.position.set(5, 8, 10);
scene.add(sun);

const module = 0.12;

function gear(teeth, inner, color) {
  const pitch = (module * teeth) / 2;
  const outer = pitch + module;
  const root = pitch - 1.25 * module;
  const step = (2 * Math.PI) / teeth;
  const shape = new THREE.Shape();
  for (let i = 0; i < teeth; i++) {
    const corners = [[root, -0.32], [outer, -0.14], [outer, 0.14], [root, 0.32]];
    for (const [radius, share] of corners) {
      const angle = (i + share) * step;
      const x = radius * Math.cos(angle);
      const y = radius * Math.sin(angle);
      if (shape.curves.length === 0 && i === 0 && share === -0.32) shape.moveTo(x, y);
      else shape.lineTo(x, y);
    }
  }
  shape.closePath();
  const hole = new THREE.Path();
  hole.absarc(0, 0, inner, 0, 2 * Math.PI, true);
  shape.holes.push(hole);
  const geometry = new THREE.ExtrudeGeometry(shape, { depth: 0.3, bevelEnabled: false });
  const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color }));
  scene.add(mesh);
  return mesh;
}

const small = gear(16, 0.25, 'gold');
const large = gear(40, 0.5, 'steelblue');
small.position.x = (-(16 + 40) * module) / 4;
large.position.x = ((16 + 40) * module) / 4;

const clock = new THREE.Clock();
renderer.setAnimationLoop(() => {
  const turned = ((clock.getElapsedTime() % 4) / 4) * 1.5 * 2 * Math.PI;
  small.rotation.z = -turned;
  large.rotation.z = Math.PI / 40 + (turned * 16) / 40;
  renderer.render(scene, camera);
});
