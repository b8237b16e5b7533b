# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests pages of `betwixt web`: editing in them, and their messages. They have a mock engine (mock_engine.js).
# film_test.py tests the real engine.
#   page_test.py PROGRAM
import os, subprocess, sys, tempfile
from browser import Browser
from checks import check, done, same

program = os.path.abspath(sys.argv[1])
root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, f"{root}/web")
from scripts import editor_scripts, player_scripts

read = lambda path: open(os.path.join(root, path)).read()
text = "# ball.bx — a ball\nrate 24\nrange 1f 72f\nsize 320x180\ncreate ball sphere color=gold\n"
folder_of_test = tempfile.TemporaryDirectory()
folder = folder_of_test.name


def write(name, words):
    with open(f"{folder}/{name}", "w", encoding="utf-8", newline="") as out:
        out.write(words)
    return f"{folder}/{name}"


def web(*words):
    player = write("player.js", read("tests/web/mock_engine.js") + "".join(read(f"web/{p}") for p in player_scripts + editor_scripts))
    said = subprocess.run([program, "web", *words], capture_output=True, text=True, cwd=folder, env={**os.environ, "BETWIXT_PLAYER": player})
    if said.returncode != 0:
        sys.exit(said.stderr)


def opened(browser, name, **how):
    page = browser.page(f"file://{folder}/{name}", **how)
    page.do("window.e = document.querySelector('betwixt-editor'); window.p = document.querySelector('betwixt-player');"
            "window.t = e && e.shadowRoot.querySelector('textarea'); window.inside = (what) => e.shadowRoot.querySelector(what);"
            "window.calm = async () => { await new Promise((r) => setTimeout(r, 120)); for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame); };"
            "window.place = (m) => { const r = m.getBoundingClientRect(); return [r.left, r.top, r.width, r.height] };"
            "window.colour = () => { const c = p.shadowRoot.querySelector('canvas'), x = c.getContext('2d');"
            "  return [...x.getImageData(c.width / 10, c.height / 2, 1, 1).data].slice(0, 3).join(' ') };")
    page.until("p.readyState === 4")
    page.do("p.pause(); p.currentTime = 0; await calm();")
    return page


def typing(browser):
    page = opened(browser, "ball.html", size=(1200, 800))
    same("the text stands beside the picture", page.ask("t.value"), text)
    check("the picture", page.until("colour() === '255 215 0'"))
    page.do("t.focus(); t.setSelectionRange(t.value.length - 5, t.value.length - 1);")
    page.type("tomato")
    check("what is typed is seen", page.until("colour() === '255 99 71'"))
    same("at the same time", page.ask("p.currentTime"), 0)
    page.key("End", ctrl=True)
    page.type("  it is broken 🎈 broken\n")
    same("the last good picture stays", page.do("await calm(); return [colour(), p.error];"), ["255 99 71", None])
    same("what is wrong stands below", page.ask("inside('.said').innerText.split('\\n').filter((l) => l)"),
         ["line 6: this is broken", "  it is broken 🎈 broken", "        ^", "mend it"])
    same("its line is underlined", page.ask("inside('.bad').textContent"), "it is broken 🎈 broken")
    same("and spoken", page.ask("inside('.spoken').textContent"), "Line 6: this is broken")
    page.do("t.setSelectionRange(0, 0); inside('.said button').click()")
    same("a click goes there", page.ask("[t.selectionStart, e.shadowRoot.activeElement === t]"), [len(text) + len('tomato') - len('gold') + 8, True])
    same("columns count characters", page.do("e.go(6, 18); return t.value.slice(t.selectionStart, t.selectionStart + 6);"), "broken")
    for _ in range(3):
        page.key("z", ctrl=True)
    page.do("await calm()")
    check("undo is the browser's", page.ask("t.value.length") < len(text) + 25, page.ask("t.value"))
    page.do("inside('[data-do=revert]').click(); await calm()")
    same("as it was", page.ask("[t.value, colour(), inside('[data-do=revert]').disabled, inside('.said').children.length]"), [text, "255 215 0", True, 0])
    page.key("z", ctrl=True)
    check("and undo brings it back", page.ask("t.value") != text)
    page.close()


