# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Measures how evenly the imaging server makes frames. pacing.sh describes this and calls it."""

import os
import signal
import subprocess
import sys
import tempfile
import time

from betwixt_client import Server

RATE = 120
SCRIPT = """rate 120
ticks 120
create box box
create eye camera position=(0 0 10)
set box.environments (spin)
animate spin every 1t by rotate(10deg, z)
"""
HOST = """
import sys, time
from betwixt_client import Server
server = Server(sys.argv[1])
server.do("subscribe frames")
print("ready", flush=True)
while True:
    server.do("set box.color red")
    time.sleep(0.01)
"""
# The loop of a program that animates by itself: at each frame it sends the place of the box and asks for the result.
LOOP = """
import sys, time
from betwixt_client import Server
server, rate, frames = Server(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
begun, late, missed, k = time.monotonic() + 0.1, [], 0, 0
while k < frames:
    now = time.monotonic()
    if now < begun + k / rate:
        time.sleep(begun + k / rate - now)
    server.do(f"set box.rotation (0deg 0deg {10 * k % 360}deg)")
    server.eval("box.world")
    by = time.monotonic() - (begun + k / rate)
    late.append(by)
    missed += by >= 1 / rate
    following = max(k + 1, int((time.monotonic() - begun) * rate) + 1)
    missed += min(following, frames) - (k + 1)
    k = following
late.sort()
at = lambda part: late[min(len(late) - 1, int(part * len(late)))] * 1e6
print(missed, at(0.5), at(0.99), late[-1] * 1e6)
"""


def row(what, frames, missed, p50, p99, largest):
    print(f"{what:34} {frames:>8} {missed:>8} {p50:>10.1f} {p99:>10.1f} {largest:>10.1f}", flush=True)


class Serving:
    def __init__(self, program, folder, priority):
        self.socket, script = os.path.join(folder, "s"), os.path.join(folder, "box.bx")
        with open(script, "w") as f:
            f.write(SCRIPT)
        self.process = subprocess.Popen(
            [program, "serve", script, "--socket", self.socket, "--rate", str(RATE), "--class", priority],
            stderr=subprocess.PIPE, text=True)
        self.said = self.process.stderr.readline().strip()

    def __enter__(self):
        return self

    def __exit__(self, *why):
        self.process.terminate()
        self.process.communicate()


def paced(program, folder, priority, frames):
    """Measures the server's own clock. A host starts the motion and is stopped (SIGSTOP). The statistics are read at
    the end."""
    with Serving(program, folder, priority) as serving:
        host = subprocess.Popen([sys.executable, "-c", HOST, serving.socket], stdout=subprocess.PIPE, text=True)
        host.stdout.readline()
        time.sleep(0.5)
        os.kill(host.pid, signal.SIGSTOP)
        with Server(serving.socket) as server:
            first = server.stats()
            while (now := server.stats())["frames_due"] - first["frames_due"] < frames:
                time.sleep(min(5, max(0.05, (frames - now["frames_due"] + first["frames_due"]) / RATE)))
        host.kill()
        host.wait()
        due, missed = (now[k] - first[k] for k in ("frames_due", "frames_missed"))
        row(f"server, {now['class']}", due, missed, now["late_p50_us"], now["late_p99_us"], now["late_max_us"])
        if now["class"] != priority:
            print(f"  the class {priority} was requested: {serving.said}")


def driven(program, folder, frames, stopped):
    """Measures the host's loop. With `stopped`, the host is stopped for a second in the middle."""
    with Serving(program, folder, "ordinary") as serving:
        loop = subprocess.Popen([sys.executable, "-c", LOOP, serving.socket, str(RATE), str(frames)],
                                stdout=subprocess.PIPE, text=True)
        if stopped:
            time.sleep(frames / RATE / 2)
            os.kill(loop.pid, signal.SIGSTOP)
            time.sleep(1)
            os.kill(loop.pid, signal.SIGCONT)
        missed, *late = (float(x) for x in loop.communicate()[0].split())
        row("host's loop" + (", stopped for 1 s" if stopped else ""), frames, int(missed), *late)


def main():
    program, frames = sys.argv[1], int(sys.argv[2])
    print(f"{os.cpu_count()} processors, 4 busy processes, {RATE} Hz; lateness in microseconds\n")
    print(f"{'':34} {'due':>8} {'missed':>8} {'p50':>10} {'p99':>10} {'max':>10}")
    busy = [subprocess.Popen(["sh", "-c", "while :; do :; done"]) for _ in range(4)]
    try:
        for priority in ("fifo", "nice", "ordinary"):
            with tempfile.TemporaryDirectory() as folder:
                paced(program, folder, priority, frames)
        for stopped in (False, True):
            with tempfile.TemporaryDirectory() as folder:
                driven(program, folder, min(frames, 2400), stopped)
    finally:
        for b in busy:
            b.kill()


main()
