# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Measures how many mistakes the tests catch. It changes one line of a source file, runs the tests until one fails,
restores the file, and goes to the next file.

    mutants.py [COUNT [SEED]]      the defaults are 40 and 1; run it in a clone of its own, after ./test: it edits src/

For each mistake it builds and runs the unit tests of the file's room, then those of the rooms that follow, then the
command line, the examples, Python and the studio. Prints a line for each mistake, and the share that was caught.
"""

import glob
import os
import random
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BUILD = f"{ROOT}/build/release"
ROOMS = "base syntax algebra track scene program procedure exchange language commands editor compare export render film playback lsp server".split()
SWAPS = [(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "), (" != ", " == "),
         (" && ", " || "), (" || ", " && "), (" + ", " - "), (" - ", " + "), (" * ", " / "), ("true", "false"),
         ("false", "true"), ("(!", "("), (" += ", " -= "), ("std::min", "std::max"), ("std::max", "std::min"),
         ("break;", "continue;"), (" 1)", " 2)"), (" 0)", " 1)"), (" 0;", " 1;"), (" 1;", " 2;"), (" 0.5 ", " 0.25 ")]


def mistakes(path, rand):
    """Returns the lines of a file, and possible changes in random order: (line number, new line)."""
    with open(path) as file:
        lines = file.read().split("\n")
    found = []
    for k, line in enumerate(lines):
        code = line.split("//")[0]
        if '"' in code or code.lstrip().startswith(("#", "template", "namespace", "using", "case", "static_assert")):
            continue
        for old, new in SWAPS:
            at = code.find(old)
            if at >= 0 and "<" + old.strip() not in code:
                found.append((k + 1, code[:at] + new + code[at + len(old):]))
    rand.shuffle(found)
    return lines, found


def ninja(*targets):
    return subprocess.run(["ninja", "-C", BUILD, *targets], capture_output=True).returncode == 0


def fails(command, seconds):
    env = dict(os.environ, BETWIXT_PARSER=f"{BUILD}/bin/betwixt-parser")
    try:
        return subprocess.run(command, cwd=ROOT, env=env, capture_output=True, timeout=seconds,
                              stdin=subprocess.DEVNULL).returncode != 0
    except subprocess.TimeoutExpired:
        return True


def caught_by(room):
    """Returns the name of the first test that fails, None if all pass, or "" if the changed file does not compile."""
    rooms = ROOMS[ROOMS.index(room):] if room in ROOMS else []
    for k, name in enumerate(rooms):
        if not ninja(f"test_{name}"):
            return "" if k == 0 else "the build"
        for share in ("1/2", "2/2"):
            if fails(["python3", "tests/units.py", f"{BUILD}/bin/test_{name}", share, "--gtest_fail_fast"], 240):
                return f"test_{name}"
    if room == "studio":
        if not ninja("betwixt_studio", "studio_tests"):
            return ""
    elif not ninja("betwixt_command", "betwixt_python"):
        return ""
    else:
        program = f"{BUILD}/bin/betwixt"
        for script in sorted(glob.glob(f"{ROOT}/tests/app/*_test.sh")) + [f"{ROOT}/tests/examples.sh"]:
            if "editors_test" not in script and fails([script, program], 300):
                return os.path.basename(script)
        if fails(["tests/python/run.sh", BUILD], 300):
            return "Python"
        ninja("betwixt_studio", "studio_tests")
    for test in sorted(glob.glob(f"{BUILD}/bin/studio_*_test")):
        if fails(["tests/studio/run.sh", BUILD, test], 300):
            return os.path.basename(test)
    return None


def main(count=40, seed=1):
    rand = random.Random(seed)
    files = sorted(f for f in glob.glob(f"{ROOT}/src/*/*.cpp") if not f.endswith("_program.cpp"))
    rand.shuffle(files)
    tried = caught = 0
    for path in files:
        if tried == count:
            break
        room, short = path.split("/")[-2], os.path.relpath(path, ROOT)
        lines, found = mistakes(path, rand)
        for number, line in found[:3]:
            changed = list(lines)
            changed[number - 1] = line
            with open(path, "w") as file:
                file.write("\n".join(changed))
            by = caught_by(room)
            if by != "":
                tried += 1
                caught += by is not None
                print(f"{short}:{number}: {line.strip()}\n    {'caught by ' + by if by else 'NOT CAUGHT'}", flush=True)
                break
        with open(path, "w") as file:
            file.write("\n".join(lines))
    print(f"{caught} of {tried} caught")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
