# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The scene of spheres.py in Blender's Workbench: blender -b -P bench/spheres_blender.py -- MODE SAMPLES OUT [COLUMNS ROWS]
#   MODE pictures: draws every frame, keeps none; film: draws and encodes to OUT (H.264); still: draws frame 30 to OUT.
#   SAMPLES is Workbench's antialiasing: OFF, FXAA, 5, 8 (its default), 11, 16, 32.
# The last line says "SECONDS frames N spheres N seconds S".
import os
import sys
import time

import bpy
from mathutils import Vector

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import spheres

mode, samples, out, *grid = sys.argv[sys.argv.index("--") + 1:]
grid = [int(n) for n in grid] or [spheres.COLUMNS, spheres.ROWS]


def up(v):
    """Converts a point from y up to Blender's z up."""
    return Vector((v[0], -v[2], v[1]))


def linear(s):
    return s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4


bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.world = bpy.data.worlds.new("world")


def put(name, data, at):
    thing = bpy.data.objects.new(name, data)
    thing.location = up(at)
    scene.collection.objects.link(thing)
    return thing


def material(name, color):
    m = bpy.data.materials.new(name)
    m.diffuse_color = [linear(int(color[i:i + 2], 16) / 255) for i in (1, 3, 5)] + [1]
    m.roughness = 0.4
    return m


bpy.ops.mesh.primitive_uv_sphere_add(segments=32, ring_count=16, radius=spheres.RADIUS * spheres.size_of(grid[0]))
model = bpy.context.object
bpy.ops.object.shade_smooth()
ball = model.data
ball.materials.append(None)
bpy.data.objects.remove(model)
for name, color, events in spheres.spheres(*grid[:2]):
    s = put(name, ball, events[0][1])
    s.material_slots[0].link = "OBJECT"  # one mesh for all spheres, a material for each
    s.material_slots[0].material = material(name, color)
    for frame, at in events:
        s.location = up(at)
        s.keyframe_insert("location", frame=frame)
    for curve in s.animation_data.action.fcurves:
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"

bpy.ops.mesh.primitive_plane_add(size=spheres.PLANE)
bpy.context.object.data.materials.append(material("floor", "#b0b4ba"))
for i, (at, reach, intensity) in enumerate(spheres.LIGHTS):
    lamp = bpy.data.lights.new(f"lamp{i}", "POINT")
    lamp.energy = 1000 * intensity  # Workbench ignores it
    put(lamp.name, lamp, at)
eye = put("eye", bpy.data.cameras.new("eye"), spheres.EYE)
eye.data.lens, eye.data.sensor_width = spheres.LENS, 36
eye.rotation_euler = (up(spheres.LOOK_AT) - up(spheres.EYE)).to_track_quat("-Z", "Y").to_euler()
scene.camera = eye

render = scene.render
render.engine = "BLENDER_WORKBENCH"
render.resolution_x, render.resolution_y, render.resolution_percentage = 960, 540, 100
render.fps, render.use_persistent_data = spheres.RATE, True
scene.frame_start, scene.frame_end = 1, min(spheres.FRAMES - 1, int(grid[2]) if len(grid) > 2 else spheres.FRAMES)
scene.display.render_aa = samples
scene.display.shading.light = "STUDIO"
scene.display.shading.color_type = "MATERIAL"
scene.view_settings.view_transform = "Standard"

scene.frame_set(30)
if mode == "still":
    render.filepath = out
    bpy.ops.render.render(write_still=True)
else:
    bpy.ops.render.render()  # the first picture starts the graphics interface
    begun = time.perf_counter()
    if mode == "pictures":
        for frame in range(scene.frame_start, scene.frame_end + 1):
            scene.frame_set(frame)
            bpy.ops.render.render()
    else:
        render.filepath = out
        render.use_file_extension = False
        render.image_settings.file_format = "FFMPEG"
        render.ffmpeg.format, render.ffmpeg.codec = "MPEG4", "H264"
        render.ffmpeg.constant_rate_factor, render.ffmpeg.ffmpeg_preset = "MEDIUM", "REALTIME"
        bpy.ops.render.render(animation=True)
    count = sum(o.type == "MESH" and o.data == ball for o in scene.objects)
    print(f"SECONDS frames {scene.frame_end - scene.frame_start + 1} spheres {count} seconds {time.perf_counter() - begun:.4f}")
