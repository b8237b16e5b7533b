# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares flat films with their exports, pixel by pixel: Lottie drawn by rlottie and by lottie-web, SVG drawn by a
# browser.
#   drawings.py PROGRAM FOLDER [NAME|FILM.bx…]   the variable DRAWINGS_OUT=FOLDER keeps all pictures side by side
import os, random, shutil, subprocess, sys, tempfile

here = os.path.dirname(os.path.abspath(__file__))
root = os.environ.get("ROOT", os.path.dirname(os.path.dirname(here)))
program, modules, wanted = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3:]
browser = next(filter(shutil.which, [os.environ.get("BROWSER", ""), "chromium", "chromium-browser", "google-chrome"]), None)
width, height = 640, 360
# Limits in per cent of the pixels. A pixel counts if it is neither the film's pixel nor between its neighbours. Lines
# thinner than a pixel differ along their length: Betwixt blends them in linear light, players as bytes. rlottie draws
# strokes with a constant width where a scale stretches them.
most_off = {"fourier": 0.25, "sine": 0.1}
most_off_otherwise, most_off_in_random_by_rlottie = 0.025, 0.2
passed = failed = 0

try:
    import numpy as np
except ImportError:
    sys.exit(print("left out: there is no python3-numpy\n0 passed, 0 failed"))


def run(*words, **more):
    done = subprocess.run(words, capture_output=True, **more)
    if done.returncode != 0:
        raise RuntimeError(f"{words}: {done.stderr.decode(errors='replace')[-600:]}")
    return done.stdout


def pixels_of(png, rows=height):
    raw = run("ffmpeg", "-v", "error", "-i", png, "-f", "rawvideo", "-pix_fmt", "rgb24", "-")
    return np.frombuffer(raw, np.uint8).reshape(-1, width, 3)[: rows].astype(np.int16)


# Returns the share of pixels that are neither the other picture's pixel nor between that picture's neighbouring pixels.
def off(picture, other, slack=26):
    padded = np.pad(other, ((1, 1), (1, 1), (0, 0)), mode="edge")
    around = np.stack([padded[y : y + height, x : x + width] for y in range(3) for x in range(3)])
    bad = (picture < around.min(0) - slack) | (picture > around.max(0) + slack)
    return bad.any(axis=2).mean()


def film_pictures(film, frames, folder):
    out = []
    for f in frames:
        run(program, "frame", film, "--at", f"{f + 1}f", "--size", f"{width}x{height}", "--samples", "4", "-o", f"{folder}/film{f}.png")
        out.append(pixels_of(f"{folder}/film{f}.png"))
    return out


def lottie_pictures(film, span, frames, folder):
    run(program, "export", film, "--frames", span, "-o", folder + "/film.json")
    raw = run(folder + "/lottie", folder + "/film.json", str(width), str(height), *map(str, frames))
    all = np.frombuffer(raw, np.uint8).reshape(len(frames), height, width, 4).astype(np.int16)
    return [picture[:, :, 2::-1] for picture in all]


# Renders all times in one page, one below the other.
def shot(page, count, folder):
    open(folder + "/page.html", "w").write(page)
    run("timeout", "200", browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--force-color-profile=srgb",
        "--force-device-scale-factor=1", f"--user-data-dir={folder}/profile", "--virtual-time-budget=3000",
        f"--window-size={width},{height * count + 200}", f"--screenshot={folder}/page.png", f"file://{folder}/page.html")
    whole = pixels_of(folder + "/page.png", height * count)
    return [whole[i * height : (i + 1) * height] for i in range(count)]


