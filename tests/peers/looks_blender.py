# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Renders models with Cycles, by Blender's own importer.
#   tools/blender.sh -b --factory-startup --python looks_blender.py -- JOBS.json   a list of what looks.py asks for
import json, math, sys, time
import numpy
numpy.bool = bool  # the importer of Blender 3.4 needs it, but numpy 1.24 has removed it
import bpy
from mathutils import Vector


def upright(p):
    return Vector((p[0], -p[2], p[1]))


def under_sky(scene, path):
    world = scene.world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    nodes = world.node_tree.nodes
    picture = nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(path)
    world.node_tree.links.new(picture.outputs["Color"], nodes["Background"].inputs["Color"])
    world.cycles.sampling_method, world.cycles.sample_map_resolution = "MANUAL", 512


def linked(tree, kind, links, **values):
    node = tree.nodes.new("ShaderNode" + kind)
    for name, value in values.items(): setattr(node, name, value)
    for number, what in links.items():
        if hasattr(what, "is_linked"): tree.links.new(what, node.inputs[number])
        else: node.inputs[number].default_value = what
    return node.outputs[0]


def decoded(picture):
    """The picture, not multiplied by its alpha. Its colours become light: Cycles interpolates coded ones."""
    picture.alpha_mode = "CHANNEL_PACKED"
    if picture.colorspace_settings.name != "sRGB": return picture
    values = numpy.empty(len(picture.pixels), numpy.float32)
    picture.pixels.foreach_get(values)
    colors = values.reshape(-1, 4)[:, :3]
    colors[:] = numpy.where(colors <= 0.04045, colors / 12.92, ((colors + 0.055) / 1.055) ** 2.4)
    light = bpy.data.images.new(picture.name, *picture.size, alpha=True, float_buffer=True)
    light.colorspace_settings.name, light.alpha_mode = "Linear", "CHANNEL_PACKED"
    light.pixels.foreach_set(values)
    return light


def as_in_gltf(material):
    """Where Blender 3.4 leaves glTF: colours of pictures are decoded before they are interpolated, and not multiplied by their alpha;
    masks cut; glass has its colour once, not at each of its sides; facets reflect light more than once; what is reflected does not
    reach the dull ground below, which is Lambert's; a clear coat has all of its reflection, not a quarter."""
    tree = material.node_tree
    for node in list(tree.nodes):
        if node.type == "TEX_IMAGE" and node.image: node.image = decoded(node.image)
        if node.type == "BSDF_PRINCIPLED": principled_as_in_gltf(material, tree, node)


def reflected_share(nv, roughness, f0):
    """The share of even light that a rough surface reflects once, for a cosine of the angle of sight: a mean over its facets."""
    a2 = max(roughness ** 4, 1e-6)
    u, turn = numpy.meshgrid((numpy.arange(128) + 0.5) / 128, (numpy.arange(64) + 0.5) / 64 * 2 * math.pi)
    nh = numpy.sqrt((1 - u) / (1 + (a2 - 1) * u))
    vh = math.sqrt(1 - nv * nv) * numpy.sqrt(1 - nh * nh) * numpy.cos(turn) + nv * nh
    nl = 2 * vh * nh - nv
    seen = 2 * nl * nv / (nl * numpy.sqrt(a2 + (1 - a2) * nv * nv) + nv * numpy.sqrt(a2 + (1 - a2) * nl * nl))
    each = (f0 + (1 - f0) * (1 - vh) ** 5) * seen * vh / (nh * nv)
    return float(numpy.where((nl > 0) & (vh > 0), each, 0).mean())


