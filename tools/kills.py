#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Kills servers and shells (SIGKILL) at random moments, then cuts their journals at random bytes.

    tools/kills.py PROGRAM [ROUNDS] [SEED]

It sends commands without waiting for the answers. After a kill, the film must equal the film of a simple model after
the first n commands, where n is at least the number of answered commands and at most the number of sent ones. After a
cut, n may be any number. The last line is "N passed, N failed". The exit code is 1 if a check failed.
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
    """Returns a fingerprint of a set of names: equal for equal sets, and quick to update when a name is added."""
    return len(made), sum(map(hash, made))


class Model:
    """A simple model of a film: the commands in effect and the undone ones. Each command is a list of lines."""

    def __init__(self, in_effect=()):
        self.in_effect, self.undone, self.states = [], [], [("7", (0, 0))]
        for lines in in_effect:
            self.do(lines)

    def do(self, lines):
        radius, (count, hashes) = self.states[-1]
        for words in map(str.split, lines):
            if words[0] == "set":
                radius = words[2]
            else:
                count, hashes = count + 1, hashes + hash(words[1])
        self.in_effect.append(lines)
        self.states.append((radius, (count, hashes)))
        self.undone = []

    def undo(self):
        self.undone.append((self.in_effect.pop(), self.states.pop()))

    def redo(self):
        lines, state = self.undone.pop()
        self.in_effect.append(lines)
        self.states.append(state)

    def text(self):
        return [line for lines in self.in_effect for line in lines]

    def state(self):
        """Returns the ball's radius and a fingerprint of the names of the other objects."""
        return self.states[-1]


def states(in_effect, changes, of):
    """Returns of(model) after 0, 1, 2 … of the changes. A change of None (`save`) changes nothing."""
    model = Model(in_effect)
    out = [of(model)]
    for change in changes:
        if change:
            change(model)
        out.append(of(model))
    return out


def commands(rng, number, bundles):
    """Generates random commands without end: (number, lines to send, change of a model). No two commands are equal."""
    done = undone = 0  # commands of this generator that can be undone and redone
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
        """Cuts the journal at a random byte."""
        with open(journal, "r+b") as f:
            size = f.seek(0, os.SEEK_END)
            f.truncate(self.rng.randrange(size + 1))
        self.cuts += 1

    # ---- a server

    def start_server(self):
        server = subprocess.Popen([self.program, "serve", "--socket", "s", "--save", "live.bx", "--class", "ordinary",
                                   "--undo", str(DEPTH), "--checkpoint", "20000"], stderr=subprocess.PIPE, text=True)
        said = ""
        for line in server.stderr:
            said += line
            if line.startswith("serving at"):
                return server
        raise RuntimeError(f"the server did not begin: {said}")

    def state_after_start(self):
        """Starts a server, returns the state of its film as Model.state does, and kills it."""
        server = self.start_server()
        with socket.socket(socket.AF_UNIX) as connection:
            connection.settimeout(60)
            connection.connect("s")
            connection.sendall(b"eval ball.radius\nlist\n")
            with connection.makefile() as answers:
                radius = json.loads(answers.readline())["values"]["ball.radius"]
                made = re.findall(r"\bo\d+", json.loads(answers.readline())["said"])
        server.kill()
        server.communicate()
        return str(radius), names(set(made))

    def run_until_killed(self, what):
        """Runs a server and stops or kills it. Returns the changes that were sent, and how many were answered."""
        server = self.start_server()
        connection = socket.socket(socket.AF_UNIX)
        connection.connect("s")
        answers = bytearray()

        def read_answers():
            while True:
                try:
                    more = connection.recv(1 << 16)
                except OSError:
                    return
                if not more:
                    return
                answers.extend(more)

        reader = threading.Thread(target=read_answers)
        reader.start()
        changes, last = [], time.monotonic() + self.rng.random() * 0.3
        try:
            for number, lines, change in commands(self.rng, self.number, True):
                self.number = number
                changes.append(change)
                connection.sendall(("\n".join(lines) + "\n").encode())
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
        reader.join()
        connection.close()
        lines = answers.decode().split("\n")[:-1]
        refused = [line for line in lines if '"ok":true' not in line]
        self.verdict(not refused, f"{what}: {refused[:1]}")
        self.answered, self.sent = self.answered + len(lines), self.sent + len(changes)
        return changes, len(lines)

    def serve(self, index):
        """Starts and kills a server on one file a few times, then cuts its journal."""
        for name in os.listdir("."):
            os.unlink(name)
        with open("live.bx", "w") as f:
            f.write(AUTHOR)
        in_effect, all_states = [], []
        for life in range(1 + self.rng.randrange(3)):
            changes, answered = self.run_until_killed(f"server {index}.{life}")
            possible = states(in_effect, changes, Model.state)
            all_states += possible
            found = self.state_after_start()
            n = next((n for n in range(len(possible) - 1, answered - 1, -1) if possible[n] == found), None)
            self.verdict(n is not None, f"server {index}.{life}: {answered} of {len(changes)} were answered; {found[0]}")
            if n is None:
                return
            model = Model(in_effect)
            for change in changes[:n]:
                if change:
                    change(model)
            in_effect = model.in_effect
        self.checkpoints += os.path.exists("live.bx.orig")
        if os.path.exists(".live.bx.journal"):
            self.cut(".live.bx.journal")
            found = self.state_after_start()
            self.verdict(found in all_states, f"server {index}, cut: {found[0]}")

    # ---- a shell

    def shell(self, index):
        """Kills a shell while it carries out commands, may cut its journal, and compares the recovered script."""
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
        possible = ["\n".join([AUTHOR, *text, ""]) if text else AUTHOR for text in states([], changes, Model.text)]
        self.kills += 1
        self.verdict(found in possible[0 if cut else answered:],
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
