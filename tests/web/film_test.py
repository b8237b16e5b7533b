# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests pages with the real engine: edits are visible, errors have the words of the program, memory does not grow, and
# the graphics context may be lost and restored. Skipped if the player is not built (./betwixt web builds it).
#   film_test.py PROGRAM
import json, os, re, shutil, subprocess, sys, tempfile
from browser import Browser, Served
from checks import check, done, player, root, same, there_is_a_player

program = os.path.abspath(sys.argv[1])
folder_of_test = tempfile.TemporaryDirectory()
folder = folder_of_test.name
there_is_a_player()
environment = {**os.environ, "BETWIXT_PLAYER": player}

ball = "# ball.bx — a ball\nrate 24\nrange 1f 48f\nsize 320x180\nfilm flat\ncreate ball circle radius=3 color=red\nball.position\n  1f (0 0 0) linear\n  25f (4 0 0)\nat 13f note \"half way\"\n"
others = "create eye camera position=(0 0 10)\ncreate word text text=\"grün\" display=off\ncreate way polyline points=((0 0 0) (1 2 3)) display=off\n"
memory = """const real = WebAssembly.instantiate; WebAssembly.instantiate = async function (...all) {
    const made = await real.apply(this, all), e = (made.instance ?? made).exports;
    window.memories = [...(window.memories ?? []), Object.values(e).find((x) => x instanceof WebAssembly.Memory)]; return made; };
  const get = OffscreenCanvas.prototype.getContext; OffscreenCanvas.prototype.getContext = function (kind, how) {
    const made = get.call(this, kind, how); if (kind.startsWith("webgl")) window.graphics = made; return made; };"""
helpers = """window.until = (m, name) => new Promise((r) => m.addEventListener(name, r, { once: true }));
  window.calm = async () => { await new Promise((r) => setTimeout(r, 150)); for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame); }; window.p = document.querySelector("betwixt-player");
  window.e = document.querySelector("betwixt-editor"); window.t = e && e.shadowRoot.querySelector("textarea");
  window.pixel = (p, x = 0.5, y = 0.5) => { const c = p.shadowRoot.querySelector("canvas"), d = document.createElement("canvas");
    d.width = c.width, d.height = c.height; const k = d.getContext("2d"); k.drawImage(c, 0, 0);
    return [...k.getImageData(c.width * x, c.height * y, 1, 1).data].slice(0, 3); };
  window.colours = (p) => { const c = p.shadowRoot.querySelector("canvas"), d = document.createElement("canvas"); d.width = 64, d.height = 36;
    const k = d.getContext("2d"); k.drawImage(c, 0, 0, 64, 36); return new Set(new Uint32Array(k.getImageData(0, 0, 64, 36).data.buffer)).size; };"""


def write(name, words):
    os.makedirs(os.path.dirname(f"{folder}/{name}"), exist_ok=True)
    with open(f"{folder}/{name}", "w", encoding="utf-8") as out:
        out.write(words)
    return f"{folder}/{name}"


def run(*words):
    return subprocess.run([program, *words], capture_output=True, text=True, cwd=folder, env=environment)


def web(*words):
    said = run("web", *words)
    if said.returncode != 0:
        sys.exit(said.stderr)


refuses = """for (const of of [OffscreenCanvas, HTMLCanvasElement]) { const get = of.prototype.getContext;
    of.prototype.getContext = function (kind, ...how) { return /^webgl/.test(kind) ? null : get.call(this, kind, ...how); }; }"""


def opened(browser, url, refuse=False, **how):
    page = browser.page(**how)
    page.call("Page.addScriptToEvaluateOnNewDocument", source=refuses if refuse else memory)
    page.go(url)
    page.do(helpers)
    return page