def over_dull_ground(tree, node):
    """Puts Lambert's surface below the reflections of a node that is no metal; returns the new output."""
    names = ("Metallic", "Roughness", "Transmission", "Alpha", "Sheen")
    metal, rough, through, alpha, sheen = [0.5 if node.inputs[n].is_linked else node.inputs[n].default_value for n in names]
    if metal or through or sheen or alpha < 1 or node.inputs["Roughness"].is_linked: return node.outputs["BSDF"]
    color, normal = [node.inputs[n].links[0].from_socket if node.inputs[n].is_linked else None for n in ("Base Color", "Normal")]
    across = {"Normal": normal} if normal else {}
    weight = tree.nodes.new("ShaderNodeLayerWeight")
    weight.inputs["Blend"].default_value = 0.5
    if normal: tree.links.new(normal, weight.inputs["Normal"])
    ramp = tree.nodes.new("ShaderNodeValToRGB")
    tree.links.new(weight.outputs["Facing"], ramp.inputs[0])
    stops = ramp.color_ramp.elements
    for k in range(32):
        at = k / 31
        stop = stops[0] if k == 0 else stops[len(stops) - 1] if k == 31 else stops.new(at)
        left = 1 - reflected_share(max(1 - at, 1e-3), rough, 0.08 * node.inputs["Specular"].default_value)
        stop.color = (left, left, left, 1)
    dull = linked(tree, "VectorMath", {0: color or list(node.inputs["Base Color"].default_value)[:3], 1: ramp.outputs[0]},
                  operation="MULTIPLY")
    if color: tree.links.remove(node.inputs["Base Color"].links[0])
    node.inputs["Base Color"].default_value = (0, 0, 0, 1)
    ground = linked(tree, "BsdfDiffuse", {"Color": dull, **across})
    return linked(tree, "AddShader", {0: node.outputs["BSDF"], 1: ground})


def principled_as_in_gltf(material, tree, node):
    node.distribution = "MULTI_GGX"
    if material.blend_method == "CLIP" and node.inputs["Alpha"].is_linked:
        alpha = node.inputs["Alpha"].links[0].from_socket
        cut = linked(tree, "Math", {0: alpha, 1: material.alpha_threshold}, operation="GREATER_THAN")
        tree.links.new(cut, node.inputs["Alpha"])
    if node.inputs["Transmission"].default_value > 0:
        color = node.inputs["Base Color"].default_value
        for k in range(3): color[k] = math.sqrt(color[k])
    to = node.outputs["BSDF"].links[0].to_socket
    base = over_dull_ground(tree, node)
    much = node.inputs["Clearcoat"].default_value
    node.inputs["Clearcoat"].default_value = 0
    tree.links.new(base, to)
    if much == 0: return
    coat = linked(tree, "BsdfGlossy", {"Roughness": node.inputs["Clearcoat Roughness"].default_value})
    share = linked(tree, "Math", {0: linked(tree, "Fresnel", {0: 1.5}), 1: much}, operation="MULTIPLY")
    tree.links.new(linked(tree, "MixShader", {0: share, 1: base, 2: coat}), to)


def render(job):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=job["model"])
    for material in bpy.data.materials:
        if material.use_nodes: as_in_gltf(material)
    scene = bpy.context.scene
    under_sky(scene, job["sky"])
    camera = bpy.data.cameras.new("eye")
    camera.sensor_fit, camera.angle_y = "VERTICAL", math.radians(job["fov"])
    eye = scene.camera = bpy.data.objects.new("eye", camera)
    scene.collection.objects.link(eye)
    eye.location = upright(job["eye"])
    eye.rotation_euler = (-eye.location).to_track_quat("-Z", "Y").to_euler()
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples = "CPU", job["samples"]
    scene.cycles.use_adaptive_sampling = scene.cycles.use_denoising = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.sample_clamp_indirect = scene.cycles.sample_clamp_direct = scene.cycles.blur_glossy = 0
    scene.cycles.max_bounces = scene.cycles.transmission_bounces = scene.cycles.glossy_bounces = 64
    scene.cycles.diffuse_bounces = scene.cycles.transparent_max_bounces = 64
    scene.render.resolution_x, scene.render.resolution_y = job["width"], job["height"]
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.filepath = job["out"]
    bpy.ops.render.render(write_still=True)


for job in json.load(open(sys.argv[sys.argv.index("--") + 1])):
    begun = time.time()
    render(job)
    print("RESULT", job["out"], f"{time.time() - begun:.1f} s", flush=True)
