# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Sends each hostile line of abuse_cases.py to a server of its own, with a well-behaved host. abuse.sh calls this."""

import contextlib
import math
import os
import random
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

from abuse_cases import DOORS, LINES, SCRIPT, lay_out
from betwixt_client import Gone, Refused, Server

ALONE = 1.0  # seconds without the hostile host, for comparison
AFTER = 1.0  # seconds of measuring after the hostile host has its answers
LONGEST = 6.0  # seconds that the hostile host waits for its answers
# The slowest answer to the other host may take MOST_WAIT seconds, or MOST_NOISE times its slowest answer without the
# hostile host if that is longer: the machine may have other work.
MOST_WAIT = 0.05
MOST_NOISE = 3
MOST_STOP = 1.0  # seconds from SIGTERM to the end
MOST_START = 10.0  # seconds until a server accepts connections
SHOWN = ("good.world", "good.radius", "ball.world", "ball.radius", "heavy.position")  # compared after a restart …
AT = "3.25s"  # … at this time


class Serving:
    """A server that keeps its history in the folder."""

    def __init__(self, program, folder, *script):
        self.begun = time.monotonic()
        self.said = os.path.join(folder, "said")
        with open(self.said, "wb") as said:
            self.process = subprocess.Popen([program, "serve", *script, "--tcp", "127.0.0.1:0", "--save", "kept.bx"],
                                            stderr=said, stdout=subprocess.DEVNULL, cwd=folder)
        words = self.await_words()
        self.token = re.search(rb"token (\w+)", words)[1].decode()
        self.port = int(re.search(rb"serving at [^\n;]*:(\d+)", words)[1])
        self.took = time.monotonic() - self.begun

    def await_words(self):
        while time.monotonic() < self.begun + MOST_START:
            with open(self.said, "rb") as said:
                words = said.read()
            if b"serving at" in words:
                return words
            if self.process.poll() is not None:
                raise Gone(f"the server does not start: {words[-300:]!r}")
            time.sleep(0.005)
        self.process.kill()
        raise Gone(f"the server has not started in {MOST_START:g} s")

    def host(self, timeout=30):
        return Server(f"127.0.0.1:{self.port}", self.token, timeout=timeout)

    def most_memory(self):
        with open(f"/proc/{self.process.pid}/status") as status:
            return int(re.search(r"VmHWM:\s*(\d+)", status.read())[1]) / 1024

    def stop(self):
        """Stops the server. Returns the seconds from SIGTERM to the end, or a text if it had ended or did not end
        well."""
        if self.process.poll() is not None:
            return f"it had ended with {self.process.returncode}"
        begun = time.monotonic()
        self.process.terminate()
        try:
            self.process.wait(20 * MOST_STOP)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            return f"it had to be killed after {20 * MOST_STOP:g} s"
        return time.monotonic() - begun if self.process.returncode == 0 else f"it ended with {self.process.returncode}"


class PoliteHost:
    """The well-behaved host: it sends lines with code and with patterns all the time, and checks the answers."""

    def __init__(self, server, undone):
        self.undone = undone  # whether the hostile host says `undo`
        self.host, self.frames = server.host(), server.host()
        self.frames._send(b"subscribe frames\n")
        self.said, self.worst, self.wrong = 0, 0.0, []

    def timed(self, what):
        begun = time.monotonic()
        out = what()
        self.worst = max(self.worst, time.monotonic() - begun)
        return out

    def ask(self):
        self.said += 1
        radius, tick = 1 + self.said % 7, random.randrange(10_000)
        self.timed(lambda: self.host.do(f'set goo*.radius = "{radius}"' if self.said % 5 == 0 else
                                        f"set good.radius {radius}"))
        found = self.timed(lambda: self.host.eval("good.radius", "good.world", at=f"{tick}t"))
        turned = math.sin(math.radians(3 * (tick + 1)))
        # `undo` takes back the last command of the document, which may be one of this host.
        mine = found["good.radius"] == radius or self.undone
        if not mine or abs(found["good.world"][4] - turned) > 1e-9:
            self.wrong.append(f"at {tick}t {found}")
        time.sleep(0.005)

    def ask_until(self, over):
        while not over():
            self.ask()


def say(server, said):
    """Runs the hostile host in a process of its own. Returns the process id and a pipe that gets the last answer: "ok",
    the text of an error, or why there was no answer."""
    here, there = os.pipe()
    child = os.fork()
    if child:
        os.close(there)
        return child, here
    answer = "no answer"
    try:
        os.nice(19)
        stop = time.monotonic() + LONGEST
        with socket.create_connection(("127.0.0.1", server.port), LONGEST) as wire:
            wire.sendall(f"token {server.token}\n".encode())
            pieces = [said] if isinstance(said, (str, bytes)) else said
            held = b""
            for piece in ["", *pieces]:
                wire.settimeout(max(0.01, stop - time.monotonic()))
                if piece:
                    wire.sendall(piece if isinstance(piece, bytes) else piece.encode() + b"\n")
                while b"\n" not in held:
                    if not (more := wire.recv(1 << 16)):
                        break
                    held += more
                line, _, held = held.partition(b"\n")
                if not piece:
                    continue
                told = re.search(rb'"error":"((?:[^"\\]|\\.)*)"', line)
                answer = told[1].decode(errors="replace") if told else "ok" if b'"ok":true' in line else repr(line[:60])
    except OSError as why:
        answer = "no answer in time" if isinstance(why, TimeoutError) else str(why)
    finally:
        os.write(there, answer[:300].encode())
        os._exit(0)


