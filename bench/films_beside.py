#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Renders films with two versions of the program, in turns.

Prints the processor time of the whole (with the encoder) and the time of painting a frame: minimum and median of each
version, and the ratio of the minima. Some pictures of both are compared: PSNR in decibels.

  films_beside.py [--rounds N] [--frames N] PROGRAM BEFORE [FILM…]
"""
import argparse
import math
import re
import statistics
import subprocess
import tempfile
from pathlib import Path

from processor_time import processor_time

ROOT = Path(__file__).resolve().parent.parent
FILMS = ("examples/menagerie.bx", "examples/funnel.bx", "bench/spheres.bx", "examples/chart-race.bx",
         "examples/unit-circle.bx", "examples/refactoring.bx", "examples/sine.bx", "examples/fourier.bx")


def pixels(program, film, folder):
    picture = Path(folder) / "frame.png"
    subprocess.run([program, "frame", film, "--at", "40f", "--size", "1280x720", "-o", picture], check=True,
                   capture_output=True)
    return subprocess.run(["ffmpeg", "-v", "error", "-i", picture, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                          check=True, capture_output=True).stdout


def decibels(a, b):
    square = sum((x - y) ** 2 for x, y in zip(a, b)) / len(a)
    return "the same bytes" if a == b else f"{10 * math.log10(255 ** 2 / square):.1f} dB"


def measured(program, film, frames, folder):
    seconds, out = processor_time([program, "render", film, "--frames", f"1f..{frames}f", "--size", "1280x720",
                                   "--stats", "-o", "film.mp4"], folder, stderr=subprocess.STDOUT)
    painting = re.search(rb"painting [^(]*\(([\d.]+) ms", out)
    return seconds * 1000 / frames, float(painting.group(1))


def main():
    ask = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    ask.add_argument("--rounds", type=int, default=5)
    ask.add_argument("--frames", type=int, default=48)
    ask.add_argument("programs", nargs=2, metavar="PROGRAM")
    ask.add_argument("films", nargs="*")
    options = ask.parse_args()
    now, before = (str(Path(p).resolve()) for p in options.programs)
    print("| Film, 1280x720 | processor ms a frame, before | now | before / now | painting ms, before | now | "
          "before / now | pictures |\n|---|---:|---:|---:|---:|---:|---:|---|", flush=True)
    for film in options.films or FILMS:
        path = str((ROOT / film).resolve())
        with tempfile.TemporaryDirectory() as folder:
            rows = {before: [], now: []}
            for _ in range(options.rounds):
                for program, row in rows.items():
                    row.append(measured(program, path, options.frames, folder))
            cells = []
            for k in range(2):
                was, here = ([sample[k] for sample in rows[p]] for p in (before, now))
                cells += [f"{min(x):.1f} ({statistics.median(x):.1f})" for x in (was, here)]
                cells.append(f"{min(was) / min(here):.2f}")
            alike = decibels(pixels(before, path, folder), pixels(now, path, folder))
            print("| " + " | ".join([Path(film).stem, *cells, alike]) + " |", flush=True)


main()
