# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests of poses, frames, meshes and tracks."""

import gc
import math
import unittest

import numpy as np
from support import example

import betwixt

ARM = """rate 24
range 1f 25f
create arm box size=(2 1 1) color=#ff0000
create tip sphere radius=3 position=(2 0 0) transparency=0.25 material=metal
create lamp light position=(1 2 3)
create eye camera position=(0 0 20) lens=36mm
couple tip to arm
arm.rotation.z
  1f 0deg linear
  25f 360deg
tip.scale
  1f (1 1 1) linear
  25f (2 4 6)
at 13f note "half"
at 5f look through eye
"""


class Poses(unittest.TestCase):
    def test_a_turning_arm_carries_its_tip(self):
        poses = betwixt.loads(ARM).poses()
        self.assertEqual(poses.names, ["arm", "tip", "lamp", "eye"])
        self.assertEqual((len(poses), poses.world.shape), (25, (25, 4, 4, 4)))
        np.testing.assert_array_equal(poses.frames, np.arange(1, 26))
        for k, world in enumerate(poses["tip"]):
            a, share = 2 * math.pi * k / 24, k / 24
            turn = np.array(((math.cos(a), -math.sin(a), 0), (math.sin(a), math.cos(a), 0), (0, 0, 1)))
            scale = np.diag((1 + share, 1 + 3 * share, 1 + 5 * share))
            np.testing.assert_allclose(world[:3, :3], turn @ scale, atol=1e-9)
            np.testing.assert_allclose(world[:3, 3], turn @ (2, 0, 0), atol=1e-9)
            np.testing.assert_array_equal(world[3], (0, 0, 0, 1))
        np.testing.assert_array_equal(poses.parents, [[-1, 0, -1, -1]] * 25)

    def test_poses_are_worlds_in_every_order(self):
        film = betwixt.load(example("grab.bx"))
        poses = film.poses("10f", 40, step=2.5)
        for name in poses.names:
            np.testing.assert_array_equal(poses[name], film.eval(f"{name}.world", poses.frames), name)

    def test_arrays_are_views_that_keep_what_they_show(self):
        film = betwixt.loads(ARM)
        poses = film.poses()
        world, same, tip = poses.world, poses.world, poses["tip"]
        self.assertTrue(np.shares_memory(world, same) and np.shares_memory(world, tip))
        self.assertFalse(world.flags.writeable or world.flags.owndata)
        before = world.copy()
        del film, poses, same
        gc.collect()
        betwixt.loads(ARM).poses()  # uses the memory if it was freed by mistake
        np.testing.assert_array_equal(world, before)
        np.testing.assert_array_equal(tip, before[:, 1])

    def test_films_without_things(self):
        poses = betwixt.loads("").poses()
        self.assertEqual((poses.names, poses.world.shape), ([], (24, 0, 4, 4)))
        self.assertRaises(KeyError, lambda: poses["ball"])

    def test_wrong_calls(self):
        film = betwixt.loads(ARM)
        for call, said in ((lambda: film.poses(9, 3), "the segment ends before it begins"),
                           (lambda: film.poses(step=0), "a step is a number of frames above 0"),
                           (lambda: film.poses(step=float("nan")), "a step is a number of frames above 0"),
                           (lambda: film.poses(1, 1e9), "that is more than can be held at once"),
                           (lambda: film.poses("x"), "'x' is not a time")):
            with self.assertRaisesRegex(betwixt.Error, said):
                call()