def keys(browser):
    page = opened(browser, "ball.html", size=(1200, 800))
    page.do("t.focus(); t.setSelectionRange(t.value.length, t.value.length)")
    page.key("Tab")
    page.type("1f\n13f")
    same("Tab indents, and the next line too", page.ask("t.value").split("\n")[-2:], ["  1f", "  13f"])
    page.key("Escape")
    page.key("Tab")
    same("Escape, then Tab leaves", page.ask("e.shadowRoot.activeElement === t"), False)
    page.do("t.focus()")
    page.key("Tab", shift=True)
    same("so does Tab with shift", page.ask("e.shadowRoot.activeElement === t"), False)
    page.do("t.focus(); t.value.length")
    page.key("Enter", ctrl=True)
    same("Ctrl-Enter plays", page.ask("p.paused"), False)
    page.key("Enter", ctrl=True)
    same("and stops", page.ask("p.paused"), True)
    page.do("window.saved = null; const make = URL.createObjectURL; URL.createObjectURL = (blob) => (window.saved = blob, make.call(URL, blob));"
            "HTMLAnchorElement.prototype.click = function () { window.named = this.download; };")
    page.do("t.focus()")
    page.key("s", ctrl=True)
    same("Ctrl-S saves", page.ask("saved.text()"), page.ask("t.value"))
    same("under its name", page.ask("named"), "ball.bx")
    browser.call("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
    page.do("inside('[data-do=copy]').click(); await calm();")
    same("copied", page.ask("navigator.clipboard.readText()"), page.ask("t.value"))
    page.close()


def looks(browser):
    page = opened(browser, "ball.html", size=(1200, 800))
    (px, py, pw, _), (tx, ty, _, _) = page.ask("[place(p), place(inside('.side'))]")
    check("wide: the text is beside the picture", tx >= px + pw and ty == py, (px, py, pw, tx, ty))
    page.show(size=(400, 800))
    (px, py, pw, ph), (tx, ty, tw, _) = page.do("await calm(); return [place(p), place(inside('.side'))]")
    check("narrow: it is below", ty >= py + ph and tx == px and pw == tw, (px, py, pw, ph, tx, ty, tw))
    same("nothing sticks out", page.ask("document.documentElement.scrollWidth <= innerWidth"), True)
    page.close()
    page = opened(browser, "ball.html", size=(390, 844), touch=True)
    page.do("t.focus(); e.text += 'it is broken'; await calm();")
    same("what a finger cannot hit", page.ask("[...e.shadowRoot.querySelectorAll('button')].map((b) => [b.textContent, b.getBoundingClientRect()])"
         ".filter(([, r]) => r.width && (r.width < 44 || r.height < 44)).map(([n]) => n)"), [])
    same("on a phone nothing sticks out", page.ask("document.documentElement.scrollWidth <= innerWidth"), True)
    page.close()
    page = opened(browser, "odd.html")
    same("a text with ends of scripts is as it was", page.ask("t.value"), odd)
    same("it is shown as text", page.ask("inside('.colours').querySelector('script, b')"), None)
    page.close()
    page = browser.page(f"file://{folder}/linked.html")
    page.until("document.querySelector('betwixt-player').readyState === 4")
    check("a page with what plays beside it", True)
    same("two films, two editors", page.ask("document.querySelectorAll('betwixt-editor').length"), 2)
    page.close()
    page = browser.page(f"file://{folder}/alone.html")
    page.until("document.querySelector('betwixt-player').readyState === 4")
    same("without the text box", page.ask("document.querySelector('betwixt-editor')"), None)
    same("as large as was said", page.ask("(() => { const r = document.querySelector('betwixt-player').getBoundingClientRect(); return [r.width, r.height] })()"), [400, 300])
    page.close()
    page = browser.page()
    page.call("Emulation.setScriptExecutionDisabled", value=True)
    page.go(f"file://{folder}/ball.html")
    tree = page.call("DOMSnapshot.captureSnapshot", computedStyles=["display"])
    check("without JavaScript the text can be read", any("create ball sphere color=gold" in s for s in (tree["strings"][i] for i in tree["documents"][0]["layout"]["text"] if i >= 0)))
    page.close()


# Injected scripts must not run: the policy has hashes of the page's own script and style.
def policy(browser):
    listens = "window.broken = []; addEventListener('securitypolicyviolation', (e) => broken.push(e.effectiveDirective));"
    hostile = ("<script>window.ran = 'a script'</script><img src='none.png' onerror=\"window.ran = 'a handler'\">"
               "<style>main { display: none }</style><base href='https://example.org/'>"
               "<script src='data:text/javascript,window.ran=1'></script><iframe src='ball.html'></iframe>")
    for name in ("ball.html", "linked.html", "alone.html"):
        with open(f"{folder}/{name}", encoding="utf-8") as made:
            page_text = made.read()
        write("hostile.html", page_text.replace("</main>", hostile + "</main>"))
        for file, forbidden in ((name, []), ("hostile.html", ["base-uri", "frame-src", "script-src-attr", "script-src-elem", "script-src-elem", "style-src-elem"])):
            page = browser.page()
            page.call("Page.addScriptToEvaluateOnNewDocument", source=listens)
            page.go(f"file://{folder}/{file}")
            page.until("document.querySelector('betwixt-player').readyState === 4")
            page.do("await new Promise((r) => setTimeout(r, 100))")
            same(f"{name} as {file}: what its policy forbade", page.ask("broken.sort()"), forbidden)
            same(f"{name} as {file}: what ran", page.ask("window.ran ?? 'nothing'"), "nothing")
            same(f"{name} as {file}: it is seen", page.ask("getComputedStyle(document.querySelector('main')).display"), "block")
            page.close()


odd = "# </script> <\\/script> <!-- <b>&amp; ümläut 🎈\n\n\ncreate ball sphere\n"
web(write("ball.bx", text), "-o", "ball.html")
web(write("odd.bx", odd), "-o", "odd.html")
web("ball.bx", "odd.bx", "-o", "linked.html", "--link")
web("ball.bx", "-o", "alone.html", "--no-edit", "--size", "400x300")
with Browser() as browser:
    for part in (typing, keys, looks, policy):
        try:
            part(browser)
        except Exception as e:
            check(part.__name__, False, e)
done()
