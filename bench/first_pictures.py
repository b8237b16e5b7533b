#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Measures the first picture of each example: `betwixt frame`, from the start of the process to the PNG on disk.

    bench/first_pictures.py [--rounds N] PROGRAM [PROGRAM-BEFORE]

The time is processor time of all threads. Each round runs both programs in turn. The first run of each is not measured,
since the driver then stores its shaders. Prints a Markdown table with the minimum and the median in milliseconds.
"""
import argparse
import pathlib
import statistics
import tempfile

from processor_time import processor_time


def measure(program, film, picture):
    return 1000 * processor_time([program, "frame", film.name, "-o", picture, "--size", "1280x720"], film.parent)[0]


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--rounds", type=int, default=5)
    options.add_argument("programs", nargs="+")
    chosen = options.parse_args()
    programs = [str(pathlib.Path(p).resolve()) for p in chosen.programs]
    examples = sorted((pathlib.Path(__file__).resolve().parent.parent / "examples").glob("*.bx"))
    medians = {True: [[] for _ in programs], False: [[] for _ in programs]}
    print("| film | " + " | ".join(["minimum, median (ms)"] + ["before"] * (len(programs) - 1) + ["factor"]) + " |")
    print("|---" * (len(programs) + 2) + "|")
    with tempfile.TemporaryDirectory() as folder:
        for film in examples:
            times = [[] for _ in programs]
            for k in range(chosen.rounds + 1):
                for i, program in enumerate(programs):
                    t = measure(program, film, folder + "/a.png")
                    if k > 0:
                        times[i].append(t)
            flat = "film flat" in film.read_text()
            middle = [statistics.median(t) for t in times]
            for i, m in enumerate(middle):
                medians[flat][i].append(m)
            cells = [f"{min(t):.0f}, {m:.0f}" for t, m in zip(times, middle)]
            print(f"| {film.stem}{' (flat)' if flat else ''} | " + " | ".join(cells) + f" | {middle[-1] / middle[0]:.1f} |",
                  flush=True)
    for flat, name in ((True, "flat films"), (False, "others")):
        middle = [statistics.median(m) for m in medians[flat]]
        print(f"| **median of {name}** | " + " | ".join(f"{m:.0f}" for m in middle) + f" | {middle[-1] / middle[0]:.1f} |")


main()
