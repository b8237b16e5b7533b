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


def as_in_gltf(tree, node):
    """Blender 3.4's clear coat has a quarter of the reflection, and its facets reflect light only once."""
    node.distribution = "MULTI_GGX"
    much = node.inputs["Clearcoat"].default_value
    if much == 0: return
    node.inputs["Clearcoat"].default_value = 0
    fresnel, coat, share, mixed = [tree.nodes.new("ShaderNode" + kind) for kind in
                                   ("Fresnel", "BsdfGlossy", "Math", "MixShader")]
    fresnel.inputs["IOR"].default_value = 1.5
    coat.inputs["Roughness"].default_value = node.inputs["Clearcoat Roughness"].default_value
    share.operation, share.inputs[1].default_value = "MULTIPLY", much
    to = node.outputs["BSDF"].links[0].to_socket
    for a, b in [(fresnel.outputs[0], share.inputs[0]), (share.outputs[0], mixed.inputs[0]), (node.outputs["BSDF"], mixed.inputs[1]),
                 (coat.outputs[0], mixed.inputs[2]), (mixed.outputs[0], to)]:
        tree.links.new(a, b)


def render(job):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=job["model"])
    for material in bpy.data.materials:
        for node in material.node_tree.nodes if material.use_nodes else []:
            if node.type == "BSDF_PRINCIPLED": as_in_gltf(material.node_tree, node)
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
    scene.cycles.max_bounces = scene.cycles.transmission_bounces = scene.cycles.glossy_bounces = 16
    scene.cycles.diffuse_bounces = scene.cycles.transparent_max_bounces = 16
    scene.view_settings.view_transform, scene.view_settings.look = "Standard", "None"
    scene.render.resolution_x, scene.render.resolution_y = job["width"], job["height"]
    scene.render.resolution_percentage = 100
    scene.render.dither_intensity = 0
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.filepath = job["out"]
    bpy.ops.render.render(write_still=True)


for job in json.load(open(sys.argv[sys.argv.index("--") + 1])):
    begun = time.time()
    render(job)
    print("RESULT", job["out"], f"{time.time() - begun:.1f} s", flush=True)
