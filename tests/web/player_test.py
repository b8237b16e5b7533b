# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares <betwixt-player> with a <video> of the same length: the same calls must give the same results and events.
# Then tests what a video does not have. A mock engine (mock_engine.js) counts the calls of the player.
import os, subprocess, sys, tempfile, time
from browser import Browser, Served
from checks import check, done, same

root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, f"{root}/web")
from scripts import player_scripts

read = lambda path: open(os.path.join(root, path)).read()
scripts = f"<script>{read('tests/web/mock_engine.js')}</script><script>{''.join(read(f'web/{p}') for p in player_scripts)}</script>"
film = "# a ball goes its way\nrate 24\nrange 1f 72f\nsize 320x180\n"
inline = lambda text=film: f'<script type="text/betwixt">\n{text}</script>'
head = f"<!DOCTYPE html><meta charset=utf-8><style>body{{margin:0}}</style>"

# ---- The calls for both. `m` is the player or the video; `log` has its events.
helpers = """
const names = ["loadstart","durationchange","loadedmetadata","loadeddata","canplay","canplaythrough","play","playing",
  "pause","timeupdate","seeking","seeked","ratechange","ended","error","emptied"];
function listen(m) { m.log = []; for (const n of names) m.addEventListener(n, () => m.log.push(n)); }
function taken(m) { return m.log.splice(0); }
const until = (m, name) => new Promise((r) => m.addEventListener(name, r, { once: true }));
const calm = async () => { await new Promise((r) => setTimeout(r, 120)); for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame); };
// Events that do not depend on the speed of the machine: without repetitions and without a video's network events.
const plain = (all, ...without) => all.filter((n) => !without.includes(n)).filter((n, i, a) => n !== a[i - 1]);
const word = (error) => error.name;
"""
scenarios = {
    "loading": """
      m.src = m === video ? three : "three.bx"; await until(m, "canplaythrough"); await calm();
      return [plain(taken(m)), m.readyState, m.networkState, m.paused, m.ended, m.seeking, m.currentTime, m.error,
              Math.abs(m.duration - 3) < 0.05, m.videoWidth, m.videoHeight];""",
    "play and pause": """
      const promise = m.play(); const at_once = m.paused;
      const answer = await promise; await until(m, "timeupdate");
      const going = m.currentTime > 0; m.pause(); const paused = m.paused; await calm();
      const t = m.currentTime; await calm();
      return [at_once, answer === undefined, going, paused, t === m.currentTime, plain(taken(m), "canplay", "canplaythrough")];""",
    "seek at rest": """
      taken(m); m.currentTime = 1; const [now, seeking] = [m.currentTime, m.seeking];
      await until(m, "seeked"); await calm();
      return [now, seeking, m.seeking, m.currentTime, m.paused, plain(taken(m), "canplay", "canplaythrough")];""",
    "seek while it plays": """
      await m.play(); await calm(); taken(m); m.currentTime = 2; await until(m, "seeked");
      const there = m.currentTime >= 2, going = !m.paused;
      m.pause(); await calm();
      return [there, going, plain(taken(m), "canplay", "canplaythrough", "playing", "timeupdate")];""",
    "many seeks are one": """
      taken(m); for (const t of [0.5, 1, 1.5, 2.5]) m.currentTime = t; await until(m, "seeked"); await calm();
      return [m.currentTime, m.log.filter((n) => n === "seeked").length, taken(m).filter((n) => n === "seeking").length > 0];""",
    "beyond its ends": """
      m.currentTime = -5; await until(m, "seeked"); const first = m.currentTime;
      m.currentTime = 99; await until(m, "seeked"); const last = m.currentTime === m.duration;
      let thrown = ""; try { m.currentTime = NaN; } catch (e) { thrown = e.name; }
      return [first, last, thrown];""",
    "the end": """
      m.currentTime = m.duration - 0.2; await until(m, "seeked"); await calm(); taken(m);
      await m.play(); await until(m, "ended"); await calm();
      return [m.ended, m.paused, m.currentTime === m.duration, plain(taken(m), "canplay", "canplaythrough")];""",
    "seek to the end while it plays": """
      m.currentTime = 0; await until(m, "seeked"); await m.play(); await calm(); taken(m);
      m.currentTime = m.duration; await until(m, "ended"); await calm();
      return [m.ended, m.paused, m.currentTime === m.duration, plain(taken(m), "canplay", "canplaythrough", "playing", "timeupdate")];""",
    "play again": """
      taken(m); await m.play(); await calm(); const far = m.currentTime; m.pause(); await calm();
      return [far > 0 && far < m.duration, m.ended, plain(taken(m), "canplay", "canplaythrough", "timeupdate", "playing")];""",
    "loop": """
      m.loop = true; m.currentTime = m.duration - 0.2; await until(m, "seeked"); await calm(); taken(m);
      await m.play(); await until(m, "seeked"); const near = m.currentTime < 2.5, going = !m.paused, ended = m.ended;
      m.pause(); m.loop = false; await calm();
      return [near, going, ended, plain(taken(m), "canplay", "canplaythrough", "timeupdate", "playing"), m.hasAttribute("loop")];""",
    "rates": """
      taken(m); m.playbackRate = 2; await calm(); const said = taken(m); m.playbackRate = 2; await calm();
      const again = taken(m); m.playbackRate = 0; m.currentTime = 1; await until(m, "seeked"); await m.play(); await calm();
      const stands = m.currentTime === 1 && !m.paused; m.pause(); m.playbackRate = 1;
      let thrown = ""; try { m.playbackRate = Infinity; } catch (e) { thrown = e.name; }
      return [said, again, stands, thrown];""",
    "play, and pause at once": """
      m.currentTime = 0; await until(m, "seeked"); m.load(); const promise = m.play(); m.pause();
      return [await promise.catch(word), m.paused];""",
    "load": """
      while (m.readyState < 4) await calm(); await calm(); taken(m); m.load(); const state = [m.readyState, m.paused];
      await until(m, "canplaythrough"); await calm();
      return [state, plain(taken(m))];""",
    "what is not there": """
      taken(m); m.src = "not-there.bx"; await until(m, "error"); await calm();
      const played = await m.play().catch(word);
      return [m.error.code, m.networkState, m.readyState, played, m.paused, plain(taken(m), "emptied")];""",
}


