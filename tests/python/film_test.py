# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests of loading, values, changes and errors."""

import datetime
import os
import tempfile
import unittest

import numpy as np
from support import ROOT, example, said_by_program

import betwixt

LINE = "create ball sphere\nball.position\n  1f (0 0 0) linear\n  25f (24 12 -6)\n"


class Values(unittest.TestCase):
    def test_sent_bytes_are_files(self):
        picture = betwixt.loads("create a sphere\nsize 8x8\n").picture(1).png()
        full = betwixt.send("ball.png", picture)
        self.assertTrue(full.startswith("@") and full.endswith("-ball.png"))
        film = betwixt.loads('create a rectangle size=(2 2) texture="@ball.png"')
        self.assertEqual(film.eval("a.texture", 1), full)
        for name, data, code in (("ball.png", b"no picture", "file"), ("ball.exe", picture, "name")):
            with self.assertRaises(betwixt.Error) as caught:
                betwixt.send(name, data)
            self.assertEqual(caught.exception.code, code)

    def test_kinds_of_the_script(self):
        film = betwixt.loads("create man box\ndefine kind human like man hidden\ncreate {anna,bert} human\n"
                             "set anna.color red\n")
        self.assertEqual(film.kinds, {"human": {"model": "man", "hidden": True,
                                                "instances": {"anna": ["anna.color"], "bert": []}}})
        film.say("set man.size (2 2 2)\nunlink bert\nset man.size (3 3 3)")
        self.assertEqual(list(film.eval("anna.size", 1)), [3, 3, 3])
        self.assertEqual(list(film.eval("bert.size", 1)), [2, 2, 2])

    def test_values_from_outside(self):
        script = "let size = 2\nlet who = \"Ada\"\nlet way = (1 2 3)\ncreate a sphere radius=size position=way\ncreate b text text=who\n"
        film = betwixt.loads(script, lets={"size": 5.5, "who": 'B "o"', "way": (4, 5, 6.5)})
        self.assertEqual([film.eval("a.radius", 1), film.eval("b.text", 1)], [5.5, 'B "o"'])
        self.assertEqual(list(film.eval("a.position", 1)), [4, 5, 6.5])
        film.say("create c sphere radius=size")
        self.assertEqual(film.eval("c.radius", 1), 5.5)
        self.assertEqual(film.text.splitlines()[0], "let size = 2")
        for lets, words in (({"siez": 1}, "no 'let siez'"), ({"size": "gold"}, "that is a colour")):
            with self.assertRaises(betwixt.Error) as caught:
                betwixt.loads(script, lets=lets)
            self.assertIn(words, str(caught.exception))
        with tempfile.NamedTemporaryFile("w", suffix=".po") as po:
            po.write('msgid "Ada"\nmsgstr "Grace"\n')
            po.flush()
            self.assertEqual(betwixt.loads(script, language=po.name).eval("b.text", 1), "Grace")

    def test_a_line_is_a_line_however_its_times_are_said(self):
        film = betwixt.loads(LINE)
        for when, share in ((7, 6 / 24), (7.5, 6.5 / 24), ("7f", 6 / 24), ("7", 6 / 24), ("0.25s", 6 / 24),
                            (datetime.timedelta(seconds=0.25), 6 / 24), (np.float32(7), 6 / 24), (np.int64(7), 6 / 24),
                            (np.array(7), 6 / 24), (0, 0.0), (99, 1.0)):
            with self.subTest(when=when):
                np.testing.assert_allclose(film.eval("ball.position", when), share * np.array((24, 12, -6)), atol=1e-12)

    def test_many_times_are_an_array(self):
        film = betwixt.loads(LINE + "at 9f hide ball\nat 5f ball.geometry shape(ball)\n")
        frames = np.arange(1, 26)
        for times in (frames, list(frames), tuple(frames), (f"{k}f" for k in frames), range(1, 26)):
            there = film.eval("ball.position", times)
            np.testing.assert_allclose(there, np.outer(frames - 1, (1, 0.5, -0.25)), atol=1e-12)
        self.assertEqual(film.eval("ball.position.x", frames).shape, (25,))
        self.assertEqual(film.eval("ball.world", frames).shape, (25, 4, 4))
        np.testing.assert_allclose(film.eval("ball.world", frames)[:, 0, 3], frames - 1, atol=1e-12)
        shown = film.eval("ball.display", frames)
        self.assertEqual(shown.dtype, np.dtype(bool))
        self.assertEqual(list(shown), [k < 9 for k in frames])
        self.assertEqual(film.eval("ball.geometry", [5, 6]), ["ball", "ball"])

    def test_of_no_time_there_is_an_array_as_wide_as_of_others(self):
        film = betwixt.loads(LINE + "create way polyline points=((0 0 0) (1 2 3))\ncreate card rectangle size=(1 2)\n")
        for name in ("position", "position.x", "color", "rotation", "world", "display", "radius", "geometry", "material",
                     "attachment", "touching"):
            some, none = film.eval(f"ball.{name}", [1, 2]), film.eval(f"ball.{name}", [])
            self.assertIs(type(none), type(some), name)
            if isinstance(some, np.ndarray):
                self.assertEqual((none.shape, none.dtype), ((0, *some.shape[1:]), some.dtype), name)
            else:
                self.assertEqual(none, [], name)
        for none in (range(0), (), np.array([]), np.array([], "timedelta64[s]"), iter([])):
            self.assertEqual(film.eval("ball.position", none).shape, (0, 3))
        self.assertEqual(film.eval("card.size", []).shape, (0, 2))
        self.assertEqual(film.eval("way.points", []), [])
        wrong = betwixt.loads("create ball sphere\nset ball.scale = \"nosuch(t)\"\n")
        self.assertEqual(wrong.eval("ball.scale", []).shape, (0, 3))  # no warning about code that was not run
        with self.assertRaises(betwixt.Error):
            film.eval("bal.position", [])

    def test_lengths_of_numpy_are_times(self):
        film = betwixt.loads(LINE)
        for length in (np.timedelta64(250, "ms"), np.timedelta64(250_000_000, "ns"), np.array(250, "timedelta64[ms]")):
            self.assertEqual(film.time(length), 7)
            self.assertEqual(film.seconds(length), 0.25)
            np.testing.assert_allclose(film.eval("ball.position", length), (6, 3, -1.5), atol=1e-12)
        many = np.arange(0, 1000, 250).astype("timedelta64[ms]")
        np.testing.assert_allclose(film.eval("ball.position.x", many), (0, 6, 12, 18), atol=1e-12)
        self.assertEqual(film.time(np.timedelta64(1, "m")), 24 * 60 + 1)
        for wrong in (np.timedelta64(1, "M"), np.datetime64("2026-01-01")):  # months have no fixed length
            with self.assertRaises(TypeError):
                film.time(wrong)
        with self.assertRaises(betwixt.Error):
            film.time(np.timedelta64("NaT", "s"))

    def test_all_examples_say_what_the_program_says(self):
        for name in sorted(n for n in os.listdir(os.path.join(ROOT, "examples")) if n.endswith(".bx")):
            with self.subTest(film=name):
                try:
                    film = betwixt.load(example(name))
                except betwixt.Warning:
                    continue
                for when, said in zip(("5f", "30.5f"), said_by_program(example(name), ("5f", "30.5f"))):
                    got = film.values(when)
                    self.assertEqual(list(got), list(said))
                    for target, value in said.items():
                        mine = got[target]
                        # JSON has no infinite numbers. In a list of points they lift the pen.
                        if isinstance(value, list) and value and isinstance(value[0], list):
                            value = [[np.inf if n is None else n for n in row] for row in value]
                        if np.shape(mine) == (4, 4):
                            mine = mine.reshape(16)  # row by row
                        if name == "complex-map.bx" and target.endswith(".points"):  # a power that is no whole number is that of Python's C library
                            np.testing.assert_allclose(mine, value, rtol=1e-14, err_msg=target)
                        else:
                            np.testing.assert_array_equal(mine, value, target)

    def test_code_uses_the_program_s_sines_and_not_those_of_python_s_library(self):
        calls = ("sin(x)", "cos(x)", "tan(x)", "asin(x / 9)", "math.acos(x / 9)", "atan(x)", "math.atan(x, 3)",
                 "exp(x)", "log(x + 1)", "log(x + 1, 2)", "log(x + 1, 10)", "log(x + 1, 3)")
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "sines.bx")
            with open(file, "w", encoding="utf-8") as script:
                script.write("create line polyline\nset line.points = \"local p = {} for i = 0, 400 do local x = i / 50 ")
                script.write("".join(f"p[#p + 1] = vec({a}, {b}, {c}) " for a, b, c in zip(*[iter(calls)] * 3)))
                script.write("end return p\"\n")
            (said,) = said_by_program(file, ("1f",), ("line.points",))
            mine = betwixt.load(file).eval("line.points", "1f")
        np.testing.assert_array_equal(mine, said["line.points"])
        x = np.arange(401) / 50
        np.testing.assert_allclose(mine[1::4][:, 1], np.arccos(x / 9), rtol=1e-15)
        np.testing.assert_allclose(mine[3::4][:, 2], np.log(x + 1) / np.log(3), rtol=1e-15)

    def test_values_of_every_kind(self):
        film = betwixt.loads("create ball sphere color=#ff8000 radius=2 material=metal\ncreate box box size=(1 2 3)\n"
                             "create word text text=\"grün\"\ncreate line polyline points=((0 0 0) (1 2 3))\n"
                             "at 3f attach ball to box keep-world\nball.motion\n  1f..9f T(1 0) R(90deg @ 0 0)\n")
        self.assertEqual(film.eval("ball.radius", 1), 2.0)
        self.assertEqual(film.eval("word.text", 1), "grün")
        self.assertEqual(film.eval("ball.material", 1), "metal")
        self.assertEqual(film.eval("ball.attachment", 3), "attach to box keep-world")
        self.assertEqual(film.eval("ball.attachment", 1), "detach")
        self.assertIs(film.eval("ball.display", 1), True)
        self.assertIsNone(film.eval("ball.geometry", 1))
        self.assertIn("T(1 0)", film.eval("ball.motion", 2))
        np.testing.assert_array_equal(film.eval("ball.color", 1), (1, 128 / 255, 0))
        np.testing.assert_array_equal(film.eval("line.points", 1), ((0, 0, 0), (1, 2, 3)))
        np.testing.assert_array_equal(film.eval("box.size", 1), (1, 2, 3))


