# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares exported CSS, element.animate() and SVG in a browser with the film, in pixels.
#   web.py PROGRAM     the variable BROWSER=PROGRAM names another browser than chromium
import html, json, math, os, random, re, shutil, subprocess, sys, tempfile

program = os.path.abspath(sys.argv[1])
browser = next(filter(shutil.which, [os.environ.get("BROWSER", ""), "chromium", "chromium-browser", "google-chrome"]), None)
if not browser:
    print("left out: there is no browser (apt-get install chromium)\n0 passed, 0 failed")
    sys.exit()
film = os.path.join(os.path.dirname(os.path.abspath(__file__)), "flat.bx")
objects = ["ball", "arm/bar", "arm/tip", "bounced", "turner", "blink"]
pixels, seconds = 360 / 9, 3.0
most = 0.05  # pixels, at a point 20 px from the centre of an object
rand = random.Random(3)
times = [seconds * rand.random() for _ in range(60)]


def run(*words):
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{words}: {done.stderr}")
    return done.stdout


said = json.loads(run(program, "eval", film, "--at", ",".join(f"{t:.9f}s" for t in times), "--json",
                      *[name + ".world" for name in objects]))


def wanted(frame, name):  # a, b, c, d, e, f on a page
    m = frame["values"][name + ".world"]
    m = [x for row in m for x in row] if isinstance(m[0], list) else m
    return [m[0], -m[4], -m[1], m[5], m[3] * pixels, -m[7] * pixels]


with tempfile.TemporaryDirectory() as folder:
    for end in ("css", "js", "svg"):
        run(program, "export", film, *objects, "-o", f"{folder}/film.{end}")
    plain = [name.replace("/", "-") for name in objects]
    boxes = lambda kind: "".join(f'<div id="{kind}-{n}" class="{n if kind == "css" else ""}" style="position:absolute"></div>'
                                 for n in plain)
    page = f"""<!DOCTYPE html><meta charset="utf-8"><style>{open(folder + "/film.css").read()}</style>
{boxes("css")}{boxes("js")}{open(folder + "/film.svg").read()}
<script type="module">
{open(folder + "/film.js").read()}
const names = {json.dumps(objects)}, times = {json.dumps(times)}, out = [];
for (const name of names) play(document.getElementById("js-" + name.replace("/", "-")), name);
onerror = (e) => document.body.append(e);
// The time of an SVG picture begins when the page is loaded.
await new Promise((done) => (document.readyState === "complete" ? done() : addEventListener("load", done)));
await new Promise((done) => setTimeout(done, 50));
const svg = document.querySelector("svg");
svg.pauseAnimations();
const numbers = (m) => [m.a, m.b, m.c, m.d, m.e, m.f];
for (const t of times) {{
  for (const a of document.getAnimations()) a.pause(), a.currentTime = 1000 * t;
  svg.setCurrentTime(t);
  const row = {{}};
  for (const name of names) {{
    const plain = name.replace("/", "-");
    const of = (id) => {{
      const list = document.getElementById(id).computedStyleMap().get("transform");
      return numbers(list.toMatrix ? list.toMatrix() : new DOMMatrix());
    }};
    const g = svg.getScreenCTM().inverse().multiply(document.getElementById(plain).getScreenCTM());
    row[name] = {{ css: of("css-" + plain), js: of("js-" + plain), svg: numbers(g) }};
  }}
  out.push(row);
}}
document.body.innerHTML = "";
const pre = document.createElement("pre");
pre.id = "answers";
pre.textContent = JSON.stringify(out) + " the end";
document.body.append(pre);
</script>"""
    open(folder + "/page.html", "w").write(page)
    dom = run("timeout", "120", browser, "--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
              "--allow-file-access-from-files", "--virtual-time-budget=5000", "--dump-dom", f"file://{folder}/page.html")
found = re.search(r'<pre id="answers">(.*) the end', dom, re.S)
if not found:
    sys.exit("the page said nothing: " + dom[-2000:])
answers = json.loads(html.unescape(found[1]))
passed = failed = 0
for kind in ("css", "js", "svg"):
    for name in objects:
        worst = 0
        for frame, answer in zip(said["times"], answers):
            a, b = wanted(frame, name), answer[name][kind]
            for x, y in ((0, 0), (20, 0), (0, 20)):
                p, q = ([m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5]] for m in (a, b))
                worst = max(worst, math.hypot(p[0] - q[0], p[1] - q[1]))
        if worst <= most:
            passed += 1
        else:
            failed += 1
        print(f"{'' if worst <= most else 'FAILED '}{kind} {name}: within {worst:.4f} px")
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
