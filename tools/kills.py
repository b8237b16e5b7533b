#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Kills servers and shells (SIGKILL) at random moments, then cuts their journals at random bytes.

    tools/kills.py PROGRAM [ROUNDS] [SEED]

Lines are sent without waiting for answers. What is there after a kill must be what a plain model says is there after
some number of these: of all that were answered at least, and of no more than were sent. After a cut it must be what was
there after some number of them, however few. Ends with "N passed, N failed" and an exit code.
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
import threading
import time

DEPTH = 20  # commands that can be undone
AUTHOR = "# by hand\n# bundle\nrate 24\ncreate ball sphere\nset ball.radius 7  # no newline behind it"


def names(made):
    """What stands for a set of names: equal for equal sets, and quickly made of one that is a name smaller."""
    return len(made), sum(map(hash, made))


class Model:
    """Commands that stand, and those that were undone; each has its lines."""

    def __init__(self, stand=()):
        self.stand, self.undone, self.states = [], [], [("7", (0, 0))]
        for lines in stand:
            self.do(lines)

    def do(self, lines):
        radius, (count, hashes) = self.states[-1]
        for words in map(str.split, lines):
            if words[0] == "set":
                radius = words[2]
            else:
                count, hashes = count + 1, hashes + hash(words[1])
        self.stand.append(lines)
        self.states.append((radius, (count, hashes)))
        self.undone = []

    def undo(self):
        self.undone.append((self.stand.pop(), self.states.pop()))

    def redo(self):
        lines, state = self.undone.pop()
        self.stand.append(lines)
        self.states.append(state)

    def text(self):
        return [line for lines in self.stand for line in lines]

    def state(self):
        """The ball's radius, and which objects there are."""
        return self.states[-1]


def states(stand, changes, of):
    """What there is after none, one, two … of the changes."""
    model = Model(stand)
    out = [of(model)]
    for change in changes:
        if change:
            change(model)
        out.append(of(model))
    return out


def commands(rng, number, bundles):
    """Endless things to say: the lines, and what they do to a model. Every command is another one."""
    done = undone = 0  # what was said here can be undone
    while True:
        number += 1
        what = rng.randrange(12)
        if what == 9 and done > 0:
            done, undone = done - 1, undone + 1
            yield number, ["undo"], Model.undo
        elif what == 10 and undone > 0:
            done, undone = done + 1, undone - 1
            yield number, ["redo"], Model.redo
        elif what == 11 and rng.randrange(5) == 0:
            yield number, ["save"], None
        else:
            lines = [f"set ball.radius {number}  # {'x' * rng.randrange(1, 200)}"]
            if what in (6, 7):
                lines = [f"create o{number} sphere"]
            elif what == 8 and bundles:
                lines += [f"create o{number} box"]
            done, undone = min(done + 1, DEPTH), 0
            said = ["bundle", *lines, "end"] if len(lines) > 1 else lines
            yield number, said, lambda model, lines=lines: model.do(lines)


