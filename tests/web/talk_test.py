# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the page that shows a film as a talk (betwixt web --present), with the mock engine.
#   talk_test.py PROGRAM
import os, subprocess, sys, tempfile, time
from browser import Browser
from checks import check, done, same

program = os.path.abspath(sys.argv[1])
root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, f"{root}/web")
from scripts import editor_scripts, player_scripts

read = lambda path: open(os.path.join(root, path)).read()
folder_of_test = tempfile.TemporaryDirectory()
folder = folder_of_test.name
with open(f"{folder}/talk.bx", "w") as out:
    out.write("rate 24\nrange 1f 72f\nsize 320x180\ncreate ball sphere color=gold\n"
              "section one for 1s\n  step \"begin\" note=\"say </script> hello\"\nsection two\n  step \"middle\"\n"
              "  at 25f step \"late\"\n")
with open(f"{folder}/player.js", "w") as out:
    out.write(read("tests/web/mock_engine.js") + "".join(read(f"web/{p}") for p in player_scripts + editor_scripts))
said = subprocess.run([program, "web", "talk.bx", "--present", "-o", "talk.html"], capture_output=True, text=True, cwd=folder,
                      env={**os.environ, "BETWIXT_PLAYER": f"{folder}/player.js"})
same("a page is made", said.returncode, 0)

with Browser() as browser:
    page = browser.page(f"file://{folder}/talk.html", size=(640, 360))
    page.do("window.p = document.querySelector('#talk > betwixt-player:not(.preview)')")
    page.until("p.readyState === 4 && document.getElementById('where').textContent !== ''")
    where = lambda: page.ask("document.getElementById('where').textContent")
    now = lambda: round(page.ask("p.currentTime") * 24, 3)
    same("it waits at the beginning", (where(), now(), page.ask("p.paused")), ("1 / 4", 0, True))
    # The time from a key to the picture, in the page.
    page.do("""window.drawn = [];
      const old = Betwixt.Film.prototype.draw;
      Betwixt.Film.prototype.draw = function (...all) { drawn.push([performance.now(), all[1]]); return old.apply(this, all); };
      addEventListener('keydown', (e) => (window.pressed = performance.now()), true);""")
    page.key("ArrowRight")
    time.sleep(0.3)
    check("it plays", 1 <= now() <= 24, now())
    page.until("drawn.some(([at, s]) => at > pressed && s > 0)")
    delay = page.ask("drawn.find(([at, s]) => at > pressed && s > 0)[0] - pressed")
    check("a picture comes within a frame, or a few on a loaded machine", delay <= 1000, delay)
    page.until("p.paused")
    same("it waits at the step", (where(), now()), ("2 / 4", 24))
    latest = page.ask("Math.max(...drawn.map((d) => d[1]))")
    check("no picture behind it was shown", latest <= 1 + 1e-6, latest)
    page.key("ArrowRight"), page.key("ArrowRight")
    same("a second key ends the step at once", (where(), now(), page.ask("p.paused")), ("3 / 4", 48, True))
    time.sleep(0.3)
    page.do("drawn.length = 0")
    page.key("ArrowLeft")
    page.until("drawn.length > 0")
    same("back at once", (where(), now()), ("2 / 4", 24))
    delay = page.ask("drawn[0][0] - pressed")
    check("and soon", delay <= 1000, delay)
    page.key("End")
    same("the end", (where(), now()), ("4 / 4", 71))
    page.key("Home")
    same("the beginning", (where(), now()), ("1 / 4", 0))
    page.key("b")
    check("blank", not page.ask("document.getElementById('blank').hidden"))
    page.key("b")
    check("not blank", page.ask("document.getElementById('blank').hidden"))
    page.mouse("mousePressed", 500, 100), page.mouse("mouseReleased", 500, 100)
    page.until("!p.paused")
    page.mouse("mousePressed", 20, 100), page.mouse("mouseReleased", 20, 100)
    page.until("p.paused")
    same("a click at the left goes back", now(), 0)
    page.do("""window.opened = null; const old_open = window.open;
      window.open = (...all) => (window.opened = old_open.apply(window, all));""")
    page.ask("window.dispatchEvent(new KeyboardEvent('keydown', { key: 'n' }))")
    if page.until("opened !== undefined") and page.ask("opened !== null"):
        page.until("!!opened.document.getElementById('note')")
        same("the notes", page.ask("[opened.document.getElementById('note').textContent, opened.document.getElementById('coming').textContent]"),
             ["say </script> hello", "next: middle"])
    same("nothing threw", [s for s in page.said if s.startswith("threw")], [])
done()
