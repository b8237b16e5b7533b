# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""See abuse.sh."""

import os
import random
import signal
import socket
import statistics
import subprocess
import sys
import tempfile
import time

from betwixt_client import Server

SCRIPT = """rate 60
ticks 60
create ball sphere
set ball.environments (spin)
animate spin every 1t by rotate(3deg, z)
"""
HALVES = [b"create half sph", b"bundle\nremove ball\n", b"set ball.position (1 2", b'note """', b"ball.position\n  1f (",
          b"(" * 1000, b"token x\n", b"at 9999999999999t halt spin", b"\n" * 1000, b"\x00\xff\xfe\n"]
MOST_GROWTH = 0.5  # MiB a minute; the well-behaved host's own commands, one a second, take a tenth of it
MINE = "good"  # what the well-behaved host's objects are called; the others know none of these


def memory(pid):
    with open(f"/proc/{pid}/statm") as f:
        return int(f.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def growth(rests):
    """MiB a minute, of memory at the end of each: the median of the slopes between any two. The first third is left out:
    until then buffers and the allocator's pools find their size. None: too few to tell."""
    settled = list(enumerate(rests))[(len(rests) + 2) // 3:]
    slopes = [(b - a) / (j - i) for i, a in settled for j, b in settled if i < j]
    return statistics.median(slopes) if len(settled) >= 4 else None


def connect(where):
    c = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    c.settimeout(5)
    c.connect(where)
    return c


def in_a_child(what):
    """Runs `what` in a process of its own and gives its number."""
    child = os.fork()
    if child:
        return child
    try:
        what()
    except OSError:
        pass
    finally:
        os._exit(0)


def garbage(where):
    c = connect(where)
    for _ in range(random.randrange(1, 40)):
        c.sendall(random.randbytes(random.randrange(1, 65536)))


def half(where):
    c = connect(where)
    c.sendall(random.choice(HALVES))


def flood(where):
    c = connect(where)
    while True:
        c.sendall(b"bundle\ncreate {a,b,c} sphere\nremove ball\nremo")


def long_line(where):
    c = connect(where)
    for _ in range(1024):
        c.sendall(b"x" * 2**20)
    c.sendall(b"\ntime\n")
    c.recv(1000)


def crowd(where):
    all_of_them = []
    for _ in range(1000):
        all_of_them.append(connect(where))
    for c in all_of_them:
        c.sendall(b"time\nhelp\n")
    time.sleep(1)


def deaf(where):
    c = connect(where)
    while True:
        c.sendall(b"help\n" * 100)


def abuse(where, until):
    random.seed()
    while time.monotonic() < until:
        what = random.choice([garbage, garbage, half, half, half, flood, deaf, crowd, long_line])
        child = in_a_child(lambda: what(where))
        wait = time.monotonic() + random.choice([0.01, 0.1, 1, 10 if what is long_line else 2])
        while time.monotonic() < wait and os.waitpid(child, os.WNOHANG)[0] == 0:
            time.sleep(0.005)
        try:  # in the middle of whatever it does
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
        except (ProcessLookupError, ChildProcessError):
            pass


def main():
    program, minutes = sys.argv[1], float(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        where, script = os.path.join(folder, "s"), os.path.join(folder, "film.bx")
        with open(script, "w") as f:
            f.write(SCRIPT)
        server = subprocess.Popen([program, "serve", script, "--socket", where, "--hosts", "1100"],
                                  stderr=subprocess.PIPE, text=True)
        print(server.stderr.readline().strip())
        drain = in_a_child(lambda: [None for _ in server.stderr])
        good = Server(where, timeout=60)
        good.do("create good sphere")
        first, before = good.stats(), memory(server.pid)
        print(f"memory {before:.1f} MiB at the start")
        over = time.monotonic() + 60 * minutes

        def round_of_abuse():
            until = min(time.monotonic() + 60, over)
            return until, [in_a_child(lambda: abuse(where, until)) for _ in range(3)]

        until, abusers = round_of_abuse()
        largest, slowest, wrong, seen, rests = before, 0.0, 0, 0, []
        events = good.subscribe("frames", wait=30)
        frame = None
        for event in events:
            if event["event"] != "frame":
                continue
            # Honest frames: numbers go up by what has gone by, and the value is that of the time.
            if frame and event["frame"] <= frame:
                wrong += 1
            wrong += abs(event["seconds"] - (event["frame"] - 1) / 60) > 1e-9
            frame = event["frame"]
            seen += 1
            if seen % 60 == 0:
                begun = time.monotonic()
                good.do(f"set good.radius {1 + seen % 7}")
                value = good.eval("good.radius")["good.radius"]
                slowest = max(slowest, time.monotonic() - begun)
                wrong += value != 1 + seen % 7
                largest = max(largest, memory(server.pid))
                if time.monotonic() < until:
                    continue
                for child in abusers:
                    os.waitpid(child, 0)
                time.sleep(2)
                rests.append(memory(server.pid))
                print(f"memory {rests[-1]:.1f} MiB after minute {len(rests)}", flush=True)
                if time.monotonic() > over:
                    break
                until, abusers = round_of_abuse()
        good.do("unsubscribe")
        last, after, grows = good.stats(), memory(server.pid), growth(rests)
        good.close()
        server.terminate()
        code = server.wait()
        os.kill(drain, signal.SIGKILL)
        os.waitpid(drain, 0)
        lines, refused = last["lines"] - first["lines"], last["refused"] - first["refused"]
        print(f"{minutes:g} minutes, {last['bytes'] / 2**20:.0f} MiB in whole lines, {lines} lines, {refused} refused")
        print(f"frames due {last['frames_due'] - first['frames_due']}, made {last['frames_made'] - first['frames_made']}, "
              f"missed {last['frames_missed'] - first['frames_missed']}; late p50 {last['late_p50_us']} us, "
              f"p99 {last['late_p99_us']} us, max {last['late_max_us']} us ({last['class']})")
        print(f"the well-behaved host: {seen} frames, {wrong} of them wrong; slowest answer {1000 * slowest:.1f} ms")
        print(f"memory {before:.1f} MiB before, {largest:.1f} at most, {after:.1f} after; "
              f"{last['hosts']} host left; the server ended with {code}")
        print("too short to tell whether memory grows: six minutes are enough" if grows is None else
              f"memory grows by {grows:.2f} MiB a minute; {MOST_GROWTH} are allowed")
        sys.exit(wrong > 0 or code != 0 or last["hosts"] != 1 or (grows or 0) > MOST_GROWTH)


main()
