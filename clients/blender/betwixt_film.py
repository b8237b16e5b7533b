# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""An add-on that imports Betwixt scripts as Blender objects with F-curves. It can follow a script file or a server.

This is one file, because that is how add-ons are installed: Edit > Preferences > Add-ons > Install. Then use
File > Import > Betwixt (.bx). The add-on needs the Python module `betwixt`: on Debian 12,
`sudo apt install ./betwixt_*.deb ./python3-betwixt_*.deb`. If Blender does not find the module, name its folder in the
add-on's preferences or in the variable BETWIXT_PYTHON. The page "Import and export" of the documentation
(/usr/share/doc/betwixt/exchange.md) lists what the add-on imports.
"""

import importlib
import math
import os
import sys

import bpy
import numpy as np
from bpy.props import BoolProperty, FloatProperty, StringProperty
from bpy_extras.io_utils import ImportHelper
from mathutils import Matrix, Vector

bl_info = {
    "name": "Betwixt",
    "author": "The Betwixt authors",
    "version": (0, 0, 0),  # tools/release.sh writes it
    "blender": (3, 4, 0),
    "location": "File > Import > Betwixt (.bx)",
    "description": "Films of the animation system Betwixt",
    "category": "Import-Export",
}

HELD, STRAIGHT, CUBIC = 0, 1, 2  # the numbers that foreach_set has for CONSTANT, LINEAR and BEZIER
MOMENT = 0.002  # a jump becomes a step of so many frames before its time, because a curve has one value at each time


def betwixt():
    """Returns the module betwixt. Raises ImportError if no folder has it."""
    try:
        return importlib.import_module("betwixt")
    except ImportError:
        preferences = bpy.context.preferences.addons.get(__name__)
        named = preferences.preferences.module if preferences and preferences.preferences else ""
        for folder in (named, os.environ.get("BETWIXT_PYTHON", "")):
            if folder and folder not in sys.path:
                sys.path.insert(0, bpy.path.abspath(folder))
        return importlib.import_module("betwixt")


# ---- curves

def pieces_of(channel, rate):
    """Returns tuples (shape, first, last, begin, end, leaving, arriving): times in frames, values and slopes at both
    ends. Each jump takes MOMENT frames."""
    given, made = without_corners(channel, rate), []
    for k, (shape, first, last, begin, end, leaving, arriving) in enumerate(given):
        jumps = k + 1 < len(given) and not alike(given[k + 1][3], end)
        if not jumps or shape == HELD:
            made.append((shape, first, last, begin, end, leaving, arriving))
            continue
        # A part of a cubic is a cubic, so the piece is unchanged up to MOMENT before its end.
        length = last - first
        u = max(0.5, 1 - MOMENT / length)
        if shape == STRAIGHT:
            there, speed = begin + u * (end - begin), arriving
        else:
            a, b = length * leaving, length * arriving
            there = (((2 * u - 3) * u * u + 1) * begin + (3 - 2 * u) * u * u * end
                     + ((u - 2) * u + 1) * u * a + (u - 1) * u * u * b)
            speed = ((6 * u - 6) * u * (begin - end) + ((3 * u - 4) * u + 1) * a + (3 * u - 2) * u * b) / length
        made.append((shape, first, first + u * length, begin, there, leaving, speed))
        made.append((HELD, first + u * length, last, there, there, 0 * there, 0 * there))
    return made


def without_corners(channel, rate):
    """Returns lists [shape, first, last, begin, end, leaving, arriving] in frames, with one key for each corner.

    A corner may be a very short piece. Blender uses the value of a key also for times very close to it, so such a piece
    would show wrong values. It becomes one key at the value to which both neighbours lead, on a whole frame if one is
    near."""
    given = [[("held", "straight", "cubic").index(p.shape), p.first, p.last, p.begin, p.end, p.leaving / rate,
              p.arriving / rate] for p in channel.pieces]
    given = [p for p in given[:-1] if p[2] > p[1]] + given[-1:]  # the last may be a jump, without length
    for p in given:
        if p[0] == STRAIGHT and p[2] > p[1]:
            p[5] = p[6] = (p[4] - p[3]) / (p[2] - p[1])
    made = given[:1]
    for p, after in zip(given[1:], given[2:] + [None]):
        before, (_, first, last, begin, end, _, _) = made[-1], p
        if after is not None and last - first < 2 * MOMENT and alike(before[4], begin) and alike(end, after[3]):
            corner = (first + last) / 2
            corner = round(corner) if abs(corner - round(corner)) < 2 * MOMENT else corner
            there = begin + (corner - first) * before[6]
            if np.abs(there - (end + (corner - last) * after[5])).max() < 1e-5:
                before[2], before[4], after[1], after[3] = corner, there, corner, there
                continue
        made.append(p)
    return made


def alike(a, b):
    return np.allclose(a, b, rtol=1e-7, atol=1e-7)


def curve(action, path, index, points):
    """Makes an F-curve from points (frame, value, interpolation, slope after, slope before). The handles are at thirds
    of the segments."""
    fcurve = action.fcurves.new(path, index=index)
    n = len(points)
    x, y, shape, leaving, arriving = (np.array([p[i] for p in points], dtype=float) for i in range(5))
    before = np.diff(x, prepend=x[0] - 1) / 3
    behind = np.diff(x, append=x[-1] + 1) / 3
    fcurve.keyframe_points.add(n)
    for point in fcurve.keyframe_points:  # foreach_set does not set these
        point.handle_left_type = point.handle_right_type = "FREE"
    for name, a, b in (("co", x, y), ("handle_left", x - before, y - before * arriving),
                       ("handle_right", x + behind, y + behind * leaving)):
        fcurve.keyframe_points.foreach_set(name, np.column_stack((a, b)).ravel())
    fcurve.keyframe_points.foreach_set("interpolation", shape.astype(int))
    fcurve.update()
    return fcurve


def action_of(owner):
    data = owner.animation_data_create()
    if data.action is None:
        data.action = bpy.data.actions.new(owner.name)
    return data.action


def animate(owner, path, channel, rate, order=None):
    """Animates a property by a channel. `order` has the index of the channel's component for each component of the
    property."""
    order = order or range(channel.width)
    if channel.constant:
        setattr(owner, path, [channel.pieces[0].begin[i] for i in order])
        return
    pieces = pieces_of(channel, rate)
    for place, i in enumerate(order):
        points, arriving = [], 0
        for shape, first, last, begin, end, leaving, at_end in pieces:
            if last == first:
                continue
            points.append((first, begin[i], shape, leaving[i], arriving))
            arriving = at_end[i]
        points.append((pieces[-1][2], pieces[-1][4][i], HELD, 0, arriving))
        curve(action_of(owner), path, place, points)


def animate_samples(owner, path, frames, values, index=0, held=False, also=None):
    """Animates a number by its values at frames. Between frames it is linear, or constant if `held`. Returns whether
    the number varies."""
    values = [float(v) for v in values]
    if all(v == values[0] for v in values):
        return False
    last, points = len(values) - 1, []
    for k, v in enumerate(values):
        if 0 < k < last and (values[k - 1] == v if held else values[k - 1] + values[k + 1] == 2 * v):
            continue
        points.append((frames[k], v, HELD if held else STRAIGHT, 0, 0))
    curve(action_of(also or owner), path, index, points)
    return True


# ---- meshes, materials, lights, cameras

def mesh_of(name, shape):
    """Returns a Blender mesh. Its texture coordinates are flipped, because Blender's start at the bottom."""
    made = bpy.data.meshes.new(name)
    positions, triangles = shape.positions, shape.triangles
    made.vertices.add(len(positions))
    made.vertices.foreach_set("co", np.ascontiguousarray(positions, np.float32).ravel())
    made.loops.add(triangles.size)
    made.loops.foreach_set("vertex_index", triangles.astype(np.int32).ravel())
    made.polygons.add(len(triangles))
    made.polygons.foreach_set("loop_start", np.arange(0, triangles.size, 3, dtype=np.int32))
    made.polygons.foreach_set("loop_total", np.full(len(triangles), 3, np.int32))
    made.polygons.foreach_set("use_smooth", np.ones(len(triangles), bool))
    if len(shape.uvs):
        uvs = shape.uvs[triangles.ravel()].astype(np.float32)
        uvs[:, 1] = 1 - uvs[:, 1]
        made.uv_layers.new().data.foreach_set("uv", uvs.ravel())
    slots = np.zeros(len(triangles), np.int32)
    for k, part in enumerate(shape.parts):
        slots[part.first:part.first + part.count] = k
    made.polygons.foreach_set("material_index", slots)
    made.update()
    made.validate()
    if len(triangles):
        made.use_auto_smooth = True
        made.normals_split_custom_set_from_vertices(np.ascontiguousarray(shape.normals, np.float32))
    return made