def values_now(host):
    return {name: host.eval(name, at=AT)[name] for name in SHOWN}


def try_line(program, folder, said):
    """Sends one hostile line to a new server. Returns a row of the report and the failures."""
    row, wrong = {}, []
    server = Serving(program, folder, "film.bx")
    try:
        good = PoliteHost(server, "undo" in (said if isinstance(said, list) else []))
        for _ in range(3):
            good.ask()
        good.worst = 0
        alone = time.monotonic() + ALONE
        before = good.host.stats()
        good.ask_until(lambda: time.monotonic() > alone)
        middle, quiet, good.worst = good.host.stats(), good.worst, 0
        child, pipe = say(server, said)
        over = []
        good.ask_until(lambda: over or os.waitpid(child, os.WNOHANG)[0] and not over.append(1))
        rest = time.monotonic() + AFTER
        good.ask_until(lambda: time.monotonic() > rest)
        with os.fdopen(pipe) as told:
            row["answer"] = told.read()
        after = good.host.stats()
        row["missed"] = after["frames_missed"] - middle["frames_missed"]
        row["due"] = after["frames_due"] - middle["frames_due"]
        begun = {name: middle[name] - before[name] for name in ("frames_due", "frames_missed")}
        row["noise"] = math.ceil(row["due"] * begun["frames_missed"] / max(1, begun["frames_due"]))
        row["worst"], row["quiet"], row["memory"] = good.worst, quiet, server.most_memory()
        wrong += good.wrong[:1]
        film = values_now(good.host)
    except (Gone, Refused) as why:
        wrong.append(f"the other host failed: {why}")
        film = None
    row["stop"] = server.stop()
    if film is not None:
        wrong += check_restart(program, folder, film, row)
    if row.get("missed", 0) > row.get("noise", 0):
        wrong.append(f"{row['missed']} frames missed")
    if row.get("worst", 0) > max(MOST_WAIT, MOST_NOISE * row.get("quiet", 0)):
        wrong.append("the other host waited too long")
    if isinstance(row["stop"], str) or row["stop"] > MOST_STOP:
        wrong.append(f"SIGTERM: {row['stop']}")
    return row, wrong


def check_restart(program, folder, film, row):
    """Restarts the server. Returns the failures: it does not start, or the film differs."""
    try:
        server = Serving(program, folder)
    except Gone as why:
        return [str(why)]
    try:
        row["start"] = server.took
        now = values_now(server.host())
        return [f"{name} is {now[name]} and was {film[name]}" for name in SHOWN if now[name] != film[name]][:1]
    except (Gone, Refused) as why:
        return [f"after a restart: {why}"]
    finally:
        server.stop()


def try_command(program, folder, what):
    """Runs a test of another command than `serve`. Returns an empty row of the report and the failures."""
    return {}, what(program, folder)


def number(row, name, words, times=1):
    return words.format(times * row[name]) if isinstance(row.get(name), (int, float)) else "-"


def report_line(name, row, wrong):
    shown_answer = row.get("answer", "")
    return (f"{'FAIL' if wrong else 'ok':5}{name[:46]:47}{number(row, 'missed', '{}'):>4} of {number(row, 'due', '{}'):5}"
            f"{number(row, 'worst', '{:.1f}', 1000):>8} ({number(row, 'quiet', '{:.1f}', 1000):>5})"
            f"{number(row, 'stop', '{:.2f}'):>7}{number(row, 'memory', '{:.0f}'):>7}{number(row, 'start', '{:.2f}'):>7}  "
            f"{shown_answer[:60]}" + "".join(f"\n     {w}" for w in wrong))


def case_numbers(words, count):
    first, _, last = words.partition("-")
    return range(int(first or 1) - 1, min(int(last or first or count), count))


def main():
    program, words = sys.argv[1], sys.argv[2]
    cases = [*((name, try_line, said) for name, said in LINES.items()),
             *((name, try_command, what) for name, what in DOORS.items())]
    failed, worst, stop, missed = [], 0.0, 0.0, 0
    print(f"{'':5}{'':47}{'frames missed':13}{'worst ms (alone)':>18}{'SIGTERM':>8}{'MiB':>6}{'again':>7}  answer")
    with tempfile.TemporaryDirectory() as files:
        lay_out(files)
        for i in case_numbers(words, len(cases)):
            name, how, what = cases[i]
            with tempfile.TemporaryDirectory() as folder:
                shutil.copytree(files, folder, dirs_exist_ok=True, copy_function=os.link, ignore=lambda at, all_of_them: [
                    n for n in all_of_them if not os.path.isfile(os.path.join(at, n))])
                for pipe in ("pipe.obj", "pipe.bx"):
                    os.mkfifo(os.path.join(folder, pipe))
                with open(os.path.join(folder, "film.bx"), "w") as film:
                    film.write(SCRIPT)
                try:
                    row, wrong = how(program, folder, what)
                except Gone as why:
                    row, wrong = {}, [str(why)]
            print(report_line(f"{i + 1} {name}", row, wrong), flush=True)
            failed += [name] if wrong else []
            worst, missed = max(worst, row.get("worst", 0)), missed + row.get("missed", 0)
            stop = max(stop, row["stop"]) if isinstance(row.get("stop"), float) else stop
    print(f"{len(case_numbers(words, len(cases)))} lines: {missed} frames missed, the slowest answer to another host "
          f"{1000 * worst:.0f} ms, the slowest end {stop:.2f} s; {len(failed)} failed")
    return int(bool(failed))


if __name__ == "__main__":
    sys.exit(main())
