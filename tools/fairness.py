#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Measures how long other hosts wait while one host sends hostile lines.

    tools/fairness.py [--program PROGRAM] [--seconds N] [CASE…]

For each case it starts a server and prepares the film. Four polite hosts ask every 5 ms: `time`, a line with a quoted
text, a line with a pattern, and `set x.position`. They ask first alone, then while a hostile host sends its lines. The
report gives the slowest answer of each polite host in both phases, how long the hostile lines took, the peak memory of
the server, and how long the server took to end after SIGTERM while the hostile lines were sent again.

The figures depend on how busy the machine is. So compare the two phases with each other, and with the delay of this
program itself ("self").
"""

import argparse
import json
import os
import selectors
import signal
import socket
import subprocess
import sys
import tempfile
import time

MOST_TO_END = 10  # seconds that a server may take to end
EVERY = 0.005  # seconds from one question of a polite host to its next
SCRIPT = """rate 30
create x sphere
create word text text="one"
create few1 sphere
create few2 sphere
"""
POLITE = {
    "time": lambda n: "time",
    "quoted": lambda n: f'set word.text "{n % 10}"',
    "pattern": lambda n: f"set few*.radius {1 + n % 7}",
    "set": lambda n: f"set x.position ({n % 10} 0 0)",
}


def many(n):
    return [f"create o{{1..{n}}} sphere"]


def lines_of_a_bundle(lines):
    return ["\n".join(["bundle", *lines, "end"])]


def sound(path):
    """Writes a WAV file of 122 kB."""
    n = 122_000
    with open(path, "wb") as f:
        f.write(b"RIFF" + (36 + n).to_bytes(4, "little") + b"WAVEfmt " + (16).to_bytes(4, "little") +
                (1).to_bytes(2, "little") * 2 + (8000).to_bytes(4, "little") * 2 + (1).to_bytes(2, "little") +
                (8).to_bytes(2, "little") + b"data" + n.to_bytes(4, "little") + bytes(i * 37 % 256 for i in range(n)))


def mesh(path):
    """Writes an OBJ file of 160,000 triangles, one for each cell of a grid."""
    side = 400
    with open(path, "w") as f:
        for y in range(side):
            for x in range(side):
                f.write(f"v {x} {y} {(x * y) % 7}\n")
        for y in range(side - 1):
            for x in range(side - 1):
                a = y * side + x + 1
                f.write(f"f {a} {a + 1} {a + side}\n")


T_AND_T = " and ".join(["t"] * 200_000)
LONG_NAMES = ["create " + "a" * 900 + "{1..20000} sphere"]
# Name -> (lines that prepare the film, hostile lines, number of connections). Each connection sends all hostile lines.
CASES = {
    "eval all of 100000": (many(100_000), ["eval o*.*"], 1),
    "eval position of 200000": (many(200_000), ["eval o*.position"], 1),
    "eval names of 100000": (many(100_000), ["eval o*"], 1),
    "eval unknown of 200000": (many(200_000), ["eval nothing", "eval nothing.position"] * 5, 1),
    "list of long names": (LONG_NAMES, ["list " + "a*" * 400 + "b"], 1),
    "list of 100000": (many(100_000), ["list"], 1),
    "set over long names": (LONG_NAMES, ["set " + "a*" * 400 + "b.radius 2"], 1),
    "describe 100000": (many(100_000), ["describe o*"], 1),
    "describe positions": (many(100_000), ["describe o*.position"], 1),
    "aliases": (many(200_000), ["alias all = " + "o* " * 50, "set all.radius 2", "eval all.position", "describe all"], 1),
    "frame all": (many(300_000) + ["create eye camera"], ["frame all"], 1),
    "rows over a pattern": (many(200_000), ["o*.position", *[f"  {i}f ({i} 0 0)" for i in range(1, 6)]], 1),
    "undo of 900000": (["create o{1..900000} sphere"], ["set o*.radius 2", "undo", "redo", "undo", "undo", "redo"], 1),
    "compiler": ([], [f'set x.radius = "{T_AND_T}"', 'set x.radius = "' + T_AND_T[:65_000] + '"'], 2),
    "formula": ([], ["set x.radius (" + "1+" * 300_000 + "1)", "set x.radius " + "(" * 300_000], 2),
    "sound": ([], ['create s sound file="sound.wav"', "remove s"] * 3, 2),
    "mesh": ([], ['create m{} mesh file="mesh.obj"', "remove m{}"] * 2, 2),
    "bundle of 100000": ([], lines_of_a_bundle([f"create o{i} sphere" for i in range(100_000)]), 1),
    "bundle of 100000 sets": (many(1000), lines_of_a_bundle([f"set o{1 + i % 1000}.radius {i}" for i in range(100_000)]), 1),
    "points": (["create o{1..100000} polygon"], ["set o*.points (" + "(i 0) " * 20_000 + ")",
                                              "set o*.points (" + "(1 0) " * 20_000 + ")"], 1),
    "history": (many(1000) + ["set o*.radius 2"] * 1, ["history"] * 3, 1),
    "notes": ([f'at {i}f note "{"x" * 900_000}"' for i in range(1, 9)], ["notes"] * 5, 1),
    "remove many": (many(500_000), ["remove o*"], 1),
    "copies": (many(100_000), ["create c{1..100000} like o1"], 1),
    "seek and pause": (many(500_000), ["pause", "seek 10s", "go"] * 20, 1),
    "help": ([], ["help", "help set", "help nothing"] * 500, 1),
    "names": ([], ["names"] * 200, 1),
    "completely unknown": (many(300_000), ["set nothing.radius 2", "hang nothing on x", "hang x on nothing"] * 20, 1),
    "hide and show": (many(500_000), ["hide x", "show x", "look at x", "hang few1 on x", "detach few1"] * 20, 1),
}


class PoliteHost:
    def __init__(self, path, kind):
        self.kind, self.question, self.n, self.asked, self.due = kind, POLITE[kind], 0, None, 0.0
        self.waits, self.wrong, self.buffer = [], 0, b""
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
        self.socket.setblocking(False)

    def ask(self, now):
        if self.asked is None and now >= self.due:
            self.n += 1
            self.asked, self.due = now, now + EVERY
            self.socket.send(self.question(self.n).encode() + b"\n")

    def hear(self, now):
        self.buffer += self.socket.recv(1 << 16)
        if b"\n" in self.buffer:
            line, _, self.buffer = self.buffer.partition(b"\n")
            self.waits.append(now - self.asked)
            self.wrong += b'"ok":true' not in line
            self.asked = None

    def take(self, now):
        """Returns the slowest answer since the last call, in seconds. An answer that has not come yet counts too."""
        open_now = [now - self.asked] if self.asked else []
        worst, self.waits = max(self.waits + open_now, default=0), []
        return worst


class HostileHost:
    def __init__(self, path, lines):
        self.lines, self.at, self.told, self.begun = lines, 0, [], None
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
        self.socket.setblocking(False)
        self.out, self.buffer = b"", b""
        self.wanted = 0

    def next(self, now):
        if self.at < len(self.lines) and not self.out and self.wanted == 0:
            line = self.lines[self.at]
            self.at += 1
            self.out, self.begun = line.encode() + b"\n", now
            self.wanted = 1

    def write(self):
        try:
            sent = self.socket.send(self.out[:1 << 18])
        except BlockingIOError:
            return
        self.out = self.out[sent:] if sent < len(self.out) else b""

    def hear(self, now):
        parts = self.socket.recv(1 << 18).split(b"\n")  # only the beginning of an answer is kept
        for i, part in enumerate(parts):
            if len(self.buffer) < 160:
                self.buffer += part[:160]
            if i == len(parts) - 1:
                break
            if not self.buffer.startswith(b'{"event"'):
                self.wanted = 0
                self.told.append((now - self.begun, self.buffer.decode(errors="replace")))
            self.buffer = b""

    @property
    def done(self):
        return self.at == len(self.lines) and self.wanted == 0


def run(sockets, seconds, until=None):
    """Runs the hosts for this many seconds, or until `until()` is true. Returns the longest delay of this program
    itself, in seconds."""
    chosen = selectors.DefaultSelector()
    for s in sockets:
        chosen.register(s.socket, selectors.EVENT_READ, s)
    end, late = time.monotonic() + seconds, 0.0
    while (now := time.monotonic()) < end and not (until and until()):
        for s in sockets:
            if isinstance(s, PoliteHost):
                s.ask(now)
            else:
                s.next(now)
                chosen.modify(s.socket, selectors.EVENT_READ | (selectors.EVENT_WRITE if s.out else 0), s)
        asked = time.monotonic()
        ready = chosen.select(0.002)
        late = max(late, time.monotonic() - asked - 0.002, asked - now)
        for key, events in ready:
            if events & selectors.EVENT_WRITE:
                key.data.write()
            if events & selectors.EVENT_READ:
                key.data.hear(time.monotonic())
    chosen.close()
    return late


def connect(path, lines):
    """Returns a host that sends these lines, or None if no server listens yet."""
    try:
        return HostileHost(path, lines)
    except OSError:
        return None


def peak_memory(pid):
    """Returns the peak memory of a process in MiB."""
    with open(f"/proc/{pid}/status") as f:
        for line in f:
            if line.startswith("VmHWM"):
                return int(line.split()[1]) / 1024
    return 0


def run_case(name, call):
    prepare, lines, connections = CASES[name]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "s")
        sound(os.path.join(folder, "sound.wav"))
        mesh(os.path.join(folder, "mesh.obj"))
        with open(os.path.join(folder, "film.bx"), "w") as f:
            f.write(SCRIPT)
        kept = ["--save", os.path.join(folder, "kept.bx")] if call.save else []
        server = subprocess.Popen([call.program, "serve", os.path.join(folder, "film.bx"), "--socket", path, *kept],
                                  stderr=subprocess.DEVNULL)
        try:
            while not (first := connect(path, prepare)):
                time.sleep(0.01)
                if server.poll() is not None:
                    sys.exit(f"the server has ended with {server.returncode}")
            run([first], 120, lambda: first.done)
            for took, told in first.told:
                if '"ok":true' not in told:
                    print("   not prepared:", told)
            polite = [PoliteHost(path, kind) for kind in POLITE]
            run(polite, 1)
            for p in polite:
                p.take(time.monotonic())
            late_before = run(polite, min(call.seconds, 3))
            before = [p.take(time.monotonic()) for p in polite]
            hostile = [HostileHost(path, [line.replace("{}", str(i)) if name == "mesh" else line for line in lines])
                       for i in range(connections)]
            begun = time.monotonic()
            late = run(polite + hostile, call.seconds, lambda: all(h.done for h in hostile))
            took = time.monotonic() - begun
            after = [p.take(time.monotonic()) for p in polite]
            again = [HostileHost(path, h.lines) for h in hostile]
            run(again, 0.2, lambda: all(h.done for h in again))
            most = peak_memory(server.pid)
            server.send_signal(signal.SIGTERM)
            begun = time.monotonic()
            try:
                server.wait(MOST_TO_END)
            except subprocess.TimeoutExpired:
                pass
            ended = time.monotonic() - begun
            show = lambda all_of_them: " ".join(f"{1000 * t:6.0f}" for t in all_of_them)
            print(f"{name:26} alone {show(before)} self {1000 * late_before:4.0f} | hostile {show(after)} "
                  f"self {1000 * late:4.0f} | took {took:5.1f} s{'' if all(h.done for h in hostile) else '+'}, "
                  f"{most:5.0f} MiB, ended in {ended:4.2f} s ({server.poll()})", flush=True)
            for p in polite:
                if p.wrong:
                    print(f"   {p.kind}: {p.wrong} of {p.n} refused")
            for h in hostile if call.verbose else ():
                for took, told in h.told[:8]:
                    print(f"   {took:6.2f} s {told}")
        finally:
            if server.poll() is None:
                server.kill()
            server.wait()


def main():
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", default=os.path.join(root, "build/release/bin/betwixt"))
    options.add_argument("--seconds", type=float, default=20)
    options.add_argument("--verbose", action="store_true", help="print the first answers to the hostile lines")
    options.add_argument("--save", action="store_true", help="keep a history on the disk, which adds delays of its own")
    options.add_argument("cases", nargs="*")
    call = options.parse_args()
    print(f"{'slowest answers in ms':26} {' '.join(POLITE)}")
    for name in CASES:
        if not call.cases or any(word in name for word in call.cases):
            run_case(name, call)


if __name__ == "__main__":
    main()