def beside_a_video(browser, served):
    page = browser.page(f"{served}/both.html")
    page.do(f"{helpers}; Object.assign(window, {{listen, taken, until, calm, plain, word}});")
    page.do("listen(video); listen(player);")
    # This server gives files as wholes only, and a video seeks in parts.
    page.do("window.three = URL.createObjectURL(await (await fetch('three.webm')).blob());")
    for name, what in scenarios.items():
        run = lambda m: page.do(f"const m = {m}; {what}", patience=20)
        try:
            wanted, found = run("video"), run("player")
            same(f"as a video: {name}", found, wanted)
        except Exception as e:
            check(f"as a video: {name}", False, e)
    page.do("Object.assign(window, { video, player }); for (const m of [video, player]) { m.src = m === video ? three : 'three.bx'; }")
    for m in ("video", "player"):
        page.until(f"{m}.readyState >= 3")
        page.do(f"await {m}.play(); {m}.remove(); await calm();")
    same("taken out, both are paused", page.ask("[player.paused, video.paused]"), [True, True])
    page.close()


# Features that a video does not have.
def time_of_films(browser, served):
    page = browser.page(f"{served}/one.html")
    page.do(f"{helpers}; Object.assign(window, {{listen, taken, until, calm, plain, word}}); listen(p);")
    page.until("p.readyState === 4")
    same("backwards", page.do("""p.currentTime = 2; await until(p, "seeked"); p.playbackRate = -1; await p.play(); await calm();
        return [p.currentTime < 2, p.currentTime > 0, p.paused];"""), [True, True, False])
    same("backwards at the beginning", page.do("""p.currentTime = 0.1; await until(p, "seeked"); taken(p); await calm();
        await calm(); return [p.currentTime, p.paused, p.ended, plain(taken(p))];"""), [0, False, False, ["timeupdate"]])
    same("and round again", page.do("""p.loop = true; p.currentTime = 0.05; await until(p, "seeked");
        await until(p, "seeked"); const t = p.currentTime; p.loop = false; p.pause(); p.playbackRate = 1; return t > 1;"""), True)
    same("values at a time", page.ask("[p.eval('ball.position', 1), (p.currentTime = 2, p.eval('ball.position'))]"), [[1, 0, 0], [2, 0, 0]])
    same("unknown values", page.ask("(() => { try { return p.eval('nobody.color') } catch (e) { return e.message } })()"), "there is no object 'nobody.color'")
    # The time of a film in a page begins at 0, also if its range begins later.
    page.do("p.script = 'rate 12\\nrange 25f 48f\\nat 37f note \"the middle\"\\n'; p.currentTime = 0.75; await until(p, 'seeked');")
    same("from its own beginning", page.ask("[p.duration, p.eval('ball.position', 0), p.eval('ball.position')]"), [2, [2, 0, 0], [2.75, 0, 0]])
    same("notes", page.do("""const all = []; p.addEventListener("note", (e) => all.push([e.detail.text, e.detail.time]));
        p.playbackRate = 4; await p.play(); await until(p, "ended"); p.playbackRate = 1; return all;"""), [["the middle", 1]])
    check("the last frame is held", abs(page.ask("Betwixt.last_drawn") - 47 / 12) < 1e-12)
    page.close()


