# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares every example in a page with the program: pictures with a PSNR of at least 38 dB, because pages smooth the
# edges of thin lines in another way; and the values of all objects at random times, letter by letter as
# `betwixt eval --json` prints them. Skipped if the player is not built.
#   examples_test.py PROGRAM [FILM…]     the variable LOOK=FOLDER keeps the pictures
import base64, glob, math, os, random, subprocess, sys, tempfile
from browser import Browser, Served
from checks import check, done, player, root, same, there_is_a_player

program = os.path.abspath(sys.argv[1])
there_is_a_player()
wide, high = 1280, 720
rand = random.Random(7)
scratch = tempfile.TemporaryDirectory()
keep = os.environ.get("LOOK")


def run(*words):
    answer = subprocess.run([program, *words], capture_output=True)
    if answer.returncode != 0:
        raise RuntimeError(answer.stderr.decode())
    return answer.stdout


def drawn(film, frame):  # rgb
    name = f"{keep or scratch.name}/{os.path.basename(film)[:-3]}-{frame}.png"
    run("frame", film, "--at", f"{frame}f", "-o", name, "--size", f"{wide}x{high}", "--subframes", "1")
    return subprocess.run(["ffmpeg", "-v", "error", "-i", name, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                          capture_output=True, check=True).stdout


def decibels(a, b):
    square = sum((x - y) ** 2 for x, y in zip(a, b)) / len(a)
    return 99 if square == 0 else 10 * math.log10(255 ** 2 / square)


script = f"""window.canvas = document.createElement("canvas"); canvas.width = {wide}, canvas.height = {high}; document.body.append(canvas);
  window.flat = document.createElement("canvas"); flat.width = {wide}, flat.height = {high};
  window.get = async (path) => {{ const r = await fetch("/examples/" + path); if (!r.ok) throw new Error(path + ": " + r.status); return r; }};
  window.show = async (name) => {{
    const engine = await Betwixt.engine(), text = await (await get(name)).text(), files = {{}};
    const bold = new Uint8Array(await (await fetch("/fonts/DejaVuSans-Bold.ttf")).arrayBuffer());
    if (/weight=bold|\\btable\\b/.test(text)) files["DejaVuSans-Bold.ttf"] = bold;
    await engine.prepare(files, text);
    if (window.film) film.dispose();
    window.film = engine.open(text, {{ name, files }});
    for (let i = 0; i < 20 && film.wants.length; ++i) {{
      for (const path of film.wants) files[path] = new Uint8Array(await (await get(path)).arrayBuffer());
      await engine.prepare(files, text);
      film.dispose(), window.film = engine.open(text, {{ name, files }});
    }}
    return film.ok ? {{ firstFrame: film.firstFrame, lastFrame: film.lastFrame }} : film.message;
  }};
  window.pixels = (seconds) => {{ film.draw(canvas, seconds); const k = flat.getContext("2d", {{ willReadFrequently: true }});
    k.clearRect(0, 0, {wide}, {high}); k.drawImage(canvas, 0, 0); const all = k.getImageData(0, 0, {wide}, {high}).data;
    let text = ""; for (let i = 0; i < all.length; i += 4) text += String.fromCharCode(all[i], all[i + 1], all[i + 2]); return btoa(text); }};"""

films = [f"{root}/examples/{name}.bx" for name in sys.argv[2:]] or sorted(glob.glob(f"{root}/examples/*.bx"))
films = [film for film in films if not film.endswith("/cinema.bx")]  # betwixt web gives pages the pictures of videos: video_test.py
worst = (999, "")
os.symlink(f"{root}/examples", f"{scratch.name}/examples")
os.symlink("/usr/share/fonts/truetype/dejavu", f"{scratch.name}/fonts")
os.symlink(os.path.abspath(player), f"{scratch.name}/player.js")
with open(f"{scratch.name}/page.html", "w") as out:
    out.write('<!DOCTYPE html><meta charset="utf-8"><body><script src="player.js"></script>')
with Browser() as browser, Served(scratch.name) as served:
    page = browser.page(f"{served}/page.html")
    page.do(script)
    for path in films:
        name = os.path.basename(path)
        try:
            about = page.ask(f"show({name!r})", patience=120)
            if not check(f"{name} is opened", isinstance(about, dict), about):
                continue
            first, last = round(about["firstFrame"]), round(about["lastFrame"])
            for frame in {(2 * first + last) // 3, (first + 2 * last) // 3}:
                seconds = page.ask(f"({frame} - 1) / film.fps")
                shown = base64.b64decode(page.ask(f"pixels({seconds!r})", patience=120))
                alike = decibels(shown, drawn(path, frame))
                worst = min(worst, (alike, f"{name} at {frame}f"))
                if keep:
                    with open(f"{keep}/{name[:-3]}-{frame}.ppm", "wb") as out:
                        out.write(b"P6 %d %d 255\n" % (wide, high) + shown)
                check(f"{name} at {frame}f looks as it does elsewhere", alike >= 38, f"{alike:.1f} dB")
            times = ",".join(f"{rand.uniform(first, last):.6f}f" for _ in range(5))
            wanted = run("eval", path, "--at", times, "--json").decode().strip()
            found = page.ask(f"film.evalAll([], {times.split(',')!r}, {{ text: true }})", patience=120)
            if found != wanted:
                at = next((i for i, (a, b) in enumerate(zip(found, wanted)) if a != b), min(len(found), len(wanted)))
                check(f"{name} has the same values", False, f"{found[max(0, at - 60):at + 60]} instead of {wanted[max(0, at - 60):at + 60]}")
            else:
                check(f"{name} has the same values", True)
        except Exception as e:
            check(name, False, e)
    page.close()
print(f"least alike: {worst[1]}, {worst[0]:.1f} dB", file=sys.stderr)
done()
