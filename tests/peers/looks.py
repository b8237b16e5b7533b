# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares how models look: shaded with three.js, traced with Cycles, from the same GLB, camera and sky, in sRGB without a
# view transform. The models are made by looks_models.py. Traced light is compared as OpenEXR, cut at white, since programs
# differ in how they show edges of light above white.
#   looks.py PROGRAM FOLDER [MODEL…]   FOLDER has node_modules
# Prints the peak signal-to-noise ratio of each pair, over the whole picture. LOOKS_OUT=FOLDER keeps the pictures and a sheet for each
# model: Betwixt and the other one, and four times their difference. LOOKS_SIZE=512x384 and LOOKS_SAMPLES=256 change the size and the
# samples of the traced pictures; LOOKS_AGAIN=1 takes the pictures of the other programs that are in the folder.
import base64, json, os, shutil, subprocess, sys, tempfile, time
import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.dirname(os.path.dirname(here))
sys.path += [here, os.path.join(root, "tests", "web")]
from browser import Browser, Served, find_browser
import looks_models, verdicts
from verdicts import verdict

program, modules, wanted = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3:]
width, height = map(int, os.environ.get("LOOKS_SIZE", "256x192").split("x"))
samples = int(os.environ.get("LOOKS_SAMPLES", "64"))
again = "LOOKS_AGAIN" in os.environ
# For each model its sky, and the least decibels beside three.js and beside Cycles; None: there is nothing to compare. Cycles of Blender
# 3.4 has another sheen, and bends light in panes. Where bumps are as steep as in "normals", mirrors show what is behind their own
# surface: Cycles swallows that light, Betwixt sends it back.
USUAL = {"spheres": ("studio", 31, 36.4), "helmet": ("studio", 36, 35.9), "coat": ("studio", 34, 37.6), "normals": ("studio", 29, 30.2),
         "bumps": ("studio", 32.5, 36.7), "glass": ("studio", 36, 35.5), "panes": ("studio", 36, None), "many": ("studio", 35, 40.7),
         "lamps": ("studio", 40, 45.9), "masks": ("studio", 35, 40.6), "tiles": ("studio", 38, 42.1), "cloth": ("studio", 40, None)}
# Cycles takes as many samples as Betwixt takes at edges. Light that glass gathers on walls is grainier.
CYCLES_SAMPLES, CYCLES_SAMPLES_OF_GLASS = 4 * samples, 8 * samples
EYE, FOV = (0.0, 0.8, 9.0), 32.0


def read_picture(path):
    """A picture, or light as a picture."""
    light = path.endswith(".exr")
    raw = subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", "gbrapf32le" if light else "rgb24", "-"],
                         capture_output=True, check=True).stdout
    if not light: return np.frombuffer(raw, np.uint8).reshape(height, width, 3)
    green, blue, red, _ = np.frombuffer(raw, np.float32).reshape(4, height, width)
    c = np.clip(np.stack([red, green, blue], -1), 0, 1)
    return looks_models.as_bytes(np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055))


def decibels(a, b):
    mean = ((np.float64(a) - np.float64(b)) ** 2).mean()
    return 99.0 if mean == 0 else 10 * np.log10(255 ** 2 / mean)


def draw(model, sky, folder, style, *more):
    name = os.path.splitext(os.path.basename(model))[0]
    out = f"{folder}/{name}-{style}{'-'.join(more)}.{'exr' if style == 'traced' else 'png'}"
    tangent = np.tan(np.radians(FOV / 2)) * width / height
    with open(f"{folder}/{name}.bx", "w") as film:
        film.write(f"""sky "{sky}.hdr"
view plain
create model scene file="{name}.glb"
create eye camera position=({EYE[0]} {EYE[1]} {EYE[2]}) look-at=(0 0 0) fov={np.degrees(2 * np.arctan(tangent)):.6f}deg
look through eye
""")
    count = samples if style == "traced" else 16
    made = subprocess.run([program, "frame", film.name, "-o", out, "--size", f"{width}x{height}", "--style", style, "--samples",
                           str(count), *more], capture_output=True, text=True)
    if made.returncode != 0: raise RuntimeError(made.stderr)
    if wanted and made.stderr: print(made.stderr.strip())
    return read_picture(out)


def difference(a, b):
    return np.uint8(np.clip(np.abs(np.int16(a) - np.int16(b)) * 4, 0, 255))


