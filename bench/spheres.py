# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The scene of spheres.bx: 200 moving spheres on a plane under three lights. `python3 bench/spheres.py > bench/spheres.bx`
# writes the script; spheres_blender.py makes the same scene from the same numbers. `spheres.py COLUMNS ROWS` makes
# another number of spheres, in a size that fits the same field.
import colorsys
import math
import sys

COLUMNS, ROWS, RATE, FRAMES, STEP = 20, 10, 24, 49, 6
RADIUS = 0.45
EYE, LOOK_AT, LENS = (0, 12, 19.5), (0, 0.6, 1), 28
LIGHTS = [((6, 10, 8), 60, 0.5), ((-9, 8, 2), 50, 0.3), ((0, 12, -12), 60, 0.3)]  # place, range, intensity
PLANE = 40


def size_of(columns):
    return COLUMNS / columns


def spheres(columns=COLUMNS, rows=ROWS):
    """Yields (name, color, events) of each sphere. An event is (frame, (x, y, z)), with linear motion in between. A
    wave runs over the grid."""
    size = size_of(columns)
    for k in range(columns * rows):
        column, row = size * (k % columns), size * (k // columns)
        x, z = 1.1 * (column - size * (columns - 1) / 2), 1.1 * (row - size * (rows - 1) / 2)
        events = []
        for frame in range(1, FRAMES + 1, STEP):
            phase = 0.55 * column + 0.35 * row + math.tau * (frame - 1) / (FRAMES - 1) * 2
            events.append((frame, (round(x + 0.08 * math.cos(phase), 3), round(1.2 + 0.7 * math.sin(phase), 3), round(z, 3))))
        r, g, b = colorsys.hsv_to_rgb(column / COLUMNS, min(0.35 + 0.05 * row, 1), 0.95)
        yield f"s{k + 1}", "#%02x%02x%02x" % tuple(round(255 * c) for c in (r, g, b)), events


def vector(v):
    return "(" + " ".join(f"{c:g}" for c in v) + ")"


def script(columns=COLUMNS, rows=ROWS):
    lines = ["# spheres.bx — 200 lit spheres move; written by spheres.py", f"rate {RATE}", f"range 1f {FRAMES - 1}f", "",
             f"create floor plane size=({PLANE} {PLANE}) rotation=(-90deg 0 0) color=#b0b4ba",
             f"create eye camera position={vector(EYE)} look-at={vector(LOOK_AT)} lens={LENS}mm"]
    lines += [f"create lamp{i} light position={vector(p)} range={r} intensity={b}" for i, (p, r, b) in enumerate(LIGHTS, 1)]
    for name, color, events in spheres(columns, rows):
        lines += ["", f"create {name} sphere radius={RADIUS * size_of(columns):g} color={color} shininess=0.4", f"{name}.position"]
        lines += [f"  {frame}f {vector(at)} linear" for frame, at in events]
    return "\n".join(lines)


if __name__ == "__main__":
    print(script(*map(int, sys.argv[1:3])))
