# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""A host of the imaging server, `betwixt serve`, in nothing but Python's own library.

    from betwixt_client import Server

    with Server("/run/user/1000/betwixt.sock") as server:
        server.do("create ball sphere radius=0.5 color=gold")
        with server.bundle():                       # all of it, or nothing
            server.do("set ball.environments (spin)")
            server.do("animate spin every 1t by rotate(3deg, y)")
        print(server.eval("ball.position"))         # {'ball.position': [0.0, 0.0, 0.0]}

By TCP, with the token that the server has printed:

    with Server("127.0.0.1:9100", token="0123456789abcdef0123456789abcdef") as server:
        for event in server.subscribe("changes"):   # what other hosts do
            print(event["commands"])

What the server refuses is a `Refused`; its `hint` may say a way out. docs/server.md describes what goes over the wire.
"""

import collections
import contextlib
import json
import mmap
import os
import socket
import struct
import time

__all__ = ["Gone", "Picture", "Refused", "Ring", "Server"]


class Gone(ConnectionError):
    """The server has ended, or has cut us off."""


class Refused(Exception):
    """A line that was not carried out, and changed nothing. `answer` is all that the server said."""

    def __init__(self, answer):
        super().__init__(answer.get("error", "refused"))
        self.answer = answer
        self.hint = answer.get("hint", "")
        self.column = answer.get("column")

    def __str__(self):
        return super().__str__() + (f" ({self.hint})" if self.hint else "")


class Server:
    """A connection. `where` is the path of a socket, or "HOST:PORT" with a token; without, where servers usually are.

    Commands are sent one at a time and answered one at a time; events that come in between wait until they are asked
    for. One thread at a time, please.
    """

    def __init__(self, where=None, token=None, timeout=10.0):
        if where is None:
            where = os.path.join(os.environ["XDG_RUNTIME_DIR"], "betwixt.sock")
        if token is None:
            self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            self._socket.settimeout(timeout)
            self._socket.connect(where)
        else:
            host, _, port = where.rpartition(":")
            self._socket = socket.create_connection((host.strip("[]"), int(port)), timeout)
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._timeout = timeout
        self._read = b""
        self._events = collections.deque()
        self._bundle = None
        if token is not None:
            self._answer_to(f"token {token}")

    def __enter__(self):
        return self

    def __exit__(self, *why):
        self.close()

    def close(self):
        """Ends the connection; what was done stays."""
        self._socket.close()

    # ---- commands

    def do(self, command):
        """Carries out a command of the language, or a word of the server. The answer, as a dict; raises Refused.

        Inside `bundle` it is only noted down; nothing is known yet.
        """
        lines = command.strip("\n").split("\n")
        if any(line.split()[:1] == ["bundle"] for line in lines):
            raise ValueError("a bundle is made by: with server.bundle():")
        if self._bundle is not None:
            self._bundle += lines
            return None
        return self._answer_to(*lines)

    @contextlib.contextmanager
    def bundle(self):
        """All commands inside are carried out at one moment at its end: all, or none and Refused."""
        self._bundle = []
        try:
            yield self
            lines = self._bundle
        finally:
            self._bundle = None
        self._send("\n".join(["bundle", *lines, "end"]))
        self._heard(self._next_answer())

    def sheet(self, target, rows):
        """Events of a target: pairs of a time and a value, as they are written in scripts. All of them, or none."""
        self._send("\n".join(["bundle", target, *(f"  {when} {value}" for when, value in rows), "end"]))
        return self._heard(self._next_answer())

    # ---- questions

    def eval(self, *targets, at=None):
        """The values of targets, by their names, now or at a time such as "90t" or "2.5s"."""
        return self.do("eval " + " ".join(targets) + (f" at {at}" if at else ""))["values"]

    def time(self):
        """{"tick", "seconds", "slot", "running"} of now."""
        return self.do("time")

    def slot(self):
        """The slot counter: the tick modulo 30."""
        return self.time()["slot"]

    def stats(self):
        """How the server is doing: a dict of numbers."""
        return self.do("stats")["stats"]

    def history(self):
        """The document as a script."""
        return self.do("history")["said"]

    # ---- events

    def subscribe(self, *topics, wait=None):
        """Asks for events and gives them one after another, for ever, or until none comes for `wait` seconds."""
        self.do("subscribe " + " ".join(topics))
        return self.events(wait)

    def events(self, wait=None):
        """Events that have come and that will; ends when none comes for `wait` seconds (None: never)."""
        while True:
            if self._events:
                yield self._events.popleft()
                continue
            self._socket.settimeout(wait)
            try:
                message = self._next_message()
            except TimeoutError:
                return
            finally:
                self._socket.settimeout(self._timeout)
            yield message

    # ---- the wire

    def _send(self, text):
        try:
            self._socket.sendall(text.encode() + b"\n")
        except (BrokenPipeError, ConnectionResetError) as why:
            raise Gone("the server has gone") from why

    def _next_message(self):
        while b"\n" not in self._read:
            try:
                more = self._socket.recv(1 << 16)
            except ConnectionResetError as why:
                raise Gone("the server has gone") from why
            if not more:
                raise Gone("the server has gone")
            self._read += more
        line, _, self._read = self._read.partition(b"\n")
        return json.loads(line)

    def _next_answer(self):
        while True:
            message = self._next_message()
            if "event" not in message:
                return message
            self._events.append(message)

    @staticmethod
    def _heard(answer):
        if not answer["ok"]:
            raise Refused(answer)
        return answer

    def _answer_to(self, *lines):
        """Sends the lines of one command; of the answers only the last counts, unless an earlier one says no."""
        answer = None
        for line in lines:
            self._send(line)
            answer = self._heard(self._next_answer())
        return answer


class Picture:
    """A picture of a ring: `rgba`, bytes row by row from the top; its size; `seconds`, the document's time; `number`,
    the frame's; `moment`, when it was shown, on the clock of time.monotonic_ns()."""

    def __init__(self, width, height, rgba, flicks, number, moment):
        self.width, self.height, self.rgba = width, height, rgba
        self.seconds = flicks / 705_600_000
        self.number, self.moment = number, moment


