# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Every example as glTF, asked of Khronos' validator, three.js and, where it is, Blender.
#   gltf.py PROGRAM FOLDER [EXAMPLE…]   FOLDER: with gltf.mjs and node_modules; examples that are named are told of
import json, os, random, shutil, subprocess, sys, tempfile, time

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.dirname(os.path.dirname(here))
program, modules, wanted = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3:]
passed = failed = 0


def run(*words):
    return subprocess.run(words, capture_output=True, text=True)


def verdict(good, words):
    global passed, failed
    if good: passed += 1
    else:
        failed += 1
        print("FAILED", words)


def check(film, keys):
    name = os.path.basename(film)[:-3]
    rand = random.Random(name + keys)
    with tempfile.TemporaryDirectory() as folder:
        begun = time.time()
        made = run(program, "export", film, "-o", folder + "/x.glb", "--keys", keys)
        took = time.time() - begun
        if made.returncode != 0:
            return verdict(False, f"{name} {keys}: {made.stderr}")
        file = read_glb(folder + "/x.glb")
        extras = file["scenes"][0]["extras"]
        begin, length = (extras["first_frame"] - 1) / extras["rate"], (extras["frames"] - 1) / extras["rate"]
        times = [begin + length * rand.random() for _ in range(40)]
        listed = json.loads(run(program, "eval", film, "--at", f"{times[0]}s", "--json").stdout)
        names = dict.fromkeys(target.split(".")[0] for target in listed["times"][0]["values"])
        placed = {node["name"] for node in file["nodes"]}
        worlds = [name + ".world" for name in names if name in placed]
        said = run(program, "eval", film, "--at", ",".join(f"{t:.9f}s" for t in times), "--json", *worlds).stdout
        answer = json.loads(said)
        answer["from"] = begin
        json.dump(answer, open(folder + "/v.json", "w"))
        asked = run("node", os.path.join(modules, "gltf.mjs"), folder + "/x.glb", folder + "/v.json")
        try:
            got = json.loads(asked.stdout.splitlines()[-1])
        except Exception:
            return verdict(False, f"{name} {keys}: {asked.stdout} {asked.stderr}")
        good = got["errors"] == 0 and got["warnings"] == 0 and got["most"] is not None and got["most"] <= 1e-4
        verdict(good, f"{name} {keys}: {got} {asked.stderr[:2000]}")
        if wanted:
            print(f"{name:14} {keys:7} {got['most'] or -1:.1e}  {made.stderr.splitlines()[-1]}  {took:.1f} s")


# Blender's importer drops tangents, so it gets straight keys; asked at whole frames.
def check_in_blender(film):
    name = os.path.basename(film)[:-3]
    with tempfile.TemporaryDirectory() as folder:
        run(program, "export", film, "-o", folder + "/x.glb", "--keys", "linear")
        file = read_glb(folder + "/x.glb")
        extras = file["scenes"][0]["extras"]
        first, rate = round(extras["first_frame"]), extras["rate"]
        frames = [first + round(k * (extras["frames"] - 1) / 9) for k in range(10)]
        placed = {node["name"] for node in file["nodes"]}
        listed = json.loads(run(program, "eval", film, "--at", f"{first}f", "--json").stdout)
        names = dict.fromkeys(target.split(".")[0] for target in listed["times"][0]["values"])
        answer = json.loads(run(program, "eval", film, "--at", ",".join(f"{f}f" for f in frames), "--json",
                                *[n + ".world" for n in names if n in placed]).stdout)
        answer.update({"from": (first - 1) / rate, "rate": rate})
        json.dump(answer, open(folder + "/v.json", "w"))
        asked = run(os.path.join(root, "tools", "blender.sh"), "-b", "--factory-startup", "--python", os.path.join(here, "blender_gltf.py"), "--",
                    folder + "/x.glb", folder + "/v.json")
        said = [line for line in asked.stdout.splitlines() if line.startswith("RESULT ")]
        got = json.loads(said[0][7:]) if said else {"most": 1e9, "where": asked.stdout[-500:] + asked.stderr[-500:]}
        verdict(got["most"] <= 1e-4, f"{name} in Blender: {got}")
        if wanted: print(f"{name:14} Blender {got['most']:.1e}")


def read_glb(path):
    data = open(path, "rb").read()
    length = int.from_bytes(data[12:16], "little")
    return json.loads(data[20:20 + length])


films = [os.path.join(root, "examples", f) for f in sorted(os.listdir(os.path.join(root, "examples"))) if f.endswith(".bx")]
for film in films:
    if wanted and os.path.basename(film)[:-3] not in wanted: continue
    for keys in ("cubic", "linear"):
        # Of long ones a second way would only take long.
        if keys == "cubic" or wanted or os.path.basename(film)[:-3] in ("bounce", "grab", "limp", "two-stars", "funnel"):
            check(film, keys)
if shutil.which("blender"):
    for name in wanted or ("bounce", "grab", "limp", "solar", "two-stars", "figure"):
        check_in_blender(os.path.join(root, "examples", name + ".bx"))
else:
    print("left out: there is no Blender here")
print(f"{passed} passed, {failed} failed")
sys.exit(failed != 0)
