# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests of one film used by many threads."""

import os
import sys
import tempfile
import threading
import time
import unittest

import numpy as np
from support import example

import betwixt


def together(*works):
    """Runs each function in its own thread. Raises the exception of a thread, if any."""
    raised = []

    def run(work):
        try:
            work()
        except BaseException as why:
            raised.append(why)

    threads = [threading.Thread(target=run, args=(w,)) for w in works]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    if raised:
        raise raised[0]


class Threads(unittest.TestCase):
    def test_all_get_the_same(self):
        film = betwixt.load(example("grab.bx"))
        poses = film.poses().world.copy()
        pictures = [film.picture(t, size=(64, 36)).png() for t in (10, 40, 70)]

        def ask():
            for _ in range(3):
                np.testing.assert_array_equal(film.poses().world, poses)
                self.assertEqual([film.picture(t, size=(64, 36)).png() for t in (10, 40, 70)], pictures)

        together(*[ask] * 6)

    def test_who_asks_gets_a_whole_film_while_others_change_it(self):
        # An edit always changes both components together. If a reader sees them differ, it has seen half of an edit.
        film = betwixt.loads("create a box\ncreate b box\n")
        done = threading.Event()

        def change():
            try:
                for k in range(1, 60):
                    film.say(f"set a.position.x {k}\nset b.position.x {k}")
                    if k % 3 == 0:
                        film.undo(), film.redo()
            finally:
                done.set()

        def look():
            while not done.is_set():
                poses = film.poses(1, 2)
                self.assertEqual(poses["a"][0, 0, 3], poses["b"][0, 0, 3])
                seen = film.values(1, "{a,b}.position.x")
                self.assertEqual(seen["a.position.x"], seen["b.position.x"])

        together(change, look, look, look)
        self.assertEqual(film.eval("a.position.x", 1), 59)

    def test_two_change_it_and_no_line_is_lost(self):
        film = betwixt.loads("")
        together(*[lambda n=n: [film.say(f"create {n}{k} box") for k in range(30)] for n in "abc"])
        self.assertEqual(sorted(film.objects), sorted(f"{n}{k}" for n in "abc" for k in range(30)))
        self.assertEqual(film.text.count("\n"), 90)

    def test_films_are_made_side_by_side(self):
        film = betwixt.load(example("bounce.bx"))
        with tempfile.TemporaryDirectory() as folder:
            names = [os.path.join(folder, f"{k}-%02d.png") for k in range(3)]
            together(*[lambda n=n: film.render(n, frames=(1, 4), size=(64, 36)) for n in names])
            for k in (1, 4):
                made = set()
                for n in names:
                    with open(n % k, "rb") as there:
                        made.add(there.read())
                self.assertEqual(made, {film.picture(k, size=(64, 36)).png()})

    def test_others_go_on_while_it_works(self):
        # Python does not switch threads here by itself, so the other thread runs only when this one releases the lock.
        film = betwixt.load(example("menagerie.bx"))
        inside, seen, over = [False], [False], [False]
        before = sys.getswitchinterval()

        def other():
            while not over[0]:
                seen[0] = seen[0] or inside[0]
                time.sleep(1e-4)  # releases the lock

        thread = threading.Thread(target=other)
        sys.setswitchinterval(1e6)
        try:
            thread.start()
            for _ in range(2000):
                inside[0] = True
                film.poses(1, 60)
                inside[0] = False
                if seen[0]:
                    break
        finally:
            over[0] = True
            sys.setswitchinterval(before)
            thread.join()
        self.assertTrue(seen[0])
