# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests objects that were made by __new__ without __init__. Every use raises an exception and never crashes."""

import copy
import inspect
import pickle
import unittest

import betwixt
from betwixt import _core

CLASSES = [what for what in vars(_core).values() if inspect.isclass(what)]


class NeverMade(unittest.TestCase):
    def test_whatever_is_asked_of_it_raises(self):
        self.assertGreater(len(CLASSES), 15)
        for kind in CLASSES:
            empty, asked = kind.__new__(kind), 0
            for name, member in vars(kind).items():
                with self.subTest(name=f"{kind.__name__}.{name}"):
                    if isinstance(member, property):
                        with self.assertRaises((TypeError, RuntimeError)):
                            getattr(empty, name)
                    elif callable(member) and not (name.startswith("__") and name != "__repr__") and name not in (
                            "player", "_repr_html_"):
                        needed = [p for p in inspect.signature(getattr(kind, name)).parameters.values()
                                  if p.default is p.empty][1:]
                        with self.assertRaises((TypeError, RuntimeError)):
                            getattr(empty, name)(*["1f" for _ in needed])
                    else:
                        continue
                    asked += 1
            self.assertGreater(asked, 0, kind)

    def test_handed_to_others_it_raises_too(self):
        film = betwixt.loads("create ball sphere\n")
        for call in (lambda: film.frame(1).items[0].has_shape_of(_core.Item.__new__(_core.Item)),
                     lambda: betwixt.Player(betwixt.Film.__new__(betwixt.Film)),
                     lambda: betwixt.Film.__new__(betwixt.Film, "create ball sphere\n").objects,
                     lambda: betwixt.Error([_core.Diagnostic.__new__(_core.Diagnostic)])):
            with self.assertRaises(TypeError):
                call()

    def test_made_after_all_it_is_a_film(self):
        film = betwixt.Film.__new__(betwixt.Film)
        film.__init__("create ball sphere\n")
        self.assertEqual(film.objects, ["ball"])

    def test_a_film_is_neither_copied_nor_packed(self):
        film = betwixt.loads("create ball sphere\n")
        for call in copy.copy, copy.deepcopy, pickle.dumps:
            with self.assertRaises(TypeError):
                call(film)
