# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Exports a flat film as Lottie, draws it with rlottie, and compares the centre and the area of each object with the
# film.
#   lottie.py PROGRAM
import json, math, os, subprocess, sys, tempfile

here = os.path.dirname(os.path.abspath(__file__))
program = os.path.abspath(sys.argv[1])
film = os.path.join(here, "flat.bx")
scale, pixels = 4, 40  # pixels per metre, and a factor on top: in a large picture blended pixels at edges matter little
areas = {"ball": math.pi * 0.4**2, "arm/bar": 3 * 0.2, "arm/tip": math.pi * 0.3**2, "bounced": math.pi * 0.3**2, "turner": 0.5}
passed = failed = 0


def run(*words):
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{words}: {done.stderr}")
    return done.stdout


if not os.path.exists("/usr/include/rlottie_capi.h"):
    print("left out: there is no rlottie (librlottie-dev)\n0 passed, 0 failed")
    sys.exit()
with tempfile.TemporaryDirectory() as folder:
    run("cc", "-O1", here + "/lottie.c", "-o", folder + "/lottie", "-lrlottie")
    frames = list(range(0, 73))
    for name, area in areas.items():
        run(program, "export", film, name, "-o", folder + "/film.json")
        got = run(folder + "/lottie", folder + "/film.json", str(640 * scale), str(360 * scale), *map(str, frames))
        said = json.loads(run(program, "eval", film, "--at", ",".join(f"{f + 1}f" for f in frames), "--json", name + ".world"))
        worst = worst_area = 0
        for line, frame in zip(got.splitlines(), said["times"]):
            _, x, y, covered = map(float, line.split())
            m = frame["values"][name + ".world"]
            m = [n for row in m for n in row] if isinstance(m[0], list) else m
            wanted = area * abs(m[0] * m[5] - m[1] * m[4]) * (pixels * scale) ** 2
            worst_area = max(worst_area, abs(covered / wanted - 1))
            worst = max(worst, math.hypot(x / scale - 320 - m[3] * pixels, y / scale - 180 + m[7] * pixels))
        good = worst <= 0.1 and worst_area <= 0.02
        passed, failed = passed + good, failed + (not good)
        print(f"{'' if good else 'FAILED '}{name}: within {worst:.4f} px, its area within {100 * worst_area:.2f} %")
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
