# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests of pictures and films."""

import json
import os
import signal
import struct
import subprocess
import tempfile
import threading
import unittest
import zlib

import numpy as np
from support import PROGRAM, example

import betwixt

FLAT = """film flat
size 64x36
samples 1
rate 24
range 1f 9f
background #0000ff
create r rectangle size=(100 100) color=#ff8000
"""


def read_png(data):
    """Decodes a PNG of four channels with eight bits, as betwixt writes them."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, width, height = 8, b"", 0, 0
    while at < len(data):
        (length,), kind = struct.unpack(">I", data[at:at + 4]), data[at + 4:at + 8]
        if kind == b"IHDR":
            width, height, bits, colors = struct.unpack(">IIBB", data[at + 8:at + 18])
            assert (bits, colors) == (8, 6)
        packed += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += length + 12
    raw = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + 4 * width)
    out, above = np.zeros((height, width, 4), np.int64), np.zeros((width, 4), np.int64)
    for y in range(height):
        how, row, left, corner = raw[y, 0], raw[y, 1:].reshape(width, 4).astype(np.int64), 0, 0
        for x in range(width):
            a, b, c = left, above[x], corner
            p = a + b - c
            above_or_corner = np.where(abs(p - b) <= abs(p - c), b, c)
            best = np.where((abs(p - a) <= abs(p - b)) & (abs(p - a) <= abs(p - c)), a, above_or_corner)
            left = out[y, x] = (row[x] + (0, a, b, (a + b) // 2, best)[how]) % 256
            corner = b
        above = out[y]
    return out


class Pictures(unittest.TestCase):
    def test_a_plain_colour(self):
        picture = betwixt.loads(FLAT).picture(1)
        self.assertEqual((picture.width, picture.height, picture.pixels.shape), (64, 36, (36, 64, 4)))
        np.testing.assert_array_equal(picture.pixels, np.broadcast_to((255, 128, 0, 255), (36, 64, 4)))
        np.testing.assert_array_equal(np.asarray(picture), picture.pixels)
        self.assertEqual(np.asarray(picture, dtype=float).dtype, np.dtype(float))
        self.assertFalse(picture.pixels.flags.writeable or picture.pixels.flags.owndata)
        behind = betwixt.loads(FLAT + "at 5f hide r").picture(5)
        np.testing.assert_array_equal(behind.pixels[..., :3], [[(0, 0, 255)] * 64] * 36)

    def test_it_is_the_programs_picture_byte_for_byte(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, how in (("bounce.bx", {}), ("grab.bx", {"style": "wireframe", "samples": 9}),
                              ("bounce.bx", {"shutter": "180deg", "subframes": 4})):
                path, words = os.path.join(folder, "there.png"), [w for k, v in how.items() for w in ("--" + k, str(v))]
                subprocess.run([PROGRAM, "frame", example(name), "--at", "20f", "--size", "80x45", "-o", path, *words],
                               check=True)
                with open(path, "rb") as there:
                    ours = betwixt.load(example(name)).picture("20f", size=(80, 45), **how)
                    self.assertEqual(ours.png(), there.read())

    def test_its_png_has_its_pixels(self):
        picture = betwixt.load(example("bounce.bx")).picture(24, size=(80, 45))
        np.testing.assert_array_equal(read_png(picture._repr_png_()), picture.pixels)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.png")
            picture.write(path)
            with open(path, "rb") as there:
                self.assertEqual(there.read(), picture.png())
            with self.assertRaises(betwixt.Error):
                picture.write(path, overwrite=False)
            jpeg = os.path.join(folder, "a.JPG")
            picture.write(jpeg)
            with open(jpeg, "rb") as there:
                self.assertEqual(there.read(3), b"\xff\xd8\xff")
            with self.assertRaisesRegex(betwixt.Error, "written as .png or .jpg"):
                picture.write(os.path.join(folder, "a.bmp"))

    def test_what_is_clear_is_clear(self):
        picture = betwixt.loads(FLAT.replace("#0000ff", "transparent") + "at 5f hide r").picture(5)
        self.assertEqual(picture.pixels.max(), 0)

    def test_wrong_calls(self):
        film = betwixt.loads(FLAT)
        for how, said in (({"style": "shadd"}, "there is no style 'shadd'"), ({"size": (0, 4)}, "a picture of 0x4"),
                          ({"samples": 3}, "3 samples"), ({"samples": "many"}, "samples is a number"), ({"shutter": "x"}, "'x' is not a shutter time"),
                          ({"subframes": 0}, "subframes are 1 to 4096")):
            with self.assertRaisesRegex(betwixt.Error, said):
                film.picture(1, **how)
        for how in ({"size": 3}, {"size": (1, 2, 3)}, {"size": ("a", "b")}, {"colour": 1}):
            with self.assertRaises(TypeError):
                film.picture(1, **how)
        self.assertIn("shaded", betwixt.styles())


class Films(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.film = betwixt.loads(FLAT)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_a_film_has_its_frames(self):
        made = self.film.render(self.path("a.mp4"), size=(128, 72))
        said = json.loads(subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-show_entries",
             "stream=width,height,nb_read_frames,r_frame_rate", "-of", "json", self.path("a.mp4")],
            capture_output=True, check=True).stdout)["streams"][0]
        self.assertEqual(said, {"width": 128, "height": 72, "r_frame_rate": "24/1", "nb_read_frames": "9"})
        self.assertEqual((made.frames, made.found), (9, 0))

    def test_pictures_are_those_of_the_program(self):
        self.film.render(self.path("a-%02d.png"), frames=(3, "5f"))
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["a-03.png", "a-04.png", "a-05.png"])
        with open(self.path("a-04.png"), "rb") as there:
            self.assertEqual(there.read(), self.film.picture(4).png())
        os.remove(self.path("a-04.png"))
        made = self.film.render(self.path("a-%02d.png"), frames=(3, 5), missing=True)
        self.assertEqual((made.frames, made.found), (3, 2))

    def test_progress_is_told_from_this_thread(self):
        told = []
        self.film.render(self.path("a-%02d.png"), progress=lambda *what: told.append((threading.get_ident(), what)))
        self.assertEqual({who for who, _ in told}, {threading.get_ident()})
        self.assertEqual([frames for _, (_, frames, _) in told], [9] * len(told))
        self.assertEqual(told[-1][1][0], 9)
        self.assertEqual(sorted(what[0] for _, what in told), [what[0] for _, what in told])

    def test_who_says_false_ends_it_and_nothing_is_left(self):
        with self.assertRaisesRegex(betwixt.Error, "stopped"):
            self.film.render(self.path("a.mp4"), progress=lambda *_: False)
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_what_progress_raises_comes_through(self):
        def progress(*_):
            raise KeyError("mine")
        with self.assertRaisesRegex(KeyError, "mine"):
            self.film.render(self.path("a.mp4"), progress=progress)
        with self.assertRaises(TypeError):
            self.film.render(self.path("a.mp4"), progress=lambda: None)
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_ctrl_c_ends_it(self):
        # A shell may start background processes with SIGINT ignored.
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))
        with self.assertRaises(KeyboardInterrupt):
            self.film.render(self.path("a.mp4"), progress=lambda *_: os.kill(os.getpid(), signal.SIGINT))
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_wrong_calls(self):
        for path, how, said in (("a.mp5", {}, "mp5"), ("no/a.mp4", {}, "no"),
                                ("a.mp4", {"frames": (5, 3)}, "ends before it begins"),
                                ("a.mp4", {"frames": (1, 1e9)}, "too many"), ("a.mp4", {"bits": 9}, "8 or 16"),
                                ("a.mp4", {"colors": "rec709"}, "rec709"), ("a.gif", {"colors": "pq"}, "sRGB only"),
                                ("a.mp4", {"jobs": -1}, "jobs"), ("a.mp4", {"size": (-1, 1)}, "-1x1"),
                                ("a.mp4", {"missing": True}, "")):
            with self.assertRaisesRegex(betwixt.Error, said, msg=(path, how)):
                self.film.render(self.path(path), **how)
        with self.assertRaises(TypeError):
            self.film.render(None)
        self.assertEqual(os.listdir(self.folder.name), [])
