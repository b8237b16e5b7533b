# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Exports every example as glTF with the defaults, and checks it with Khronos' validator, three.js, assimp and, if it is
# installed, Blender. Files with --keys cubic are checked with the programs that keep tangents.
#   gltf.py PROGRAM FOLDER [EXAMPLE…]   FOLDER has gltf.mjs and node_modules; named examples are reported in detail
import json, os, random, shutil, subprocess, sys, tempfile, time
from verdicts import done, verdict

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.dirname(os.path.dirname(here))
program, modules, wanted = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3:]
MOST = {"usual": 1e-3, "cubic": 1e-4}  # the tolerance of each kind of keys
# These films jump between frames. Some of the tested times lie in the hundredth of a frame that a jump takes.
JUMPING = {"frisbee": 0.12, "swarm": 0.1}
# Blender's numbers and frames are 32-bit floats.
BLENDER = 1.1e-3


def run(*words):
    return subprocess.run(words, capture_output=True, text=True)


def last_json(said):
    try:
        return json.loads(said.stdout.splitlines()[-1])
    except (IndexError, ValueError):
        return {"most": 1e9, "where": said.stdout[-500:] + said.stderr[-500:]}


# The tested times: whole frames (all in short films), and times between them. With linear keys a jump takes the last
# hundredth of a frame before its time or before a tick of an environment. These times are not tested.
def times_of(extras, rand, keys):
    rate, first, count = extras["rate"], extras["first_frame"], extras["frames"]
    between = []
    while len(between) < 40:
        t = rand.random() * (count - 1) / rate
        early = min(-(t * rate) % 1 / rate, -(t + (first - 1) / rate) * 30 % 1 / 30)
        if keys == "cubic" or early > 0.011 / rate: between.append(t)
    whole = range(0, count, 1 + count // 150)
    return [(first - 1) / rate + t for t in sorted([k / rate for k in whole] + between)]


def check(film, keys, folder):
    """Exports a film. Returns the file and the expected values, or None if it was not made."""
    name = os.path.basename(film)[:-3]
    path, values = f"{folder}/{name}-{keys}.glb", f"{folder}/{name}-{keys}.json"
    rand = random.Random(name + keys)
    begun = time.time()
    made = run(program, "export", film, "-o", path, *([] if keys == "usual" else ["--keys", keys]))
    took = time.time() - begun
    if made.returncode != 0:
        return verdict(False, f"{name} {keys}: {made.stderr}")
    file = read_glb(path)
    extras = file["scenes"][0]["extras"]
    times = times_of(extras, rand, keys)
    listed = json.loads(run(program, "eval", film, "--at", f"{times[0]}s", "--json").stdout)
    names = dict.fromkeys(target.split(".")[0] for target in listed["times"][0]["values"])
    placed = {node["name"] for node in file["nodes"]}
    worlds = [name + ".world" for name in names if name in placed]
    said = run(program, "eval", film, "--at", ",".join(f"{t:.9f}s" for t in times), "--json", *worlds).stdout
    answer = json.loads(said)
    answer.update({"from": (extras["first_frame"] - 1) / extras["rate"], "rate": extras["rate"]})
    json.dump(answer, open(values, "w"))
    asked = run("node", os.path.join(modules, "gltf.mjs"), path, values)
    got = last_json(asked)
    most = max(MOST[keys], JUMPING.get(name, 0) if keys == "usual" else 0)
    good = got.get("errors") == 0 and got["warnings"] == 0 and got["most"] is not None and got["most"] <= most
    verdict(good, f"{name} {keys} in three.js: {got} {asked.stderr[:2000]}")
    told = f"{name:14} {keys:7} three.js {got['most'] or -1:.1e}"
    if keys == "usual" and assimp:
        other = last_json(run(assimp, path, values))
        verdict(other["most"] <= most and other["compared"] > 0, f"{name} in assimp: {other}")
        told += f"  assimp {other['most']:.1e}"
    if wanted:
        print(f"{told}  {made.stderr.splitlines()[-1].replace(folder + '/', '')}  {took:.1f} s", flush=True)
    return path, values


def check_in_blender(made):
    names = [os.path.basename(path)[:-4] for path, _ in made]
    asked = run(os.path.join(root, "tools", "blender.sh"), "-b", "--factory-startup", "--python",
                os.path.join(here, "blender_gltf.py"), "--", *[word for pair in made for word in pair])
    said = [json.loads(line[7:]) for line in asked.stdout.splitlines() if line.startswith("RESULT ")]
    if len(said) < len(made):
        verdict(False, f"{names[len(said)]} in Blender: {asked.stdout[-500:]} {asked.stderr[-500:]}")
    for name, got in zip(names, said):
        verdict(got["most"] <= max(BLENDER, JUMPING.get(name[:-6], 0)) and got["compared"] > 0, f"{name} in Blender: {got}")
        if wanted: print(f"{name:22} Blender {got['most']:.1e}")


def built_assimp(folder):
    out = folder + "/assimp"
    made = run("c++", "-std=c++20", "-O1", os.path.join(here, "assimp.cpp"), "-o", out, "-lassimp")
    if made.returncode == 0: return out
    print("left out: assimp:", made.stderr.strip().splitlines()[-1] if made.stderr else "it cannot be built")


def read_glb(path):
    data = open(path, "rb").read()
    length = int.from_bytes(data[12:16], "little")
    return json.loads(data[20:20 + length])


films = [os.path.join(root, "examples", f) for f in sorted(os.listdir(os.path.join(root, "examples"))) if f.endswith(".bx")]
in_blender = wanted or ("bounce", "grab", "limp", "solar", "two-stars", "figure", "chain", "clockwork", "roll",
                        "unfold")
with tempfile.TemporaryDirectory() as folder:
    assimp, others = built_assimp(folder), []
    for film in films:
        name = os.path.basename(film)[:-3]
        if wanted and name not in wanted: continue
        made = check(film, "usual", folder)
        if made and name in in_blender: others.append(made)
        # A second check of long films would only take time.
        if wanted or name in ("bounce", "grab", "limp", "two-stars", "funnel"): check(film, "cubic", folder)
    if shutil.which("blender"): check_in_blender(others)
    else: print("left out: there is no Blender here")
done()