class Frames(unittest.TestCase):
    def test_what_is_seen(self):
        frame = betwixt.loads(ARM + "set eye.shutter 180deg\nbackground black\nat 20f hide arm\n").frame(13)
        self.assertEqual((frame.time, frame.seconds, frame.notes, frame.problems), (13, 0.5, ["half"], []))
        arm, tip = frame.items
        self.assertEqual((arm.name, arm.kind, tip.body, tip.material), ("arm", "box", "arm", "metal"))
        np.testing.assert_array_equal(arm.color, (1, 0, 0))
        np.testing.assert_allclose(tip.world[:3, 3], (-2, 0, 0), atol=1e-12)
        self.assertEqual((tip.transparency, tip.casts, tip.texture), (0.25, True, None))
        (lamp,) = frame.lights
        self.assertEqual((lamp.name, lamp.sun), ("lamp", False))
        np.testing.assert_array_equal(lamp.position, (1, 2, 3))
        self.assertEqual((frame.camera.name, frame.camera.orthographic), ("eye", False))
        self.assertAlmostEqual(frame.camera.fov, 2 * math.atan(18 / 36))  # the film is 36 mm wide
        self.assertAlmostEqual(frame.camera.shutter, 0.5 / 24)
        np.testing.assert_array_equal(frame.background, (0, 0, 0))
        self.assertEqual(len(betwixt.loads(ARM + "at 20f hide arm\n").frame(20).items), 1)

    def test_meshes_are_in_the_space_of_their_objects(self):
        arm, tip = betwixt.loads(ARM).frame(1).items
        box = arm.mesh()
        np.testing.assert_array_equal(box.positions.min(0), (-1, -0.5, -0.5))
        np.testing.assert_array_equal(box.positions.max(0), (1, 0.5, 0.5))
        for mesh, volume, off in ((box, 2, 1e-6), (tip.mesh(), 4 / 3 * math.pi * 27, 1.5)):
            a, b, c = (mesh.positions[mesh.triangles[:, k]].astype(float) for k in range(3))
            self.assertAlmostEqual(np.einsum("ij,ij->", a, np.cross(b, c)) / 6, volume, delta=off)  # facing outwards
            np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-6)
            outwards = np.einsum("ij,ij->i", np.cross(b - a, c - a), mesh.normals[mesh.triangles[:, 0]])
            self.assertTrue((outwards >= -1e-6).all())
            self.assertTrue(mesh.closed)
            self.assertFalse(mesh.positions.flags.writeable)
        np.testing.assert_allclose(np.linalg.norm(tip.mesh().positions, axis=1), 3, rtol=1e-6)
        self.assertGreater(len(tip.mesh(96).triangles), 3 * len(tip.mesh(48).triangles))
        for around in (0, 5, 5000):
            with self.assertRaisesRegex(betwixt.Error, "6 to 1024 faces"):
                tip.mesh(around)

    def test_normals_of_what_is_stretched_stand_upright(self):
        (thing,) = betwixt.loads("create c cylinder radius=4 height=1\n").frame(1).items
        mesh = thing.mesh()
        side = np.abs(mesh.normals[:, 1]) < 0.5
        around = mesh.positions[side][:, (0, 2)]
        np.testing.assert_allclose(mesh.normals[side][:, (0, 2)] * 4, around, atol=1e-4)

    def test_meshes_of_files_have_their_parts(self):
        film = betwixt.load(example("menagerie.bx"))
        meshes = [i.mesh() for i in film.frame(10).items if i.kind == "mesh"]
        self.assertGreater(len(meshes), 1)
        for mesh in meshes:
            self.assertGreater(len(mesh.triangles), 100)
            self.assertLess(mesh.triangles.max(), len(mesh.positions))
            self.assertEqual(sum(p.count for p in mesh.parts) or len(mesh.triangles), len(mesh.triangles))

    def test_what_a_part_shows_outlives_the_frame(self):
        world = betwixt.loads(ARM).frame(13).items[1].world
        positions = betwixt.loads(ARM).frame(13).items[0].mesh().positions
        gc.collect()
        betwixt.loads(ARM).frame(1)
        np.testing.assert_allclose(world[:3, 3], (-2, 0, 0), atol=1e-12)
        np.testing.assert_array_equal(np.abs(positions), [(1, 0.5, 0.5)] * len(positions))


class Tracks(unittest.TestCase):
    def test_events_are_as_they_were_written(self):
        film = betwixt.loads("rate 24\ncreate ball sphere\nball.position\n  1f (0 0 0) linear ease-out=4f\n"
                             "  9f (1 2 3) bezier(0.1 0.2 0.3 0.4)\n  13f (0 0 0) cut (5 5 5)\n"
                             "extend ball.position cycle\n")
        (track,) = film.tracks("ball")
        self.assertEqual((track.name, track.object, len(track), track.after), ("ball.position", "ball", 3, "cycle"))
        first, middle, last = track.events
        self.assertEqual((first.time, first.seconds, first.twerper, first.ease_out), (1, 0, "linear", 4))
        self.assertEqual((middle.twerper, middle.arguments), ("bezier", [0.1, 0.2, 0.3, 0.4]))
        np.testing.assert_array_equal(middle.value, (1, 2, 3))
        self.assertIsNone(middle.before)
        self.assertEqual([t.name for t in film.tracks()], ["ball.position"])
        self.assertEqual([t.name for t in film.tracks("ball.position.x")], ["ball.position"])
        self.assertEqual(film.tracks("ball.color"), [])
        with self.assertRaisesRegex(betwixt.Error, "no object 'bal'"):
            film.tracks("bal.position")

    def test_what_else_a_film_says(self):
        film = betwixt.loads(ARM)
        self.assertEqual((film.range, film.rate, film.size), ((1, 25), 24, None))
        self.assertEqual((film.notes, film.cuts), ([(13, "half")], [(5, "eye")]))
        self.assertEqual(betwixt.loads("create eye camera\nlook through eye").cuts, [(-math.inf, "eye")])
        parts = betwixt.loads("create b sphere\nsection one at 1s speed=2\n  at 49f step \"x\" note=\"y\"\n  at 25f describe \"z\"")
        self.assertEqual(parts.sections, [{"name": "one", "begin": 25, "end": 49, "speed": 2}])
        self.assertEqual(parts.steps, [{"frame": 49, "text": "x", "note": "y"}])
        self.assertEqual(parts.descriptions, [(37, "z")])
        self.assertEqual(film.kind("tip"), "sphere")
        self.assertEqual((film.time("0.5s"), film.seconds(13), film.time(7.5)), (13, 0.5, 7.5))
        with self.assertRaisesRegex(betwixt.Error, "no object 'nobody'"):
            film.kind("nobody")
        self.assertEqual(betwixt.loads("create a box\nat 5f hide a\nat 9f show a").breaks(1, 24), [5, 9])
