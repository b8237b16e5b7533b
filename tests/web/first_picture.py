# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Measures the time from opening pages of `betwixt web`, in turns, to their first pictures. The browser has started
# before, and knows no shader yet. Prints for each stage the least and the median of the times since the page was asked
# for, in milliseconds.
#   first_picture.py COUNT PAGE.html…
import os, statistics, sys, time
from browser import Browser

# `drawn` waits until the graphics have finished: calls of WebGL return before anything is drawn.
marks = """
window.marks = {}; const mark = (name) => { marks[name] ??= performance.now(); };
mark("the page begins");
addEventListener("DOMContentLoaded", () => mark("the page is read"));
const compile = WebAssembly.instantiate;
WebAssembly.instantiate = async function (...all) { mark("engine unpacked"); const made = await compile.apply(this, all); mark("engine compiled"); return made; };
const get = OffscreenCanvas.prototype.getContext;
OffscreenCanvas.prototype.getContext = function (...all) { const made = get.apply(this, all); mark("context"); window.graphics ??= made; return made; };
const { linkProgram } = WebGL2RenderingContext.prototype;
WebGL2RenderingContext.prototype.linkProgram = function (...all) { mark("first shader"); return linkProgram.apply(this, all); };
for (const name of ["drawArrays", "drawElementsInstanced", "drawArraysInstanced"]) {
  const draw = WebGL2RenderingContext.prototype[name];
  WebGL2RenderingContext.prototype[name] = function (...all) { mark("first drawing"); return draw.apply(this, all); };
}
const take = OffscreenCanvas.prototype.transferToImageBitmap;
OffscreenCanvas.prototype.transferToImageBitmap = function () {
  mark("all drawings given");
  if (!marks["drawn"]) graphics.readPixels(0, 0, 1, 1, graphics.RGBA, graphics.UNSIGNED_BYTE, new Uint8Array(4));
  mark("drawn");
  return take.call(this);
};
"""
count, pages = int(sys.argv[1]), sys.argv[2:]
times = {name: [] for name in pages}
for _ in range(count):
    for name in pages:
        with Browser(*os.environ.get("FLAGS", "").split()) as browser:
            page = browser.page(size=(1200, 800))
            time.sleep(2)
            page.call("Page.addScriptToEvaluateOnNewDocument", source=f"{{{marks}}}")
            page.go("file://" + os.path.abspath(name))
            page.until("window.marks.drawn")
            times[name].append(page.ask("marks"))
for name in pages:
    print(f"{name}: {os.path.getsize(name)} bytes")
    of = {stage: [t[stage] for t in times[name]] for stage in times[name][0]}
    for stage in sorted(of, key=lambda stage: statistics.median(of[stage])):
        print(f"  {stage:20}{min(of[stage]):6.0f}{statistics.median(of[stage]):6.0f}")