def lottie_web_pictures(film, span, frames, folder):
    run(program, "export", film, "--frames", span, "-o", folder + "/film.json")
    places = "".join(f'<div style="width:{width}px;height:{height}px"></div>' for _ in frames)
    player = open(modules + "/node_modules/lottie-web/build/player/lottie.min.js").read()
    return shot(f"""<!DOCTYPE html><meta charset="utf-8"><style>body{{margin:0;background:#000}}</style>{places}
<script>{player}</script><script>
const film = {open(folder + "/film.json").read()}, frames = {frames};
[...document.querySelectorAll("div")].forEach((container, i) => {{
  const played = lottie.loadAnimation({{ container, renderer: "svg", autoplay: false, loop: false, animationData: structuredClone(film) }});
  played.addEventListener("DOMLoaded", () => played.goToAndStop(frames[i], true));
  played.goToAndStop(frames[i], true);
}});</script>""", len(frames), folder)


def svg_pictures(film, span, frames, rate, folder):
    run(program, "export", film, "--frames", span, "-o", folder + "/film.svg")
    svg = open(folder + "/film.svg").read().replace("<svg ", f'<svg preserveAspectRatio="none" style="display:block" ', 1)
    page = "".join(svg.replace("width=", f'width="{width}" height="{height}" data-width=', 1).replace(" height=", " data-height=", 2)
                   .replace(" data-height=", " height=", 1).replace(".background", f".background{f}") for f in frames)
    moments = ",".join(str(f / rate) for f in frames)
    return shot(f"""<!DOCTYPE html><meta charset="utf-8"><style>body{{margin:0;background:#000}}</style>
{page}<script>addEventListener("load", () => {{
  const times = [{moments}];
  [...document.querySelectorAll("svg")].forEach((svg, i) => {{ svg.pauseAnimations(); svg.setCurrentTime(times[i]); }});
}});</script>""", len(frames), folder)


# Returns a film of a few objects with random numbers.
def random_film(seed):
    r = random.Random(seed)
    at = lambda: f"({r.uniform(-6, 6):.2f} {r.uniform(-3.5, 3.5):.2f} {r.choice([-2, -1, 0, 1, 2]) + r.random() * 0.9:.2f})"
    ease = lambda: r.choice(["linear", "smooth", "hold", "ease-in-out", "sine-in-out", "back-out"])
    color = lambda: f"#{r.randrange(1 << 24):06x}"
    out = ["film flat", f"background {color()}", "size 640x360", "range 1f 49f"]
    for i in range(9):
        kind = r.choice(["circle radius=0.6", "rectangle size=(1.6 1)", "star points=5 radius=0.8 inner=0.4", "ring radius=0.8 inner=0.5",
                         "regular sides=6 radius=0.7", "arc radius=0.7 width=0.2 from=0deg to=250deg",
                         "curve points=((-1 0) (0 1) (1 -0.5)) width=0.12", "text text=\"word\" size=0.8", "line to=(2 1 0) width=0.1"])
        name = f"thing{i}"
        out.append(f"create {name} {kind} color={color()}")
        word = kind.split()[0]
        if word in ("circle", "rectangle", "star", "regular") and r.random() < 0.5:
            out.append(f"set {name}.stroke {color()}"), out.append(f"set {name}.stroke-width {r.uniform(0.05, 0.25):.2f}")
            if r.random() < 0.5: out.append(f"set {name}.fill off")
        trims = ("arc", "curve", "line") if not any(name + ".stroke " in line for line in out) else ("circle", "rectangle", "star", "regular", "arc", "curve", "line")
        if word in trims and r.random() < 0.7:
            a = sorted(round(r.random(), 2) for _ in range(4))
            out.append(f"{name}.trim\n  1f ({a[0]} {a[1]}) {r.choice(['linear', 'smooth'])}\n  30f ({a[0]} {a[2]}) linear\n  49f ({a[1]} {a[3]})")
        rows = [f"  {f}f {at()} {ease()}" for f in sorted(r.sample(range(1, 49), 3))]
        out.append(f"{name}.position\n" + "\n".join(rows))
        if r.random() < 0.5: out.append(f"{name}.rotation.z\n  1f 0deg {ease()}\n  49f {r.randrange(-400, 400)}deg")
        if r.random() < 0.3: out.append(f"{name}.scale\n  1f (1 1 1) {ease()}\n  49f ({r.uniform(0.5, 1.6):.2f} {r.uniform(0.5, 1.6):.2f} 1)")
        if word in ("circle", "star", "regular") and r.random() < 0.5: out.append(f"{name}.radius\n  1f 0.4 {ease()}\n  40f 1.1")
        if word == "rectangle" and r.random() < 0.5: out.append(f"{name}.size\n  1f (1 1) smooth\n  40f (2 0.5)")
        if r.random() < 0.3: out.append(f"{name}.color\n  1f {color()} linear\n  49f {color()}")
        if r.random() < 0.2: out.append(f"at {r.randrange(2, 40)}f hide {name}")
    return "\n".join(out) + "\n"


