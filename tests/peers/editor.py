# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the extension for Visual Studio Code: its types with TypeScript and the types of the editor, its grammar with
# the editor's grammar engine, and its features with a mock editor.
#   editor.py PROGRAM FOLDER     FOLDER has the npm packages
import json, os, shutil, subprocess, sys, tempfile

here, program, peers = os.path.dirname(os.path.abspath(__file__)), *map(os.path.abspath, sys.argv[1:])
extension = os.path.normpath(os.path.join(here, "../../clients/vscode"))
passed = failed = 0


def case(name, got, wanted):
    global passed, failed
    passed, failed = passed + (got == wanted), failed + (got != wanted)
    if got != wanted:
        print(f"FAILED {name}: {got!r} is not {wanted!r}")


def node(*words):
    done = subprocess.run(["node", *words], capture_output=True, text=True, timeout=120)
    return done.stdout, done.stderr


def pairs(text):
    return [tuple(line.split("\t")) for line in text.splitlines()]


package = json.load(open(f"{extension}/package.json"))
case("no other packages", [k for k in package if k.lower().endswith("dependencies")], [])
named = [package["main"], package["contributes"]["languages"][0]["configuration"],
         *(g["path"] for g in package["contributes"]["grammars"])]
case("all files are there", [n for n in named if not os.path.exists(f"{extension}/{n}")], [])
json.load(open(f"{extension}/language-configuration.json"))

with tempfile.TemporaryDirectory() as folder:
    for name in ("extension.js", "server.js"):
        shutil.copy(f"{extension}/{name}", folder)
    os.symlink(f"{peers}/node_modules", f"{folder}/node_modules")
    said = node(f"{peers}/node_modules/typescript/bin/tsc", "--noEmit", "--allowJs", "--checkJs", "--strict",
                "--noImplicitAny", "--target", "es2022", "--module", "commonjs", "--moduleResolution", "node10",
                "--ignoreDeprecations", "5.0", "--typeRoots", f"{peers}/node_modules/@types", "--types", "node,vscode",
                f"{folder}/extension.js")[0]
    case("types", said, "")

    script = f"{folder}/film.bx"
    open(script, "w").write(
        "# a ball\nrate 24\ncreate ball sphere radius=1 color=gold\n\nball.positon\n  12f  (4 1 0) linear\n"
        "  1f (0 1 0)\nat 3f note \"\U0001F600 the ball\"\n")
    out, errors = node(f"{here}/vscode_extension.cjs", f"{extension}/extension.js", program, script)
    case("errors", errors, "")
    case("an editor's day", pairs(out), [
        ("diagnostic", "4:5-4:12 0 'ball', a sphere, has no function 'positon' / did you mean 'position'?"),
        ("code action", "replace by 'position'"),
        ("mended", "true"),
        ("completion", "sphere 2:12-2:15"),
        ("hover", "ball, a sphere"),
        ("usage", "create NAME KIND"),
        ("definition", "2:7-2:11"),
        ("references", "2"),
        ("highlights", "2"),
        ("can be renamed", "ball"),
        ("cannot", "there is no name here that can be renamed"),
        ("renames", "orb,orb"),
        ("symbols", "ball,ball.position"),
        ("folds", "4-6"),
        ("colours", "2:34-2:38 0.843"),
        ("ways", "gold,#ffd700,rgb(1 0.843 0)"),
        ("formatting", json.dumps("  1f   (0 1 0)\n  12f  (4 1 0)  linear\n")),
        ("of a part", "true"),
        ("no program", "'/nowhere/betwixt lsp' tells nothing of scripts any more: spawn /nowhere/betwixt ENOENT"),
    ])

    colored = f"{folder}/colors.bx"
    open(colored, "w").write(
        "# a remark\ncreate ball-2 sphere radius=1.5cm color=gold  # so\nball-2.position\n"
        "  1f..24f  (4 -1 .5) ease-in-out ease-in=4f\nat 00:01.5 hide ball-2\nset ball-2.color #ffcc00\n"
        "make house\n  polygon (0 0) (1 0)\ncopy a.x 1f..2f to 3f\nset a.x = \"\"\"sin(t) -- \\\n  'b'\"\"\"\nat 3f note \"a \\\" b\"\n"
        "filter ball-2.position wobble frequency=2\nset goldie.look-at sphere#1\n")
    out, errors = node(f"{here}/vscode_grammar.mjs", peers, f"{extension}/syntaxes/betwixt.tmLanguage.json", colored)
    case("errors of the grammar", errors, "")
    scopes = pairs(out)
    for word, scope in [("# a remark", "comment.line.number-sign"), ("create", "keyword.control"), ("ball-2", "entity.name"),
                        ("sphere", "storage.type"), ("radius", "support.function"), ("1.5cm", "constant.numeric"),
                        ("gold", "support.constant.color"), ("# so", "comment.line.number-sign"),
                        ("position", "support.function"), ("1f", "constant.numeric.time"),
                        ("24f", "constant.numeric.time"), ("-1", "constant.numeric"), (".5", "constant.numeric"),
                        ("ease-in-out", "constant.language"), ("ease-in", "keyword.other"),
                        ("4f", "constant.numeric.time"), ("at", "keyword.control"), ("hide", "keyword.control"),
                        ("#ffcc00", "support.constant.color"), ("make", "keyword.control"), ("house", "entity.name"),
                        ("polygon", "keyword.control"), ("to", "keyword.other"), ("'b'", "string.quoted.triple"),
                        ("a \\\" b", None), ("filter", "keyword.control"), ("wobble", "constant.language"),
                        ("set", "keyword.control")]:
        if scope is not None:
            case(f"'{word}'", (word, scope) in scopes, True)
    case("no name is a colour", [s for w, s in scopes if w == "goldie"], [])
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
