# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the examples of docs/python.md as one session."""

import doctest
import os
import shutil
import tempfile
import unittest

from support import ROOT


def blocks():
    """Returns the page with everything but its Python blanked out, so that line numbers stay the same."""
    with open(os.path.join(ROOT, "docs", "python.md")) as page:
        lines, inside = [], False
        for line in page:
            fence = line.startswith("```")
            lines.append(line if inside and not fence else "\n")
            inside = line.strip() == "```python" if fence else inside
    return "".join(lines)


class Page(unittest.TestCase):
    maxDiff = None

    def test_answers_are_those_of_the_page(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(os.path.join(ROOT, "examples"), os.path.join(folder, "examples"))
            here = os.getcwd()
            os.chdir(folder)
            try:
                test = doctest.DocTestParser().get_doctest(blocks(), {}, "python.md", "docs/python.md", 0)
                self.assertGreater(len(test.examples), 10)
                said: list[str] = []
                doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=said.append)
            finally:
                os.chdir(here)
            self.assertEqual("".join(said), "")
