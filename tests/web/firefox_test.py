# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests a page in Firefox: it plays, seeks and plays backwards, with the same pictures. The page itself reports the
# results. If the variable PICTURE is set, a screenshot goes to that file. Firefox has no WebGL without a display, so it
# gets a virtual one (Xvfb). Skipped if Firefox is not installed.
#   firefox_test.py PROGRAM
import json, os, shutil, subprocess, sys, tempfile, threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from checks import check, done, player, root, same

program = os.path.abspath(sys.argv[1])
firefox = shutil.which("firefox-esr") or shutil.which("firefox")
for there, words in ((firefox and shutil.which("Xvfb"), "there is no Firefox, or no Xvfb (apt-get install firefox-esr xvfb)"),
                     (os.path.exists(player), "what plays is not built (./betwixt web)")):
    if not there:
        print(f"left out: {words}\n0 passed, 0 failed")
        sys.exit()
ball = "# a ball\nrate 24\nrange 1f 48f\nsize 320x180\nfilm flat\ncreate ball circle radius=3 color=red\nball.position\n  1f (0 0 0) linear\n  25f (4 0 0)\n"
asks = """<script>(async () => {
  const p = document.querySelector("betwixt-player"), out = { log: [] };
  const until = (name) => new Promise((r) => p.addEventListener(name, r, { once: true }));
  const pixel = () => { const c = p.shadowRoot.querySelector("canvas"), d = document.createElement("canvas"); d.width = c.width, d.height = c.height;
    const k = d.getContext("2d"); k.drawImage(c, 0, 0); return [...k.getImageData(c.width / 2, c.height / 2, 1, 1).data].slice(0, 3); };
  const drawn = async () => { for (let i = 0; i < 100 && !p.getVideoPlaybackQuality().totalVideoFrames; ++i) await new Promise((r) => setTimeout(r, 50)); };
  for (const n of ["loadstart", "loadedmetadata", "canplay", "seeking", "seeked", "play", "playing", "pause", "ended", "error"])
    p.addEventListener(n, () => out.log.push(n));
  try {
    if (p.readyState < 4) await until("canplaythrough");
    p.pause(); p.currentTime = 0; await until("seeked"); await drawn(); out.first = pixel();
    p.currentTime = 1; await until("seeked"); out.second = pixel(); out.value = p.film.eval("ball.position", 0.5, { text: true });
    p.playbackRate = -1; await p.play(); await until("timeupdate"); out.back = p.currentTime < 1; p.pause();
    p.playbackRate = 4; p.currentTime = 1.5; p.loop = false; p.play(); await until("ended"); out.ended = [p.ended, p.currentTime];
    p.script = "create ball\\n  wrong\\n"; out.wrong = p.message;
    p.script = p.querySelector("script").textContent; p.currentTime = 0; await until("seeked");
  } catch (e) { out.thrown = String(e); }
  out.message = p.shadowRoot.querySelector("[part=message]").innerText;
  await fetch("/said", { method: "POST", body: JSON.stringify(out) });
})();</script>"""

with tempfile.TemporaryDirectory() as folder:
    open(f"{folder}/ball.bx", "w").write(ball)
    made = subprocess.run([program, "web", "ball.bx", "-o", "ball.html"], cwd=folder, capture_output=True, text=True, env={**os.environ, "BETWIXT_PLAYER": player})
    if made.returncode != 0:
        sys.exit(made.stderr)
    page = open(f"{folder}/ball.html", encoding="utf-8").read().replace("</body>", asks + "</body>").encode()
    said, heard = {}, threading.Event()

    class Serves(BaseHTTPRequestHandler):
        def do_GET(self):
            self.send_response(200)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.end_headers()
            self.wfile.write(page if self.path == "/" else b"")

        def do_POST(self):
            said.update(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
            self.send_response(204)
            self.end_headers()
            heard.set()

        def log_message(self, *_):
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Serves)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    os.mkdir(f"{folder}/profile")
    with open(f"{folder}/profile/user.js", "w") as prefs:  # also with software rendering
        prefs.write('user_pref("webgl.force-enabled", true);\n')
    number, told = os.pipe()
    screen = subprocess.Popen(["Xvfb", "-displayfd", str(told), "-screen", "0", "1300x900x24", "-nolisten", "tcp"], pass_fds=[told],
                              stderr=subprocess.DEVNULL)
    os.close(told)
    display = ":" + os.read(number, 16).decode().strip()
    window = subprocess.Popen([firefox, "--no-remote", "--profile", f"{folder}/profile", "--kiosk", f"http://127.0.0.1:{server.server_port}/"],
                              env={**os.environ, "DISPLAY": display}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    heard.wait(120)
    if picture := os.environ.get("PICTURE"):
        subprocess.run(["ffmpeg", "-v", "error", "-y", "-f", "x11grab", "-video_size", "1300x900", "-i", display, "-frames:v", "1", picture])
    for process in (window, screen):
        process.terminate()
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
    server.shutdown()

same("nothing is thrown", [said.get("thrown"), said.get("message")], [None, ""])
same("the first picture", said.get("first"), [255, 0, 0])
check("another one a second later", said.get("second") not in (None, [255, 0, 0]), said.get("second"))
same("a value", said.get("value"), subprocess.run([program, "eval", "--at", "0.5s", "/dev/stdin", "ball.position"], input=ball, capture_output=True, text=True).stdout.split(maxsplit=1)[-1].strip())
same("backwards", said.get("back"), True)
same("the end", said.get("ended"), [True, 2])
check("a wrong text is said", "^" in said.get("wrong", ""), said.get("wrong"))
done()