class Ring:
    """The pictures of a server that was started with `--to ring:NAME`.

        with Ring("stage") as ring:
            picture = ring.wait()
            print(picture.width, picture.height, picture.seconds)
    """

    HEAD = struct.Struct("<8s6IQQI")
    PICTURE = struct.Struct("<Qqqq")

    def __init__(self, name):
        with open(f"/dev/shm/{name}", "rb") as file:
            self._map = mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ)
        magic, version, self._first, self.width, self.height, self._count, self._head, self._stride, _, _ = (
            self.HEAD.unpack_from(self._map, 0))
        if magic != b"BTWXRING" or version != 1:
            raise ValueError(f"{name} is no ring of pictures that is known here")

    def __enter__(self):
        return self

    def __exit__(self, *why):
        self.close()

    def close(self):
        self._map.close()

    @property
    def written(self):
        """How many pictures have been shown so far."""
        return self.HEAD.unpack_from(self._map, 0)[8]

    @property
    def over(self):
        """The server has ended."""
        return self.HEAD.unpack_from(self._map, 0)[9] != 0

    def latest(self):
        """The picture that was shown last; None: there is none yet. Never half of one and half of the next."""
        while (n := self.written) > 0:
            at = self._first + (n - 1) % self._count * self._stride
            before, flicks, number, moment = self.PICTURE.unpack_from(self._map, at)
            rgba = self._map[at + self._head : at + self._head + 4 * self.width * self.height]
            if before == 2 * n and self.PICTURE.unpack_from(self._map, at)[0] == before:
                return Picture(self.width, self.height, rgba, flicks, number, moment)
        return None

    def wait(self, after=0, timeout=10.0):
        """The latest picture, once more than `after` have been shown; None when it takes too long."""
        until = time.monotonic() + timeout
        while self.written <= after and not self.over:
            if time.monotonic() > until:
                return None
            time.sleep(0.002)
        return self.latest()
