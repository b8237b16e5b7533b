# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Measures Blender without pictures: frame_set evaluates the F-curves and makes the world matrices.
#   blender -b -P frames_blender.py -- ROW ROUNDS       keys, random, shared, rest, move, tree, edit
#   blender -b -P frames_blender.py -- compare - <LINES: like peers/scene.mjs
# Prints a line for each round: "Blender" and the time of a frame, in the unit of the row.
import math
import os
import sys
import time

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import scene as numbers

row, rounds = sys.argv[sys.argv.index("--") + 1:][:2]
PART = 10  # makes only a tenth of the many boxes and nodes, because that takes very long; times are multiplied by this
PATHS = ("location", "rotation_euler", "scale")

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.fps = 60
scene.frame_start, scene.frame_end = 1, 1000
things = bpy.data.collections.new("things")  # linked to the scene when it is full, because each later object costs much time


def put(name, at=(0, 0, 0), parent=None):
    thing = bpy.data.objects.new(name, None)
    thing.rotation_mode = "ZYX"  # about the object's own x axis, then y, then z
    thing.location = at
    thing.parent = parent
    things.objects.link(thing)
    return thing


def animate(thing, path, frames, values):
    """Makes F-curves with linear interpolation."""
    data = thing.animation_data or thing.animation_data_create()
    if data.action is None:
        data.action = bpy.data.actions.new(thing.name)
    linear = bpy.types.Keyframe.bl_rna.properties["interpolation"].enum_items["LINEAR"].value
    for c in range(3):
        curve = data.action.fcurves.new(path, index=c)
        curve.keyframe_points.add(len(frames))
        curve.keyframe_points.foreach_set("co", [n for f, v in zip(frames, values) for n in (f, v[c])])
        curve.keyframe_points.foreach_set("interpolation", [linear] * len(frames))
        curve.update()


def keyed(count, shared):
    objects = [put(f"b{k}") for k in range(count)]
    for k, thing in enumerate(objects):
        for f, path in enumerate(PATHS):
            values = [numbers.value_of(k, f, i) for i in range(numbers.KEYS)]
            if f == 1:
                values = [tuple(math.radians(a) for a in v) for v in values]
            animate(thing, path, [numbers.frame_of(shared, k, f, i) for i in range(numbers.KEYS)], values)
    return objects


def moves(thing, x):
    animate(thing, "location", (1, 300, 600), ((x, 0, 0), (x, 5, 0), (0, 0, 1)))


def boxes(count, moving):
    for k in range(1, count + 1):
        thing = put(f"b{k}")
        if moving and k % (count // moving) == 0:
            moves(thing, k // (count // moving))


def tree(count):
    nodes = []
    for k in range(count):
        nodes.append(put(f"n{k}", (1, 0.5, 0), nodes[(k - 1) // 10] if k else None))
    moves(nodes[0], 1)


def go(frame):
    scene.frame_set(int(frame), subframe=frame - int(frame))


def measure(frames, unit):
    scene.collection.children.link(things)
    go(frames[0])
    for _ in range(int(rounds)):
        go(frames[0])
        begun = time.perf_counter()
        for frame in frames[1:]:
            go(frame)
        print("Blender", (time.perf_counter() - begun) * 1e9 / (len(frames) - 1) / unit)


def edits():
    """Moves one key of a million, and evaluates the next frame."""
    frames = list(range(1, 1001))
    balls = [put(f"ball{k}") for k in range(1000)]
    for k, ball in enumerate(balls):
        animate(ball, "location", frames, [numbers.million_key(k, f) for f in frames])
    scene.collection.children.link(things)
    go(500)
    for i in range(int(rounds)):
        ball = balls[numbers.scramble(i) % 1000]
        begun = time.perf_counter()
        for c, value in enumerate((-1, i, 3)):
            ball.animation_data.action.fcurves[c].keyframe_points[499].co.y = value
        ball.animation_data.action.id_data.update_tag()
        go(500)
        print("Blender", (time.perf_counter() - begun) * 1e3)
        if abs(ball.matrix_world.translation.y - i) > 1e-5:
            sys.exit("a value")


def compare():
    objects = keyed(100, False)
    scene.collection.children.link(things)
    worst, compared = 0, 0
    for line in sys.stdin:
        k, frame, *wanted = (float(word) for word in line.split())
        go(frame)
        thing = objects[int(k)]
        world = [n for line in thing.matrix_world for n in line]
        for is_now, want in zip([*thing.location, *thing.rotation_euler, *thing.scale, *world], wanted):
            worst, compared = max(worst, abs(is_now - want) / (1 + abs(want))), compared + 1
    print("compared", compared)
    print("differs", worst)


if row == "compare":
    compare()
elif row == "edit":
    edits()
elif row in ("rest", "move"):
    boxes(100000 // PART, 1000 // PART if row == "move" else 0)
    measure(numbers.frames_of(row, 10), 1e6 / PART)
elif row == "tree":
    tree(100000 // PART)
    measure(numbers.frames_of(row, 10), 1e5 / PART)
else:
    keyed(1000, row == "shared")
    measure(numbers.frames_of(row, 50), 1e3)