def image_of(name, picture):
    made = bpy.data.images.new(name, picture.width, picture.height, alpha=True)
    made.pixels.foreach_set((picture.pixels[::-1].astype(np.float32) / 255).ravel())
    made.pack()
    return made


def material_of(name, looks, frames, part=None):
    """Returns a material with the thing's colour and transparency over time, and its shininess."""
    first = looks[0]
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    tint = part.color.astype(float) if part else np.ones(3)
    tinted = part.tinted if part else True
    colors = [np.append(tint * (look.color if tinted else 1), 1) for look in looks]
    clear = [1 - look.transparency for look in looks]
    glows = first.material == "glow"
    shader.inputs["Metallic"].default_value = float(first.material == "metal")
    shader.inputs["Roughness"].default_value = 1.0 if first.material == "matte" else 1 - first.shininess
    shader.inputs["Specular"].default_value = 0.0 if first.material in ("matte", "glow") else 0.5
    shader.inputs["Alpha"].default_value = clear[0]
    color = shader.inputs["Emission" if glows else "Base Color"]
    color.default_value = colors[0]
    if glows:
        shader.inputs["Base Color"].default_value = (0, 0, 0, 1)
        shader.inputs["Emission Strength"].default_value = 1.0
    made.diffuse_color = (*colors[0][:3], clear[0])
    if min(clear) < 1:
        made.blend_method = "BLEND"
    texture = part.texture if part and part.texture else first.texture
    if texture:
        image = made.node_tree.nodes.new("ShaderNodeTexImage")
        image.image = image_of(name, texture)
        mix = made.node_tree.nodes.new("ShaderNodeMixRGB")
        mix.blend_type = "MULTIPLY"
        mix.inputs["Fac"].default_value = 1.0
        mix.inputs["Color2"].default_value = colors[0]
        made.node_tree.links.new(image.outputs["Color"], mix.inputs["Color1"])
        made.node_tree.links.new(mix.outputs["Color"], color)
        color = mix.inputs["Color2"]
    for i in range(3):
        animate_samples(made.node_tree, color.path_from_id("default_value"), frames, [c[i] for c in colors], i)
    animate_samples(made.node_tree, shader.inputs["Alpha"].path_from_id("default_value"), frames, clear)
    return made