def check(name, film, last, rate, folder):
    global passed, failed
    frames = [0, last // 3, 2 * last // 3, last - 1, last]
    span = f"1f..{last + 1}f"
    own = film_pictures(film, frames, folder)
    ways = {}
    if os.path.exists(folder + "/lottie"): ways["Lottie in rlottie"] = lambda: lottie_pictures(film, span, frames, folder)
    if browser and os.path.isdir(modules + "/node_modules/lottie-web"):
        ways["Lottie in lottie-web"] = lambda: lottie_web_pictures(film, span, frames, folder)
    if browser: ways["SVG"] = lambda: svg_pictures(film, span, frames, rate, folder)
    rows = [own]
    for way, pictures in ways.items():
        try:
            theirs = pictures()
        except RuntimeError as error:
            failed += 1
            print(f"FAILED {name} as {way}: {error}")
            continue
        rows.append(theirs)
        shares = [max(off(a, b), off(b, a)) for a, b in zip(theirs, own)]
        most = most_off.get(name, most_off_otherwise)
        if name.startswith("random") and "rlottie" in way: most = most_off_in_random_by_rlottie
        good = 100 * max(shares) <= most
        passed, failed = passed + good, failed + (not good)
        print(f"{'' if good else 'FAILED '}{name} as {way}: {100 * max(shares):.3f} % of the pixels are others (" +
              ", ".join(f"{f + 1}f {100 * s:.3f}" for f, s in zip(frames, shares)) + ")")
    if keep := os.environ.get("DRAWINGS_OUT"):
        os.makedirs(keep, exist_ok=True)
        sheet = np.concatenate([np.concatenate(row, 0) for row in rows], 1).astype(np.uint8)
        run("ffmpeg", "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{sheet.shape[1]}x{sheet.shape[0]}", "-i", "-",
            f"{keep}/{os.path.basename(name)}.png", input=sheet.tobytes())


with tempfile.TemporaryDirectory() as folder:
    if os.path.exists("/usr/include/rlottie_capi.h"):
        run("cc", "-O1", "-DPICTURES", here + "/lottie.c", "-o", folder + "/lottie", "-lrlottie")
    if not browser and not os.path.exists(folder + "/lottie"):
        sys.exit(print("left out: there is neither rlottie (librlottie-dev) nor a browser\n0 passed, 0 failed"))
    # With its last frame and its rate; only a part of a film with much code.
    films = {"drawings": (here + "/drawings.bx", 48, 24)}
    for name, last in {"fourier": 120, "lighthouse": 96, "race": 12, "sine": 100, "spirograph": 120, "swarm": 48}.items():
        films[name] = (f"{root}/examples/{name}.bx", last, 24)
    for seed in range(1, 9):
        path = f"{folder}/random{seed}.bx"
        open(path, "w").write(random_film(seed))
        films[f"random{seed}"] = (path, 48, 24)
    for path in wanted:
        if path.endswith(".bx"): films[path] = (path, 24, 24)
    for name, (film, last, rate) in films.items():
        if not wanted or name in wanted: check(name, film, last, rate, folder)
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
