#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests lessons in a browser. The engine in the page must give the program's numbers to the last bit. Strings are typed,
# factors swapped and handles dragged with mouse and keys. Every figure is checked in both themes, wide and narrow.
#   lesson_test.py PROGRAM [FOLDER for pictures]     the variable BETWIXT_PLAYER=FILE names another player
import json, math, os, re, subprocess, sys, tempfile, time
from browser import Browser
from checks import check as verdict, done

program = os.path.abspath(sys.argv[1])
pictures = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else None
def run(*words):
    said = subprocess.run([program, "algebra", *words], capture_output=True, text=True)
    if "./betwixt web builds it" in said.stderr:
        print("left out: the engine for pages is not built (./betwixt web)\n0 passed, 0 failed")
        sys.exit()
    if said.returncode != 0:
        sys.exit(f"{words}: {said.stderr}")
    return said.stdout


strings = [
    "T(6.28 0) R(-1turn @ 0 1)", "R(1turn) T(3 0)", "S(2 0.5 @ 1 1) R(180deg)", "S(3 0.5 @ 1 2 linear) T(6 1)",
    "R(1turn) R(12turn @ 3 0) R(-2turn @ 4 1)", "T(100 0) R(35deg @ 3 1) S(2 2 @ 0 0)", "",
    "T(1 0) R(90deg @ 1 0) S(1.5 @ 0 1) T(0 2) R(-1turn @ 2 2) S(0.5 1 @ 1 1) R(45deg) T(-1 -1) S(2 1 linear) "
    "R(0.5turn @ 3 0) T(2 0) R(-30deg @ 1 1)",
    "S(-1 0 @ 1 1 linear)", "R(1000.25turn @ 1e-3 0)", "R(24turn) T(3 0)", "R(500turn) T(3 0)",
            "R(10000turn) S(20) R(99turn @ 3 0)",
    "S(0 linear) S(1.0000001) S(1 1)", "T(1e-9 0) S(1e3)", "T(9e8 -9e8)",
    "T(0 -3 0) R(6turn @ 0 0 0 axis y) S(0.1 1 0.1)", "R(70deg @ 1 2 3 axis 1 -2 0.5) S(2 1 0.25 @ 0 0 1) T(1 2 3)",
]


def to_plain(number):
    return float(number.replace("−", "-"))


def open_lesson(browser, folder, motion, *options, **how):
    path = f"{folder}/lesson.html"
    run("--lesson", path, motion, *options)
    page = browser.page(f"file://{path}", **how)
    page.until("document.documentElement.dataset.ready === 'yes'")
    return page


def settled(page):
    page.until("'shown' in document.documentElement.dataset")


def field(page):
    return page.ask("document.getElementById('string').value")


def box(page, selector, scroll=True):
    return page.ask(f"""(() => {{ const e = document.querySelector({json.dumps(selector)});
        if ({json.dumps(scroll)}) e.scrollIntoView({{block: "center", behavior: "instant"}});
        const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2, b.width, b.height] }})()""")


def drag(page, x, y, *places):
    page.mouse("mouseMoved", x, y, "none"), page.mouse("mousePressed", x, y)
    for to in places:
        page.mouse("mouseMoved", *to)
        page.do("await new Promise(requestAnimationFrame)")
    page.mouse("mouseReleased", *places[-1])
    settled(page)


def write(page, text):
    page.do("const f = document.getElementById('string'); f.focus(); f.select()")
    page.call("Input.insertText", text=text) if text else page.key("Delete")


