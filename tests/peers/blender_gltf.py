# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Imports exported files with Blender's own importer and its defaults, and compares matrices at the given times.
#   tools/blender.sh -b --factory-startup --python blender_gltf.py -- FILE.glb VALUES.json [FILE.glb VALUES.json…]
import json, math, sys
import numpy
numpy.bool = bool  # the importer of Blender 3.4 needs it, but numpy 1.24 has removed it
import bpy
from mathutils import Matrix

UPRIGHT = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))
BACK = UPRIGHT.inverted()


def worst(file, values):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    answers = json.load(open(values))
    scene = bpy.context.scene
    scene.render.fps = round(answers["rate"])
    bpy.ops.import_scene.gltf(filepath=file)
    most, where, compared = 0.0, "", 0
    for answer in answers["times"]:
        frame = (answer["seconds"] - answers["from"]) * answers["rate"]
        whole = math.floor(frame + 1e-6)
        scene.frame_set(whole, subframe=max(0.0, min(frame - whole, 0.999)))
        for target, world in answer["values"].items():
            name = target[: -len(".world")]
            thing = bpy.data.objects.get(name + " turned") or bpy.data.objects.get(name)
            if thing is None:
                continue
            wanted = UPRIGHT @ Matrix([world[i * 4: i * 4 + 4] for i in range(4)]) @ BACK
            compared += 1
            # The importer rotates cameras and lamps, because they look in another direction in Blender.
            columns = (3,) if thing.type in ("CAMERA", "LIGHT") else range(4)
            for r in range(3):
                for c in columns:
                    off = abs(thing.matrix_world[r][c] - wanted[r][c])
                    if not off <= most:
                        most, where = off, f"{name} at frame {frame:.2f} [{r}][{c}]"
    return {"most": most, "where": where, "compared": compared, "objects": len(bpy.data.objects)}


words = sys.argv[sys.argv.index("--") + 1:]
for file, values in zip(words[::2], words[1::2]):
    print("RESULT " + json.dumps(worst(file, values)), flush=True)
