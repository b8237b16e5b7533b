# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Exports films as USD, and checks the files with three.js and tinyusdz.
#   usda.py PROGRAM PEERS [FILM…]     PEERS is the folder with node_modules and usda.mjs
import json, os, random, subprocess, sys, tempfile

here = os.path.dirname(os.path.abspath(__file__))
program, peers = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
examples = os.path.join(here, "..", "..", "examples")
films = sys.argv[3:] or [os.path.join(here, "flat.bx")] + [
    os.path.join(examples, name + ".bx") for name in ("bounce", "grab", "chain", "four-balls", "clockwork", "roll", "walk", "figure", "nail")]
most = 1e-3  # the tolerance of the file
passed = failed = 0
with tempfile.TemporaryDirectory() as folder:
    for film in films:
        name = os.path.basename(film)[:-3]
        rand = random.Random(name)

        def run(*words):
            return subprocess.run(words, capture_output=True, text=True)

        made = run(program, "export", film, "-o", folder + "/film.usda")
        head = open(folder + "/film.usda").read(600) if made.returncode == 0 else made.stderr
        def said(key):
            return float(head.split(key + " = ")[1].split()[0])
        try:
            length = said("endTimeCode") / said("timeCodesPerSecond")
        except IndexError:
            failed += 1
            print("FAILED", name, head)
            continue
        begin = 0.0
        times = [begin + length * rand.random() for _ in range(30)]
        listed = json.loads(run(program, "eval", film, "--at", "0s", "--json").stdout)
        worlds = [f"{n}.world" for n in dict.fromkeys(t.split(".")[0] for t in listed["times"][0]["values"])]
        answer = json.loads(run(program, "eval", film, "--at", ",".join(f"{t:.9f}s" for t in times), "--json", *worlds).stdout)
        answer["from"] = begin
        json.dump(answer, open(folder + "/values.json", "w"))
        asked = run("node", peers + "/usda.mjs", folder + "/film.usda", folder + "/values.json")
        try:
            got = json.loads(asked.stdout.splitlines()[-1])
            good = got["most"] <= most and got["compared"] > 0 and got["tinyusdz"]
        except (IndexError, ValueError):
            got, good = asked.stdout[-500:] + asked.stderr[-1500:], False
        # Compares skinned vertices with those that three.js gets from the glTF file.
        if name == "figure" and good:
            run(program, "export", film, "-o", folder + "/film.glb", "--keys", "cubic")
            boxes = [json.loads(run("node", peers + "/usda_skin.mjs", folder + end, *[str(t) for t in times[:8]]).stdout)
                     for end in ("/film.usda", "/film.glb")]
            flat = [[sorted(skins) for skins in at] for at in boxes]
            got["skins"] = max((abs(a - b) for one, other in zip(*flat) for s, t in zip(one, other)
                                for p, q in zip(s, t) for a, b in zip(p, q)), default=1e9)
            good = len(flat[0][0]) == len(flat[1][0]) == 2 and got["skins"] <= most
        passed, failed = passed + good, failed + (not good)
        print("" if good else "FAILED ", name, got, sep="")
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