# Lists the layout faults of a page at rest.
faults = """(() => {
  const wrong = [], want = (what, is) => is || wrong.push(what), root = document.documentElement;
  want("numbers are numbers", ![...document.querySelectorAll("svg *")].some((e) =>
    [...e.attributes].some((a) => /NaN|Infinity|undefined/.test(a.value))));
  want("words are words", !/NaN|undefined|Infinity|\\[object/.test(document.querySelector("main").innerText));
  want("pictures are named", [...document.querySelectorAll("svg.picture")].every((s) =>
    s.getAttribute("aria-label") || s.getAttribute("aria-hidden")));
  want("what is pressed has a name", [...document.querySelectorAll("button, .handle, input, textarea")].every((e) =>
    e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.length));
  want("nothing is loaded", performance.getEntriesByType("resource").every((e) => /^(data|blob):/.test(e.name)));
  want(`it fits: ${root.scrollWidth} of ${innerWidth}`, root.scrollWidth <= innerWidth);
  const factors = new Set, paths = new Set;
  for (const e of document.querySelectorAll(".factor, .path")) {
    const of = getComputedStyle(e), to = e.classList.contains("factor") ? factors : paths;
    const own = e.namespaceURI.endsWith("svg") ? [of.stroke, e.tagName === "circle" ? of.fill : "none"]
      : e.classList.contains("chip") || e.classList.contains("key") ? [of.borderTopColor] : [of.color];
    own.filter((c) => c.startsWith("rgb") && !/, 0\\)$/.test(c)).forEach((c) => to.add(c));
  }
  const panel = getComputedStyle(document.querySelector("svg.picture"))?.backgroundColor;
  paths.delete(panel);
  want(`a colour of both: ${[...factors].filter((c) => paths.has(c))}`, ![...factors].some((c) => paths.has(c)));
  return wrong;
})()"""


def seen_by(rgb):
    """Returns a colour in OKLab as eyes with each kind of colour vision see it (Machado and others, 2009)."""
    kinds = [((1, 0, 0), (0, 1, 0), (0, 0, 1)),
             ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
             ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
             ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900))]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in rgb]
    out = []
    for kind in kinds:
        r, g, b = (min(1, max(0, sum(k * c for k, c in zip(row, linear)))) for row in kind)
        l, m, s = ((0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) ** (1 / 3),
                   (0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) ** (1 / 3),
                   (0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b) ** (1 / 3))
        out.append((0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
                1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
                    0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s))
    return out


def check_colours(page, theme):
    names = page.ask("""Object.fromEntries([..."fp"].flatMap((k) => [0, 1, 2, 3].map((i) => [k + i,
        getComputedStyle(document.documentElement).getPropertyValue(`--${k}${i}`).trim()])).filter(([, c]) => c))""")
    colours = {n: seen_by([int(c[i:i + 2], 16) / 255 for i in (1, 3, 5)]) for n, c in names.items()}
    least = min((min(math.dist(a, b) for a, b in zip(colours[f], colours[p])), f, p)
                for f in colours if f[0] == "f" for p in colours if p[0] == "p")
    verdict(f"factors and paths are told apart by all eyes, {theme}", len(names) == 7 and least[0] >= 0.1,
            f"{names} {least}")


def same_numbers(page):
    """Checks that the in-betweens of the page and of the program have the same bits."""
    worst = ""
    for motion in strings:
        if not motion:
            continue
        for k in (-3.5, 0.25, 7.75, 16.125, 23.9, 31.3):
            space = "axis" in motion
            said = json.loads(run(motion, "--steps", "24", "--at", str(k), "--json", "--points",
                                  "0,0,0 1,0,0 0.3,1.7,2.5" if space else "0,0 1,0 0.3,1.7"))
            there = [p + [0] * (3 - len(p)) for p in said["frames"][0]["points"]]
            m = page.ask(f"(await Betwixt.engine()).algebra.moment({json.dumps(motion)}, {k!r} / 24).matrix")
            for (x, y, z), wanted in zip([(0, 0, 0), (1, 0, 0), (0.3, 1.7, 2.5 if space else 0)], there):
                here = [m[4 * r] * x + m[4 * r + 1] * y + m[4 * r + 2] * z + m[4 * r + 3] for r in range(3)]
                if any(a != b for a, b in zip(here, wanted)):
                    worst = worst or f"{motion} at {k}: {here} and not {wanted}"
    verdict("the page's numbers are the program's, bit for bit", not worst, worst)


