# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The npm package in Node: without a page, films have the values that the program computes.
#   node_test.py PROGRAM
import json, os, shutil, subprocess, sys, tempfile

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.dirname(os.path.dirname(here))
program, package = sys.argv[1], os.path.join(root, "build", "web", "package")
passed = failed = 0
USES = """import { readFileSync } from "node:fs";
import { engine } from "betwixt-player";
const made = await engine();
const files = JSON.parse(process.argv[2]).map((path) => {
  const text = readFileSync(path, "utf8");
  const film = made.open(text, { name: path });
  return film.ok ? film.evalAll(JSON.parse(process.argv[3]), ["1f", "20f", 1.3]) : film.message;
});
const wrong = made.open("create b sphere\\nb.positon\\n  1f (0 0 0)\\n");
const edited = made.open("create b sphere\\n");
edited.setTrack("b.position", [0, 1], [[0, 0, 0], [2, 4, 6]], { twerper: "linear" });
const refused = [[{ ease: "linear" }, [0, 1], [1, 2]], [{}, [0, 1], ["red", "#fff"]], [{}, [0, NaN], [1, 2]]].map(([how, times, values]) => {
  try { edited.setTrack("b.position.x", times, values, how); return "taken"; } catch (error) { return error.message; }
});
console.log(JSON.stringify({ refused, files, wrong: wrong.message, edited: edited.eval("b.position", 0.5) }));
"""


def check(good, words):
    global passed, failed
    passed, failed = passed + bool(good), failed + (not good)
    if not good: print("FAILED", words)


def values(film):
    said = subprocess.run([program, "eval", film, "--at", "1f,20f,1.3s", "--json", "ball.world"], capture_output=True, text=True)
    return [t["values"] for t in json.loads(said.stdout)["times"]]


with tempfile.TemporaryDirectory() as folder:
    shutil.copytree(package, f"{folder}/node_modules/betwixt-player")
    open(f"{folder}/package.json", "w").write('{"type": "module"}')
    open(f"{folder}/use.js", "w").write(USES)
    films = [os.path.join(root, "examples", name + ".bx") for name in ("bounce", "grab", "roll")]
    said = subprocess.run(["node", "use.js", json.dumps(films), '["ball.world"]'], cwd=folder, capture_output=True, text=True)
    check(said.returncode == 0, f"node: {said.stderr[-800:]}")
    if said.returncode == 0:
        got = json.loads(said.stdout)
        for film, answer in zip(films, got["files"]):
            check(isinstance(answer, dict) and [t["values"] for t in answer["times"]] == values(film), f"{film}: {str(answer)[:400]}")
        check("positon" in got["wrong"] and "did you mean 'position'?" in got["wrong"], got["wrong"])
        check(got["edited"] == [1, 2, 3], got["edited"])
        check("no option 'ease'" in got["refused"][0], got["refused"])
        check("needs lists of numbers" in got["refused"][1], got["refused"])
        check("that is no time" in got["refused"][2], got["refused"])
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