class Rounds:
    def __init__(self, program, seed):
        self.program, self.rng = program, random.Random(seed)
        self.passed = self.failed = self.answered = self.sent = self.kills = self.cuts = self.checkpoints = 0
        self.number = 10

    def verdict(self, good, what):
        self.passed += good
        self.failed += not good
        if not good:
            print(f"FAILED {what}", flush=True)

    def cut(self, journal):
        """The journal's first bytes only, however many."""
        with open(journal, "r+b") as f:
            size = f.seek(0, os.SEEK_END)
            f.truncate(self.rng.randrange(size + 1))
        self.cuts += 1

    # ---- a server

    def begin(self):
        server = subprocess.Popen([self.program, "serve", "--socket", "s", "--save", "live.bx", "--class", "ordinary",
                                   "--undo", str(DEPTH), "--checkpoint", "20000"], stderr=subprocess.PIPE, text=True)
        said = ""
        for line in server.stderr:
            said += line
            if line.startswith("serving at"):
                return server
        raise RuntimeError(f"the server did not begin: {said}")

    def found(self):
        """What a server begins with. It is killed then, having done nothing."""
        server = self.begin()
        with socket.socket(socket.AF_UNIX) as wire:
            wire.settimeout(60)
            wire.connect("s")
            wire.sendall(b"eval ball.radius\nlist\n")
            with wire.makefile() as answers:
                radius = json.loads(answers.readline())["values"]["ball.radius"]
                made = re.findall(r"\bo\d+", json.loads(answers.readline())["said"])
        server.kill()
        server.communicate()
        return str(radius), names(set(made))

    def live(self, what):
        """One life of a server: what was done to it, and how much of that was answered."""
        server = self.begin()
        wire = socket.socket(socket.AF_UNIX)
        wire.connect("s")
        answers = bytearray()

        def listen():
            while True:
                try:
                    more = wire.recv(1 << 16)
                except OSError:
                    return
                if not more:
                    return
                answers.extend(more)

        ear = threading.Thread(target=listen)
        ear.start()
        changes, last = [], time.monotonic() + self.rng.random() * 0.3
        try:
            for number, lines, change in commands(self.rng, self.number, True):
                self.number = number
                changes.append(change)
                wire.sendall(("\n".join(lines) + "\n").encode())
                if time.monotonic() > last:
                    break
        except OSError:
            pass
        time.sleep(self.rng.random() * 0.01)
        if self.rng.randrange(8) == 0:
            server.terminate()
        else:
            server.kill()
            self.kills += 1
        server.communicate()
        ear.join()
        wire.close()
        lines = answers.decode().split("\n")[:-1]
        refused = [line for line in lines if '"ok":true' not in line]
        self.verdict(not refused, f"{what}: {refused[:1]}")
        self.answered, self.sent = self.answered + len(lines), self.sent + len(changes)
        return changes, len(lines)

    def serve(self, index):
        """Some lives of a server on one file, and a cut at their end."""
        for name in os.listdir("."):
            os.unlink(name)
        with open("live.bx", "w") as f:
            f.write(AUTHOR)
        stand, all_states = [], []
        for life in range(1 + self.rng.randrange(3)):
            changes, answered = self.live(f"server {index}.{life}")
            ways = states(stand, changes, Model.state)
            all_states += ways
            found = self.found()
            n = next((n for n in range(len(ways) - 1, answered - 1, -1) if ways[n] == found), None)
            self.verdict(n is not None, f"server {index}.{life}: {answered} of {len(changes)} were answered; {found[0]}")
            if n is None:
                return
            model = Model(stand)
            for change in changes[:n]:
                if change:
                    change(model)
            stand = model.stand
        self.checkpoints += os.path.exists("live.bx.orig")
        if os.path.exists(".live.bx.journal"):
            self.cut(".live.bx.journal")
            found = self.found()
            self.verdict(found in all_states, f"server {index}, cut: {found[0]}")

    # ---- a shell

    def shell(self, index):
        for name in os.listdir("."):
            os.unlink(name)
        with open("film.bx", "w") as f:
            f.write(AUTHOR)
        shell = subprocess.Popen([self.program, "shell", "film.bx"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL)
        changes = []
        text = ""
        for number, lines, change in commands(self.rng, self.number, False):
            self.number = number
            changes.append(change)
            text += "\n".join(lines) + "\n"
            if len(changes) > 400:
                break
        threading.Timer(0.02 + self.rng.random() * 0.2, shell.kill).start()
        try:
            out, _ = shell.communicate(text.encode())
        except BrokenPipeError:
            out = b""
        answered = out.decode().split("\n").count("ok")
        self.answered, self.sent = self.answered + answered, self.sent + len(changes)
        cut = self.rng.randrange(2) == 1 and os.path.exists(".film.bx.journal")
        if cut:
            self.cut(".film.bx.journal")
        subprocess.run([self.program, "shell", "film.bx", "--recover"], input=b"save\nquit\n", capture_output=True,
                       check=False)
        with open("film.bx") as f:
            found = f.read()
        ways = ["\n".join([AUTHOR, *text, ""]) if text else AUTHOR for text in states([], changes, Model.text)]
        self.kills += 1
        self.verdict(found in ways[0 if cut else answered:],
                     f"shell {index}{', cut' if cut else ''}: {answered} of {len(changes)} were answered; {found[-60:]!r}")


def main():
    program = os.path.realpath(sys.argv[1])
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        all_rounds = Rounds(program, seed)
        for index in range(rounds):
            all_rounds.serve(index)
            all_rounds.shell(index)
        os.chdir("/")
    r = all_rounds
    print(f"{r.kills} servers and shells killed, {r.cuts} journals cut, {r.checkpoints} with a checkpoint; "
          f"{r.sent} commands sent, {r.answered} answered")
    print(f"{r.passed} passed, {r.failed} failed")
    return 1 if r.failed else 0


if __name__ == "__main__":
    sys.exit(main())
