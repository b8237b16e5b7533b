# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# put_together.py FOLDER VERSION: makes the player from the compiled engine in the folder (betwixt.js, betwixt.wasm) and
# the scripts here: betwixt-player.js, one file for pages, and the package for npm.
import base64, gzip, json, os, re, shutil, sys

from scripts import editor_scripts, engine_scripts, player_scripts

folder, version = sys.argv[1], sys.argv[2]
here = os.path.dirname(os.path.abspath(__file__))


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".new", path)


def slim(text):  # without blank lines and lines of comments
    return "\n".join(line for line in text.split("\n") if line.strip() and not re.match(r"\s*//", line)) + "\n"


# The compiled programs: the engine, and the reader of foreign files.
programs = ["betwixt", "betwixt-reader"]
packed, glue = {}, {}
for name in programs:
    with open(os.path.join(folder, name + ".wasm"), "rb") as file:
        packed[name] = gzip.compress(file.read(), 9, mtime=0)
    # Inside a function, the exports for other module systems are of no use.
    glue[name] = re.sub(r"if\s*\(typeof exports\s*===.*", "", read(folder, name + ".js"), flags=re.S)
parts = "".join(slim(read(here, name)) for name in engine_scripts + player_scripts + editor_scripts)
# These would end the script of a page, or begin a comment.
tame = lambda text: re.sub(r"<(?=/script|!--)", r"\\x3c", text, flags=re.I)
glue, parts = {name: tame(text) for name, text in glue.items()}, tame(parts)
head = f"// Betwixt {version}, <https://www.apache.org/licenses/LICENSE-2.0>: films from text. docs/web.md says what it does.\n"

inline = """const held = { betwixt: "%s" };
const wasmBytes = async (name) => {
  const text = atob(held[name]), packed = new Uint8Array(text.length);  // a loop: Uint8Array.from takes ten times as long
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
};
""" % base64.b64encode(packed["betwixt"]).decode()
# A page whose films have no files for the reader leaves out all from the first of these lines to the second
# (src/app/player_file.cpp).
reader = ("// begin of the reader\n" + glue["betwixt-reader"] +
          '\nheld["betwixt-reader"] = "%s";\n// end of the reader\n' % base64.b64encode(packed["betwixt-reader"]).decode())
assert reader.count("// begin of the reader\n") == reader.count("// end of the reader\n") == 1
write(os.path.join(folder, "betwixt-player.js"),
      head + "(() => {\n" + glue["betwixt"] + inline + reader + parts + "})();\n")

beside = """const addresses = {
  "betwixt": () => new URL("./betwixt.wasm", import.meta.url),
  "betwixt-reader": () => new URL("./betwixt-reader.wasm", import.meta.url),
};
const wasmBytes = async (name) => {
  const answer = await fetch(addresses[name]());
  if (!answer.ok) throw new Error(`${answer.url} cannot be fetched: the server answered ${answer.status}`);
  return answer.arrayBuffer();
};
const makeReader = async (how) => (await import("./betwixt-reader.mjs")).makeReader(how);
"""
exports = """export const engine = Betwixt.engine;
export const BetwixtPlayer = Betwixt.Player, BetwixtEditor = Betwixt.Editor;
"""
package = os.path.join(folder, "package")
write(os.path.join(package, "betwixt-player.mjs"), head + glue["betwixt"] + beside + parts + exports)
write(os.path.join(package, "betwixt-reader.mjs"), head + glue["betwixt-reader"] + "export { makeReader };\n")
for name, source in {"betwixt.wasm": folder, "betwixt-reader.wasm": folder, "betwixt-player.js": folder, "betwixt-player.d.ts": here, "README.md": here,
                     "LICENSE": os.path.join(here, "..")}.items():
    shutil.copyfile(os.path.join(source, name), os.path.join(package, name))
about = json.loads(read(here, "package.json"))
about["version"] = version
write(os.path.join(package, "package.json"), json.dumps(about, indent=2) + "\n")

size = lambda text: len(gzip.compress(text.encode(), 9))
plays = {"engine": len(packed["betwixt"]), "its glue": size(glue["betwixt"]), "player": size(parts)}
print("compressed:", ", ".join(f"{what} {n}" for what, n in plays.items()), f"in all {sum(plays.values())} bytes;",
      f"what reads files {len(packed['betwixt-reader']) + size(glue['betwixt-reader'])}")