class Thing:
    """The looks and shapes of one object, at the frames at which it is visible."""

    def __init__(self):
        self.frames, self.looks, self.shapes = [], [], []  # shapes: (first frame, item)

    def see(self, frame, item):
        self.frames.append(frame)
        self.looks.append(item)
        if not self.shapes or not item.has_shape_of(self.shapes[-1][1]):
            self.shapes.append((frame, item))

    def materials(self, name, parts):
        return [material_of(name, self.looks, self.frames, p) for p in parts or [None]]


def dress(owner, thing, frames, collection):
    """Gives an object its meshes: one mesh, one mesh with shape keys, or several meshes of which one is visible at a
    time."""
    meshes = [item.mesh() for _, item in thing.shapes]
    first = meshes[0]
    alike = all(m.triangles.shape == first.triangles.shape and (m.triangles == first.triangles).all()
                and m.positions.shape == first.positions.shape for m in meshes)
    for variant, m in enumerate(meshes[:1] if alike else meshes):
        made = mesh_of(owner.name, m)
        for material in thing.materials(owner.name, m.parts):
            made.materials.append(material)
        shown = owner
        if not alike:
            shown = bpy.data.objects.new(owner.name, made)
            collection.objects.link(shown)
            shown.parent = owner
            hold_while(shown, thing, frames, variant)
        else:
            empty, shown.data = shown.data, made
            bpy.data.meshes.remove(empty)
            hold_while(shown, thing, frames)
    if alike and len(meshes) > 1:
        for k, m in enumerate(meshes):
            key = owner.shape_key_add(name=f"{thing.shapes[k][0]:g}f", from_mix=False)
            key.interpolation = "KEY_LINEAR"
            key.data.foreach_set("co", np.ascontiguousarray(m.positions, np.float32).ravel())
        keys = owner.data.shape_keys
        keys.use_relative = False
        at = [sum(1 for when, _ in thing.shapes if when <= f) - 1 for f in thing.frames]
        animate_samples(keys, "eval_time", thing.frames, [keys.key_blocks[max(0, k)].frame for k in at])


