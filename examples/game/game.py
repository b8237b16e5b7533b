#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Two hosts play ball on one imaging server.

Nobody computes where the ball is: it flies by an environment, the server says when it touches something, and the host
whose side that is gives it another motion. Each host moves its own paddle. (Animation Imaging Model, 5: collisions)

    cd examples/game
    betwixt serve court.bx --socket /tmp/court.sock --save played.bx &
    python3 game.py /tmp/court.sock 20
    kill %1
    betwixt render played.bx -o played.mp4        # the whole game once more
"""

import os
import random
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "clients", "python"))
from betwixt_client import Gone, Refused, Server  # noqa: E402


class Player:
    def __init__(self, where, side, wall, seed):
        self.server = Server(where)
        self.side, self.wall = side, wall
        self.towards = -1 if side == "left" else 1  # the ball comes to us when it flies this way
        self.luck = random.Random(seed)
        self.hits = self.misses = 0

    def motion(self):
        """The ball's way in a tick."""
        m = self.server.eval("fly.by")["fly.by"]
        return m[3], m[7]

    def send_ball(self, x, y):
        self.server.do(f"animate fly every 1t by translate({x:.4f} {y:.4f} 0)")

    def touched(self, other):
        x, y = self.motion()
        if other == self.side and x * self.towards > 0:
            self.hits += 1
            self.send_ball(-x, y + self.luck.uniform(-0.03, 0.03))
        if other == self.wall and y * (1 if self.wall == "wall/high" else -1) > 0:
            self.send_ball(x, -y)

    def missed(self):
        x, y = self.motion()
        if x * self.towards > 0:
            self.misses += 1
            tick = self.server.time()["tick"]
            self.server.do(f'at {tick}t note "{self.side} missed"')
            self.send_ball(-x, y)

    def follow(self):
        """The paddle goes where the ball is now, a little late and not quite."""
        ball = self.server.eval("ball.world")["ball.world"]
        answer = self.server.time()
        aim = max(-3.1, min(3.1, ball[7] + self.luck.uniform(-1.2, 1.2)))
        with self.server.bundle():
            here = f"{self.side}.position.y"
            self.server.do(f"at {answer['tick'] + 1}t {here} {self.place:.4f} linear")
            self.server.do(f"at {answer['tick'] + 9}t {here} {aim:.4f} linear")
        self.place = aim

    def play(self, seconds):
        self.place = 0.0
        end, next_look = time.monotonic() + seconds, 0.0
        self.server.do("subscribe contacts")
        while time.monotonic() < end:
            for event in self.server.events(wait=0.05):
                if event.get("event") == "contact" and event["state"] == "begin" and "ball" in (event["a"], event["b"]):
                    self.touched(event["b"] if event["a"] == "ball" else event["a"])
                if event.get("event") == "view" and event["object"] == "ball" and event["state"] == "out":
                    self.missed()
                if time.monotonic() >= end:
                    break
            if time.monotonic() >= next_look:
                next_look = time.monotonic() + 0.35
                self.follow()
        print(f"{self.side}: {self.hits} hits, {self.misses} misses", flush=True)


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: game.py SOCKET [SECONDS]")
    where, seconds = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 20.0
    with Server(where) as referee:
        referee.do("animate fly every 1t by translate(0.16 0.07 0)")
    other = os.fork()  # another host, in a process of its own
    side, wall, seed = ("left", "wall/low", 1) if other else ("right", "wall/high", 2)
    try:
        Player(where, side, wall, seed).play(seconds)
    except (Gone, Refused) as why:
        print(f"{side}: {why}", file=sys.stderr)
        sys.exit(1)
    if other:
        _, status = os.waitpid(other, 0)
        sys.exit(os.waitstatus_to_exitcode(status))


if __name__ == "__main__":
    main()