def texts_and_files(browser, served):
    page = browser.page(f"{served}/one.html")
    page.do(f"{helpers}; Object.assign(window, {{listen, taken, until, calm, plain, word}}); listen(p);")
    page.until("p.readyState === 4")
    same("text from the page", page.ask("p.script"), film)
    same("another text, at the same time", page.do("""p.currentTime = 1.5; await until(p, "seeked"); const before = p.film;
        p.script = p.script + "color=tomato\\n"; return [p.film !== before, before.gone, p.currentTime, p.film.color];"""),
         [True, True, 1.5, "tomato"])
    same("a wrong text leaves the last good film", page.do("""const good = p.film; let told;
        p.addEventListener("diagnostics", (e) => (told = e.detail.diagnostics), { once: true });
        p.script = "create ball\\n  it is broken\\n"; await calm(); const d = told[0];
        const banner = p.shadowRoot.querySelector("[part=banner]");
        return [p.film === good, p.error, d.line, d.column, d.text, banner.hidden, banner.textContent];"""),
         [True, None, 2, 9, "this is broken", False, "line 2: this is broken"])
    same("mended, the next is taken", page.do("""p.script = "rate 12\\n"; await calm();
        return [p.film.fps, p.diagnostics, p.shadowRoot.querySelector("[part=banner]").hidden];"""), [12, [], True])
    # Files that the film needs are fetched once each, and only from its folder and below.
    same("files are fetched", page.do("""p.src = "films/wants.bx"; await until(p, "loadeddata");
        return [Object.keys(p.film.used).sort(), new TextDecoder().decode(p.film.used["parts/a.txt"])];"""),
         [["parts/a.txt"], "the letter a"])
    page.do("p.script = 'use ../one.html\\nuse parts/none.txt\\n'; await calm(); await calm();")
    check("files elsewhere are not", "there is no file '../one.html'" in page.ask("p.message"), page.ask("p.message"))
    check("and what was not found is said", "parts/none.txt cannot be fetched: the server answered 404" in page.ask("p.message"), page.ask("p.message"))
    same("files of the page's own", page.do("""p.files = { "parts/none.txt": "words" }; p.script = "use parts/none.txt\\n"; await calm();
        return new TextDecoder().decode(p.film.used["parts/none.txt"]);"""), "words")
    same("files that stand in the page", page.do("""
        document.body.insertAdjacentHTML("beforeend", `<script type="application/json" data-betwixt-files>{"a b.txt": "aGVsbG8="}</scr` + `ipt>`);
        const q = document.createElement("betwixt-player");
        q.innerHTML = `<script type="text/betwixt" data-name="x.bx">\\nuse a b.txt\\n</scr` + `ipt>`; q.loading = "eager"; document.body.append(q);
        await until(q, "error"); q.script = "# fine <\\\\/script> <\\/script>\\n"; await calm(); return [q.error, q.script];"""),
         [None, "# fine <\\/script> </script>\n"])
    page.close()