class Editing(unittest.TestCase):
    def test_lines_are_said_and_taken_back(self):
        film = betwixt.loads(LINE)
        self.assertEqual(film.say("at 24f hide ball"), "")
        self.assertFalse(film.eval("ball.display", 24))
        self.assertIn("hide ball", film.text)
        after = film.text
        film.undo()
        self.assertEqual(film.text, LINE)
        self.assertTrue(film.eval("ball.display", 24))
        film.redo()
        self.assertEqual(film.text, after)

    def test_what_is_said_stands_where_an_author_would_write_it(self):
        film = betwixt.loads(LINE)
        film.say("at 25f ball.position (1 1 1)")
        self.assertEqual(film.text, LINE.replace("(24 12 -6)", "(1 1 1)"))

    def test_tracks_are_columns_of_numbers(self):
        film = betwixt.loads(LINE)
        frames = np.arange(1, 200)
        rows = np.stack([np.sin(frames / 9), frames * 0.1, frames**2 / 7], axis=1)
        for times, values in ((frames, rows), (list(map(float, frames)), rows.tolist()),
                              ([f"{k}f" for k in frames], rows.astype(np.float32))):
            self.assertEqual(film.set_track("ball.position", times, values, "linear"), "")
            got_frames, got = film.track_numbers("ball.position")
            np.testing.assert_array_equal(got_frames, frames)
            np.testing.assert_array_equal(got, np.asarray(values, float))
            np.testing.assert_array_equal(film.eval("ball.position", frames), got)
            np.testing.assert_array_equal(betwixt.loads(film.text).track_numbers("ball.position")[1], got)
        for _ in range(3):
            film.undo()
        self.assertEqual(film.text, LINE)
        one = film.track_numbers("ball.position")[1]
        self.assertEqual(one.shape[1], 3)
        for target, times, values, error in (
            ("ball.positon", frames, rows, betwixt.Error),
            ("ball.position", frames, rows[:-1], betwixt.Error),
            ("ball.position", frames[::-1], rows, betwixt.Error),
            ("ball.position", frames, rows * np.nan, betwixt.Error),
            ("ball.position", rows, rows, TypeError),
            ("ball.position", frames * 1e300, rows, betwixt.Error),
            ("ball.position", frames, "words", (TypeError, ValueError)),
        ):
            with self.assertRaises(error):
                film.set_track(target, times, values)
        self.assertEqual(film.text, LINE)

    def test_several_lines_are_one_step_all_of_them_or_none(self):
        film = betwixt.loads(LINE)
        film.say("create box box\n\n# a remark\nbox.position\n  1f (0 0 0)\n  9f (8 0\n  0)\n")
        np.testing.assert_allclose(film.eval("box.position", "9f"), (8, 0, 0))
        film.undo()
        self.assertEqual(film.objects, ["ball"])
        with self.assertRaises(betwixt.Error) as caught:
            film.say("create box box\n\n\nset box.size (1 2\n 3)\nset box.sise (1 1 1)\n")
        self.assertEqual((caught.exception.line, caught.exception.text), (6, "set box.sise (1 1 1)"))
        self.assertEqual(film.objects, ["ball"])
        self.assertEqual(film.text, LINE)

    def test_what_a_shell_would_answer_comes_back(self):
        self.assertIn("a sphere", betwixt.loads(LINE).say("describe ball"))

    def test_no_session_leaves_anything_on_the_disk(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "film.bx")
            with open(path, "w") as script:
                script.write(LINE)
            one, other = betwixt.load(path), betwixt.load(path)
            one.say("at 2f hide ball")
            other.say("at 3f hide ball")
            self.assertEqual(os.listdir(folder), ["film.bx"])