def check_standing(browser, folder):
    for motion in strings:
        page = open_lesson(browser, folder, motion, size=(1200, 900))
        for size in ((1200, 900), (390, 800)):
            page.show(size)
            page.do("location.hash = location.hash.replace(/t=[0-9.]*/, 't=0.25')")
            settled(page)
            wrong = page.ask(faults)
            verdict(f"\"{motion}\" at {size[0]}", not wrong, wrong)
        verdict(f"\"{motion}\" says nothing wrong", not page.said, page.said)
        verdict(f"\"{motion}\" stands in its field",
                field(page) == (motion and field(page)) and not page.ask("document.getElementById('wrong').innerText"),
                        "")
        page.close()


def slide(page, t):
    page.do(f"""const s = document.getElementById("time");
        s.value = {t}, s.dispatchEvent(new Event("input")), s.dispatchEvent(new Event("change"))""")


def check_typing(page):
    write(page, "T(5 3) R(90deg @ 1 4)")
    settled(page)
    slide(page, 0.5)
    cells = [to_plain(c) for c in page.ask("[...document.querySelectorAll('#matrix td')].map((c) => c.textContent)")]
    h = math.sqrt(0.5)  # computed by hand: half of the way, after an eighth of a turn about (1, 4)
    wanted = [h, -h, 2.5 + (1 - h) * 1 + h * 4, h, h, 1.5 - h * 1 + (1 - h) * 4, 0, 0, 1]
    verdict("the matrix in numbers", all(abs(a - b) < 1e-5 for a, b in zip(cells, wanted)), cells)
    written = page.ask("[...document.querySelectorAll('#written .symbols')].at(-1).innerText.replace(/\\s+/g, ' ').trim()")
    verdict("the matrix in letters",
            written.replace("\n", "") == "c2 −s2 u1 + (1 − c2) x2 + s2 y2 s2 c2 v1 − s2 x2 + (1 − c2) y2 0 0 1",
                    written)
    letters = page.ask("document.getElementById('letters').innerText")
    verdict("what letters stand for", "cos(90deg t)" in letters and "5 t" in letters, letters)
    verdict("the lead follows", "A motion of 2 factors" in page.ask("document.getElementById('lead').innerText"))
    # Typed key by key; the strings in between are invalid.
    write(page, "R(1turn")
    said = page.ask("document.getElementById('wrong').innerText")
    verdict("a mistake, with its place", said.startswith("R(1turn\n       ^\nError: ')' is missing"), repr(said))
    verdict("the last string stays in the picture",
            page.ask("document.getElementById('chips').innerText").startswith("T(5 3)"))
    verdict("and the field says so",
            page.ask("document.getElementById('string').getAttribute('aria-invalid')") == "true")
    page.type(")")
    verdict("mended", field(page) == "R(1turn)" and page.ask("document.getElementById('wrong').hidden"), field(page))
    page.key("Enter")
    verdict("a string is one line", field(page) == "R(1turn)")
    for bad in ("T(1e12 0)", "R(1turn @ </script><b>)", "S(-1)", "Q", "T(" * 400, "R(1turn @ ball)"):
        write(page, bad)
        verdict(f"no string: {bad[:20]}", "Error: " in page.ask("document.getElementById('wrong').innerText"))
    verdict("nothing of it has become an element",
            page.ask("document.querySelectorAll('main b:not(figcaption b, .figures b, .bars b), header b').length") == 0)
    write(page, "")
    settled(page)
    verdict("an empty string is the identity", "Nothing moves" in page.ask("document.getElementById('lead').innerText"))


