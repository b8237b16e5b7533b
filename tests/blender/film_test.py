# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Compares films in Blender with Betwixt: positions and looks of objects over time."""

import math
import os
import subprocess
import sys
import tempfile
import time
import unittest

import bpy
import numpy as np

import betwixt_film
from betwixt_client import Server

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
betwixt = betwixt_film.betwixt()
UP = np.array(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1.0)))  # y up to z up
FILMS = ["bounce", "grab", "four-balls", "menagerie", "title", "clockwork", "gears", "letters", "mirror", "bars",
         "funnel", "potter", "blur", "chain", "figure", "eclipse"]
EASED = "rate 24\nrange 1f 25f\ncreate b box\nb.position\n  1f (0 0 0)\n  9f (4 1 0)\n  25f (-2 5 3)\n"
JUMPING = """rate 24
range 1f 25f
create b box
b.position
  1f (0 0 0) linear
  9f (8 0 0) cut (20 0 0)
  17f (28 0 0) hold
  21f (1 1 1) hold
  25f (2 2 2)
"""
SHEARED = """rate 24
range 1f 25f
create a box
create b box position=(1 0 0)
create c box position=(0 1 0)
couple b to a
couple c to b
set a.scale (1 4 1)
b.rotation.z
  1f 0deg linear
  25f 180deg
b.scale
  1f (1 1 1)
  25f (3 1 1)
"""
TURNING = """rate 24
range 1f 25f
create a box
create b box position=(2 0 0)
couple b to a
a.rotation.z
  1f 0deg linear
  25f 720deg
"""
CAMERAS = """rate 24
range 1f 25f
size 320x180
create b box
create a camera position=(0 0 9) lens=35mm
create c camera position=(5 5 5) look-at=b height=4
at 1f a.lens 35mm linear
at 25f a.lens 70mm
at 1f look through a
at 13f look through c
"""
LIGHTS = """range 1f 9f
create b box
create lamp light position=(0 3 0) range=12 intensity=2
create sun light shines=sun position=(3 4 0) intensity=1.5
"""
MATERIALS = """rate 24
range 1f 25f
create b box color=#ff8000 material=metal shininess=0.5
create g box material=glow color=#00ff00
at 1f b.color #ff8000 linear
at 25f b.color #0000ff
set g.transparency 0.25
"""
SMALL = """rate 24
range 1f 9f
size 64x36
background #0000ff
create r rectangle size=(3 3) material=glow color=#ff8000
create eye camera position=(0 0 9)
r.position
  1f (-9 0 0)
  5f (0 0 0)
"""


def example(name):
    return os.path.join(ROOT, "examples", name + ".bx")


class Case(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.scene = bpy.context.scene

    def bring(self, text, **how):
        return betwixt_film.bring_in(betwixt.loads(text), "film", self.scene, **how)[1]

    def world(self, thing, frame):
        whole = math.floor(frame)
        self.scene.frame_set(whole, subframe=frame - whole)
        return np.array(thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).matrix_world)


class Places(Case):
    def test_examples_are_where_they_should_be_at_whole_frames(self):
        for name in FILMS:
            self.setUp()
            film = betwixt.load(example(name))
            _, objects = betwixt_film.bring_in(film, name, self.scene)
            poses, worst = film.poses(), 0.0
            self.assertTrue(set(objects) <= set(poses.names), name)
            self.assertGreater(len(objects), 2, name)
            for k, frame in enumerate(poses.frames):
                self.scene.frame_set(int(frame))
                seen = bpy.context.evaluated_depsgraph_get()
                for thing, place in ((t, poses.names.index(n)) for n, t in objects.items()):
                    if thing.evaluated_get(seen).hide_viewport:
                        continue  # its position is not defined
                    there = np.array(thing.evaluated_get(seen).matrix_world)
                    should = UP @ poses.world[k, place]
                    worst = max(worst, np.abs(there - should).max() / max(1, np.abs(should).max()))
            print(f"{name}: {len(objects)} objects, {len(poses)} frames, at most {worst:.1e} off", flush=True)
            self.assertLess(worst, 1e-5, name)

    def test_cubics_are_blenders_own_and_right_between_frames(self):
        objects, film = self.bring(EASED), betwixt.loads(EASED)
        for frame in np.linspace(1, 25, 97):
            np.testing.assert_allclose(self.world(objects["b"], frame), UP @ film.eval("b.world", frame), atol=5e-6)
        curves = objects["b"].animation_data.action.fcurves
        self.assertEqual([len(c.keyframe_points) for c in curves], [3, 3, 3])
        self.assertEqual({p.interpolation for c in curves for p in list(c.keyframe_points)[:-1]}, {"BEZIER"})
        self.assertEqual({p.handle_left_type for c in curves for p in c.keyframe_points}, {"FREE"})

    def test_what_jumps_jumps_on_its_frame(self):
        objects, film = self.bring(JUMPING), betwixt.loads(JUMPING)
        for frame in list(range(1, 26)) + [8.5, 8.9, 9.1, 20.9]:
            np.testing.assert_allclose(self.world(objects["b"], frame), UP @ film.eval("b.world", frame), atol=2e-5)

    def test_turns_keep_to_the_tolerance_between_frames(self):
        objects, film = self.bring(TURNING, tolerance=1e-4), betwixt.loads(TURNING)
        for frame in np.linspace(1, 25, 49):
            np.testing.assert_allclose(self.world(objects["b"], frame), UP @ film.eval("b.world", frame), atol=5e-4)

    def test_a_stretched_thing_that_turns_within_another_is_sheared_alike(self):
        objects, film = self.bring(SHEARED), betwixt.loads(SHEARED)
        for frame in range(1, 26):
            for name in "abc":
                should = UP @ film.eval(f"{name}.world", frame)
                np.testing.assert_allclose(self.world(objects[name], frame), should, atol=2e-5)