with tempfile.TemporaryDirectory() as made_here:
    folder = os.environ.get("LOOKS_OUT") or made_here
    os.makedirs(folder, exist_ok=True)
    for sky, light in looks_models.SKIES.items(): looks_models.write_sky(f"{folder}/{sky}.hdr", light())
    names = [n for n in USUAL if not wanted or n in wanted]
    for name in names: looks_models.MODELS[name]().write(f"{folder}/{name}.glb")
    jobs = [{"model": f"{folder}/{n}.glb", "sky": f"{folder}/{USUAL[n][0]}.hdr", "out": f"{folder}/{n}-cycles.exr", "samples": CYCLES_SAMPLES_OF_GLASS if n == "glass" else CYCLES_SAMPLES,
             "width": width, "height": height, "eye": EYE, "fov": FOV} for n in names if USUAL[n][2]]
    cycles, three = {}, {}
    if again: jobs = [job for job in jobs if not os.path.exists(job["out"])]
    begun = time.time()
    if shutil.which("blender"):
        json.dump(jobs, open(f"{folder}/jobs.json", "w"))
        asked = jobs and subprocess.run([os.path.join(root, "tools", "blender.sh"), "-b", "--factory-startup", "--python",
                                os.path.join(here, "looks_blender.py"), "--", f"{folder}/jobs.json"], capture_output=True, text=True)
        asked_for = [n for n in names if USUAL[n][2]]
        for n in asked_for:
            if os.path.exists(f"{folder}/{n}-cycles.exr"): cycles[n] = read_picture(f"{folder}/{n}-cycles.exr")
        if len(cycles) < len(asked_for): verdict(False, f"Blender: {asked.stdout[-800:]} {asked.stderr[-800:]}")
    else: print("left out: there is no Blender here")
    if wanted: print(f"Cycles {time.time() - begun:.0f} s")
    begun = time.time()
    if find_browser():
        for at in ("node_modules", "looks.html"):
            if not os.path.lexists(f"{folder}/{at}"): os.symlink(os.path.abspath(os.path.join(modules, at)), f"{folder}/{at}")
        with Browser() as browser, Served(folder) as address:
            page = browser.page(address + "/looks.html")
            page.until("window.ready === true")
            for n in names:
                if again and os.path.exists(f"{folder}/{n}-three.png"):
                    three[n] = read_picture(f"{folder}/{n}-three.png")
                    continue
                job = {"model": f"{n}.glb", "sky": f"{USUAL[n][0]}.hdr", "width": width, "height": height, "fine": 4, "eye": EYE, "fov": FOV}
                three[n] = np.frombuffer(base64.b64decode(page.ask(f"drawn({json.dumps(job)})", 180)), np.uint8).reshape(height, width, 3)
                with open(f"{folder}/{n}-three.png", "wb") as out: out.write(looks_models.png(three[n]))
    else: print("left out: there is no browser here")
    if wanted: print(f"three.js {time.time() - begun:.0f} s")
    told = [f"{'decibels':10} {'shaded':>8} {'traced':>8}" + (f" {'grainy':>8} {'Cycles beside three.js':>24}" if wanted else "")]
    for n in names:
        model, (sky, least_shaded, least_traced) = f"{folder}/{n}.glb", USUAL[n]
        line, rows = f"{n:10}", []
        # What others made of the model, our style for it, and the least decibels.
        for theirs, name, style, least in ((three, "three.js", "shaded", least_shaded), (cycles, "Cycles", "traced", least_traced)):
            if n not in theirs: continue
            ours = draw(model, sky, folder, style)
            found = decibels(ours, theirs[n])
            line += f" {found:8.1f}"
            verdict(found >= least, f"{n} {style} beside {name}: {found:.1f} dB; at least {least}")
            rows.append((ours, theirs[n], difference(ours, theirs[n])))
        if wanted and n in cycles:
            line += f" {decibels(draw(model, sky, folder, 'traced', '--denoise', 'off'), cycles[n]):8.1f}"
            if n in three: line += f" {decibels(cycles[n], three[n]):24.1f}"
        told.append(line)
        if wanted: print(line, flush=True)
        if rows:
            with open(f"{folder}/{n}-sheet.png", "wb") as out:
                out.write(looks_models.png(np.concatenate([np.concatenate(r, 1) for r in rows])))
if not wanted and (verdicts.failed or "LOOKS_OUT" in os.environ): print("\n".join(told))
verdicts.done()