def check_swapping(page):
    write(page, "R(1turn) T(3 0) S(2)")
    settled(page)
    page.click(*box(page, ".swap")[:2])
    verdict("swapped by a button", field(page) == "T(3 0) R(1turn) S(2)", field(page))
    page.key("Enter")
    verdict("and back by a key", field(page) == "R(1turn) T(3 0) S(2)", field(page))
    x, y, *_ = box(page, ".chip span")
    to = box(page, "li:nth-child(3) .chip")
    drag(page, x, y, (x + 10, y + 2), (to[0], to[1]))
    verdict("swapped by dragging one onto another", field(page) == "S(2) T(3 0) R(1turn)", field(page))
    x, y, *_ = box(page, ".chip span")
    drag(page, x, y, (x, y + 200))
    verdict("dragged nowhere, it stays", field(page) == "S(2) T(3 0) R(1turn)", field(page))
    page.click(*box(page, "#undo")[:2])
    verdict("undone", field(page) == "R(1turn) T(3 0) S(2)", field(page))
    page.click(*box(page, ".law")[:2])
    verdict("the other law", field(page) == "R(1turn) T(3 0) S(2 linear)", field(page))
    page.key("Enter")
    verdict("and back", field(page) == "R(1turn) T(3 0) S(2)", field(page))
    page.click(*box(page, "li:nth-child(2) .out")[:2])
    verdict("taken out", field(page) == "R(1turn) S(2)", field(page))
    page.click(*box(page, "#add-T")[:2])
    verdict("put in", re.fullmatch(r"T\(\S+ 0\) R\(1turn\) S\(2\)", field(page)), field(page))


def pixels(page):
    """Returns how many pixels one unit has, from the end of the path and the origin."""
    return page.ask("""(() => { const s = document.querySelector("#stage svg");
        const all = [...s.querySelectorAll("path.factor")].find((p) => p.getAttribute("stroke-opacity"));
        const [a, b] = all.getAttribute("d").slice(1).split("L").map((p) => p.split(" ").map(Number));
        return (b[0] - a[0]) * s.getScreenCTM().a })()""")


def check_dragging(page):
    write(page, "T(4 0) R(90deg @ 1 1) S(2 @ 0 1)")
    settled(page)
    one = pixels(page) / 4
    x, y, *_ = box(page, "[data-grip='0-by'] .grip")
    drag(page, x, y, (x + one / 2, y - one), (x + one, y - 2 * one))
    verdict("a way is dragged", field(page).startswith("T(5 2) R(90deg @ 1 1)"), field(page))
    settled(page)
    # The visible part of the plane has changed.
    one = page.ask("""(() => { const at = (n) => document.querySelector(`[data-grip='${n}']`).getBoundingClientRect();
        return Math.hypot(at("0-by").x - at("2-centre").x, at("0-by").y - at("2-centre").y) })()""") / math.hypot(5, 1)
    x, y, *_ = box(page, "[data-grip='1-centre'] .grip")
    drag(page, x, y, (x, y - one), (x - 2 * one, y - one))
    verdict("a centre is dragged", "R(90deg @ -1 2)" in field(page), field(page))
    page.key("ArrowRight")
    page.key("ArrowRight", shift=True)
    moved = re.search(r"R\(90deg @ (\S+) 2\)", field(page))
    verdict("and by keys", moved and -1 < float(moved[1]) < -0.7, field(page))
    write(page, "T(4 0) R(90deg @ 1 1) S(2 @ 0 1)")
    settled(page)
    # Several turns of a handle: whole turns are kept.
    x, y, *_ = box(page, "[data-grip='1-angle'] .grip")
    cx, cy, *_ = box(page, "[data-grip='1-centre'] .grip", scroll=False)
    r = math.hypot(x - cx, y - cy)
    drag(page, x, y, *[(cx + r * math.cos(math.radians(a)), cy - r * math.sin(math.radians(a))) for a in range(90, 856,
            15)])
    verdict("an angle is dragged round twice", "R(855deg @ 1 1)" in field(page), field(page))
    page.key("ArrowUp")
    verdict("and on by a key", "R(860deg @ 1 1)" in field(page), field(page))
    settled(page)
    x, y, *_ = box(page, "[data-grip='2-x'] .grip")
    cx, cy, *_ = box(page, "[data-grip='2-centre'] .grip", scroll=False)
    drag(page, x, y, (cx + (x - cx) * 1.5, y))
    verdict("a growth is dragged", field(page).endswith("S(3 2 @ 0 1)"), field(page))
    x, y, *_ = box(page, "[data-grip='2-all'] .grip")
    cx, cy, *_ = box(page, "[data-grip='2-centre'] .grip", scroll=False)
    drag(page, x, y, (cx - 50, cy + 50))
    verdict("never to nothing", field(page).endswith("S(0.1 @ 0 1)"), field(page))
    for _ in range(3):
        page.click(*box(page, "#undo")[:2])
    verdict("undone, drag by drag", field(page).endswith("R(855deg @ 1 1) S(2 @ 0 1)"), field(page))


