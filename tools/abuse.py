# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the well-behaved host among the hostile clients of abuse_cases.py. abuse.sh describes the test and calls it."""

import collections
import json
import math
import os
import random
import signal
import statistics
import subprocess
import sys
import tempfile
import time

from abuse_cases import CASES, FOR_THE_CLOCK, SCRIPT, Visits, lay_out
from betwixt_client import Gone, Refused, Server

QUIET = 20  # seconds without abuse at the beginning, for comparison
CLOCK_TIME = 3  # seconds in each minute during which frames take long
MOST_GROWTH = 0.5  # MiB a minute; the commands of the well-behaved host need a tenth of this
# The slowest answer may take MOST_WAIT seconds, or MOST_NOISE times the slowest answer without abuse if that is longer:
# machines differ in speed.
MOST_WAIT = 0.1
MOST_NOISE = 20


def memory(pid):
    """Returns the resident memory of a process in MiB."""
    with open(f"/proc/{pid}/statm") as f:
        return int(f.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def growth(rests):
    """Returns how fast memory grows, in MiB a minute, from the values at the end of each minute: the median of the
    slopes between any two values. Leaves out the first third, in which buffers and the allocator's pools find their
    size. Returns None if too few values are left."""
    settled = list(enumerate(rests))[(len(rests) + 2) // 3:]
    slopes = [(b - a) / (j - i) for i, a in settled for j, b in settled if i < j]
    return statistics.median(slopes) if len(settled) >= 4 else None


def run_in_a_child(what):
    """Runs `what` in a process of its own and returns the process id. The process has the lowest priority, so that it
    disturbs the server as little as a client on another machine would."""
    child = os.fork()
    if child:
        return child
    try:
        os.nice(19)
        what()
    except OSError:
        pass
    finally:
        os._exit(0)


def abuse(visits, until):
    random.seed()
    while time.monotonic() < until:
        name = random.choice(CASES)
        child = run_in_a_child(getattr(visits, name))
        wait = time.monotonic() + random.choice([0.01, 0.1, 1, 10 if name in ("long_line", "heavy_line") else 2])
        while time.monotonic() < wait and os.waitpid(child, os.WNOHANG)[0] == 0:
            time.sleep(0.005)
        try:  # kill it in the middle of its work
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
        except (ProcessLookupError, ChildProcessError):
            pass


def percentile_ms(sorted_times, part):
    return 1000 * sorted_times[min(len(sorted_times) - 1, int(part * len(sorted_times)))]


class PoliteHost:
    """The well-behaved host: it sends commands and questions, measures the waits and checks the answers and frames."""

    def __init__(self, port, token):
        self.host = Server(f"127.0.0.1:{port}", token, timeout=60)
        self.frames = Server(f"127.0.0.1:{port}", token, timeout=60)
        self.waits = collections.defaultdict(list)
        self.wrong, self.seen, self.said, self.frame = 0, 0, 0, None
        self.events = self.frames.subscribe("frames", wait=60)

    def timed(self, phase, line, what):
        begun = time.monotonic()
        out = what()
        took = time.monotonic() - begun
        self.waits[phase].append(took)
        if took > MOST_WAIT:
            print(f"SLOW: {1000 * took:.0f} ms {phase}: {line[:60]}", flush=True)
        return out

    def mistake(self, what):
        self.wrong += 1
        if self.wrong < 10:
            print(f"WRONG: {what}", flush=True)

    def ask(self, phase):
        self.said += 1
        value = 1 + self.said % 7
        self.timed(phase, "set", lambda: self.host.do(f"set good.radius {value}"))
        tick = random.randrange(10_000)
        asked = self.timed(phase, "eval", lambda: self.host.eval("good.radius", "good.world", at=f"{tick}t"))
        turn = math.radians(3 * (tick + 1))
        if asked["good.radius"] != value or abs(asked["good.world"][4] - math.sin(turn)) > 1e-9:
            self.mistake(f"at {tick}t {asked}")

    def check_next_event(self):
        """Reads the next event. If it is a frame, checks that its number has grown and its time fits the number."""
        event = next(self.events)
        if event["event"] != "frame":
            return
        if self.frame and event["frame"] <= self.frame:
            self.mistake(f"{event} after {self.frame}")
        if abs(event["seconds"] - (event["frame"] - 1) / 60) > 1e-9:
            self.mistake(event)
        self.frame = event["frame"]
        self.seen += 1

    def keep_asking(self, phase, until):
        while time.monotonic() < until:
            for _ in range(6):
                self.check_next_event()
            self.ask(phase)

    def report(self, phase):
        times = sorted(self.waits[phase])
        if not times:
            return 0
        print(f"{phase:28} {len(times)} answers: p50 {percentile_ms(times, 0.5):.1f} ms, "
              f"p99 {percentile_ms(times, 0.99):.1f} ms, slowest {1000 * times[-1]:.1f} ms")
        return times[-1]


def frames(before, after):
    return {k: after[k] - before[k] for k in ("frames_due", "frames_made", "frames_missed")}


def counts_text(part):
    return f"{part['frames_due']} frames due, {part['frames_made']} made, {part['frames_missed']} missed"


def start_server(program, folder):
    lay_out(folder)
    script = os.path.join(folder, "film.bx")
    with open(script, "w") as f:
        f.write(SCRIPT)
    server = subprocess.Popen([program, "serve", script, "--tcp", "127.0.0.1:0", "--hosts", "1100",
                               "--checkpoint", "1000000"], stderr=subprocess.PIPE, text=True)
    token = server.stderr.readline().split()[1]
    said = server.stderr.readline().strip()
    port = int(said.split(";")[0].rpartition(":")[2])
    print(said)
    server.stderr.close()  # the rest of its output is not needed
    return server, port, token


def count_given_names(folder):
    """Returns how many blocks of names the server has handed out, and how many of them twice."""
    try:
        with open(os.path.join(folder, "names")) as f:
            first = [json.loads(line)["first"] for line in f if line.endswith("}\n")]
    except OSError:
        return 0, 0
    return len(first), len(first) - len(set(first))


def main():
    program, minutes = sys.argv[1], float(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        server, port, token = start_server(program, folder)
        try:
            return watch(server, PoliteHost(port, token), Visits(port, token, folder), minutes)
        except (Gone, Refused, StopIteration) as why:
            time.sleep(1)
            print(f"the well-behaved host failed: {why!r}; the server {ended(server.poll())}")
            return 1
        finally:
            if server.poll() is None:
                server.kill()


def ended(code):
    return "is still running" if code is None else f"has ended with {code}"


def watch(server, good, visits, minutes):
    good.keep_asking("alone", time.monotonic() + QUIET)
    first, before = good.host.stats(), memory(server.pid)
    print(f"alone, {QUIET} s: {counts_text(frames({k: 0 for k in first}, first))}; late p50 {first['late_p50_us']} us, "
          f"p99 {first['late_p99_us']} us, max {first['late_max_us']} us", flush=True)
    over, rests, clock = time.monotonic() + 60 * minutes, [], collections.Counter()
    heavy = list(FOR_THE_CLOCK.items())
    while time.monotonic() < over:
        until = min(time.monotonic() + 60, over)
        abusers = [run_in_a_child(lambda: abuse(visits, until)) for _ in range(3)]
        good.keep_asking("among others", until - 2 * CLOCK_TIME)
        what, (lines, back) = heavy[len(rests) % len(heavy)]
        start = good.host.stats()
        for line in lines:
            good.timed("when frames take long", line, lambda: good.host.do(line))
        good.keep_asking("when frames take long", time.monotonic() + CLOCK_TIME)
        for line in back:
            good.timed("when frames take long", line, lambda: good.host.do(line))
        part = frames(start, good.host.stats())
        clock.update(part)
        print(f"minute {len(rests) + 1}: {what}: {counts_text(part)}", flush=True)
        good.keep_asking("among others", until)
        for child in abusers:
            os.waitpid(child, 0)
        good.keep_asking("at rest", time.monotonic() + 2)
        rests.append(memory(server.pid))
        print(f"memory {rests[-1]:.1f} MiB after minute {len(rests)}", flush=True)
    return verdict(server, good, visits.folder, minutes, first, clock, before, rests)


def verdict(server, good, folder, minutes, first, clock, before, rests):
    good.frames.close()
    time.sleep(1)
    last = good.host.stats()
    lines, refused = last["lines"] - first["lines"], last["refused"] - first["refused"]
    print(f"{minutes:g} minutes, {last['bytes'] / 2**20:.0f} MiB in whole lines, {lines} lines, {refused} refused")
    of_all = collections.Counter(frames(first, last))
    of_all.subtract(clock)
    print(f"among others {counts_text(of_all)}; late p50 {last['late_p50_us']} us, p99 {last['late_p99_us']} us, "
          f"max {last['late_max_us']} us ({last['class']})")
    alone = good.report("alone")
    slowest = max(good.report(phase) for phase in ("among others", "when frames take long", "at rest"))
    given, twice = count_given_names(folder)
    print(f"{given} blocks of names were given, {twice} of them twice; "
          f"damaged or forbidden files read: {'SOME' if os.path.exists(os.path.join(folder, 'wrong')) else 'none'}")
    after, grows = memory(server.pid), growth(rests)
    good.host.close()
    stopped = time.monotonic()
    server.terminate()
    code = server.wait()
    stopped = time.monotonic() - stopped
    print(f"the well-behaved host: {good.seen} frames and {good.said} questions, {good.wrong} of them wrong")
    print(f"memory {before:.1f} MiB before, {max(rests):.1f} at most, {after:.1f} after; {last['hosts']} host left; "
          f"the server ended with {code}, in {stopped:.2f} s")
    print("the run was too short to measure how memory grows: run six minutes" if grows is None else
          f"memory grows by {grows:.2f} MiB a minute; {MOST_GROWTH} MiB are allowed")
    bound = max(MOST_WAIT, MOST_NOISE * alone)
    print(f"slowest answer {1000 * slowest:.1f} ms; {1000 * bound:.0f} ms are allowed")
    return int(good.wrong > 0 or code != 0 or last["hosts"] != 1 or (grows or 0) > MOST_GROWTH or slowest > bound or
               twice > 0 or os.path.exists(os.path.join(folder, "wrong")) or stopped > 1)


if __name__ == "__main__":
    sys.exit(main())
