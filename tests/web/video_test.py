# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests videos in pages: at each frame a page shows the picture that the program shows. The pictures say their own
# numbers: a column for each bit, white or black. Skipped if the player is not built.
#   video_test.py PROGRAM
import os, subprocess, sys, tempfile
from browser import Browser
from checks import done, player, same, there_is_a_player

program = os.path.abspath(sys.argv[1])
there_is_a_player()
with tempfile.TemporaryDirectory() as folder:
    subprocess.run(["ffmpeg", "-v", "error", "-f", "lavfi", "-i", "color=black:size=128x64:rate=24", "-frames:v", "100", "-vf",
                    "geq=lum='235*mod(floor(N/pow(2,floor(X/16))),2)':cb=128:cr=128", "-pix_fmt", "yuv420p", "-c:v", "libx264",
                    "-bf", "3", "code.mp4"], cwd=folder, check=True)
    with open(f"{folder}/film.bx", "w") as script:
        script.write("film flat\nrate 24\nsize 128x64\nrange 1f..90f\ncreate eye camera position=(0 0 10) height=2\n"
                     'create clip video file="code.mp4" at=12f height=2\n')
    subprocess.run([program, "web", "film.bx", "-o", "film.html"], cwd=folder, check=True, capture_output=True,
                   env={**os.environ, "BETWIXT_PLAYER": player})
    with Browser() as browser:
        page = browser.page()
        page.go(f"file://{folder}/film.html")
        page.do("""window.p = document.querySelector("betwixt-player"); window.shown = (frame) => {
            const c = new OffscreenCanvas(128, 64), d = new OffscreenCanvas(128, 64), k = d.getContext("2d"); let n = 0;
            p.film.draw(c, (frame - 1) / 24), k.drawImage(c, 0, 0);
            for (let i = 0; i < 8; ++i) if (k.getImageData(16 * i + 8, 32, 1, 1).data[0] > 127) n |= 1 << i;
            return n; };""")
        page.until("p.readyState === 4")
        for frame in (1, 12, 13, 60, 59, 58, 90, 14, 30):
            same(f"frame {frame}", page.ask(f"shown({frame})"), max(0, frame - 12))
done()
