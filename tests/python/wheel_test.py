# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests build_wheel.py: its progress lines, the folder of the build, the content of the wheel. A fake CMake prints
similar output."""

import os
import pty
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

from support import ROOT

CMAKE = """#!/bin/bash
echo "$*" >>"$CALLS"
if [ "$1" != --build ]; then exit; fi
for i in 1 2 3 4 5 6 7 8 9 10; do echo "[$i/10] Building CXX object $i"; done
[ -z "$BREAKS" ] || { echo "error: it is broken"; exit 1; }
mkdir -p "$2/python/betwixt" && echo film >"$2/python/betwixt/__init__.py"
"""
STEPS = [f"betwixt: building the module, {i} of 10 steps" for i in range(1, 11)]


class Wheel(unittest.TestCase):
    def setUp(self):
        self.tree = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.tree)
        os.makedirs(f"{self.tree}/python")
        os.makedirs(f"{self.tree}/bin")
        os.makedirs(f"{self.tree}/docs")
        for name in ("python/build_wheel.py", "python/pyproject.toml", "python/README.md", "docs/python.md"):
            shutil.copy(os.path.join(ROOT, name), f"{self.tree}/{name}")
        shutil.copy(os.path.join(ROOT, "CMakeLists.txt"), self.tree)
        with open(f"{self.tree}/bin/cmake", "w") as cmake:
            cmake.write(CMAKE)
        os.chmod(f"{self.tree}/bin/cmake", 0o755)
        self.call = [sys.executable, f"{self.tree}/python/build_wheel.py", self.tree]
        self.environment = {**os.environ, "PATH": f"{self.tree}/bin:{os.environ['PATH']}", "CALLS": f"{self.tree}/calls"}

    def run_it(self, **more):
        return subprocess.run(self.call, env={**self.environment, **more}, capture_output=True, text=True,
                              start_new_session=True)

    def test_it_says_how_far_it_is(self):
        done = self.run_it()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([line for line in done.stdout.splitlines() if "steps" in line], STEPS)

    def test_a_terminal_is_told_though_pip_shows_nothing(self):
        child, terminal = pty.fork()
        if child == 0:
            os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
            os.execve(self.call[0], self.call, self.environment)
        seen = b""
        try:
            while more := os.read(terminal, 4096):
                seen += more
        except OSError:
            pass  # the process has ended
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 0, seen)
        for step in STEPS:
            self.assertIn(step.encode(), seen)

    def test_the_build_of_the_source_tree_stays_as_it_is(self):
        os.makedirs(f"{self.tree}/build/release")
        self.run_it()
        own = f"pip-cp{sys.version_info[0]}{sys.version_info[1]}"
        self.assertEqual(sorted(os.listdir(f"{self.tree}/build")), [own, "release"])
        self.assertEqual(os.listdir(f"{self.tree}/build/release"), [])
        with open(f"{self.tree}/calls") as calls:
            for call in calls:
                self.assertIn(f"{self.tree}/build/{own}", call)
                self.assertNotIn("build/release", call)

    def test_the_wheel_has_the_package(self):
        name = self.run_it().stdout.splitlines()[-1]
        with zipfile.ZipFile(f"{self.tree}/{name}") as wheel:
            self.assertEqual(wheel.read("betwixt/__init__.py"), b"film\n")
            self.assertEqual(len([n for n in wheel.namelist() if ".dist-info/" in n]), 3)
            about, _, description = wheel.read(next(n for n in wheel.namelist() if n.endswith("/METADATA"))).decode().partition("\n\n")
        self.assertIn("\nDescription-Content-Type: text/markdown", about)
        self.assertIn("sudo apt install ./betwixt_*.deb", description)
        self.assertIn(">>> import betwixt", description)
        self.assertNotIn("](", description)

    def test_what_failed_is_said(self):
        done = self.run_it(BREAKS="1")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("error: it is broken", done.stdout)
        self.assertEqual([n for n in os.listdir(self.tree) if n.endswith(".whl")], [])
