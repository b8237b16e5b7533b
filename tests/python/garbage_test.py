# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Calls all functions with random arguments. Each call must return or raise an exception. The variable
BETWIXT_GARBAGE=ROUNDS makes the test longer."""

import datetime
import os
import random
import tempfile
import unittest
import warnings

import numpy as np
from support import example

import betwixt

FINE = (betwixt.Error, TypeError, ValueError, KeyError, IndexError, OverflowError, OSError, AttributeError, MemoryError)


class Garbage(unittest.TestCase):
    def test_nothing_falls_over(self):
        chance = random.Random(7)
        words = ["", "24f", "2.5s", "ball.position", "ball", "*", "{a,b}.position", "create x sphere",
                 "ball.position\n  9f (1 2 3)", "at 3f hide ball", "\x00", "ü\udc80", "(((", '"""', "undo", "9" * 400,
                 "1e999f", "-1f", "rewrite 1..1 \"\"", "use \"/etc/passwd\"", "a.png", "a-%02d.png", "\n" * 50,
                 "create m mesh file=\"a.png\"", "set *.position (1 2)"]
        things = [None, True, 0, -1, 3, 24.5, 1e308, -1e30, float("nan"), float("inf"), 2**70, b"\xff\xfe", (),
                  [], {}, (1, 2), (64, 36), (0, 0), (2, 2, 2), [1, "x"], {"a": 1}, object(), np.arange(5),
                  np.zeros((2, 2)), np.array("x"), np.float64(3), datetime.timedelta(days=10**6), lambda *_: None,
                  range(3), iter([1, 2]), int, 1j]
        names = [n for n in dir(betwixt.Film) if not n.startswith("__") and n != "player"] + ["__init__"]
        options = ["size", "style", "samples", "shutter", "subframes", "bits", "jobs", "frames", "progress",
                   "step", "time", "pattern"]
        here = os.getcwd()
        film = betwixt.load(example("bounce.bx"))
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            os.chdir(folder)
            try:
                for _ in range(int(os.environ.get("BETWIXT_GARBAGE", "1500"))):
                    what = [chance.choice(chance.choice((words, things))) for _ in range(chance.randrange(4))]
                    how = {chance.choice(options): chance.choice(things + words) for _ in range(chance.randrange(2))}
                    name = chance.choice(names)
                    if name == "poses" and what[2:]:
                        continue  # a step of a millionth of a frame takes long
                    try:
                        if name == "__init__":
                            film = betwixt.Film(*what, **how)
                        elif callable(getattr(betwixt.Film, name)):
                            getattr(film, name)(*what, **how)
                        else:
                            getattr(film, name)
                    except FINE as why:
                        str(why), repr(why)
            finally:
                os.chdir(here)
        repr(film.frame(1).items)
