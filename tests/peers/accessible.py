# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Checks the accessibility of pages with axe-core: names, roles, contrasts, focus.
#   accessible.py PROGRAM FOLDER     FOLDER has the npm packages
import os, subprocess, sys, tempfile

root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [f"{root}/tests/web", f"{root}/web"]
from browser import Browser, find_browser
from checks import check, done
from scripts import editor_scripts, player_scripts

program, peers = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
if not find_browser():
    print("left out: there is no browser (apt-get install chromium)\n0 passed, 0 failed")
    sys.exit()
with tempfile.TemporaryDirectory() as folder:
    # A mock engine is enough, because the engine has no visible elements.
    with open(f"{folder}/player.js", "w") as out:
        for name in ("../tests/web/mock_engine.js", *player_scripts, *editor_scripts):
            out.write(open(f"{root}/web/{name}").read())
    made = subprocess.run([f"{root}/tools/pages.sh", program, folder], capture_output=True, text=True,
                          env={**os.environ, "BETWIXT_PLAYER": f"{folder}/player.js"})
    if made.returncode != 0:
        sys.exit(made.stderr)
    axe = open(f"{peers}/node_modules/axe-core/axe.min.js").read()
    with Browser() as browser:
        for name in ("gallery", "tutorial"):
            for dark in (False, True):
                page = browser.page(f"file://{folder}/{name}.html", size=(1200, 800), dark=dark)
                page.until("document.querySelector('betwixt-player').readyState === 4")
                # An error, so that its message is checked too.
                page.do("document.querySelector('betwixt-editor').text += 'broken\\n'; await new Promise((r) => setTimeout(r, 300));")
                page.call("Runtime.evaluate", expression=axe)
                found = page.ask("axe.run(document).then((r) => ({ good: r.passes.length, bad: r.violations.map((v) =>"
                                 " `${v.id}: ${v.nodes[0].html.slice(0, 120)}: ${v.nodes[0].failureSummary}`) }))", patience=120)
                check(f"{name}, {'dark' if dark else 'light'}: {found['good']} rules", found["good"] > 30 and not found["bad"], "\n".join(found["bad"]))
                page.close()
done()