def hold_while(shown, thing, frames, variant=None):
    """Hides an object at the frames at which its thing is not visible. A variant is also hidden while the thing has
    another shape."""
    seen = set(thing.frames)
    if variant is not None:
        begin = thing.shapes[variant][0]
        end = thing.shapes[variant + 1][0] if variant + 1 < len(thing.shapes) else math.inf
        seen = {f for f in seen if begin <= f < end}
    hidden = [f not in seen for f in frames]
    for path in ("hide_render", "hide_viewport"):
        setattr(shown, path, hidden[0])
        animate_samples(shown, path, frames, hidden, held=True)


def light_of(name, lights, frames, target):
    """Returns a light. Suns are as bright as in Betwixt. Lamps fade with distance in another way in Blender, so they
    have the brightness of Betwixt only at the point `target`."""
    sun = lights[0].sun
    made = bpy.data.lights.new(name, "SUN" if sun else "POINT")
    bright = [max(*l.color, 1e-9) for l in lights]
    if sun:
        strength = [math.pi * b for b in bright]
        made.angle = 0
    else:
        made.shadow_soft_size = 0
        away = [np.linalg.norm(l.position - target) for l in lights]
        fade = [max(0.0, 1 - (d / l.range) ** 2) ** 2 for d, l in zip(away, lights)]
        strength = [4 * math.pi ** 2 * d * d * b * f for d, b, f in zip(away, bright, fade)]
    made.energy = strength[0]
    made.color = lights[0].color / bright[0]
    animate_samples(made, "energy", frames, strength)
    for i in range(3):
        animate_samples(made, "color", frames, [l.color[i] / b for l, b in zip(lights, bright)], i)
    return made


def camera_of(name, cameras, frames, scene, rate):
    first = cameras[0]
    made = bpy.data.cameras.new(name)
    made.sensor_fit = "HORIZONTAL"
    made.clip_start, made.clip_end = 0.01, 10000
    if first.orthographic:
        made.type = "ORTHO"
        scale = [c.height * c.aspect for c in cameras]
        made.ortho_scale = scale[0]
        animate_samples(made, "ortho_scale", frames, scale)
    else:
        lens = [made.sensor_width / 2 / math.tan(c.fov / 2) for c in cameras]
        made.lens = lens[0]
        animate_samples(made, "lens", frames, lens)
        if max(c.aperture for c in cameras) > 0:
            made.dof.use_dof = True
            for path, values in (("aperture_fstop", [l / 1000 / max(c.aperture, 1e-6) for l, c in zip(lens, cameras)]),
                                 ("focus_distance", [c.focus for c in cameras])):
                setattr(made.dof, path, values[0])
                animate_samples(made, "dof." + path, frames, values)
    for path, values in (("shift_x", [c.shift[0] / 2 for c in cameras]),
                         ("shift_y", [c.shift[1] / 2 / c.aspect for c in cameras])):
        setattr(made, path, values[0])
        animate_samples(made, path, frames, values)
    if max(c.shutter for c in cameras) > 0:
        scene.render.use_motion_blur = True
        scene.render.motion_blur_shutter = max(c.shutter for c in cameras) * rate
        scene.cycles.motion_blur_position = "START"
    return made


