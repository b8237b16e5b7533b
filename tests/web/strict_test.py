# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests pages under the policy of docs/web.md: scripts and styles in the page have no effect, and no text becomes
# markup. Skipped if the player is not built (./betwixt web builds it).
#   strict_test.py PROGRAM
import os, re, shutil, subprocess, sys, tempfile, wave
from browser import Browser, Served
from checks import check, done, player, root, same, there_is_a_player

program = os.path.abspath(sys.argv[1])
there_is_a_player()
with open(f"{root}/docs/web.md", encoding="utf-8") as page:
    policy = " ".join(re.search(r"Content-Security-Policy: (.*?)```", page.read(), re.S)[1].split())
folder_of_test = tempfile.TemporaryDirectory()
folder = folder_of_test.name
film = "size 320x180\nfilm flat\ncreate ball circle radius=3 color=red\ncreate m mesh file=\"one.obj\" position=(9 0 0)\ncreate beep sound file=\"beep.wav\"\n"
helpers = """window.p = document.querySelector("betwixt-player"); window.e = document.querySelector("betwixt-editor");
  window.inside = (what) => p.shadowRoot.querySelector(what);
  window.pixel = () => { const c = inside("canvas"), d = document.createElement("canvas"); d.width = c.width, d.height = c.height;
    const k = d.getContext("2d"); k.drawImage(c, 0, 0); return [...k.getImageData(c.width / 2, c.height / 2, 1, 1).data].join(" "); };"""
listening = "window.given = 0; const start = AudioBufferSourceNode.prototype.start; AudioBufferSourceNode.prototype.start = function (...at) { ++given; start.apply(this, at); }; window.broken = []; addEventListener('securitypolicyviolation', (e) => broken.push(`${e.effectiveDirective} ${e.blockedURI} ${e.sourceFile}:${e.lineNumber}`));"


def write(name, words):
    with open(f"{folder}/{name}", "w", encoding="utf-8") as out:
        out.write(words)


def opened(browser, url, **how):
    page = browser.page(**how)
    page.call("Page.addScriptToEvaluateOnNewDocument", source=listening)
    page.go(url)
    page.do(helpers)
    return page


def fair(page, what):
    same(f"{what}: what was forbidden", page.ask("broken"), [])
    same(f"{what}: what the page complains of", page.said, [])


def made_pages(browser, served):
    page = opened(browser, f"{served}/film.html", size=(1200, 800))
    page.until("p.readyState === 4")
    check("it is drawn", page.until("pixel() === '255 0 0 255'"))
    same("the page has its look", page.ask("getComputedStyle(document.querySelector('main')).maxWidth"), "1408px")
    same("controls theirs", page.ask("[getComputedStyle(inside('.controls')).position, !!inside('[data-do=toggle] svg path')]"), ["absolute", True])
    colour = lambda what: page.ask(f"getComputedStyle(e.shadowRoot.querySelector('{what}')).color")
    check("words are coloured", len({colour(".v"), colour(".k"), colour(".n"), colour(".colours")}) == 4)
    page.do("const t = e.shadowRoot.querySelector('textarea'); t.focus(); t.setSelectionRange(t.value.length, t.value.length);")
    page.type("set ball.color #00ff00\n")
    check("what is typed is seen", page.until("pixel() === '0 255 0 255'"))
    check("a colour is underlined with itself", "rgb(0, 255, 0)" in page.ask("getComputedStyle(e.shadowRoot.querySelector('.h')).textDecoration"))
    page.type("wrong\n")
    check("what is wrong is underlined", page.until("e.shadowRoot.querySelector('.bad')?.textContent === 'wrong'"))
    page.do("await p.play(); p.pause(); p.playbackRate = 2; p.load();")
    page.until("p.readyState === 4")
    fair(page, "a page that betwixt web has made")
    page.close()
    page = opened(browser, f"{served}/alone.html", size=(1200, 800))
    page.until("p.readyState === 4")
    same("as wide as was said", page.ask("p.getBoundingClientRect().width"), 400)
    page.close()


def own_pages(browser, served):
    for name in ("classic", "module"):
        page = opened(browser, f"{served}/{name}.html", size=(1200, 800))
        page.until("p.readyState === 4")
        check(f"{name}: it is drawn", page.until("pixel() === '255 0 0 255'"))
        same(f"{name}: it has its size", page.ask("[p.offsetWidth, p.offsetHeight]"), [320, 180])
        page.do("await p.play()")
        check(f"{name}: it sounds", page.until("given > 0 && p.film.sound(4000, 100).left.some((x) => Math.abs(x) > 0.1)"))
        page.do("p.src = 'none.bx'; await new Promise((r) => p.addEventListener('error', r, { once: true }));")
        check(f"{name}: what goes wrong is said", "none.bx cannot be fetched" in page.ask("inside('[part=message]').innerText"))
        page.said[:] = [s for s in page.said if "404" not in s]
        fair(page, name)
        page.close()


# Each directive of the policy is needed: without it the page does not play.
def each_word_is_needed(browser):
    for word in ("'wasm-unsafe-eval'",):
        with Served(folder, Content_Security_Policy=policy.replace(word, "")) as served:
            page = opened(browser, f"{served}/classic.html")
            check(f"without {word} there is a message", page.until("p.error !== null"))
            page.close()


write("favicon.ico", "")  # browsers request it
write("film.bx", film)
write("one.obj", "v -1 0 0\nv 1 0 0\nv 0 1.5 0\nf 1 2 3\n")
with wave.open(f"{folder}/beep.wav", "wb") as beep:
    beep.setparams((1, 2, 48000, 0, "NONE", ""))
    beep.writeframes(b"".join((i % 100 * 200).to_bytes(2, "little") for i in range(48000)))
for call in (("-o", "film.html", "--link"), ("-o", "alone.html", "--link", "--no-edit", "--size", "400x225")):
    made = subprocess.run([program, "web", "film.bx", *call], capture_output=True, text=True, cwd=folder, env={**os.environ, "BETWIXT_PLAYER": player})
    if made.returncode != 0:
        sys.exit(made.stderr)
there = f"{os.path.dirname(player)}/package"
shutil.copytree(there, f"{folder}/package")
head = '<!DOCTYPE html><meta charset="utf-8">'
write("classic.html", head + '<script src="betwixt-player.js"></script><betwixt-player controls width="320" src="film.bx"></betwixt-player>')
write("module.html", head + '<script type="module" src="package/betwixt-player.mjs"></script><betwixt-player controls width="320" src="film.bx"></betwixt-player>')
with Browser("--autoplay-policy=no-user-gesture-required") as browser, Served(folder, Content_Security_Policy=policy) as served:
    for part in (lambda b: made_pages(b, served), lambda b: own_pages(b, served), each_word_is_needed):
        try:
            part(browser)
        except Exception as e:
            check(getattr(part, "__name__", "?"), False, e)
done()
