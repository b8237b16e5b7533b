#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Compares traced pictures with motion blur and depth of field of two versions of the program, in turns.

The reference of each film is the mean of 1024 sharp pictures with 4 samples each, made by the other version. Prints PSNR in
decibels and processor time. The pictures are kept; a reference that is there already is not made again.

  exposures.py PROGRAM BEFORE FOLDER-FOR-PICTURES [FILM…]
"""
import math
import subprocess
import sys
from pathlib import Path

from processor_time import processor_time

ROOT = Path(__file__).resolve().parent.parent
FILMS = {"ball": ("bench/exposures/ball.bx", "3f", ()), "propeller": ("bench/exposures/propeller.bx", "3f", ()),
         "bokeh": ("bench/exposures/bokeh.bx", "3f", ()), "walk": ("examples/walk.bx", "60f", ("--shutter", "360deg"))}
WAYS = (("before", "64", "on"), ("now", "16", "on"), ("now", "64", "on"), ("now", "auto", "on"), ("before", "64", "off"),
        ("now", "64", "off"))


def picture(program, film, samples, denoise, out, more=()):
    path, time, options = FILMS[film]
    command = [program, "frame", ROOT / path, "--at", time, "--size", "320x180", "--style", "traced", "--samples", samples,
               "--denoise", denoise, *options, *more, "-o", out]
    return processor_time(command, ROOT)[0]


def pixels(path):
    return subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], check=True,
                          capture_output=True).stdout


def decibels(a, b):
    square = sum((x - y) ** 2 for x, y in zip(a, b)) / len(a)
    return 99 if a == b else 10 * math.log10(255 ** 2 / square)


def main():
    now, before, folder = (Path(word).resolve() for word in sys.argv[1:4])
    programs = {"now": now, "before": before}
    print("| film | version | samples | denoised | PSNR (dB) | processor time (s) |\n|---|---|---|---|---:|---:|", flush=True)
    for film in sys.argv[4:] or FILMS:
        reference = folder / f"{film}-reference.png"
        if not reference.exists():
            picture(before, film, "4096", "off", reference, ("--subframes", "1024"))
        exact = pixels(reference)
        for version, samples, denoise in WAYS:
            out = folder / f"{film}-{version}-{samples}-{denoise}.png"
            seconds = picture(programs[version], film, samples, denoise, out)
            print(f"| {film} | {version} | {samples} | {denoise} | {decibels(pixels(out), exact):.1f} | {seconds:.2f} |",
                  flush=True)


if __name__ == "__main__":
    sys.exit(main() if len(sys.argv) > 3 else __doc__)