def swipe(page, x, y, dx, dy):
    page.call("Emulation.setTouchEmulationEnabled", enabled=True)
    page.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
    for k in range(1, 9):
        page.call("Input.dispatchTouchEvent", type="touchMove",
                touchPoints=[{"x": x + dx * k / 8, "y": y + dy * k / 8}])
        page.do("await new Promise(requestAnimationFrame)")
    page.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    settled(page)
    page.call("Emulation.setTouchEmulationEnabled", enabled=False)


def check_touch(page):
    write(page, "R(90deg @ 1 1) T(4 0)")
    settled(page)
    swipe(page, *box(page, "[data-grip='0-centre'] .grip")[:2], -80, 64)
    to = re.search(r"R\(90deg @ (\S+) (\S+)\)", field(page))
    verdict("a centre is dragged by a finger", to and float(to[1]) < 0.6 and float(to[2]) < 0.7, field(page))
    write(page, "R(1turn @ 1 0 0 axis y) T(0 2 1)")
    settled(page)
    yaw = page.ask("new Promise((done) => setTimeout(() => done(location.hash.split('v=')[1]), 300))")
    x, y, wide, high = box(page, "#stage svg")
    swipe(page, x - wide * 0.4, y + high * 0.4, 150, 0)
    now = page.ask("new Promise((done) => setTimeout(() => done(location.hash.split('v=')[1]), 300))")
    verdict("space is turned by a finger", float(yaw.split(",")[0]) - float(now.split(",")[0]) > 1, f"{yaw} {now}")


def check_space(page):
    write(page, "R(1turn @ 1 0 0 axis y) T(0 2 1)")
    settled(page)
    look = page.ask("location.hash")
    before = page.ask("document.querySelector('#stage .grip').getBoundingClientRect().x")
    x, y, wide, high = box(page, "#stage svg")
    drag(page, x - wide * 0.45, y + high * 0.4, (x - wide * 0.35, y + high * 0.45), (x - wide * 0.25, y + high * 0.4))
    settled(page)
    page.until(f"location.hash !== {json.dumps(look)}")
    verdict("the view is turned",
            page.ask("document.querySelector('#stage .grip').getBoundingClientRect().x") != before)
    verdict("and the string is not", field(page) == "R(1turn @ 1 0 0 axis y) T(0 2 1)", field(page))
    page.do("document.querySelector('#stage svg').focus()")
    at = page.ask("location.hash")
    page.key("ArrowLeft")
    page.until(f"location.hash !== {json.dumps(at)}")
    x, y, *_ = box(page, "[data-grip='0-axis'] .grip")
    drag(page, x, y, (x + 20, y), (x + 60, y + 5))
    axis = re.search(r"axis (\S+) (\S+) (\S+)\)", field(page))
    verdict("an axis is dragged", axis and (float(axis[1]), float(axis[3])) != (0, 0) and 0.3 < float(axis[2]) < 1,
            field(page))
    verdict("four rows of four", page.ask("document.querySelectorAll('#matrix td').length") == 16)
    verdict("methods are for the plane",
            "leaves the plane" in page.ask("document.getElementById('methods-none').innerText"))


def check_figures(page):
    page.until("document.querySelectorAll('.figures a').length >= 20")
    for theme in (False, True):
        page.show(dark=theme)
        name = "dark" if theme else "light"
        check_colours(page, name)
        for i in range(page.ask("document.querySelectorAll('.figures a').length")):
            text = page.ask(f"document.querySelectorAll('.figures a')[{i}].querySelector('code').innerText")
            page.do(f"document.querySelectorAll('.figures a')[{i}].click()")
            page.until("document.getElementById('wrong').hidden && scrollY === 0")
            settled(page)
            wrong = page.ask(faults)
            verdict(f"{text}, {name}", not wrong, wrong)
            if pictures:
                page.picture(f"{pictures}/figure-{i}-{name}.png")
    page.show(dark=False)


