# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests programs that import only the module, each in its own process: imports of other tests could hide faults."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import betwixt

FILM = 'film = betwixt.loads("create ball sphere\\nball.position\\n  1f (0 0 0) linear\\n  24f (23 46 69)\\n")\n'


def run(program, *options):
    done = subprocess.run([sys.executable, *options, "-c", "import betwixt\n" + FILM + program], capture_output=True,
                          text=True, timeout=60)
    return done.stdout + done.stderr[-2000:]


class Alone(unittest.TestCase):
    def test_threads_that_get_the_first_arrays(self):
        said = run("""
import threading
got = []
def work():
    got.append([[round(x, 9) for x in film.eval("ball.position", k).tolist()] for k in range(1, 20)])
threads = [threading.Thread(target=work) for _ in range(4)]
for t in threads: t.start()
for t in threads: t.join()
print(all(g == [[k, 2 * k, 3 * k] for k in range(19)] for g in got), len(got))
""")
        self.assertEqual(said, "True 4\n")

    def test_forked_processes_draw_what_their_parent_draws(self):
        said = run("""
import multiprocessing
def png(k):
    return film.picture(k, size=(64, 36)).png()
here = [png(k) for k in range(1, 5)]
with multiprocessing.get_context("fork").Pool(2) as pool:
    print(pool.map(png, range(1, 5)) == here)
    print(pool.map(png, range(1, 5)) == here)
print([png(k) for k in range(1, 5)] == here)
""")
        self.assertEqual(said, "True\nTrue\nTrue\n")

    def test_forked_processes_make_films_and_ask_for_values(self):
        said = run("""
import multiprocessing, os, tempfile
folder = tempfile.mkdtemp()
film.picture(1, size=(64, 36))
def work(k):
    film.render(os.path.join(folder, f"{k}-%02d.png"), frames=(1, 2), size=(64, 36))
    return film.eval("ball.position", k).tolist(), len(os.listdir(folder)) >= 2
with multiprocessing.get_context("fork").Pool(2) as pool:
    print(pool.map(work, (1, 2)))
""")
        self.assertEqual(said, "[([0.0, 0.0, 0.0], True), ([1.0, 2.0, 3.0], True)]\n")

    def test_without_numpy_it_says_what_is_missing(self):
        # Simulates that the package is not installed.
        done = subprocess.run([sys.executable, "-c", "import sys; sys.modules['numpy'] = None\nimport betwixt"],
                              capture_output=True, text=True, timeout=60)
        self.assertIn("ImportError: betwixt needs numpy: pip install numpy", done.stderr)

    def import_with_core(self, core):
        """Returns the last line that an import says if the compiled part of the module is this text."""
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(os.path.dirname(betwixt.__file__), f"{folder}/betwixt", symlinks=True,
                            ignore=shutil.ignore_patterns("_core*.so", "betwixt-parser"))
            if core:
                with open(f"{folder}/betwixt/_core.py", "w") as file:
                    file.write(core)
            done = subprocess.run([sys.executable, "-c", "import betwixt"], capture_output=True, text=True, timeout=60,
                                  env={**os.environ, "PYTHONPATH": folder})
        return done.stderr.splitlines()[-1]

    def test_a_library_that_is_missing(self):
        said = self.import_with_core(
            "raise ImportError('libx.so.3: cannot open shared object file: No such file or directory')")
        self.assertEqual(said, "ImportError: betwixt needs a library that is not installed (libx.so.3: cannot open shared "
                         "object file: No such file or directory). Debian's package betwixt installs it: sudo apt install "
                         "./betwixt_*.deb")

    def test_another_python(self):
        self.assertIn("is built for another Python than this one", self.import_with_core(""))