def typed(browser):
    page = opened(browser, f"file://{folder}/ball.html", size=(1200, 800))
    page.until("p.readyState === 4")
    page.do("p.pause(); p.currentTime = 0; await calm();")
    check("a red ball", page.until("pixel(p).join() === '255,0,0'"))
    page.do("p.currentTime = 1; await until(p, 'seeked');")
    check("which goes away", page.ask("pixel(p)") != [255, 0, 0], page.ask("pixel(p)"))
    same("the notes of the film", page.ask("p.film.notes"), [{"seconds": 0.5, "text": "half way"}])
    all_values = "ball.position ball.position.x ball.radius ball.display ball.color ball.rotation ball.scale ball.world ball.attachment ball.geometry eye.shutter word.text way.points".split()
    said = json.loads(run("eval", "ball.bx", "--at", "0.3s", *all_values, "--json").stdout)["times"][0]["values"]
    same("values are those of the program", page.ask(f"{json.dumps(all_values)}.map((t) => p.eval(t, 0.3))"), [said[t] for t in all_values])
    same("as it prints them", page.ask("p.film.eval('ball.position', 0.3, { text: true })"), run("eval", "ball.bx", "--at", "0.3s", "ball.position").stdout.split(maxsplit=1)[-1].strip())
    check("several values are no value", "names 2 values" in page.ask("(() => { try { p.eval('{ball,eye}.position') } catch (e) { return e.message } })()"))
    page.do("p.currentTime = 0; t.focus(); const at = t.value.indexOf('red'); t.setSelectionRange(at, at + 3);")
    page.type("lime")
    check("typed, it is seen", page.until("pixel(p)[1] > 200 && pixel(p)[0] < 50"))
    page.do("t.setSelectionRange(t.value.length, t.value.length)")
    page.type("ball.positon")
    page.do("await calm()")
    script = page.ask("t.value")
    check("what is wrong leaves the picture", page.ask("pixel(p)[1] > 200"))
    said = run("check", write("wrong/ball.bx", script))
    wanted = [line for line in (said.stdout + said.stderr).replace(f"{folder}/wrong/", "").split("\n")
              if line and not re.match(r"\d+ error", line)]
    found = [line for line in page.ask("p.message").split("\n") if line]
    same("it is said as the program says it", found, wanted)
    shown = page.ask("e.shadowRoot.querySelector('.said').innerText")
    check("and stands below, with its caret and a hint", "ball.positon" in shown and "^" in shown and "did you mean 'position'?" in shown, shown)
    page.close()