def check_address(page, browser):
    page.do("location.hash = '#m=' + encodeURIComponent('R(2turn) T(3 0)') + '&t=0.625&n=12&p=1,2;3,4,5'")
    page.until("document.getElementById('string').value === 'R(2turn) T(3 0)'")
    verdict("the address sets t", page.ask("document.documentElement.dataset.t") == "0.625")
    settled(page)
    verdict("and the steps", page.ask("document.getElementById('ways-caption').innerText").startswith("Counted for this string and 12 steps"))
    verdict("and the points", page.ask("document.querySelectorAll('#stage circle.path').length") == 4)
    again = browser.page(page.ask("location.href"), size=(1200, 900))
    again.until("document.documentElement.dataset.ready === 'yes'")
    verdict("a link opens the same",
            again.ask("document.getElementById('matrix').innerText") == page.ask("document.getElementById('matrix').innerText"))
    again.close()
    slide(page, 0.5)
    page.until("location.hash.includes('t=0.500')")
    slide(page, 0)
    page.click(*box(page, "#play")[:2])
    page.until("+document.documentElement.dataset.t > 0")
    page.do("document.activeElement.blur()")
    page.key(" ")
    verdict("the space bar halts", page.ask("document.getElementById('play').getAttribute('aria-label')") == "Play")
    page.do("location.hash = '#m=%E0%A4%A&t=7&p=x;&v=a,b&n=-1'")
    time.sleep(0.3)
    verdict("a broken address breaks nothing", field(page) == "R(2turn) T(3 0)" and not page.said, page.said)
    page.do("location.hash = '#m=R(1turn'")
    page.until("!document.getElementById('wrong').hidden")
    verdict("a wrong string of an address is told",
            "')' is missing" in page.ask("document.getElementById('wrong').innerText"))


def check_methods(page):
    write(page, "S(2 0.5 @ 1 1) R(180deg)")
    settled(page)
    rows = page.ask("document.getElementById('ways').innerText")
    verdict("what methods cost",
            "8Np + 27" in rows and "Refuses: the geometric method" in rows and "geometric, linear law" in rows, rows)
    verdict("other ways", page.ask("document.querySelectorAll('#paths .way').length") == 2
            and not page.ask("document.getElementById('no-root').hidden"))
    page.until("'measured' in document.documentElement.dataset", 60)
    verdict("what they lose", page.ask("document.querySelectorAll('#losses tr').length") == 3
            and page.ask("document.querySelectorAll('#drifts svg').length") == 2)


def check_silent(browser, folder):
    with open(f"{folder}/none.js", "w") as out:
        out.write("globalThis.Betwixt = { engine: () => Promise.reject(new Error('this browser has no WebAssembly')) };\n")
    path = f"{folder}/silent.html"
    subprocess.run([program, "algebra", "--lesson", path, "R(1turn)"],
            env={**os.environ, "BETWIXT_PLAYER": f"{folder}/none.js"}, check=True)
    page = browser.page(f"file://{path}")
    page.until("!document.getElementById('silent').hidden")
    words = page.ask("document.getElementById('silent').innerText")
    verdict("without an engine it says so", "this browser has no WebAssembly" in words and "R(1turn)" in words, words)
    verdict("and shows no empty pictures", page.ask("document.querySelectorAll('svg.picture').length") == 0)
    page.close()


with tempfile.TemporaryDirectory() as folder, Browser(webgl=False) as browser:
    page = open_lesson(browser, folder, strings[0], "--points", "1,0", size=(1200, 900))
    same_numbers(page)
    for part in (check_typing, check_swapping, check_dragging, check_touch, check_space, check_methods, check_figures):
        part(page)
        verdict(f"{part.__name__} says nothing wrong", not page.said, page.said)
    check_address(page, browser)
    page.close()
    check_standing(browser, folder)
    check_silent(browser, folder)
done()