def pose_samples(owner, frames, worlds):
    """Animates location and rotation of an object by its world matrices at frames."""
    owner.rotation_mode = "QUATERNION"
    places, turns = [], []
    for w in worlds:
        matrix = Matrix(w.tolist())
        turn = matrix.to_quaternion()
        if turns and turn.dot(turns[-1]) < 0:
            turn.negate()
        places.append(matrix.to_translation())
        turns.append(turn)
    owner.location, owner.rotation_quaternion = places[0], turns[0]
    for i in range(3):
        animate_samples(owner, "location", frames, [p[i] for p in places], i)
    for i in range(4):
        animate_samples(owner, "rotation_quaternion", frames, [t[i] for t in turns], i)


# ---- the film

def surroundings(frame, scene, collection, root):
    """Sets background, ground and ambient light."""
    world = bpy.data.worlds.new("betwixt")
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    seen = frame.background if frame.background is not None else (0.05, 0.06, 0.08)
    ambient = frame.ambient if frame.ambient is not None else (0.12, 0.12, 0.12)
    first, other, path, mix = (nodes["Background"], nodes.new("ShaderNodeBackground"), nodes.new("ShaderNodeLightPath"),
                               nodes.new("ShaderNodeMixShader"))
    first.inputs["Color"].default_value = (*ambient, 1)
    other.inputs["Color"].default_value = (*seen, 1)
    links.new(path.outputs["Is Camera Ray"], mix.inputs["Fac"])
    links.new(first.outputs[0], mix.inputs[1])
    links.new(other.outputs[0], mix.inputs[2])
    links.new(mix.outputs[0], nodes["World Output"].inputs["Surface"])
    scene.world = world
    scene.render.film_transparent = frame.clear
    scene.view_settings.view_transform = "Standard"  # colours appear as the script gives them
    scene.view_settings.exposure = frame.exposure
    if frame.ground is not None:
        far = 5000.0
        plane = bpy.data.meshes.new("ground")
        plane.from_pydata([(-far, 0, far), (far, 0, far), (far, 0, -far), (-far, 0, -far)], [], [(0, 1, 2, 3)])
        stuff = bpy.data.materials.new("ground")
        stuff.use_nodes = True
        stuff.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (*frame.ground, 1)
        stuff.node_tree.nodes["Principled BSDF"].inputs["Roughness"].default_value = 1.0
        plane.materials.append(stuff)
        ground = bpy.data.objects.new("ground", plane)
        collection.objects.link(ground)
        ground.parent = root


def say_time(film, scene):
    first, last = film.range
    scene.render.fps = max(1, round(film.rate))
    scene.render.fps_base = scene.render.fps / film.rate
    scene.frame_start, scene.frame_end = math.floor(first), math.floor(last)
    if film.size:
        scene.render.resolution_x, scene.render.resolution_y = film.size
        scene.render.resolution_percentage = 100


