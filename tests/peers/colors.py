# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares pictures through configurations of colours with what OpenColorIO's own module makes of the same light.
#   colors.py PROGRAM [FOLDER]
# Draws each picture as light (.exr) and through the view (PNG of 16 bits). Leaves out the edges of bright light, where
# Betwixt mixes pictures instead of light. Prints differences in units of 255.
import array, os, shutil, subprocess, sys, tempfile

here = os.path.dirname(os.path.abspath(__file__))
sys.path.append(here)
from verdicts import done, verdict

try: import PyOpenColorIO as ocio
except ImportError:
    print("left out: python3-pyopencolorio is missing")
    done()

program, W, H = os.path.abspath(sys.argv[1]), 320, 180
CONFIG = """ocio_profile_version: 2
search_path: luts
strictparsing: true
roles: {scene_linear: lin_srgb, default: lin_srgb}
displays:
  sRGB:
    - !<View> {name: Standard, colorspace: srgb}
    - !<View> {name: Logarithm, colorspace: logged}
    - !<View> {name: Mixed, colorspace: mixed}
    - !<View> {name: File, colorspace: filed}
looks:
  - !<Look>
    name: Punchy
    process_space: lin_srgb
    transform: !<CDLTransform> {slope: [1.2, 1, 0.9], offset: [0.01, 0, 0], power: [1.1, 1, 1], sat: 1.3}
colorspaces:
  - !<ColorSpace> {name: lin_srgb, encoding: scene-linear}
  - !<ColorSpace>
    name: srgb
    from_scene_reference: !<ExponentWithLinearTransform> {gamma: 2.4, offset: 0.055, direction: inverse}
  - !<ColorSpace>
    name: logged
    from_scene_reference: !<LogAffineTransform> {base: 2, log_side_slope: 0.06, log_side_offset: 0.7, lin_side_slope: 1, lin_side_offset: 0.0003}
  - !<ColorSpace>
    name: mixed
    from_scene_reference: !<GroupTransform>
      children:
        - !<MatrixTransform> {matrix: [0.6, 0.3, 0.1, 0, 0.1, 0.8, 0.1, 0, 0.05, 0.15, 0.8, 0, 0, 0, 0, 1]}
        - !<ExponentWithLinearTransform> {gamma: 2.4, offset: 0.055, direction: inverse}
  - !<ColorSpace>
    name: filed
    from_scene_reference: !<GroupTransform>
      children:
        - !<ExponentWithLinearTransform> {gamma: 2.4, offset: 0.055, direction: inverse}
        - !<FileTransform> {src: teal.cube, interpolation: tetrahedral}
"""
FILM = """size 320x180
exposure %g
ground on
create ball sphere position=(0 1 0) color=tomato
create lamp sphere radius=0.3 position=(-2 1.5 0) color=white
set lamp.emission orange
set lamp.emission-strength 12
view "config.ocio" through="%s" %s
"""


def numbers(kind, path, pixels):
    out = array.array(kind)
    out.frombytes(subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", pixels, "-"],
                                 capture_output=True, check=True).stdout)
    return out


def compare(view, look, exposure, space):
    with open("film.bx", "w") as out: out.write(FILM % (exposure, view, f'look="{look}"' if look else ""))
    subprocess.run([program, "frame", "film.bx", "-o", "light.exr"], check=True)
    subprocess.run([program, "frame", "film.bx", "-o", "shown.png", "--bits", "16"], check=True)
    planes, shown, n = numbers("f", "light.exr", "gbrapf32le"), numbers("H", "shown.png", "rgb48le"), W * H
    light = list(zip(planes[2 * n:3 * n], planes[:n], planes[n:2 * n]))
    pipeline = ocio.LegacyViewingPipeline()
    pipeline.setDisplayViewTransform(ocio.DisplayViewTransform(src=space, display="sRGB", view=view))
    if look: pipeline.setLooksOverrideEnabled(True), pipeline.setLooksOverride(look)
    config = ocio.Config.CreateFromFile("config.ocio")
    cpu = pipeline.getProcessor(config, config.getCurrentContext()).getDefaultCPUProcessor()
    peak, off = [max(c) for c in light], []
    for i, c in enumerate(light):
        x, y = i % W, i // W
        near = [peak[q * W + p] for q in range(max(0, y - 1), min(H, y + 2)) for p in range(max(0, x - 1), min(W, x + 2))]
        if max(near) > 1 and max(near) > 1.5 * min(near): continue
        wanted = cpu.applyRGB(list(c))
        off += [255 * abs(min(1, max(0, wanted[k])) - shown[3 * i + k] / 65535) for k in range(3)]
    off.sort()
    return sum(off) / len(off), off[int(0.999 * len(off))], off[-1]


# The most that the mean and the 99.9th percentile may be.
ROWS = [("Standard", "", 0.01, 0.02), ("Logarithm", "", 0.01, 0.02), ("File", "", 0.15, 0.3), ("Mixed", "", 0.3, 6),
        ("Standard", "Punchy", 0.3, 12), ("Mixed", "Punchy", 0.3, 8)]
# The configuration that comes with Blender, if it is there.
BLENDER = "/usr/share/blender/datafiles/colormanagement"
BLENDER_ROWS = [("Standard", "", 0.01, 0.02), ("Filmic", "", 0.1, 0.3), ("Filmic", "High Contrast", 0.1, 0.3),
                ("Filmic", "Very Low Contrast", 0.1, 0.3)]


def all_of(rows, name, space):
    for view, look, most_mean, most in rows:
        for exposure in (-4, 0, 2):
            mean, high, worst = compare(view, look, exposure, space)
            words = f"{name} {view} {look} exposure {exposure}: mean {mean:.3f}, 99.9 % {high:.3f}, most {worst:.2f} of 255"
            print(words)
            verdict(mean < most_mean and high < most, words)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    os.mkdir("luts")
    with open("config.ocio", "w") as out: out.write(CONFIG)
    with open("luts/teal.cube", "w") as out:
        out.write("LUT_3D_SIZE 17\n")
        for b in range(17):
            for g in range(17):
                for r in range(17):
                    out.write(f"{r / 16 * 0.9:.6f} {min(1, 0.05 + 0.9 * g / 16 + 0.05 * b / 16):.6f} {0.1 + 0.85 * b / 16:.6f}\n")
    all_of(ROWS, "our own", "lin_srgb")
    if os.path.exists(BLENDER):
        shutil.copytree(BLENDER, folder, dirs_exist_ok=True)
        all_of(BLENDER_ROWS, "Blender's", "Linear")
done()