class Errors(unittest.TestCase):
    def caught(self, call):
        with self.assertRaises(betwixt.Error) as caught:
            call()
        return caught.exception

    def test_a_script_says_all_that_is_wrong_with_place_caret_and_hint(self):
        e = self.caught(lambda: betwixt.loads("create ball sphere\ncreate box spere\nset ball.radius red", "film.bx"))
        self.assertEqual((e.code, e.message, e.hint), ("name", "there is no kind 'spere'", "did you mean 'sphere'?"))
        self.assertEqual((e.file, e.line, e.column, e.text), ("film.bx", 2, 12, "create box spere"))
        self.assertEqual([d.line for d in e.diagnostics], [2, 3])
        self.assertTrue(str(e).startswith("film.bx:2:12: error: there is no kind 'spere'\n  create box spere\n"
                                          "             ^~~~~\n  did you mean 'sphere'?\n"
                                          "film.bx:3:17: error: "), str(e))

    def test_warnings_are_pythons(self):
        with self.assertWarnsRegex(betwixt.Warning, "warning: ") as caught:
            film = betwixt.loads("create ball sphere\nball.position\n  1f (0 0 0)\n  1f (0 0 0)\n")
        self.assertEqual(os.path.basename(caught.filename), "film_test.py")
        self.assertEqual(film.objects, ["ball"])

    def test_the_differences_of_two_films_are_words(self):
        old = betwixt.loads("create ball sphere\nball.radius\n  1f 1\n  12f 2\n")
        now = betwixt.loads(old.text)
        self.assertEqual(betwixt.diff(old, now), [])
        now.say("at 12f ball.radius 3")
        self.assertEqual(betwixt.diff(old, now), ["ball.radius: event at 12f changed from 2 to 3"])
        self.assertRaises(TypeError, betwixt.diff, old, old.text)

    def test_wrong_calls(self):
        film = betwixt.loads(LINE)
        for call, code, message in (
                (lambda: film.eval("bal.position", 1), "name", "there is no object 'bal'"),
                (lambda: film.eval("ball", 1), "name", "'ball' names several values"),
                (lambda: film.eval("x*.position", 1), "name", "nothing is named 'x*.position'"),
                (lambda: film.eval("ball.position", "3x"), "type", "'x' is not a unit of time"),
                (lambda: film.eval("ball.position", "soon"), "syntax", "'soon' is not a time"),
                (lambda: film.eval("ball.position", float("nan")), "range", "that is no time"),
                (lambda: film.eval("ball.position", float("inf")), "range", "that is no time"),
                (lambda: film.eval("ball.position", 1e30), "range", "this time is too far from the beginning"),
                (lambda: film.values(1, "bal"), "name", "there is no object 'bal'"),
                (lambda: film.say("quit"), "name", "there is no shell here to leave"),
                (lambda: film.say("set ball.radius red"), "syntax", None),
                (film.undo, "name", "there is nothing to undo"),
                (film.redo, "name", "there is nothing to redo"),
        ):
            with self.subTest(message=message):
                e = self.caught(call)
                self.assertEqual(e.code, code)
                if message:
                    self.assertEqual(e.message, message)
                self.assertIn(e.message, str(e))
        for call in (lambda: film.eval("ball.position", None), lambda: film.eval("ball.position", True),
                     lambda: film.eval(3, 1), lambda: film.eval("ball.position", object()),
                     lambda: film.eval("ball.position", [1, None]), lambda: film.eval("ball.position"),
                     lambda: film.values({}), lambda: film.say(None), lambda: betwixt.loads(None)):
            with self.assertRaises(TypeError):
                call()
        with self.assertRaises(FileNotFoundError):
            betwixt.load(example("nothing.bx"))
        with self.assertRaises(IsADirectoryError):
            betwixt.load(ROOT)