def hands(browser, served):
    page = browser.page(f"{served}/one.html", size=(640, 400))
    page.until("p.readyState === 4")
    page.do(f"{helpers}; Object.assign(window, {{until, calm}});")
    inside = lambda what: page.ask(f"p.shadowRoot.querySelector('{what}')" + "?.getAttribute('aria-label')")
    same("buttons have names", [inside("[part~=play]"), inside("[part~=fullscreen]"), inside("input"), inside("select")], ["Play", "Full screen", "Time", "Speed"])
    same("the picture has words", [inside("canvas"), page.ask("p.shadowRoot.querySelector('.stage').getAttribute('role')")], ["a ball goes its way", "group"])
    spoken = lambda: page.do("await calm(); return p.shadowRoot.querySelector('input').getAttribute('aria-valuetext')")
    page.ask("p.shadowRoot.querySelector('input').focus()")
    frames = lambda: page.do("await calm(); return Math.round(p.currentTime * 24) + 1")
    page.ask("(p.currentTime = 23 / 24)")
    same("what is spoken", spoken(), "frame 24 of 72, 1.0 seconds")
    for key, shift, wanted in (("ArrowRight", 0, 25), ("ArrowLeft", 0, 24), (".", 0, 25), (",", 0, 24), ("ArrowRight", 1, 48),
                               ("ArrowLeft", 1, 24), ("ArrowUp", 0, 48), ("ArrowDown", 0, 24), ("Home", 0, 1), ("End", 0, 73)):
        page.key(key, shift=bool(shift))
        same(f"the key {key}{' with shift' if shift else ''}", frames(), wanted)
    same("the last frame is spoken", spoken(), "frame 72 of 72, 3.0 seconds")
    page.key("k")
    same("k plays", page.ask("p.paused"), False)
    page.key(" ")
    same("the space bar stops", page.ask("p.paused"), True)
    page.key("j")
    same("j goes back", page.ask("[p.paused, p.playbackRate]"), [False, -1])
    page.key("j")
    page.key("j")
    same("and faster", page.ask("p.playbackRate"), -4)
    page.key("l")
    same("l goes on", page.ask("[p.paused, p.playbackRate]"), [False, 1])
    page.key("+")
    same("+ is faster", page.ask("p.playbackRate"), 1.5)
    page.key("-"), page.key("-")
    same("- is slower", page.ask("p.playbackRate"), 0.5)
    page.do("p.pause(); p.playbackRate = 1; p.shadowRoot.querySelector('[part~=play]').focus()")
    page.key(" ")
    same("a button keeps its space bar", page.ask("p.paused"), False)
    same("and says what it does next", inside("[part~=play]"), "Pause")
    page.do("p.pause(); await calm()")
    page.click(320, 100)
    same("a click on the picture plays", page.ask("p.paused"), False)
    page.do("p.pause(); p.currentTime = 0; await calm()")
    x, y, w, h = page.ask("(() => { const r = p.shadowRoot.querySelector('input').getBoundingClientRect(); return [r.x, r.y, r.width, r.height] })()")
    page.click(x + w / 2, y + h / 2)
    same("the slider seeks", page.do("await calm(); return Math.abs(p.currentTime - 1.5) < 0.05"), True)
    # While the slider is dragged the film stays at its time, without a `pause` event.
    page.do("window.heard = []; for (const n of ['play', 'pause']) p.addEventListener(n, () => heard.push(n)); p.currentTime = 0; await p.play(); await calm(); heard.length = 0;")
    page.mouse("mousePressed", x + w / 4, y + h / 2)
    held = page.do("await calm(); const t = p.currentTime; await calm(); await calm(); return [t, p.currentTime, p.paused]")
    check("dragged, it stands", held[0] == held[1] and abs(held[0] - 0.75) < 0.1 and not held[2], held)
    page.mouse("mouseMoved", x + w / 2, y + h / 2)
    moved = page.do("await calm(); const t = p.currentTime; await calm(); return [t, p.currentTime]")
    check("where the thumb is", moved[0] == moved[1] and abs(moved[0] - 1.5) < 0.1, moved)
    page.mouse("mouseReleased", x + w / 2, y + h / 2)
    check("let go, it goes on", 1.5 < page.do("await calm(); await calm(); return p.currentTime") + 0.1 < 3)
    same("and has played all the time", page.ask("[heard.filter((n) => n === 'pause').length, p.paused]"), [0, False])
    page.do("p.pause(); await calm();")
    page.mouse("mousePressed", x + w / 4, y + h / 2), page.mouse("mouseReleased", x + w / 4, y + h / 2)
    same("one that is paused stays so", page.do("await calm(); const t = p.currentTime; await calm(); return [p.paused, t === p.currentTime]"), [True, True])
    page.do("p.currentTime = 0; await p.play(); await calm();")
    page.mouse("mousePressed", x + w / 2, y + h / 2), page.mouse("mouseMoved", x + w + 40, y + h / 2)
    same("dragged to the end, it waits there", page.do("await calm(); return [p.currentTime === p.duration, p.paused]"), [True, False])
    page.mouse("mouseReleased", x + w + 40, y + h / 2)
    same("and ends", page.do("await calm(); return [p.ended, p.paused]"), [True, True])
    page.do("p.controls = false; p.currentTime = 0; await calm(); p.shadowRoot.querySelector('.stage').focus()")
    page.key("ArrowRight")
    page.click(320, 100)
    same("without controls nothing does", page.ask("[p.currentTime, p.paused]"), [0, True])
    page.close()


