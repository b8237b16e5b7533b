#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Measures the time from an edit to its picture (1280x720, in the middle of the film) for the films of bench/teaching.

    bench/lesson_edits.py [--rounds N] [FOLDER-OF-THE-PYTHON-MODULE]

"One line" moves an object by hand. "The whole text" reads the script again, as after typing. The time is processor time
of all threads. The first rounds are not measured. The last picture of each film is compared with that of a new film with
the same text, byte for byte.
"""
import argparse
import pathlib
import statistics
import sys
import time

root = pathlib.Path(__file__).resolve().parent.parent
SIZE = (1280, 720)


def timed(run):
    begun = time.process_time()
    answer = run()
    return 1000 * (time.process_time() - begun), answer


def line_of_edit(film):
    """Returns a line with a place for a number: it moves an object, or changes the background if none can be moved."""
    for name in film.objects:
        line = f"set {name}.position.x {{}}"
        try:
            film.say(line.format(0.25))
        except Exception:  # it has no place of its own, or its place is code
            continue
        film.undo()
        return line
    return "background #0e15{}"


def measure(betwixt, path, rounds):
    text = path.read_text()
    film = betwixt.load(str(path))
    at = film.range[1] // 2
    edit = line_of_edit(film)
    line, whole, right = [], [], True
    for k in range(rounds + 2):
        now = edit.format(10 + k if "background" in edit else 0.01 * k)

        def said():
            film.say(now)
            return film.picture(at, size=SIZE)

        def read():
            new = betwixt.loads(text + now + "\n")
            return new.picture(at, size=SIZE)

        (one, a), (other, b) = timed(said), timed(read)
        right = right and (a.pixels == b.pixels).all()
        if k > 1:
            line.append(one), whole.append(other)
    return line, whole, right


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--rounds", type=int, default=9)
    options.add_argument("module", nargs="?", default=str(root / "build/release/python"))
    chosen = options.parse_args()
    sys.path.insert(0, chosen.module)
    import betwixt
    print("| film | one line: minimum, median (ms) | the whole text: minimum, median (ms) | same picture |\n|---|---|---|---|")
    lines, wholes = [], []
    for script in sorted((root / "bench/teaching").glob("*.py")):
        path = root / "examples" / (script.stem + ".bx")
        if not path.exists():
            continue
        line, whole, right = measure(betwixt, path, chosen.rounds)
        lines.append(statistics.median(line)), wholes.append(statistics.median(whole))
        print(f"| {path.stem} | {min(line):.1f}, {lines[-1]:.1f} | {min(whole):.1f}, {wholes[-1]:.1f} | {'yes' if right else 'NO'} |", flush=True)
    print(f"| **median** | {statistics.median(lines):.1f} | {statistics.median(wholes):.1f} | |")


main()