class Looks(Case):
    def test_rate_range_and_size(self):
        self.bring("rate 30000/1001\nrange 5f 40f\nsize 640x360\ncreate b box\n")
        r = self.scene.render
        self.assertAlmostEqual(r.fps / r.fps_base, 30000 / 1001, 5)
        self.assertEqual((self.scene.frame_start, self.scene.frame_end), (5, 40))
        self.assertEqual((r.resolution_x, r.resolution_y), (640, 360))

    def test_meshes_are_the_films(self):
        text = "create s sphere radius=2\ncreate b box size=(1 2 3)\ncreate w text text=\"ab\" depth=0.2\n"
        objects, film = self.bring(text), betwixt.loads(text)
        for item in film.frame(1).items:
            made, mesh = objects[item.name].data, item.mesh()
            self.assertEqual((len(made.vertices), len(made.polygons)), (len(mesh.positions), len(mesh.triangles)))
            np.testing.assert_array_equal([tuple(v.co) for v in made.vertices], mesh.positions)
            np.testing.assert_array_equal([tuple(p.vertices) for p in made.polygons], mesh.triangles)

    def test_a_shape_that_varies_varies(self):
        text = "rate 24\nrange 1f 25f\ncreate s sphere\ns.radius\n  1f 1\n  25f 3\n"
        objects, film = self.bring(text), betwixt.loads(text)
        for frame in (1, 7, 13, 24, 25):
            self.scene.frame_set(frame)
            shown = objects["s"].evaluated_get(bpy.context.evaluated_depsgraph_get()).data
            far = max(v.co.length for v in shown.vertices)
            self.assertAlmostEqual(far, film.eval("s.radius", frame), 4)

    def test_letters_that_come_one_by_one(self):
        text = "rate 24\nrange 1f 9f\ncreate w text text=\"abc\"\nat 1f w.typed 0 linear\nat 9f w.typed 4\n"
        objects, film = self.bring(text), betwixt.loads(text)
        for frame in range(1, 10):
            self.scene.frame_set(frame)
            seen = bpy.context.evaluated_depsgraph_get()
            shown = [c.evaluated_get(seen) for c in objects["w"].children if not c.evaluated_get(seen).hide_render]
            mesh = film.frame(frame).items[0].mesh()
            self.assertEqual([len(s.data.polygons) for s in shown], [len(mesh.triangles)], frame)

    def test_what_is_hidden_is_hidden(self):
        objects = self.bring("rate 24\nrange 1f 25f\ncreate b box\nat 9f hide b\nat 20f show b\n")
        for frame in range(1, 26):
            self.scene.frame_set(frame)
            there = objects["b"].evaluated_get(bpy.context.evaluated_depsgraph_get())
            self.assertEqual((there.hide_render, there.hide_viewport), (9 <= frame < 20,) * 2)

    def test_materials(self):
        objects, film = self.bring(MATERIALS), betwixt.loads(MATERIALS)
        metal = objects["b"].data.materials[0].node_tree
        shader = metal.nodes["Principled BSDF"]
        self.assertEqual([shader.inputs[i].default_value for i in ("Metallic", "Roughness")], [1, 0.5])
        for frame in (1, 8, 25):
            self.scene.frame_set(frame)
            there = metal.evaluated_get(bpy.context.evaluated_depsgraph_get()).nodes["Principled BSDF"]
            color = there.inputs["Base Color"].default_value[:3]
            np.testing.assert_allclose(color, film.frame(frame).items[0].color, atol=1e-6)
        glow = objects["g"].data.materials[0].node_tree.nodes["Principled BSDF"].inputs
        self.assertEqual((tuple(glow["Emission"].default_value), glow["Alpha"].default_value), ((0, 1, 0, 1), 0.75))

    def test_textures_are_upright(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = betwixt.loads("film flat\nsize 8x8\nbackground #ff0000 to #0000ff").picture(1)
            picture.write(os.path.join(folder, "a.png"))
            film = betwixt.loads("create p plane size=(2 2) texture=\"a.png\"\n", os.path.join(folder, "a.bx"))
            _, objects = betwixt_film.bring_in(film, "film", self.scene)
        item = film.frame(1).items[0]
        made, mesh = objects["p"].data, item.mesh()
        nodes = made.materials[0].node_tree.nodes
        image = next(n.image for n in nodes if n.type == "TEX_IMAGE")
        pixels = np.array(image.pixels[:]).reshape(image.size[1], image.size[0], 4)
        np.testing.assert_allclose(pixels[::-1], item.texture.pixels / 255, atol=1e-6)
        for loop, uv in zip(made.loops, made.uv_layers[0].data):
            np.testing.assert_allclose((uv.uv[0], 1 - uv.uv[1]), mesh.uvs[loop.vertex_index], atol=1e-6)

    def test_cameras_cuts_and_lenses(self):
        objects, film = self.bring(CAMERAS), betwixt.loads(CAMERAS)
        self.assertEqual([(m.frame, m.camera.name) for m in self.scene.timeline_markers], [(1, "a"), (13, "c")])
        for frame in (1, 7, 12):
            self.scene.frame_set(frame)
            there = objects["a"].evaluated_get(bpy.context.evaluated_depsgraph_get()).data
            self.assertAlmostEqual(there.angle_x, film.frame(frame).camera.fov, 5)
        self.assertEqual(objects["c"].data.type, "ORTHO")
        self.assertAlmostEqual(objects["c"].data.ortho_scale, 4 * 16 / 9, 5)
        np.testing.assert_allclose(self.world(objects["c"], 20), UP @ film.frame(20).camera.world, atol=1e-5)

    def test_a_film_without_a_camera_is_seen_as_ours_is(self):
        self.bring("range 1f 9f\ncreate b box\nb.position\n  1f (0 0 0)\n  9f (9 0 0)\n")
        film = betwixt.loads("range 1f 9f\ncreate b box\nb.position\n  1f (0 0 0)\n  9f (9 0 0)\n")
        for frame in (1, 5, 9):
            should = UP @ film.frame(frame).camera.world
            np.testing.assert_allclose(self.world(self.scene.camera, frame), should, atol=1e-5)

    def test_lights(self):
        objects, film = self.bring(LIGHTS), betwixt.loads(LIGHTS)
        lamp = objects["lamp"].data
        self.assertEqual(lamp.type, "POINT")
        self.assertAlmostEqual(lamp.energy, 4 * math.pi**2 * 9 * 2 * (1 - (3 / 12) ** 2) ** 2, 3)
        sun = bpy.data.objects["sun light"]
        self.assertAlmostEqual(sun.data.energy, 1.5 * math.pi, 5)
        should = UP[:3, :3] @ film.frame(1).lights[1].direction
        np.testing.assert_allclose(-self.world(sun, 1)[:3, 2], should, atol=1e-6)


class Live(Case):
    def test_it_follows_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.bx")

            def write(text):
                with open(path, "w") as script:
                    script.write(text)

            write("range 1f 9f\ncreate b box\n")
            live = betwixt_film.Live(path, self.scene)
            self.assertTrue(live.look())
            self.assertFalse(live.look())
            self.assertEqual(list(live.objects), ["b"])
            self.scene.frame_set(5)
            write("range 1f 9f\ncreate b box position=(1 2 3)\ncreate c sphere\n")
            self.assertTrue(live.look())
            self.assertEqual((list(live.objects), self.scene.frame_current), (["b", "c"], 5))
            np.testing.assert_allclose(self.world(live.objects["b"], 5)[:3, 3], (1, -3, 2))
            write("create b bxo")
            self.assertFalse(live.look())
            self.assertIn("no kind 'bxo'", live.said)
            self.assertEqual(list(live.objects), ["b", "c"])  # the last film without errors stays
            for k in range(3):
                write(f"range 1f 9f\ncreate b box position=({k} 0 0)\n")
                self.assertTrue(live.look())
            self.assertEqual((len(bpy.data.collections), len(bpy.data.meshes), len(bpy.data.materials)), (1, 1, 1))

    def test_it_follows_a_server(self):
        with tempfile.TemporaryDirectory() as folder:
            socket = os.path.join(folder, "stage.sock")
            server = subprocess.Popen([os.environ["BETWIXT_PROGRAM"], "serve", "--socket", socket, "--to", "nowhere"],
                                      stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                while not os.path.exists(socket) and server.poll() is None:
                    time.sleep(0.05)
                with Server(socket) as host:
                    host.do("create b box")
                    live = betwixt_film.Live(socket, self.scene)
                    self.assertTrue(live.look(), live.said)
                    host.do("set b.position (1 2 3)")
                    self.assertTrue(live.look(), live.said)
                    np.testing.assert_allclose(self.world(live.objects["b"], 1)[:3, 3], (1, -3, 2), atol=1e-6)
                    self.assertFalse(live.look())
                    live.stop()
            finally:
                server.terminate()
                server.wait()


class AddOn(Case):
    def test_its_operator_brings_a_film_in(self):
        betwixt_film.register()
        try:
            self.assertEqual(bpy.ops.import_scene.betwixt(filepath=example("bounce")), {"FINISHED"})
            self.assertEqual(bpy.context.scene.frame_end, 72)
            with self.assertRaisesRegex(RuntimeError, "No such file"):
                bpy.ops.import_scene.betwixt(filepath=example("nothing"))
        finally:
            betwixt_film.unregister()


class Python(Case):
    def test_another_python_on_the_path_is_not_blenders(self):
        with tempfile.TemporaryDirectory() as folder:
            # The layout of pyenv: the standard library next to bin, and no numpy.
            for name in ("bin", "lib"):
                os.mkdir(os.path.join(folder, name))
            version = "python%d.%d" % sys.version_info[:2]
            os.symlink(os.path.dirname(os.__file__), os.path.join(folder, "lib", version))
            other = os.path.join(folder, "bin", version)
            with open(other, "w") as script:
                script.write("#!/bin/sh\nexit 1\n")
            os.chmod(other, 0o755)
            said = subprocess.run(
                [os.path.join(ROOT, "tools", "blender.sh"), "-b", "--factory-startup", "--python-exit-code", "3",
                 "--python-expr", "import sys, numpy; print('PREFIX', sys.prefix)"],
                env={**os.environ, "PATH": f"{folder}/bin:" + os.environ["PATH"]}, capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said)
        self.assertIn(f"PREFIX {sys.prefix}\n", said.stdout)


class Cycles(Case):
    def cycles(self, *words):
        return subprocess.run([os.path.join(ROOT, "tools", "cycles.sh"), *words], capture_output=True, text=True)

    def test_one_command_renders_a_film(self):
        with tempfile.TemporaryDirectory() as folder:
            script, film = os.path.join(folder, "a.bx"), os.path.join(folder, "a.mp4")
            betwixt.loads(SMALL).write(script)
            said = self.cycles(script, "-o", os.path.join(folder, "f-%d.png"), "--samples", "4", "--frames", "4..5")
            self.assertEqual((said.returncode, sorted(os.listdir(folder))), (0, ["a.bx", "f-4.png", "f-5.png"]), said)
            image = bpy.data.images.load(os.path.join(folder, "f-5.png"))
            pixels = np.array(image.pixels[:]).reshape(36, 64, 4)
            np.testing.assert_allclose(pixels[18, 32], (1, 128 / 255, 0, 1), atol=0.01)
            np.testing.assert_allclose(pixels[2, 2], (0, 0, 1, 1), atol=0.01)
            ours = betwixt.load(script).picture(5).pixels[::-1] / 255
            self.assertLess(np.abs(pixels - ours).mean(), 0.02)  # edges may differ
            said = self.cycles(script, "-o", film, "--samples", "1", "--size", "32x18")
            self.assertEqual(said.returncode, 0, said)
            self.assertGreater(os.path.getsize(film), 500)

    def test_what_is_wrong_is_said(self):
        with tempfile.TemporaryDirectory() as folder:
            script = os.path.join(folder, "a.bx")
            with open(script, "w") as film:
                film.write("create b bxo\n")
            said = self.cycles(script, "-o", os.path.join(folder, "a.mp4"))
        self.assertEqual(said.returncode, 1)
        self.assertIn("did you mean 'box'?", said.stderr)
