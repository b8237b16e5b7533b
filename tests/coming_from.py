# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Checks docs/coming-from.md: coming_from.py PROGRAM. The code in the last cell of each row must load without a
warning."""

import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
CAST = """create ball sphere
create box box
create sun light shines=sun position=(2 5 3)
create title text text="hello"
create hand group
create road curve points=((0 0) (2 1) (4 0))
create eye camera position=(0 0 12)
"""


def rows():
    with open(os.path.join(ROOT, "docs", "coming-from.md")) as page:
        for line in page:
            cells = line.rstrip("\n").split(" | ")
            if len(cells) > 2 and not line.startswith(("| |", "|---")):
                yield "".join(code + "\n" for code in re.findall(r"`([^`]*)`", cells[-1]))


def main():
    program, passed, failed = sys.argv[1], 0, 0
    with tempfile.TemporaryDirectory() as folder:
        os.mkdir(os.path.join(folder, "meshes"))
        with open(os.path.join(folder, "meshes", "cow.ply"), "w") as mesh:
            mesh.write("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        script = os.path.join(folder, "film.bx")
        for code in rows():
            with open(script, "w") as film:
                film.write(CAST + code)
            said = subprocess.run([program, "check", script], capture_output=True, text=True)
            fine = said.returncode == 0 and "warning:" not in said.stdout + said.stderr
            passed, failed = passed + fine, failed + (not fine)
            if not fine:
                print(f"FAILED {code}{said.stdout}{said.stderr}")
    print(f"{passed} passed, {failed} failed")
    return failed > 0 or passed < 50


sys.exit(main())
