# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Runs inside Blender: imports a film and renders it with Cycles as numbered PNGs. Called by tools/cycles.sh."""

import argparse
import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import betwixt_film  # noqa: E402


def main():
    asks = argparse.ArgumentParser(prog="tools/cycles.sh")
    asks.add_argument("film")
    asks.add_argument("folder")
    asks.add_argument("--samples", type=int, default=64)
    asks.add_argument("--size")
    asks.add_argument("--frames")
    call = asks.parse_args(sys.argv[sys.argv.index("--") + 1:])
    betwixt = betwixt_film.betwixt()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = 1280, 720
    try:
        film = betwixt.load(call.film)
        if call.frames:
            first, _, last = call.frames.partition("..")
            wanted = round(film.time(first)), round(film.time(last or first))
        betwixt_film.bring_in(film, os.path.basename(call.film), scene)
    except (betwixt.Error, OSError) as why:
        print(f"betwixt: {why}", file=sys.stderr)
        return 1
    if call.frames:
        scene.frame_start, scene.frame_end = wanted
    if call.size:
        scene.render.resolution_x, scene.render.resolution_y = (int(n) for n in call.size.split("x"))
    scene.render.resolution_percentage = 100
    scene.render.engine = "CYCLES"
    scene.cycles.samples = call.samples
    scene.cycles.use_denoising = False  # Debian's Blender has no denoiser
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.filepath = os.path.join(call.folder, "frame-####")
    bpy.ops.render.render(animation=True)
    return 0


sys.exit(main())
