# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""What the module says of its types: mypy takes it, and what the page docs/python.md does with it."""

import doctest
import inspect
import os
import subprocess
import tempfile
import tomllib
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
        with open(os.path.join(ROOT, "python", "pyproject.toml"), "rb") as said:
            self.assertEqual(tomllib.load(said)["project"]["version"], betwixt.__version__)

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