# Touch targets are 44 pixels wide and high, and nothing overflows, also on the narrowest phone.
def fingers(browser, served):
    for width, height in ((320, 568), (390, 844), (844, 390)):
        page = browser.page(f"{served}/touched.html", size=(width, height), ratio=2, touch=True)
        page.until("p.readyState === 4")
        page.do(f"{helpers}; Object.assign(window, {{until, calm}}); await calm();")
        small = page.ask("[...p.shadowRoot.querySelectorAll('.controls > :is(button, input, select)')].map((b) => [b.localName, b.getBoundingClientRect()])"
                         ".filter(([, r]) => r.width && (r.width < 44 || r.height < 44)).map(([n, r]) => [n, r.width, r.height])")
        same(f"{width} wide: what is too small", small, [])
        check(f"{width} wide: there are buttons", page.ask("[...p.shadowRoot.querySelectorAll('.controls button')].filter((b) => b.getBoundingClientRect().width).length") >= 1)
        same(f"{width} wide: nothing sticks out", page.ask("(() => { const c = p.shadowRoot.querySelector('.controls'); return [c.scrollWidth <= c.clientWidth, document.documentElement.scrollWidth <= innerWidth] })()"), [True, True])
        page.close()
    page = browser.page(f"{served}/touched.html", size=(640, 400))
    page.until("p.readyState === 4")
    check("a mouse needs less", page.ask("p.shadowRoot.querySelector('[data-do=toggle]').offsetHeight") < 40)
    page.close()


def pictures(browser, served):
    page = browser.page(f"{served}/one.html", size=(640, 400))
    page.until("p.readyState === 4")
    page.do(f"{helpers}; Object.assign(window, {{until, calm}});")
    size = lambda: page.do("await calm(); const c = p.shadowRoot.querySelector('canvas'); return [c.width, c.height]")
    same("as wide as the page", size(), [640, 360])
    page.do("p.style.width = '400px'")
    same("made smaller", size(), [400, 225])
    page.do("p.style.height = '400px'")
    same("it keeps its shape", size(), [400, 225])
    page.do("p.style.height = ''; p.width = 320")
    page.do("p.style.width = ''")
    same("as wide as the page says", size(), [320, 180])
    page.show(size=(640, 400), ratio=2)
    same("on a screen of small pixels", size(), [640, 360])
    page.show(size=(640, 400))
    page.do("await calm()")
    page.do("Betwixt.counts.drawn = 0; await calm(); await calm();")
    same("what stands still is not drawn", page.ask("Betwixt.counts.drawn"), 0)
    page.do("p.style.marginTop = '3000px'; await calm(); p.loop = true; await p.play(); await calm(); Betwixt.counts.drawn = 0; await calm();")
    same("nor what nobody sees", page.ask("[Betwixt.counts.drawn, p.paused, p.currentTime > 0]"), [0, False, True])
    page.do("p.scrollIntoView(); await calm(); await calm();")
    check("what is seen is", page.ask("Betwixt.counts.drawn") > 0)
    # Steps by the film's frames.
    page.do("p.pause(); p.stepped = true; p.currentTime = 1.03; await calm();")
    same("frame by frame", page.ask("Betwixt.last_drawn"), 24 / 24)
    page.close()


