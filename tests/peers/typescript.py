# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The types that the player's package says it has, asked of TypeScript.
#   typescript.py PROGRAM FOLDER     of packages
import os, re, shutil, subprocess, sys, tempfile

here, peers = os.path.dirname(os.path.abspath(__file__)), sys.argv[2]
web = os.path.join(here, "../../web")
passed = failed = 0
with tempfile.TemporaryDirectory() as folder:
    package = f"{folder}/node_modules/betwixt-player"
    os.makedirs(package)
    for name in ("package.json", "betwixt-player.d.ts"):
        shutil.copy(f"{web}/{name}", package)
    source = open(f"{here}/player_use.ts").read().split("\n")
    wrong = {i + 2 for i, line in enumerate(source) if line == "// wrong:"}  # lines that must be refused
    open(f"{folder}/use.ts", "w").write("\n".join(source))
    open(f"{folder}/package.json", "w").write('{"type": "module"}')
    for resolution, module in (("bundler", "esnext"), ("nodenext", "nodenext")):
        said = subprocess.run(["node", f"{peers}/node_modules/typescript/bin/tsc", "--noEmit", "--strict", "--target", "es2022",
                               "--lib", "es2022,dom,dom.iterable", "--module", module, "--moduleResolution", resolution, "use.ts"],
                              cwd=folder, capture_output=True, text=True).stdout
        refused = {int(n) for n in re.findall(r"^use\.ts\((\d+),", said, re.M)}
        good = refused == wrong and said.count("error") == len(wrong)
        passed, failed = passed + good, failed + (not good)
        if not good:
            print(f"FAILED types with {resolution}: refused {sorted(refused)}, not {sorted(wrong)}\n{said}")
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
