# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# put_together.py FOLDER VERSION: makes the player from the compiled engine in the folder (betwixt.js, betwixt.wasm) and
# the scripts here: betwixt-player.js, one file for pages, and the package for npm.
import base64, gzip, json, os, re, shutil, subprocess, sys

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


# Returns the script with short names, and without comments and blanks. Names at the top level of a script stay, those of
# a module change, except what it exports. The result is ASCII, so a server may send it in any encoding.
def minified(text, module=False):
    # Node prints the whole line of an error, so modules keep their lines.
    smaller = ["--minify-identifiers", "--minify-syntax"] if module else ["--minify"]
    how = ["esbuild", *smaller, "--target=es2022", "--legal-comments=none", "--log-level=warning"]
    done = subprocess.run(how + ["--format=esm"] * module, input=text, capture_output=True, text=True, encoding="utf-8")
    if done.returncode != 0:
        sys.exit(done.stderr)
    # These would end the script of a page, or begin a comment.
    return re.sub(r"<(?=/script|!--)", r"\\x3c", done.stdout, flags=re.I)


# Compresses for gunzip. zopfli takes seconds, so the result is kept as long as the program stays the same.
def compressed(path):
    if not os.path.exists(path + ".gz") or os.path.getmtime(path + ".gz") < os.path.getmtime(path):
        subprocess.run(["zopfli", "--i5", path], check=True)
    with open(path + ".gz", "rb") as file:
        return file.read()


# The compiled programs: the engine, and the reader of foreign files.
programs = ["betwixt", "betwixt-reader"]
packed = {name: compressed(os.path.join(folder, name + ".wasm")) for name in programs}
fonts = ["betwixt-formulas", "betwixt-code"]
packed.update({name: compressed(os.path.join(folder, name + ".otf")) for name in fonts})
# Inside a function, the exports for other module systems are of no use.
glue = {name: re.sub(r"if\s*\(typeof exports\s*===.*", "", read(folder, name + ".js"), flags=re.S) for name in programs}
base64_script = read(here, "base64.js")  # the engine needs it before the player
parts = "".join(read(here, name) for name in engine_scripts + player_scripts + editor_scripts if name != "base64.js")
head = f"// Betwixt {version}, <https://www.apache.org/licenses/LICENSE-2.0>: films from text. docs/web.md says what it does.\n"

inline = """const wasmBytes = async (name) => {
  if (!held[name]) throw new Error("this page lacks a font of formulas or code, because its films had none when it was made");
  const stream = new DecompressionStream("gzip"), writer = stream.writable.getWriter();
  writer.write(bytes_of(held[name])).then(() => writer.close()).catch(() => {});  // the reader gets its errors
  return new Response(stream.readable).arrayBuffer();  // not through a Blob, which would take a way through another process
};
"""
in_text = lambda name: f'held["{name}"]="{base64.b64encode(packed[name]).decode()}";\n'
# A page whose films do not need a part leaves out all from the first of these lines to the second
# (src/app/player_file.cpp).
part = lambda name, script: f"// begin of the {name}\n{script}// end of the {name}\n"
some_parts = (part("reader", minified(glue["betwixt-reader"]) + in_text("betwixt-reader")) +
              "".join(part(name, in_text(name)) for name in fonts))
plays = minified("(() => {\n" + parts + "})();\n")  # in a function, so that its names become short
write(os.path.join(folder, "betwixt-player.js"),
      head + "(() => {\nconst held={};\n" + minified(glue["betwixt"] + base64_script + inline) + in_text("betwixt") + some_parts + plays + "})();\n")

beside = """const addresses = {
  "betwixt": () => new URL("./betwixt.wasm", import.meta.url),
  "betwixt-reader": () => new URL("./betwixt-reader.wasm", import.meta.url),
  "betwixt-formulas": () => new URL("./betwixt-formulas.otf", import.meta.url),
  "betwixt-code": () => new URL("./betwixt-code.otf", import.meta.url),
};
const wasmBytes = async (name) => {
  const url = addresses[name]();
  if (url.protocol === "file:" && globalThis.process?.versions?.node) {  // Node fetches no files
    const fs = globalThis.process.getBuiltinModule?.("node:fs");
    if (!fs) throw new Error(`betwixt-player needs Node 20.16, 22.3 or later; this is ${globalThis.process.version}`);
    return new Uint8Array(fs.readFileSync(url)).buffer;
  }
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${answer.url} cannot be fetched: the server answered ${answer.status}`);
  return answer.arrayBuffer();
};
const makeReader = async (how) => (await import("./betwixt-reader.mjs")).makeReader(how);
"""
exports = """export const engine = Betwixt.engine;
export const BetwixtPlayer = Betwixt.Player, BetwixtEditor = Betwixt.Editor;
"""
package = os.path.join(folder, "package")
write(os.path.join(package, "betwixt-player.mjs"), head + minified(glue["betwixt"] + base64_script + beside + parts + exports, True))
write(os.path.join(package, "betwixt-reader.mjs"), head + minified(glue["betwixt-reader"] + "export { makeReader };\n", True))
for name, source in {"betwixt.wasm": folder, "betwixt-reader.wasm": folder, "betwixt-formulas.otf": folder, "betwixt-code.otf": folder, "betwixt-player.js": folder, "betwixt-player.d.ts": here, "README.md": here,
                     "LICENSE": os.path.join(here, "..")}.items():
    shutil.copyfile(os.path.join(source, name), os.path.join(package, name))
about = json.loads(read(here, "package.json"))
about["version"] = version
write(os.path.join(package, "package.json"), json.dumps(about, indent=2) + "\n")

size = lambda text: len(gzip.compress(text.encode(), 9))
sizes = {"engine": len(packed["betwixt"]), "its glue": size(minified(glue["betwixt"])), "player": size(plays)}
print("compressed:", ", ".join(f"{what} {n}" for what, n in sizes.items()), f"in all {sum(sizes.values())} bytes;",
      f"what reads files {len(packed['betwixt-reader']) + size(minified(glue['betwixt-reader']))};",
      "fonts:", ", ".join(f"{name} {len(packed[name])}" for name in fonts))
