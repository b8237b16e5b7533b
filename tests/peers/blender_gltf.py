# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# What Blender's own importer makes of an exported file, at whole frames.
#   blender -b --factory-startup --python blender_gltf.py -- FILE.glb VALUES.json
import json, sys
import numpy
numpy.bool = bool  # Blender 3.4's importer asks for it, numpy 1.24 has it no more
import bpy
from mathutils import Matrix

file, values = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
answers = json.load(open(values))
bpy.context.scene.render.fps = round(answers["rate"])
bpy.ops.import_scene.gltf(filepath=file)
upright = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))
back = upright.inverted()
most, where = 0.0, ""
for answer in answers["times"]:
    frame = (answer["seconds"] - answers["from"]) * answers["rate"]
    bpy.context.scene.frame_set(round(frame))
    for target, world in answer["values"].items():
        name = target[: -len(".world")]
        thing = bpy.data.objects.get(name)
        if thing is None or thing.type in ("CAMERA", "LIGHT"):
            continue
        wanted = upright @ Matrix([world[i * 4: i * 4 + 4] for i in range(4)]) @ back
        for r in range(4):
            for c in range(4):
                off = abs(thing.matrix_world[r][c] - wanted[r][c])
                if not off <= most:
                    most, where = off, f"{name} at frame {frame:.0f} [{r}][{c}]"
print("RESULT " + json.dumps({"most": most, "where": where, "objects": len(bpy.data.objects)}))
