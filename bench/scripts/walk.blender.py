# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Blender: a figure that walks by inverse kinematics, as examples/walk.bx.
from math import cos, pi

import bpy
from mathutils import Vector

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.fps = 24
scene.frame_start, scene.frame_end = 1, 145


def material(name, color):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (*color, 1)
    return made


red = material("red", (1, 0.12, 0.06))
skin = material("skin", (0.87, 0.58, 0.35))
blue = material("blue", (0.03, 0.06, 0.09))
black = material("black", (0.016, 0.016, 0.016))
white = material("white", (1, 1, 1))
grass = material("grass", (0.4, 0.48, 0.32))


def dress(thing, surface, parent=None, bone=None):
    thing.data.materials.append(surface)
    if parent:
        thing.parent = parent
    if bone:
        matrix = thing.matrix_world.copy()
        thing.parent_type, thing.parent_bone = "BONE", bone
        bpy.context.view_layer.update()
        thing.matrix_world = matrix
    return thing


def cylinder(radius, depth, place, surface, parent=None, bone=None):
    bpy.ops.mesh.primitive_cylinder_add(radius=radius, depth=depth, location=place)
    return dress(bpy.context.object, surface, parent, bone)


# z is up: the skeleton, with hips at a height of 1.
data = bpy.data.armatures.new("man")
man = bpy.data.objects.new("man", data)
scene.collection.objects.link(man)
bpy.context.view_layer.objects.active = man
bpy.ops.object.mode_set(mode="EDIT")
for side, y in (("left", -0.11), ("right", 0.11)):
    thigh = data.edit_bones.new(f"{side}.thigh")
    thigh.head, thigh.tail = (0, y, 0), (0.01, y, -0.5)  # a little bent, for the solver to know the way
    shin = data.edit_bones.new(f"{side}.shin")
    shin.head, shin.tail = thigh.tail, (0, y, -1)
    shin.parent, shin.use_connect = thigh, True
    foot = data.edit_bones.new(f"{side}.foot")
    foot.head, foot.tail = shin.tail, (0.2, y, -1)
    foot.parent = shin
bpy.ops.object.mode_set(mode="OBJECT")

cylinder(0.19, 0.62, (0, 0, 0.36), red, man)
bpy.ops.mesh.primitive_uv_sphere_add(radius=0.17, location=(0.03, 0, 0.92))
dress(bpy.context.object, skin, man)
for side, y in (("left", -0.11), ("right", 0.11)):
    cylinder(0.08, 0.52, (0, y, -0.25), blue, man, f"{side}.thigh")
    cylinder(0.08, 0.52, (0, y, -0.75), blue, man, f"{side}.shin")
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0.07, y, -1))
    bpy.context.object.scale = (0.3, 0.14, 0.1)
    dress(bpy.context.object, black, man, f"{side}.foot")

arms = []
for y in (-0.24, 0.24):
    shoulder = bpy.data.objects.new("shoulder", None)
    scene.collection.objects.link(shoulder)
    shoulder.parent, shoulder.location = man, (0, y, 0.6)
    cylinder(0.06, 0.6, (0, 0, -0.3), red, shoulder)
    arms.append(shoulder)

# Feet reach for these.
for k, (side, y) in enumerate((("left", -0.11), ("right", 0.11)), start=1):
    goal = bpy.data.objects.new(f"{side}.goal", None)
    scene.collection.objects.link(goal)
    ik = man.pose.bones[f"{side}.shin"].constraints.new("IK")
    ik.target, ik.chain_count = goal, 2
    for step in range(8):
        first, x = 13 - 12 * k + 24 * step, 1.25 - 0.8 * k + 1.6 * step
        for frame, place in (
            (first, (x, y, 0.05)),
            (first + 14, (x, y, 0.05)),
            (first + 19, (x + 0.85, y, 0.2)),
        ):
            goal.location = place
            goal.keyframe_insert("location", frame=frame)
    for curve in goal.animation_data.action.fcurves:
        for key in curve.keyframe_points:
            key.interpolation = "BEZIER"
            key.handle_left_type = key.handle_right_type = "AUTO_CLAMPED"

for frame in range(1, 146):
    t = (frame - 1) / 24
    man.location = (1.6 * t, 0, 0.93 - 0.02 * cos(4 * pi * t))
    man.keyframe_insert("location", frame=frame)
    for sign, arm in zip((1, -1), arms):
        arm.rotation_euler.y = sign * 0.4 * cos(2 * pi * t)
        arm.keyframe_insert("rotation_euler", index=1, frame=frame)

bpy.ops.mesh.primitive_plane_add(size=1000)
dress(bpy.context.object, grass)
for i in range(1, 15):
    cylinder(0.05, 0.7, (i - 3, 1.2, 0.35), white)

bpy.ops.object.light_add(type="SUN")
bpy.context.object.data.energy = 4
bpy.context.object.rotation_euler = Vector((3, -5, 6)).to_track_quat("Z", "Y").to_euler()
world = bpy.data.worlds.new("sky")
scene.world = world
world.use_nodes = True
sky = world.node_tree.nodes.new("ShaderNodeTexSky")
world.node_tree.links.new(sky.outputs["Color"], world.node_tree.nodes["Background"].inputs["Color"])
camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
scene.collection.objects.link(camera)
camera.location = (4, -6, 1.2)
look = camera.constraints.new("TRACK_TO")
look.target, look.track_axis, look.up_axis = man, "TRACK_NEGATIVE_Z", "UP_Y"
scene.camera = camera
