# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Checks the types of the player's package with TypeScript: in scripts, and in the markup of React, Preact and Solid. A
# project without a framework must not need its types.
#   typescript.py PROGRAM FOLDER     FOLDER has the npm packages
import os, re, shutil, subprocess, sys, tempfile

here, peers = os.path.dirname(os.path.abspath(__file__)), sys.argv[2]
web = os.path.join(here, "../../web")
passed = failed = 0
bundler, node = ("--moduleResolution", "bundler", "--module", "esnext"), ("--moduleResolution", "nodenext", "--module", "nodenext")
react, classic = ("--jsx", "react-jsx"), ("--jsx", "react")
cases = [  # the source, compiler options, and the installed packages by name
    ("player_use.ts", bundler, {}),
    ("player_use.ts", node, {}),
    ("player_use.tsx", bundler + react, {"@types/react": "react18types"}),
    ("player_use.tsx", bundler + react, {"@types/react": "react19types"}),
    ("player_use.tsx", node + react, {"@types/react": "react19types"}),
    ("player_use.tsx", bundler + classic, {"@types/react": "react18types"}),
    ("player_use.tsx", bundler + classic, {"@types/react": "react19types"}),
    ("player_use.tsx", bundler + react + ("--jsxImportSource", "preact"), {"preact": "preact10types"}),
    ("player_use.tsx", bundler + react + ("--jsxImportSource", "preact"), {"preact": "preact"}),
    ("player_use.tsx", bundler + ("--jsx", "preserve", "--jsxImportSource", "solid-js"), {"solid-js": "solid-js"}),
]


def errors_of(source, how, packages):
    with tempfile.TemporaryDirectory() as folder:
        package = f"{folder}/node_modules/betwixt-player"
        os.makedirs(package)
        for name in ("package.json", "betwixt-player.d.ts"):
            shutil.copy(f"{web}/{name}", package)
        for name, held in packages.items():
            os.makedirs(os.path.dirname(f"{folder}/node_modules/{name}"), exist_ok=True)
            os.symlink(f"{peers}/node_modules/{held}", f"{folder}/node_modules/{name}")
        text = open(f"{here}/{source}").read()
        if "react" in how and "--jsxImportSource" not in how and "react-jsx" not in how:
            text = text.replace('import "betwixt-player";', 'import "betwixt-player"; import * as React from "react";')
        open(f"{folder}/{source}", "w").write(text)
        open(f"{folder}/package.json", "w").write('{"type": "module"}')
        said = subprocess.run(["node", f"{peers}/node_modules/typescript/bin/tsc", "--noEmit", "--strict", "--target", "es2022",
                               "--lib", "es2022,dom,dom.iterable", *how, source], cwd=folder, capture_output=True, text=True).stdout
    wanted = {i + 2 for i, line in enumerate(text.split("\n")) if line == "// wrong:"}  # lines that must be refused
    refused = {int(n) for n in re.findall(rf"^{re.escape(source)}\((\d+),", said, re.M)}
    elsewhere = [line for line in said.split("\n") if re.match(r"\S", line) and not line.startswith(f"{source}(")]
    return (refused, wanted, said) if refused != wanted or elsewhere else None


for case in cases:
    wrong = errors_of(*case)
    passed, failed = passed + (not wrong), failed + bool(wrong)
    if wrong:
        print(f"FAILED types {case}: refused {sorted(wrong[0])}, not {sorted(wrong[1])}\n{wrong[2]}")
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