def tracks(browser):
    page = opened(browser, f"file://{folder}/ball.html", size=(1200, 800))
    page.until("p.readyState === 4")
    page.do("p.pause(); p.currentTime = 0; await calm();")
    first = page.ask("t.value")
    page.do("p.film.setTrack('ball.position', [0, 1, 1.5], new Float64Array([9, 0, 0, 1, 2, 0, 3, 4, 0]), { twerper: 'linear' }); await calm();")
    check("a track from numbers is seen", page.ask("pixel(p).join() !== '255,0,0'"))
    same("its values", page.ask("[p.eval('ball.position', 0.5), p.eval('ball.position', 1.5)]"), [[5, 1, 0], [3, 4, 0]])
    same("its rows are in the text", page.ask("t.value"),
         first + "clear ball.position 1f..25f\nball.position\n  1f (9 0 0) linear\n  25f (1 2 0) linear\n  37f (3 4 0) linear\n")
    same("the film and the player have the same text", page.ask("p.script === t.value && p.film.text === t.value"), True)
    same("the numbers come back", page.ask("(({ times, values, width }) => [times instanceof Float64Array, [...times], [...values], width])(p.film.trackNumbers('ball.position'))"),
         [True, [0, 1, 1.5], [9, 0, 0, 1, 2, 0, 3, 4, 0], 3])
    page.do("p.film.setTrack('ball.radius', [0], [1]);")
    same("rows of a colour", page.do("p.film.setTrack('ball.color', [0, 1], [[1, 0, 0], [0, 0, 1]]); return p.eval('ball.color', 1);"), [0, 0, 1])
    same("one step each", page.ask("[p.film.undo(), p.film.undo(), p.film.undo()].length"), 3)
    check("undone", page.until("pixel(p).join() === '255,0,0'"))
    same("in the text too", page.ask("t.value"), first)
    same("and done again", page.do("p.film.redo(); return p.eval('ball.position', 1.5);"), [3, 4, 0])
    # The page and the program do the same: the text says so.
    page.do("await calm();")
    said = run("eval", write("edited/ball.bx", page.ask("t.value")), "--at", "0.7s", "ball.position", "--json").stdout
    same("the program reads the same film", page.ask("p.eval('ball.position', 0.7)"), json.loads(said)["times"][0]["values"]["ball.position"])
    thrown = lambda call: page.ask(f"(() => {{ try {{ p.film.{call} }} catch (e) {{ return e.message }} }})()")
    for call, words in (("setTrack('ball.positon', [0], [1])", "did you mean 'position'?"),
                        ("setTrack('ball.*', [0], [1])", "'ball.*' does not name one track"),
                        ("setTrack('ball.attachment', [0], [1])", "the values of 'ball.attachment' are not numbers"),
                        ("setTrack('ball.position', [0], [1, 2])", "1 time needs 3 numbers, not 2"),
                        ("setTrack('ball.radius', [0, 0], [1, 2])", "time 2 is not after the time before it"),
                        ("setTrack('ball.radius', [0], [NaN])", "value 1 is not finite"),
                        ("setTrack('ball.radius', [0], [-1])", "value 1 is -1, which is not from 0 to"),
                        ("setTrack('ball.radius', [1e12], [1])", "this time is too far from the beginning"),
                        ("setTrack('ball.radius', [0], [1], { twerper: 'linaer' })", "linear"),
                        ("trackNumbers('ball.none')", "'ball', a circle, has no function 'none'")):
        said = thrown(call)
        check(f"{call} says what is wrong", said and words in said, said)
    same("what was wrong changed nothing", page.ask("t.value === p.film.text"), True)
    page.do("t.focus(); t.setSelectionRange(t.value.length, t.value.length);")
    page.type("set ball.color blue\n")
    check("the text can be edited on", page.until("p.eval('ball.color', 0).join() === '0,0,1'"))
    same("with the track", page.ask("p.eval('ball.position', 1.5)"), [3, 4, 0])
    page.do("const b = p.parentNode; p.film.setTrack('ball.radius', [0], [2]); p.remove(); await calm(); b.append(p);")
    page.until("p.readyState === 4")
    same("a player that comes back has its edits", page.ask("p.eval('ball.radius', 0)"), 2)
    same("many rows", page.do("""const film = (await Betwixt.engine()).open("create ball sphere\\n"), n = 20000;
        const times = Float64Array.from({ length: n }, (_, i) => i / 24), values = times.map(Math.sin);
        film.setTrack("ball.position.y", times, values); const back = film.trackNumbers("ball.position.y"); film.dispose();
        return back.values.length === n && back.values.every((v, i) => v === values[i]) && back.times.every((t, i) => Math.abs(t - times[i]) < 1e-9);"""), True)
    same("nothing was thrown", page.said, [])
    page.close()


def wrong(browser, served):
    page = opened(browser, f"{served}/empty.html")
    said = lambda: page.do("await calm(); const m = p.shadowRoot.querySelector('[part=message]'); return m.hidden ? '' : m.innerText")
    page.do("p.src = 'none.bx'; await until(p, 'error');")
    check("a film that is not there", "none.bx cannot be fetched: the server answered 404" in said(), said())
    page.do("p.src = 'wants.bx'; await until(p, 'error');")
    check("a mesh that is not there", "meshes/none.obj" in said() and "404" in said() and "^" in said(), said())
    page.do("p.src = 'mesh.bx'; await until(p, 'loadeddata'); await calm();")
    check("one that is there is fetched", page.ask("colours(p)") > 20, page.ask("[colours(p), p.message]"))
    same("a film with files can be edited", page.do("p.film.setTrack('m.position.x', [0, 1], [0, 5]); await calm(); return [p.eval('m.position.x', 1), p.message, colours(p) > 20];"), [5, "", True])
    page.close()