def what_goes_wrong(browser, served):
    page = browser.page(f"{served}/one.html", size=(640, 400))
    page.until("p.readyState === 4")
    page.do(f"{helpers}; Object.assign(window, {{until, calm}});")
    said = lambda: page.do("await calm(); const m = p.shadowRoot.querySelector('[part=message]'); return m.hidden ? '' : m.innerText")
    page.do("p.src = 'not-there.bx'; await until(p, 'error');")
    check("a film that is not there", "not-there.bx cannot be fetched: the server answered 404" in said(), said())
    page.do("p.src = 'films/broken.bx'; await until(p, 'error');")
    check("a broken one, with its caret", "broken.bx:2:3: error: this is broken" in said() and "\n    ^" in said(), said())
    page.do("Betwixt.drawing_fails = 'this browser has no WebGL 2'; p.src = 'three.bx'; await until(p, 'error');")
    check("nothing to draw with", "this browser has no WebGL 2" in said(), said())
    page.do("Betwixt.drawing_fails = ''")
    page.until("p.shadowRoot.querySelector('[part=message]').hidden")
    check("and it is back", page.ask("Betwixt.counts.drawn") > 0)
    page.do("Betwixt.engine_fails = 'this browser has no WebAssembly'; Betwixt.one = null; p.load(); await until(p, 'error');")
    check("no engine", "this browser has no WebAssembly" in said(), said())
    page.do("Betwixt.engine_fails = ''; p.shadowRoot.querySelector('[part=message] button').click(); await until(p, 'loadeddata');")
    same("tried again", said(), "")
    page.close()


def many(browser, served):
    page = browser.page(f"{served}/many.html", size=(640, 720))
    page.until("[...document.querySelectorAll('betwixt-player')].filter((p) => p.readyState === 4).length >= 2")
    page.do(f"{helpers}; Object.assign(window, {{until, calm}}); await calm(); await calm();")
    check("those far below wait", 2 <= page.ask("Betwixt.counts.opened") <= 6, page.ask("Betwixt.counts.opened"))
    page.do("for (let y = 0; y < document.body.scrollHeight; y += 500) { scrollTo(0, y); await calm(); }")
    page.until("Betwixt.counts.opened === 20")
    same("one engine for all", page.ask("Betwixt.counts.engines"), 1)
    page.do("for (const p of document.querySelectorAll('betwixt-player')) { p.loop = true; p.play(); } await calm();")
    same("all play", page.ask("[...document.querySelectorAll('betwixt-player')].filter((p) => !p.paused && p.currentTime > 0).length"), 20)
    page.do("document.body.replaceChildren(); await calm();")
    same("taken out, all films are given back", page.ask("[Betwixt.counts.opened, Betwixt.counts.disposed]"), [20, 20])
    page.do("""for (let i = 0; i < 100; ++i) { const p = document.createElement("betwixt-player"); p.loading = "eager";
        p.src = "three.bx"; document.body.append(p); await until(p, "loadeddata"); p.remove(); } await calm();""")
    same("a hundred times", page.ask("[Betwixt.counts.opened, Betwixt.counts.disposed]"), [120, 120])
    same("without a script, it goes back to that of the page", page.do("""
        const p = document.createElement("betwixt-player"); p.src = "three.bx"; document.body.append(p); await until(p, "loadeddata");
        const of_page = p.script; p.script = "rate 12\\n"; await calm(); const own = p.script;
        p.script = undefined; await until(p, "loadeddata"); await calm(); const q = document.createElement("betwixt-player");
        q.script = null; document.body.append(q); await calm(); return [own, p.script === of_page, q.script, q.error];"""),
         ["rate 12\n", True, "", None])
    same("moved, it keeps its film; taken out and put back, its time", page.do("""
        const p = document.createElement("betwixt-player"); p.src = "three.bx"; document.body.append(p); await until(p, "loadeddata");
        const film = p.film; p.currentTime = 1; document.body.append(document.createElement("div")); document.querySelector("div").append(p);
        await calm(); const kept = p.film === film && !film.gone; p.remove(); await calm(); const gone = p.film;
        document.body.append(p); await until(p, "loadeddata"); await calm(); return [kept, gone, p.currentTime];"""), [True, None, 1])
    page.close()


