#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests in minutes what a server does in months: sends commands as fast as it can, kills the server and restarts it.

    tools/marathon.py PROGRAM [COMMANDS] [SECONDS]

The default is ten million commands. With SECONDS it stops earlier when that time is over. Commands come in bundles of
a thousand, and several bundles are on the way at once. They set values, events and environments of a thousand objects,
and sometimes clear old events. The program prints the server's memory and the length of its log while it runs. At the
end it prints how long a restart takes, and whether the film is the same after it. The exit code is 1 if the film
differs, if the server refused a bundle, or if the memory or the log keeps growing.
"""

import json
import os
import random
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time

OBJECTS = 1000
BUNDLE = 1000  # commands in a bundle
AHEAD = 6  # bundles on the way at once
REPORTS = 20  # lines of the report
FORGET = 250_000  # old events are cleared after every so many commands, as hosts that run for months should do
VALUES = "eval o*.radius o*.color o*.position.x o*.display at 50f"  # compared after the restart
LONGEST_LOG = 64 << 20  # bytes; a checkpoint begins every 16 MiB, and the log grows further while it is made


def memory(pid):
    with open(f"/proc/{pid}/status") as f:
        return int(re.search(r"VmRSS:\s+(\d+)", f.read()).group(1)) / 1024


def start_server(program):
    """Starts a server. Returns it, and how many seconds the start took."""
    begun = time.monotonic()
    server = subprocess.Popen([program, "serve", "--socket", "s", "--save", "live.bx", "--class", "ordinary"],
                              stderr=subprocess.PIPE, text=True)
    for line in server.stderr:
        if line.startswith("serving at"):
            return server, time.monotonic() - begun
    raise RuntimeError("the server did not start")


class Host:
    def __init__(self):
        self.wire = socket.socket(socket.AF_UNIX)
        self.wire.settimeout(300)
        self.wire.connect("s")
        self.answers = self.wire.makefile("rb")

    def send(self, lines):
        self.wire.sendall(("\n".join(lines) + "\n").encode())

    def answer(self):
        return json.loads(self.answers.readline())

    def expect_ok(self, lines):
        for _ in range(lines):
            answer = self.answer()
            assert answer["ok"], answer

    def ask(self, line):
        self.send([line])
        return self.answer()


class Film:
    """Generates random commands, and keeps the radius that each object should have."""

    def __init__(self):
        self.rng = random.Random(13)
        self.radius = {}

    def bundle(self):
        lines = ["bundle"]
        for _ in range(BUNDLE):
            k = self.rng.randrange(OBJECTS)
            what = self.rng.randrange(20)
            if what < 14:
                value = self.rng.randrange(1, 1000)
                self.radius[k] = value
                lines.append(f"set o{k}.radius {value}")
            elif what < 16:
                lines.append(f"set o{k}.color #{self.rng.randrange(1 << 24):06x}")
            elif what < 18:
                lines.append(f"at {self.rng.randrange(1, 100)}f o{k}.position.x {self.rng.randrange(100)}")
            elif what < 19:
                lines.append(f"set o{k}.environments (e{self.rng.randrange(10)})")
            else:
                lines.append(f"hide o{k}" if self.rng.randrange(2) else f"show o{k}")
        return [*lines, "end"]


def clear_old_events(host):
    """Clears the events of `environments` and `display` that are older than ten seconds."""
    before = host.ask("time")["seconds"] - 10
    host.send([f"clear *.{of} before {max(before, 0):.3f}s" for of in ("environments", "display")])
    host.expect_ok(2)


def log_size():
    return sum(os.path.getsize(name) for name in (".live.bx.journal", "live.bx") if os.path.exists(name))


def run(program, commands, seconds):
    server, _ = start_server(program)
    host, film = Host(), Film()
    host.send([f"create o{{0..{OBJECTS - 1}}} sphere"])
    host.send([f"animate e{k} every 1t by rotate({k + 1}deg, y)" for k in range(10)])
    assert all(host.answer()["ok"] for _ in range(11))
    begun = time.monotonic()
    done, ahead, refused, longest, forget_at = 0, 0, 0, 0, FORGET
    reports, sizes, logs = 0, [], []
    print(f"{'commands':>10} {'seconds':>8} {'a second':>9} {'memory MiB':>11} {'log MiB':>8} {'script MiB':>11}")
    while done < commands and time.monotonic() - begun < seconds:
        while ahead < AHEAD:
            host.send(film.bundle())
            ahead += 1
        answer = host.answer()
        ahead -= 1
        done += BUNDLE
        if not answer["ok"]:
            refused += 1
            print(f"refused: {answer['error']}")
            if refused > 5:
                break
        part = max(done / commands, (time.monotonic() - begun) / seconds)
        if done >= forget_at:
            host.expect_ok(ahead)
            done, ahead, forget_at = done + BUNDLE * ahead, 0, forget_at + FORGET
            clear_old_events(host)
        if done % 10000 == 0:
            longest = max(longest, log_size())
        if part * REPORTS >= reports + 1:
            reports += 1
            sizes.append(memory(server.pid))
            logs.append(log_size())
            gone = time.monotonic() - begun
            print(f"{done:>10} {gone:8.1f} {done / gone:9.0f} {sizes[-1]:11.1f} {logs[-1] / 2**20:8.1f} "
                  f"{os.path.getsize('live.bx') / 2**20:11.2f}", flush=True)
    while ahead > 0:
        refused += not host.answer()["ok"]
        ahead, done = ahead - 1, done + BUNDLE
    gone = time.monotonic() - begun
    stats = host.ask("stats")["stats"]
    values_before = host.ask(VALUES)["values"]
    memory_before = memory(server.pid)
    server.send_signal(signal.SIGKILL)
    server.communicate()
    longest = max(longest, log_size())

    server, again = start_server(program)
    host = Host()
    same = host.ask(VALUES)["values"] == values_before
    names = sorted(film.radius)
    values = host.ask("eval " + " ".join(f"o{k}.radius" for k in names))["values"]
    right = all(values[f"o{k}.radius"] == film.radius[k] for k in names)
    undone = host.ask("undo")["ok"]
    after = memory(server.pid)
    server.terminate()
    server.communicate()
    whole = os.path.getsize("live.bx")
    server, clean = start_server(program)
    server.kill()
    server.communicate()

    sizes.append(memory_before)
    half = len(sizes) // 2
    grows = half > 2 and min(sizes[half:]) > 1.2 * max(sizes[1:half])
    print(f"{done} commands in {gone:.0f} s, {done / gone:.0f} a second; {refused} bundles refused; "
          f"the server counts {stats['commands']}")
    print(f"log at most {longest / 2**20:.1f} MiB, memory {sizes[0]:.0f} to {sizes[-1]:.0f} MiB")
    print(f"after a kill it starts in {again:.2f} s with {after:.0f} MiB; "
          f"after a normal end its script is {whole / 2**20:.2f} MiB, and it starts in {clean:.2f} s")
    print(f"the film is {'the same' if same else 'DIFFERENT'}, "
          f"{len(names)} values are {'right' if right else 'WRONG'}, undo {'works' if undone else 'DOES NOT WORK'}")
    return not (same and right and undone) or refused > 0 or grows or longest > LONGEST_LOG


def main():
    program = os.path.realpath(sys.argv[1])
    commands = int(sys.argv[2]) if len(sys.argv) > 2 else 10_000_000
    seconds = float(sys.argv[3]) if len(sys.argv) > 3 else float("inf")
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        failed = run(program, commands, seconds)
        os.chdir("/")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