def bring_in(film, name, scene, tolerance=2e-6):
    """Imports a film. Returns a new collection, and the imported objects by name. All objects have one root as
    ancestor, which turns y up to z up."""
    say_time(film, scene)
    rate = film.rate
    frames = list(range(scene.frame_start, scene.frame_end + 1))
    seen = [film.frame(f) for f in frames]
    collection = bpy.data.collections.new(name)
    scene.collection.children.link(collection)
    root = bpy.data.objects.new(name, None)
    root.rotation_euler.x = math.pi / 2
    collection.objects.link(root)
    surroundings(seen[0], scene, collection, root)

    things, lights, cameras = {}, {}, {}
    for f, frame in zip(frames, seen):
        for item in frame.items:
            things.setdefault(item.name, Thing()).see(f, item)
        for light in frame.lights:
            lights.setdefault(light.name, ([], []))
            lights[light.name][0].append(f)
            lights[light.name][1].append(light)
        cameras.setdefault(frame.camera.name, ([], []))
        cameras[frame.camera.name][0].append(f)
        cameras[frame.camera.name][1].append(frame.camera)

    # By name: the object with the motion, the object with the data and the children, the name of the parent.
    moved, holds, parents = {}, {}, {}
    for k in film.motion(metres=tolerance, radians=tolerance, arcs=False):
        data = None
        if k.name in cameras:
            data = camera_of(k.name, cameras[k.name][1], cameras[k.name][0], scene, rate)
        elif k.name in lights and not lights[k.name][1][0].sun:
            data = light_of(k.name, lights[k.name][1], lights[k.name][0], middle_of(seen[0]))
        elif k.name in things:
            data = bpy.data.meshes.new(k.name)
        holds[k.name] = held = bpy.data.objects.new(k.name, data)
        moved[k.name] = held
        collection.objects.link(held)
        held["betwixt"] = k.name
        if k.sheared:  # rotation, scaling and another rotation need two objects; the inner one has data and children
            held.rotation_mode = "QUATERNION"
            animate(held, "rotation_quaternion", k.inner, rate, (3, 0, 1, 2))
            held.parent = moved[k.name] = bpy.data.objects.new(k.name + " around", None)
            collection.objects.link(held.parent)
        owner = moved[k.name]
        owner.rotation_mode = "QUATERNION"
        animate(owner, "location", k.translation, rate)
        animate(owner, "rotation_quaternion", k.rotation, rate, (3, 0, 1, 2))
        animate(owner, "scale", k.scale, rate)
        parents[k.name] = k.parent
    for name, owner in moved.items():
        owner.parent = holds[parents[name]] if parents[name] else root
    for name, thing in things.items():
        if name in holds:
            dress(holds[name], thing, frames, collection)

    for name, (when, all_of_it) in lights.items():
        if all_of_it[0].sun:
            sun = bpy.data.objects.new(name + " light", light_of(name, all_of_it, when, None))
            collection.objects.link(sun)
            sun.parent = root
            turns = [Vector(l.direction).to_track_quat("-Z", "Y") for l in all_of_it]
            pose_samples(sun, when, [np.array(t.to_matrix().to_4x4()) for t in turns])
        shown = sun if all_of_it[0].sun else holds.get(name)
        hidden = [f not in when for f in frames]
        for path in ("hide_render", "hide_viewport"):
            setattr(shown, path, hidden[0])
            animate_samples(shown, path, frames, hidden, held=True)
    if "" in cameras:  # the film has no camera of its own at some frames: use the default camera, which sees everything
        eye = bpy.data.objects.new("eye", camera_of("eye", cameras[""][1], cameras[""][0], scene, rate))
        collection.objects.link(eye)
        eye.parent = root
        pose_samples(eye, cameras[""][0], [c.world for c in cameras[""][1]])
        holds[""] = eye
    scene.camera = holds[seen[0].camera.name]
    before = None
    for f, frame in zip(frames, seen):
        if len(cameras) > 1 and frame.camera.name != before:
            scene.timeline_markers.new(frame.camera.name or "eye", frame=f).camera = holds[frame.camera.name]
        before = frame.camera.name
    if not lights:  # as in Betwixt: a key and a fill light follow the camera
        for part, turn, strength in (("key", (-0.7, 0.6, 0), 2.6), ("fill", (-0.2, -0.9, 0), 0.9)):
            lamp = bpy.data.lights.new(part, "SUN")
            lamp.energy = strength
            own = bpy.data.objects.new(part, lamp)
            collection.objects.link(own)
            own.parent, own.rotation_euler = scene.camera, turn
    scene.frame_set(scene.frame_start)
    return collection, {name: held for name, held in holds.items() if name}


def middle_of(frame):
    """Returns the middle of the visible things. Imported lamps have the brightness of Betwixt at this point."""
    places = [i.world[:3, 3] for i in frame.items]
    return np.mean(places, axis=0) if places else np.zeros(3)


def take_out(collection):
    """Removes an imported film, and everything that only it used."""
    for owner in list(collection.objects):
        data = owner.data
        bpy.data.objects.remove(owner)
        if data is not None and data.users == 0:
            for kind in (bpy.data.meshes, bpy.data.lights, bpy.data.cameras):
                if data.name in kind and kind[data.name] == data:
                    kind.remove(data)
                    break
    bpy.data.collections.remove(collection)
    for kind in (bpy.data.materials, bpy.data.actions, bpy.data.images, bpy.data.worlds):
        for one in list(kind):
            if one.users == 0:
                kind.remove(one)


# ---- live