def code_errs(browser):
    page = opened(browser, f"file://{folder}/code.html", size=(1200, 800))
    page.until("p.diagnostics.length > 0")
    said = page.ask("p.diagnostics.map((d) => [d.severity, d.line, d.column, d.text])")
    check("what code does wrong is said where it stands", len(said) == 1 and said[0][:3] == ["error", 3, 19] and "nosuch" in said[0][3], said)
    shown = page.ask("e.shadowRoot.querySelector('.said').innerText")
    check("below the text too", "nosuch" in shown and "^" in shown, shown)
    same("a value at a frame", page.ask("p.eval('c.radius', '24f')"), 0.5)
    page.close()


# A transparent film shows the page behind it. Its pixels are those of the program's picture, with premultiplied
# opacity.
def clear(browser):
    page = opened(browser, f"file://{folder}/clear.html", size=(1200, 800))
    page.until("p.readyState === 4")
    page.do("p.pause(); p.currentTime = 0; p.controls = false; document.body.style.background = 'rgb(0, 200, 0)'; await calm(); await calm();")
    page.until("p.getVideoPlaybackQuality().totalVideoFrames > 0")
    page.do("window.rgba = (x) => { const c = p.shadowRoot.querySelector('canvas'), d = document.createElement('canvas'); d.width = c.width, d.height = c.height;"
            "const k = d.getContext('2d'); k.drawImage(c, 0, 0); return [...k.getImageData(c.width * x, c.height / 2, 1, 1).data]; };")
    wanted = [0.5, 0.2, 0.95]
    run("frame", "clear.bx", "--at", "1f", "-o", "clear.png", "--size", "640x360")
    raw = subprocess.run(["ffmpeg", "-v", "error", "-i", f"{folder}/clear.png", "-f", "rawvideo", "-pix_fmt", "rgba", "-"], capture_output=True).stdout
    for x in wanted:
        at = 4 * (180 * 640 + int(640 * x))
        found, there = page.ask(f"rgba({x})"), list(raw[at:at + 4])
        check(f"at {x} it is what the program draws", all(abs(a - b) <= 2 for a, b in zip(found, there)), (found, there))
    same("of which one is whole, one glass, one nothing", [page.ask(f"rgba({x})[3]") // 64 for x in wanted], [3, 1, 0])
    # On the screen, with the page behind the film.
    page.picture(f"{folder}/screen.png")
    x, y, w, h = page.ask("(() => { const r = p.getBoundingClientRect(); return [r.x, r.y, r.width, r.height] })()")
    shot = subprocess.run(["ffmpeg", "-v", "error", "-i", f"{folder}/screen.png", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], capture_output=True).stdout
    pixel = lambda s: list(shot[3 * (1200 * int(y + h / 2) + int(x + w * s)):][:3])
    same("where there is nothing, the page is seen", pixel(0.95), [0, 200, 0])
    red, over = raw[4 * (180 * 640 + 128)], raw[4 * (180 * 640 + 128) + 3] / 255
    check("and through glass", abs(pixel(0.2)[1] - (1 - over) * 200 - over * raw[4 * (180 * 640 + 128) + 1]) <= 4, (pixel(0.2), red, over))
    page.do("p.script = p.script.replace('background transparent', 'background blue'); await calm(); await calm();")
    check("typed, there is something", page.until("rgba(0.95).join() === '0,0,255,255'"))
    page.close()


def many(browser, served):
    page = opened(browser, f"{served}/empty.html")
    page.do(f"""window.ball = {json.dumps(ball)}; window.one = async () => {{ const p = document.createElement("betwixt-player");
        p.loading = "eager"; p.width = 320; p.script = ball; document.body.append(p); await until(p, "loadeddata"); p.scrollIntoView();
        for (let i = 0; !p.getVideoPlaybackQuality().totalVideoFrames && i < 50; ++i) await new Promise(requestAnimationFrame); return p; }};
        for (let i = 0; i < 20; ++i) (await one()).remove(); await calm(); window.before = memories.map((m) => m.buffer.byteLength);""", patience=120)
    page.do("for (let i = 0; i < 100; ++i) (await one()).remove(); await calm();", patience=300)
    same("memory after a hundred films", page.ask("memories.map((m) => m.buffer.byteLength)"), page.ask("before"))
    same("and one memory", page.ask("memories.length"), 1)
    print(f"memory of the engine: {page.ask('before')[0] / 1e6:.1f} MB", file=sys.stderr)
    page.do("window.all = []; for (let i = 0; i < 12; ++i) { const p = await one(); p.style.width = '200px'; p.style.display = 'inline-block'; all.push(p); } scrollTo(0, 0);"
            "for (const p of all) { p.loop = true; p.play(); } await calm();", patience=120)
    same("twelve players play", page.do("await calm(); return all.filter((p) => !p.paused && p.currentTime > 0).length"), 12)
    page.do("for (const p of all) { p.pause(); p.currentTime = 0; } await calm(); await calm();")
    same("each has its picture", page.ask("all.filter((p) => pixel(p)[0] === 255).length"), 12)
    page.close()


def graphics_go(browser):
    page = opened(browser, f"file://{folder}/ball.html", size=(1200, 800))
    page.until("p.readyState === 4")
    page.do("p.pause(); p.currentTime = 0;")
    check("a red ball", page.until("pixel(p).join() === '255,0,0'"))
    page.do("graphics.getExtension('WEBGL_lose_context').loseContext(); await calm(); p.currentTime = 1;")
    check("when the graphics have gone, it goes on with others", page.until("pixel(p)[0] !== 255"))
    same("and no message is left", page.do("await calm(); return p.shadowRoot.querySelector('[part=message]').hidden"), True)
    page.close()


def without_graphics():
    with Browser() as browser:
        page = opened(browser, f"file://{folder}/ball.html", size=(1200, 800), refuse=True)
        page.until("!p.shadowRoot.querySelector('[part=message]').hidden")
        said = page.ask("p.shadowRoot.querySelector('[part=message]').innerText")
        check("without WebGL 2 there is a message", "WebGL 2" in said, said)
        check("and the text is there", page.ask("t.value").startswith("# ball.bx"))
        page.close()


# All films of the gallery and of the tutorial, from a folder.
def pages(browser):
    made = subprocess.run([f"{root}/tools/pages.sh", program, f"{folder}/pages"], capture_output=True, text=True, env=environment)
    if not check("the pages are made", made.returncode == 0, made.stderr):
        return
    with open(f"{root}/docs/gallery.md", encoding="utf-8") as file:
        in_gallery = len(re.findall(r"^!\[", file.read(), re.M))
    for name, count in (("gallery", in_gallery), ("tutorial", 19)):
        page = opened(browser, f"file://{folder}/pages/{name}.html", size=(1200, 900))
        page.do("window.all = [...document.querySelectorAll('betwixt-player')]")
        same(f"films of the {name}", page.ask("all.length"), count)
        page.do("""for (const p of all) { p.scrollIntoView(); for (let i = 0; p.readyState < 4 && !p.error && i < 100; ++i) await calm();
            if (p.film) { const there = until(p, "seeked"); p.currentTime = p.duration / 2; await there;
              for (let i = 0; !p.getVideoPlaybackQuality().totalVideoFrames && i < 50; ++i) await calm(); } }""", patience=300)
        bad = page.ask("all.filter((p) => !p.film).map((p) => p.error && p.error.message)")
        same(f"{name}: those with mistakes", len(bad), 1 if name == "tutorial" else 0)
        check(f"{name}: none but the one that is meant", all("positon" in (b or "") for b in bad), bad)
        same(f"{name}: those that show nothing", page.ask("all.filter((p) => p.film && colours(p) < 3).length"), 0)
        same(f"{name}: what the page complains of", page.said, [])
        page.close()


# The npm package: imported by a page, and by a program without a page.
def package(browser):
    there = f"{os.path.dirname(player)}/package"
    if not os.path.exists(there):
        return
    with Served(there) as served:
        page = browser.page(f"{served}/package.json")
        page.do(f"""document.body.innerHTML = "<betwixt-player></betwixt-player>"; {helpers}
            window.imported = await import("./betwixt-player.mjs"); p.script = {json.dumps(ball)}; await until(p, "loadeddata"); await calm();""")
        same("the module draws", page.ask("pixel(p)"), [255, 0, 0])
        same("and hands out what it has", page.ask("[imported.BetwixtPlayer === p.constructor, typeof imported.BetwixtEditor]"), [True, "function"])
        same("one engine", page.ask("(async () => (await imported.engine()) === (await Betwixt.engine()))()"), True)
        page.close()
    if shutil.which("node"):
        said = subprocess.run(["node", "--input-type=module", "-e", f"const m = await import('{there}/betwixt-player.mjs'); console.log(typeof m.engine)"],
                              capture_output=True, text=True)
        same("without a page it can be imported", said.stdout.strip(), "function")


def own_font(browser):
    """A font's file in the page gives the letters of that font. The I of a serif font has feet, beside its middle."""
    page = opened(browser, f"file://{folder}/letters.html", size=(1000, 700))
    check("a page with a font of its own", page.until("p.readyState === 4"), page.ask("p.error && p.error.message"))
    page.do("p.pause(); p.currentTime = 0; await calm();")
    row = "[...Array(64).keys()].filter((i) => pixel(p, 0.5 + (i - 32) / 200, %s)[1] < 128).length"
    feet, middle = page.ask(row % 0.94), page.ask(row % 0.5)
    check("shows its letters", feet > middle + 4 and middle > 2, [feet, middle])


write("letters.bx", "size 320x180\nfilm flat\nbackground white\nsamples 4\ncreate i text text=\"I\" font=\"fonts/Own.ttf\" size=12 position=(0 -4.3 0) color=black\n")
shutil.copyfile("/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf", os.path.join(os.path.dirname(write("fonts/none", "")), "Own.ttf"))
web("letters.bx", "-o", "letters.html", "--no-edit")
write("ball.bx", ball + others)
write("clear.bx", "size 640x360\nfilm flat\nbackground transparent\ncreate ball circle radius=1 color=red\n"
      "create glass rectangle size=(3 3) position=(-4.5 0 0) color=red transparency=0.6\n")
write("wants.bx", ball + 'create m mesh file="meshes/none.obj"\n')
write("mesh.bx", 'size 320x180\ncreate m mesh file="meshes/one.obj" color=gold\n')
write("meshes/one.obj", "v -1 0 0\nv 1 0 0\nv 0 1.5 0\nv 0 0 1\nf 1 2 3\nf 1 4 3\nf 4 2 3\n")
web("ball.bx", "-o", "ball.html")
write("code.bx", 'size 320x180\ncreate c cone radius=0.5\nset c.position = "vec(nosuch(t),0,0)"\n')
web("code.bx", "-o", "code.html")
web("clear.bx", "-o", "clear.html", "--no-edit", "--size", "640x360")
with open(player, encoding="utf-8") as source:
    write("betwixt-player.js", source.read())
write("empty.html", '<!DOCTYPE html><meta charset="utf-8"><body><script src="betwixt-player.js"></script><betwixt-player></betwixt-player>')
with Browser() as browser, Served(folder) as served:
    for part in (typed, tracks, own_font, code_errs, clear, graphics_go, package, pages, lambda b: wrong(b, served), lambda b: many(b, served)):
        try:
            part(browser)
        except Exception as e:
            check(part.__name__, False, e)
without_graphics()
done()
