// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// three.js without pictures: tracks by an AnimationMixer, then the matrices of the world.
//   node three.mjs ROW ROUNDS        keys, random, shared, rest, move, tree, parse
//   node three.mjs compare <LINES    see scene.mjs
import * as THREE from 'three';
import { compare, frameOf, framesOf, functions, keys, measure, seconds, valueOf } from './scene.mjs';

const [row, rounds = '5'] = process.argv.slice(2);
const perFrame = 1e6; // milliseconds

function track(object, f, shared) {
  const times = [], values = [], turn = new THREE.Quaternion(), euler = new THREE.Euler();
  for (let i = 0; i < keys; ++i) {
    times.push(seconds(frameOf(shared, object, f, i)));
    const value = valueOf(object, f, i);
    if (f === 1) values.push(...turn.setFromEuler(euler.set(...value.map(THREE.MathUtils.degToRad), 'XYZ')).toArray());
    else values.push(...value);
  }
  if (f === 1) return new THREE.QuaternionKeyframeTrack(`b${object}.quaternion`, times, values);
  return new THREE.VectorKeyframeTrack(`b${object}.${f === 0 ? 'position' : 'scale'}`, times, values);
}

// Goes to the time of a frame; forward by the step, which keeps the places in the tracks.
function player(root, tracks) {
  const mixer = new THREE.AnimationMixer(root);
  mixer.clipAction(new THREE.AnimationClip('film', -1, tracks)).play();
  let now = 0;
  return frame => {
    const to = seconds(frame);
    if (to >= now) mixer.update(to - now);
    else mixer.setTime(to);
    now = to;
  };
}

function keyed(count, shared) {
  const root = new THREE.Group(), tracks = [];
  for (let k = 0; k < count; ++k) {
    const o = new THREE.Object3D();
    o.name = `b${k}`;
    root.add(o);
    for (let f = 0; f < functions; ++f) tracks.push(track(k, f, shared));
  }
  return { root, go: player(root, tracks) };
}

function mover(name, x) {
  return new THREE.VectorKeyframeTrack(`${name}.position`, [1, 300, 600].map(seconds), [x, 0, 0, x, 5, 0, 0, 0, 1]);
}

function boxes(count, moving) {
  const root = new THREE.Scene(), tracks = [];
  for (let k = 1; k <= count; ++k) {
    const o = new THREE.Object3D();
    root.add(o);
    if (moving && k % (count / moving) === 0) o.name = `b${k}`, tracks.push(mover(o.name, k / (count / moving)));
  }
  return { root, go: tracks.length ? player(root, tracks) : () => {} };
}

function tree(count) {
  const nodes = [];
  for (let k = 0; k < count; ++k) {
    const o = new THREE.Object3D();
    o.position.set(1, 0.5, 0);
    nodes.push(o);
    if (k > 0) nodes[Math.floor((k - 1) / 10)].add(o);
  }
  nodes[0].name = 'n0';
  return { root: nodes[0], go: player(nodes[0], [mover('n0', 1)]) };
}

function both(scene, frames, unit) {
  measure('three.js', Number(rounds), frames, unit, frame => {
    scene.go(frame);
    scene.root.updateMatrixWorld();
  });
}

// A clip of a million keys from JSON.
function parse() {
  const tracks = [];
  for (let k = 0; k < 1000; ++k) {
    const times = [], values = [];
    for (let f = 1; f <= 1000; ++f) {
      times.push(f / 24);
      values.push(k * 0.25, ((k * 37 + f * 101) % 2001) / 100, (f % 50) * 0.5);
    }
    tracks.push({ name: `ball${k}.position`, type: 'vector', times, values });
  }
  const text = JSON.stringify({ name: 'film', duration: 42, tracks });
  for (let i = 0; i < Number(rounds); ++i) {
    const begun = process.hrtime.bigint();
    const clip = THREE.AnimationClip.parse(JSON.parse(text));
    const ms = Number(process.hrtime.bigint() - begun) / 1e6;
    if (clip.tracks.length !== 1000 || Math.abs(clip.tracks[7].values[3 * 30 + 1] - 13.89) > 1e-4) throw new Error('a value');
    console.log('three.js', text.length / 1e3 / ms);
  }
}

if (row === 'compare') {
  const { root, go } = keyed(100, false);
  await compare('three.js', (object, frame) => {
    go(frame);
    root.updateMatrixWorld();
    const o = root.children[object];
    // Turns are blended as quaternions here, as angles there: the same at a key only.
    return [...o.position.toArray(), null, null, null, ...o.scale.toArray(), ...(frame === 1 ? o.matrixWorld.clone().transpose().toArray() : [])];
  });
} else if (row === 'rest') both(boxes(100000, 0), framesOf(row).slice(0, 50), perFrame);
else if (row === 'move') both(boxes(100000, 1000), framesOf(row).slice(0, 50), perFrame);
else if (row === 'tree') both(tree(100000), framesOf(row).slice(0, 20), 100000);
else if (row === 'parse') parse();
else {
  const scene = keyed(1000, row === 'shared');
  measure('three.js-tracks', Number(rounds), framesOf(row), 1000, scene.go);
  both(scene, framesOf(row), 1000);
}
process.exit(0);
