# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests the types of the module: mypy accepts the stubs, and the examples of docs/python.md that use them."""

import ast
import doctest
import inspect
import os
import subprocess
import tempfile
import unittest

from pages_test import blocks
from support import ROOT

import betwixt
from betwixt import _core

PACKAGE = os.path.dirname(betwixt.__file__)


def mypy(*arguments):
    said = subprocess.run(["/usr/bin/mypy", "--strict", "--python-executable", "/usr/bin/python3", "--cache-dir",
                           os.devnull, *arguments], capture_output=True, text=True, cwd=os.path.dirname(PACKAGE))
    return said.stdout + said.stderr if said.returncode else ""


def callables():
    """Returns the public functions and methods of the module by name: (the function, its class in the stub)."""
    for name in betwixt.__all__:
        what = getattr(betwixt, name)
        if not inspect.isclass(what):
            yield name, what, None
        else:
            for member in vars(what):
                one = getattr(what, member)
                if callable(one) and (not member.startswith("_") or member in ("__init__", "__len__", "__getitem__",
                                                                               "__array__", "__repr__", "__str__",
                                                                               "_repr_html_", "_repr_png_")):
                    yield f"{name}.{member}", one, name


def stubs():
    """Returns the parameters of each function in the stub: names, kinds and defaults."""
    with open(os.path.join(PACKAGE, "_core.pyi")) as text:
        tree = ast.parse(text.read())
    for part in tree.body:
        for f in part.body if isinstance(part, ast.ClassDef) else [part]:
            if isinstance(f, ast.FunctionDef) and not f.decorator_list:
                plain = [a.arg for a in f.args.args]
                defaults = dict(zip(reversed(plain), (ast.literal_eval(d) for d in reversed(f.args.defaults))))
                only = {a.arg: ast.literal_eval(d) for a, d in zip(f.args.kwonlyargs, f.args.kw_defaults) if d}
                owner = f"{part.name}." if isinstance(part, ast.ClassDef) else ""
                yield owner + f.name, ([(p, False, defaults.get(p, inspect.Parameter.empty)) for p in plain]
                                       + [(p, True, only.get(p, inspect.Parameter.empty)) for p in
                                          (a.arg for a in f.args.kwonlyargs)])


class Signatures(unittest.TestCase):
    def test_everything_has_a_signature_and_says_what_it_does(self):
        count = 0
        for name, what, _ in callables():
            with self.subTest(name=name):
                inspect.signature(what)
                self.assertRegex(inspect.getdoc(what) or "", r"^[^\n(]{8}", name)
                self.assertNotIn("\n--\n", inspect.getdoc(what))
                count += 1
        self.assertGreater(count, 50)

    def test_every_property_and_class_says_what_it_is(self):
        for name in betwixt.__all__:
            what = getattr(betwixt, name)
            if inspect.isclass(what):
                self.assertTrue(what.__doc__, name)
                for member, one in vars(what).items():
                    if isinstance(one, property):
                        self.assertTrue(one.__doc__, f"{name}.{member}")

    def test_signatures_are_those_of_the_stubs(self):
        compared = 0
        for name, wanted in stubs():
            owner, _, member = name.rpartition(".")
            what = getattr(getattr(_core, owner), member) if owner else getattr(_core, member)
            found = [(p.name, p.kind is p.KEYWORD_ONLY, p.default) for p in inspect.signature(what).parameters.values()]
            self.assertEqual(found, wanted, name)
            compared += 1
        self.assertGreater(compared, 30)

    def test_a_film_is_called_as_its_class_says(self):
        made = list(inspect.signature(betwixt.Film).parameters.values())
        self.assertEqual(made, list(inspect.signature(betwixt.Film.__init__).parameters.values())[1:])
        self.assertEqual(str(inspect.signature(betwixt.loads(" ").eval)), "(target, time)")


class Types(unittest.TestCase):
    def test_mypy_takes_the_module(self):
        self.assertEqual(mypy("-p", "betwixt"), "")

    def test_mypy_takes_the_page(self):
        code = "".join(e.source for e in doctest.DocTestParser().get_examples(blocks()))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "page.py")
            with open(path, "w") as page:
                page.write(code)
            self.assertEqual(mypy(path), "")
            with open(path, "w") as page:
                page.write("import betwixt\nfilm = betwixt.load(3)\nfilm.eval('x')\nfilm.nothing\n")
            self.assertEqual(mypy(path).count(": error: "), 3)

    def test_the_wheel_has_the_version_of_the_module(self):
        with tempfile.TemporaryDirectory() as folder:
            name = subprocess.run(
                ["python3", os.path.join(ROOT, "python", "build_wheel.py"), folder],
                env={**os.environ, "BETWIXT_BUILT_PYTHON": PACKAGE}, capture_output=True, text=True, check=True,
            ).stdout.split()[-1]  # fmt: skip
        self.assertEqual(name.split("-")[1], betwixt.__version__)

    def test_the_stubs_say_what_there_is(self):
        with open(os.path.join(PACKAGE, "_core.pyi")) as stubs:
            said = stubs.read()
        for name, what in vars(_core).items():
            if name.startswith("_"):
                continue
            self.assertRegex(said, rf"(?m)^(class|def) {name}\b|^{name}: ", name)
            if inspect.isclass(what):
                body = said.split(f"class {name}:", 1)[1].split("\nclass ", 1)[0]
                for member in vars(what):
                    if not member.startswith("_"):
                        self.assertRegex(body, rf"(?m)^    (def {member}\(|{member}: )", f"{name}.{member}")