def before_it_is_known(browser, served):
    page = browser.page(f"{served}/later.html")
    page.do("window.p = document.createElement('betwixt-player'); p.script = 'rate 12\\n'; p.loop = true; p.currentTime = 1;"
            "document.body.append(p); const all = document.querySelectorAll('[type=\\'text/later\\']');"
            "for (const t of all) { const s = document.createElement('script'); s.textContent = t.textContent; document.body.append(s); }")
    page.until("p.readyState === 4")
    same("what was set before the element was known", page.ask("[p.film.fps, p.hasAttribute('loop'), p.currentTime]"), [12, True, 1])
    page.close()


def from_a_folder(browser, folder):
    page = browser.page(f"file://{folder}/one.html")
    page.until("p.readyState === 4")
    check("a page from a folder plays what it holds", True)
    page.do(f"{helpers}; Object.assign(window, {{until, calm}}); p.src = 'three.bx'; await until(p, 'error');")
    check("and says why it cannot fetch", "betwixt web FILE -o page.html" in page.ask("p.error.message"))
    page.close()


def calmly(browser, served):
    for calm, wanted in ((False, False), (True, True)):
        page = browser.page(f"{served}/moving.html", calm=calm)
        page.until("p.readyState === 4")
        page.ask("new Promise((r) => setTimeout(r, 300))")
        same(f"autoplay where {'no ' if calm else ''}motion is wanted", page.ask("p.paused"), wanted)
        page.close()
    page = browser.page(f"{served}/poster.html")
    page.until("p.readyState === 4")
    hidden = lambda: page.ask("new Promise((r) => setTimeout(() => r(p.shadowRoot.querySelector('[part=poster]').hidden), 100))")
    same("a poster stands until it is played", [hidden(), page.do("await p.play(); return 0;"), hidden()], [False, 0, True])
    page.close()


with tempfile.TemporaryDirectory() as folder:
    subprocess.run(["ffmpeg", "-v", "error", "-f", "lavfi", "-i", "testsrc=size=320x180:rate=24:duration=3", "-c:v", "libvpx", "-g", "12", f"{folder}/three.webm"], check=True)
    os.makedirs(f"{folder}/films/parts")
    files = {
        "both.html": f"{head}{scripts}<video id=video width=320 muted></video><betwixt-player id=player width=320></betwixt-player>",
        "one.html": f"{head}{scripts}<betwixt-player id=p controls>{inline()}</betwixt-player>",
        "touched.html": f"{head}<meta name=viewport content='width=device-width'>{scripts}<betwixt-player id=p controls>{inline()}</betwixt-player>",
        "later.html": head + scripts.replace("<script>", "<script type='text/later'>"),
        "moving.html": f"{head}{scripts}<betwixt-player id=p autoplay loop>{inline()}</betwixt-player>",
        "poster.html": f"{head}{scripts}<betwixt-player id=p poster=\"data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg'/%3E\">{inline()}</betwixt-player>",
        "many.html": f"{head}{scripts}" + f"<betwixt-player controls>{inline()}</betwixt-player>" * 20,
        "three.bx": film, "films/wants.bx": film + "use parts/a.txt\n", "films/parts/a.txt": "the letter a",
        "films/broken.bx": film[2:6] + "\n  broken\n",
    }
    for name, text in files.items():
        with open(f"{folder}/{name}", "w") as out:
            out.write(text)
    with Browser("--autoplay-policy=no-user-gesture-required") as browser, Served(folder) as served:
        for part in (beside_a_video, time_of_films, texts_and_files, hands, fingers, pictures, what_goes_wrong, many, calmly, before_it_is_known):
            try:
                part(browser, served)
            except Exception as e:
                check(part.__name__, False, e)
        from_a_folder(browser, folder)
done()
