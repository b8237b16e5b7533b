#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Measures work that took seconds: code in a trace, exports of filtered code, many wide strokes, long scripts.

    bench/long_work.py [--rounds N] PROGRAM [PROGRAM-BEFORE]

The time is processor time of all threads. Each round runs both programs in turn. Compares what the programs write.
Prints a Markdown table with the minimum and the median in seconds.
"""
import argparse
import math
import pathlib
import random
import re
import statistics
import sys
import tempfile

from processor_time import processor_time

ROOT = pathlib.Path(__file__).resolve().parent.parent
ARMS = 60


def arms():
    lines = ["film flat", "range 1f 97f", f"create arm{{1..{ARMS}}} line color=gold width=0.02",
             'set arm*.to = "vec(4 / pi / (2*i-1), 0, 0)"', "set arm1.position (-3 0 0)", "create pen circle radius=0.05"]
    lines += [f"hang arm{k} on arm{k - 1}" for k in range(2, ARMS + 1)]
    return lines + [f'set arm{{2..{ARMS}}}.attach-position = "vec(4 / pi / (2*i-1), 0, 0)"',
                    "arm*.rotation.z", "  1f 0deg linear", '  97f = "(2*i-1) * tau"', f"hang pen on arm{ARMS}",
                    "create wave trace of=pen width=0.03 color=tomato"]


def circles():
    return ["film flat"] + [f"create c{k} circle radius=0.1 stroke=red stroke-width=0.5 position=({k % 10 - 5} {k // 10 - 3} 0)"
                            for k in range(60)]


def events():
    pick = random.Random(5)
    lines = ["range 1f 2000f"] + [f"create b{k} sphere radius=0.2" for k in range(1000)]
    for k in range(1000):
        lines.append(f"b{k}.position")
        lines += [f"  {1 + 2 * i}f ({k % 32} {pick.random():.3f} {-(k // 32)})" for i in range(1000)]
    return lines


NUMBER = re.compile(rb"-?[0-9]+(?:\.[0-9]+)?(?:e[-+]?[0-9]+)?")


def alike(a, b):
    """Compares texts: the same words, and numbers that differ by at most a millionth."""
    if a == b:
        return True
    first, second = NUMBER.findall(a), NUMBER.findall(b)
    return NUMBER.sub(b"0", a) == NUMBER.sub(b"0", b) and all(
        math.isclose(float(x), float(y), rel_tol=1e-6, abs_tol=1e-6) for x, y in zip(first, second))


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--rounds", type=int, default=3)
    options.add_argument("programs", nargs="+")
    chosen = options.parse_args()
    programs = [str(pathlib.Path(p).resolve()) for p in chosen.programs]
    with tempfile.TemporaryDirectory() as folder:
        here = pathlib.Path(folder)
        for name, lines in (("arms", arms()), ("circles", circles()), ("events", events())):
            (here / f"{name}.bx").write_text("\n".join(lines) + "\n")
        race = str(ROOT / "examples/race.bx")
        rows = [(f"a frame of {ARMS} arms and a trace", ["frame", "arms.bx", "--at", "97f"], ".png"),
                ("export of race.bx, Lottie", ["export", race], ".json"),
                ("export of race.bx, SVG", ["export", race], ".svg"),
                ("export of race.bx, glTF", ["export", race], ".glb"),
                ("240 frames of race.bx, 64x36", ["render", race, "--size", "64x36"], ".mp4"),
                ("a frame of 60 circles with wide strokes", ["frame", "circles.bx"], ".png"),
                ("a value of a film of a million events", ["eval", "events.bx", "--at", "5f", "b5.position"], "")]
        print("| | " + " | ".join(["minimum, median (s)"] + ["before"] * (len(programs) - 1) + ["factor"]) + " |")
        print("|---" * (len(programs) + 2) + "|")
        for what, words, ending in rows:
            times, made = [[] for _ in programs], [b""] * len(programs)
            for _ in range(chosen.rounds):
                for i, program in enumerate(programs):
                    t, said = processor_time([program, *words] + (["-o", "out" + ending] if ending else []), here)
                    times[i].append(t)
                    made[i] = (here / ("out" + ending)).read_bytes() if ending else said
            if ending not in (".mp4", ".glb") and not all(alike(made[0], other) for other in made):
                print(f"{what}: the programs differ", file=sys.stderr)
            middle = [statistics.median(t) for t in times]
            cells = [f"{min(t):.2f}, {m:.2f}" for t, m in zip(times, middle)]
            print(f"| {what} | " + " | ".join(cells) + f" | {middle[-1] / middle[0]:.1f} |", flush=True)


main()