class Live:
    """Follows a script file or a server: imports the film again whenever its script changes."""

    def __init__(self, where, scene, tolerance=2e-6):
        self.where, self.scene, self.tolerance = where, scene, tolerance
        self.server, self.collection, self.objects, self.known = None, None, {}, None
        self.said = ""  # the error in the current script; the last film without errors stays
        if not where.endswith(".bx"):
            self.server = importlib.import_module("betwixt_client").Server(where)

    def text(self):
        if self.server is not None:
            return self.server.do("history").get("said", "")
        with open(self.where, "rb") as script:
            return script.read()

    def look(self):
        """Imports the film if the script changed. Returns whether it was imported."""
        try:
            text = self.text()
        except OSError as why:
            self.said = str(why)
            return False
        if text == self.known:
            return False
        self.known = text
        try:
            film = betwixt().loads(text, "" if self.server is not None else self.where)
        except Exception as why:  # for example an incomplete line: the next change may be valid
            self.said = str(why)
            return False
        self.said = ""
        at = self.scene.frame_current
        if self.collection is not None:
            take_out(self.collection)
        self.collection, self.objects = bring_in(film, os.path.basename(self.where), self.scene, self.tolerance)
        self.scene.frame_set(at)
        return True

    def stop(self):
        if self.server is not None:
            self.server.close()


_live = None


def _tick():
    if _live is None:
        return None
    _live.look()
    return 0.3


# ---- Blender

class IMPORT_OT_betwixt(bpy.types.Operator, ImportHelper):
    """Import a Betwixt film"""
    bl_idname = "import_scene.betwixt"
    bl_label = "Betwixt (.bx)"
    bl_options = {"UNDO"}
    filename_ext = ".bx"
    filter_glob: StringProperty(default="*.bx", options={"HIDDEN"})
    tolerance: FloatProperty(name="Tolerance", description="How far off a curve may be, in metres and radians",
                             default=2e-6, min=1e-9, max=0.1, precision=7)
    live: BoolProperty(name="Live", description="Follow the file: import it again when it is saved", default=False)

    def execute(self, context):
        global _live
        if self.live:
            _live = Live(self.filepath, context.scene, self.tolerance)
            bpy.app.timers.register(_tick, first_interval=0)
            return {"FINISHED"}
        try:
            film = betwixt().load(self.filepath)
        except ImportError as why:
            self.report({"ERROR"}, f"the Python module betwixt cannot be imported ({why}). Install the packages betwixt "
                        "and python3-betwixt, or name the module's folder in the add-on's preferences")
            return {"CANCELLED"}
        except Exception as why:
            self.report({"ERROR"}, str(why))
            return {"CANCELLED"}
        bring_in(film, os.path.basename(self.filepath), context.scene, self.tolerance)
        return {"FINISHED"}


class BETWIXT_OT_follow(bpy.types.Operator):
    """Follow a running imaging server. Choose this again to stop"""
    bl_idname = "betwixt.follow"
    bl_label = "Follow a Betwixt server"
    where: StringProperty(name="Socket", description="The path of its socket")

    def invoke(self, context, event):
        return self.execute(context) if _live else context.window_manager.invoke_props_dialog(self)

    def execute(self, context):
        global _live
        if _live is not None:
            _live.stop()
            _live = None
            return {"FINISHED"}
        try:
            betwixt()
            _live = Live(self.where, context.scene)
        except Exception as why:
            self.report({"ERROR"}, str(why))
            return {"CANCELLED"}
        bpy.app.timers.register(_tick, first_interval=0)
        return {"FINISHED"}


class BetwixtPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__
    module: StringProperty(name="Folder of the Python module", subtype="DIR_PATH")

    def draw(self, context):
        self.layout.prop(self, "module")


def _menu(self, context):
    self.layout.operator(IMPORT_OT_betwixt.bl_idname)
    self.layout.operator(BETWIXT_OT_follow.bl_idname)


CLASSES = (IMPORT_OT_betwixt, BETWIXT_OT_follow, BetwixtPreferences)


def register():
    for c in CLASSES:
        bpy.utils.register_class(c)
    bpy.types.TOPBAR_MT_file_import.append(_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(_menu)
    for c in reversed(CLASSES):
        bpy.utils.unregister_class(c)
