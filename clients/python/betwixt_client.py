# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""A client of the imaging server, `betwixt serve`. It needs only Python's standard library, and it is one file, so that
you can copy it beside your program.

    from betwixt_client import Server

    with Server("/run/user/1000/betwixt.sock") as server:
        server.do("create ball sphere radius=0.5 color=gold")
        with server.bundle():                       # all of it, or nothing
            server.do("set ball.environments (spin)")
            server.do("animate spin every 1t by rotate(3deg, y)")
        print(server.eval("ball.position"))         # {'ball.position': [0.0, 0.0, 0.0]}

By TCP, with the token that the server printed:

    with Server("127.0.0.1:9100", token="0123456789abcdef0123456789abcdef") as server:
        for event in server.subscribe("changes"):   # the changes of other hosts
            print(event["commands"])

A `Host` has the calls of the Animation Imaging Model, as betwixt/aim.h has them:

    with Host("/run/user/1000/betwixt.sock") as host:
        spin = host.make_environment()
        with host.object() as scene, host.environment(spin):
            host.polygon([(0, 2, 0), (-0.5, 0, 0), (0.5, 0, 0)])
        host.start(scene)
        host.animate(spin, 1, rotate_z(0.1))        # keeps turning after we disconnect

A command that the server refuses raises `Refused`; its `hint` may have a suggestion. If there is no server, or it has
ended, you get `Gone`; if it takes too long, `Late`. An invalid call raises ValueError or TypeError and sends nothing.
docs/server.md describes the protocol, docs/aim.md the calls.
"""

import collections
import contextlib
import json
import math
import mmap
import operator
import os
import re
import socket
import struct
import time

__all__ = ["Gone", "Host", "Late", "Picture", "Refused", "Ring", "Server",
           "identity", "multiply", "rotate_x", "rotate_y", "rotate_z", "scale", "transform", "translate"]


class Gone(ConnectionError):
    """There is no server, or it has ended or closed the connection. The connection is closed."""


class Late(Gone, TimeoutError):
    """The server has not answered in time. The connection is closed, because a late answer could be taken for that of
    the next command. Whether the command was carried out is unknown."""


class Refused(Exception):
    """The server refused a line, which changed nothing. `answer` is the server's whole answer."""

    def __init__(self, answer):
        super().__init__(answer.get("error", "refused"))
        self.answer = answer
        self.hint = answer.get("hint", "")
        self.column = answer.get("column")

    def __str__(self):
        return super().__str__() + (f" ({self.hint})" if self.hint else "")


class _Closing:
    """A base class: `with` closes the object at its end."""

    def __enter__(self):
        return self

    def __exit__(self, *why):
        self.close()


class Server(_Closing):
    """A connection. `where` is the path of a socket, or "HOST:PORT" with a token. By default it is the server's usual
    socket.

    Commands are sent and answered one at a time. Events that arrive in between are kept until you read them. Use a
    connection from one thread at a time.
    """

    def __init__(self, where=None, token=None, timeout=10.0):
        if where is None:
            folder = os.environ.get("XDG_RUNTIME_DIR")
            if not folder:
                raise ValueError("no socket is given, and XDG_RUNTIME_DIR is not set")
            where = os.path.join(folder, "betwixt.sock")
        self._timeout = timeout
        self._read = b""
        self._events = collections.deque()
        self._bundle = None
        try:
            self._socket = self._connected(where, token, timeout)
        except OSError as why:
            raise Gone(f"no server listens at {where}: {why.strerror or why}") from why
        if token is not None:
            try:
                self._answer_to(f"token {token}")
            except Refused:
                self.close()
                raise

    @staticmethod
    def _connected(where, token, timeout):
        if token is not None:
            host, _, port = where.rpartition(":")
            if not port.isdecimal():
                raise ValueError("with a token, where is HOST:PORT")
            made = socket.create_connection((host.strip("[]"), int(port)), timeout)
            made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            return made
        made = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            made.settimeout(timeout)
            made.connect(os.fspath(where))
        except FileNotFoundError as why:
            made.close()
            if re.fullmatch(r"[^/]+:[0-9]+", os.fsdecode(where)):
                raise ValueError(f"there is no socket {where}; by TCP the server's token is needed, too") from why
            raise
        except BaseException:
            made.close()
            raise
        return made

    def close(self):
        """Ends the connection. Changes that were made stay."""
        self._socket.close()

    # ---- commands

    def do(self, command):
        """Carries out a command of the language or of the server. Returns the answer as a dict; raises Refused.

        Inside `bundle` the command is only collected, and `do` returns None.
        """
        lines = command.strip("\n").split("\n")
        if any(line.split()[:1] == ["bundle"] for line in lines):
            raise ValueError("a bundle is made by: with server.bundle():")
        if self._bundle is not None:
            self._bundle += lines
            return None
        return self._answer_to(*lines)

    def send(self, name, data):
        """Gives the server the contents of a file: `server.send("logo.png", data)`. Then "@logo.png" names it in
        commands. Returns the full name, which means these bytes for ever; raises Refused."""
        if self._bundle is not None:
            raise ValueError("bytes cannot be sent in a bundle")
        if not name or any(c.isspace() for c in name):
            raise ValueError("the name of something sent has no spaces")
        data = bytes(data)
        return self._heard(self._exchange(f"send {name} {len(data)}", data))["name"]

    @contextlib.contextmanager
    def bundle(self):
        """Collects the commands inside the `with`. At its end the server carries out all of them at once. If it refuses
        one, it carries out none, and this raises Refused."""
        self.begin_bundle()
        try:
            yield self
        except BaseException:
            self._bundle_over()
            raise
        self.end_bundle()

    def begin_bundle(self):
        """Starts to collect commands."""
        if self._bundle is not None:
            raise ValueError("a bundle is already open")
        self._bundle = []

    def end_bundle(self):
        """Carries out the collected commands, all or none. Returns the answer as `do` does; raises Refused."""
        if self._bundle is None:
            raise ValueError("no bundle is open")
        return self._heard(self._exchange("\n".join(["bundle", *self._bundle_over(), "end"])))

    def _bundle_over(self):
        lines, self._bundle = self._bundle, None
        return lines

    def sheet(self, target, rows):
        """Adds events to a target, all or none. `rows` are pairs of a time and a value, written as in scripts."""
        rows = [f"  {when} {value}" for when, value in rows]
        return self._heard(self._exchange("\n".join(["bundle", target, *rows, "end"])))

    # ---- questions

    def eval(self, *targets, at=None):
        """Returns the values of targets by their names, now or at a time such as "90t" or "2.5s"."""
        return self._asked("eval " + " ".join(targets) + (f" at {at}" if at else ""))["values"]

    def time(self):
        """Returns the current {"tick", "seconds", "slot", "running"}."""
        return self._asked("time")

    def slot(self):
        """Returns the slot counter: the tick modulo 30."""
        return self.time()["slot"]

    def stats(self):
        """Returns the server's statistics: a dict of numbers."""
        return self._asked("stats")["stats"]

    def history(self):
        """Returns the document as a script."""
        return self._asked("history")["said"]

    # ---- events

    def subscribe(self, *topics, wait=None):
        """Subscribes to topics. Yields their events for ever, or until none arrives for `wait` seconds."""
        self._asked("subscribe " + " ".join(topics))
        return self.events(wait)

    def events(self, wait=None):
        """Yields the events that have arrived and those to come. Ends if none arrives for `wait` seconds; None waits
        for ever."""
        while True:
            if self._events:
                yield self._events.popleft()
                continue
            try:
                message = self._next_message(wait)
            except (TimeoutError, BlockingIOError):
                return
            yield message

    # ---- the wire

    def _asked(self, question):
        if self._bundle is not None:
            raise ValueError("a bundle cannot contain questions")
        return self._answer_to(question)

    def _answer_to(self, *lines):
        """Sends the lines of one command. Returns the last answer, unless the server refuses an earlier line."""
        answer = None
        for line in lines:
            answer = self._heard(self._exchange(line))
        return answer

    @staticmethod
    def _heard(answer):
        if not answer["ok"]:
            raise Refused(answer)
        return answer

    def _exchange(self, text, data=b""):
        """Sends a text that has one answer, with the bytes that follow it, and returns the answer. An exception in
        between closes the connection: otherwise the late answer could be taken for that of the next command."""
        sent = text.encode() + b"\n" + data
        try:
            self._send(sent)
            while "event" in (message := self._next_message(self._timeout)):
                self._events.append(message)
            return message
        except (TimeoutError, BlockingIOError) as why:
            raise self._lost(Late(f"the server has not answered in {self._timeout:g} s")) from why
        except BaseException:
            self.close()
            raise

    def _send(self, sent):
        wire = self._wire(self._timeout)
        try:
            wire.sendall(sent)
        except ConnectionError as why:
            raise self._lost(Gone("the server closed the connection")) from why

    def _next_message(self, wait):
        while b"\n" not in self._read:
            wire = self._wire(wait)
            try:
                more = wire.recv(1 << 16)
            except ConnectionError as why:
                raise self._lost(Gone("the server closed the connection")) from why
            if not more:
                raise self._lost(Gone("the server closed the connection"))
            self._read += more
        line, _, self._read = self._read.partition(b"\n")
        try:
            message = json.loads(line)
        except (ValueError, RecursionError):
            message = None
        if not isinstance(message, dict) or not ("ok" in message or "event" in message):
            raise self._lost(Gone("this is not an imaging server"))
        return message

    def _wire(self, wait):
        if self._socket.fileno() < 0:
            raise Gone("the connection is closed")
        self._socket.settimeout(wait)
        return self._socket

    def _lost(self, why):
        self.close()
        return why


class Host(Server):
    """A connection with the calls of the Animation Imaging Model (betwixt/aim.h, docs/aim.md).

    Matrices are 16 numbers row by row, for row vectors: p' = p M, with the translation in the last row. `translate`,
    `rotate_z` and similar functions return such matrices. Times are whole ticks, colours sRGB from 0 to 1. Names of
    objects, tags and environments are positive numbers. No other host gets or got the same numbers.
    """

    NAMES_AT_ONCE = 1000

    def __init__(self, where=None, token=None, timeout=10.0):
        super().__init__(where, token, timeout)
        self._blocks = []  # the first number of each thousand that the server gave us
        self._named = collections.Counter()
        self._open = None  # the name of the open object
        self._interrupted = False  # another command came after its last row: the next row must open it again
        self._replacing = False  # `replace` was the last row but those that replace
        self._open_before_bundle = None
        self._stamp = self._now = -math.inf  # when the last command takes effect; the last known tick
        try:
            self.time()  # fails if this is no imaging server
        except BaseException:
            self.close()
            raise

    # ---- objects: display lists

    def make_object(self):
        """MAKEOBJ: opens a new object. The commands until `close_object` belong to it. Returns its name."""
        self._none_open()
        made = self._name("object")
        self.do(f"make O{made}")
        self._opened(made)
        return made

    def edit_object(self, object):
        """EDITOBJ: opens an object again, to add and replace commands."""
        self._none_open()
        self.do(f"edit {_name('O', object)}")
        self._opened(object)

    def close_object(self):
        """CLOSEOBJ: closes the open object."""
        if self._open is None:
            raise ValueError("no object is open")
        self._open = None

    @contextlib.contextmanager
    def object(self):
        """Opens a new object for a `with`, and closes it at the end: `with host.object() as star:`."""
        made = self.make_object()
        try:
            yield made
        finally:
            self._open = None

    def delete_object(self, object):
        self.do(f"delete {_name('O', object)}")

    def call_object(self, object):
        """CALLOBJ: draws an instance of another object."""
        self._row(f"call {_name('O', object)}")

    def tag(self):
        """TAG: labels the next command. Returns the label."""
        made = self._name("tag")
        self._row(f"tag T{made}")
        return made

    def replace(self, tag, offset=0):
        """REPLACE: each command that follows replaces one old command, from tag + offset on."""
        text = f"replace {_name('T', tag)} {operator.index(offset)}"
        self._replacing = False
        self._row(text)
        self._replacing = True

    def push_matrix(self):
        self._row("push")

    def pop_matrix(self):
        self._row("pop")

    def multiply_matrix(self, matrix):
        """MULTMATRIX: replaces the matrix on top of the stack by `matrix` times it."""
        self._row(f"multiply {_matrix(matrix)}")

    @contextlib.contextmanager
    def matrix(self, matrix):
        """Multiplies a matrix to the stack for the commands inside a `with`: `with host.matrix(m):`."""
        text = _matrix(matrix)
        self.push_matrix()
        try:
            self._row(f"multiply {text}")
            yield
        finally:
            self.pop_matrix()

    def point(self, x, y, z):
        self._row(f"point {_point((x, y, z))}")

    def vector(self, start, end):
        self._row(f"vector {_point(start)} {_point(end)}")

    def polygon(self, points):
        points = [_point(p) for p in points]
        if len(points) < 3:
            raise ValueError("a polygon must have at least three points")
        self._row(f"polygon {' '.join(points)}")

    def text(self, text):
        self._row(f"text {_quoted(text)}")

    def color(self, r, g, b):
        self._row(f"color rgb({_numbers((r, g, b), 3, 'a colour is three finite numbers')})")

    def texture(self, file):
        self._row(f"texture {_quoted(os.fspath(file))}")

    def font(self, name):
        self._row(f"font {_quoted(name)}")

    def view(self, eye, at):
        self._row(f"view from {_point(eye)} to {_point(at)}")

    def perspective(self, horizontal_angle_in_radians):
        self._row(f"perspective {_numbers((horizontal_angle_in_radians,), 1, 'an angle is a finite number')}rad")

    def orthographic(self, height):
        self._row(f"orthographic {_numbers((height,), 1, 'a height is a finite number')}")

    # ---- environments

    def make_environment(self):
        """Returns the name of a new environment. `animate` creates it."""
        return self._name("environment")

    def begin_environment(self, environment):
        """BeginAniEnv: puts the next commands of the open object into the environment."""
        self._row(f"begin {_name('E', environment)}")

    def end_environment(self):
        """EndAniEnv: ends the innermost open environment."""
        self._row("end")

    @contextlib.contextmanager
    def environment(self, environment):
        """Puts the commands inside a `with` into the environment: `with host.environment(spin):`."""
        self.begin_environment(environment)
        try:
            yield
        finally:
            self.end_environment()

    def start(self, main_object):
        """StartAniProc: shows the object, and starts the clock if it was stopped."""
        self.do(f"start {_name('O', main_object)}")

    def animate(self, environment, interval, matrix, *, change=0, period=1, ceiling=30, from_=None, until=None,
                keep_phase=False):
        """Animate: multiplies `matrix` to the environment every `interval` ticks. Returns the tick at which the command
        takes effect, or None in a bundle.

        Every `period` ticks the interval grows by `change` ticks, or shrinks if `change` is negative. When a growing
        interval reaches `ceiling`, the motion stops for good. The motion starts `from_` ticks from now (None: at once)
        and stops `until` ticks from now (None: never). With `keep_phase`, the first step comes when the next step of
        the old motion was due. The call creates the environment. It also accepts a number that does not come from
        `make_environment`.
        """
        line = f"animate {_name('E', environment)} every {operator.index(interval)}t by {_matrix(matrix)}"
        if change:
            line += f" {'slower' if change > 0 else 'faster'} {abs(operator.index(change))}t"
            line += f" per {operator.index(period)}t"
        if ceiling != 30:
            line += f" limit {operator.index(ceiling)}t"
        if from_ is not None:
            line += f" from {operator.index(from_)}t"
        if until is not None:
            line += f" until {operator.index(until)}t"
        return self._stamped(line + (" keep-phase" if keep_phase else ""))

    def halt(self, environment):
        """HaltAnimation: stops the motion. Returns the tick at which the command takes effect, or None in a bundle."""
        return self._stamped(f"halt {_name('E', environment)}")

    def kill(self, environment):
        """KillAnimation: ends the environment. Returns the tick at which the command takes effect, or None in a
        bundle."""
        return self._stamped(f"kill {_name('E', environment)}")

    def cancel(self, environment):
        """Drops the environment's future starts and stops. Returns the tick at which the command takes effect, or None
        in a bundle."""
        return self._stamped(f"cancel {_name('E', environment)}")

    def get_interval(self, environment):
        """GetAniTime: returns the interval in ticks."""
        return self._value(environment, "every")

    def get_matrix(self, environment):
        """GetAniMatrix: returns M, the matrix of one step."""
        return _transposed(self._value(environment, "by"))

    def get_environment_matrix(self, environment):
        """Returns A, the product of all steps so far."""
        return _transposed(self._value(environment, "world"))

    def get_slot_counter(self):
        """Returns the slot counter, 0 … 29."""
        return self.time()["slot"]

    def get_tick(self):
        return self.time()["tick"]

    # ---- internals

    def do(self, command):
        """Does what `Server.do` does. It is also allowed between the commands of an open object."""
        self._interrupted = True
        return super().do(command)

    def begin_bundle(self):
        super().begin_bundle()
        self._open_before_bundle, self._interrupted = self._open, True

    def end_bundle(self):
        answer = super().end_bundle()
        self._stamp = answer["tick"]
        return answer

    def _bundle_over(self):
        self._open, self._interrupted = self._open_before_bundle, True
        return super()._bundle_over()

    def _name(self, kind):
        """Returns a number that is new for this kind of name. The server gives each number to one host only, a thousand
        at a time. An object, a tag and an environment may have the same number."""
        block, number = divmod(self._named[kind], self.NAMES_AT_ONCE)
        if block == len(self._blocks):
            self._blocks.append(self._answer_to("names")["first"])
        self._named[kind] += 1
        return self._blocks[block] + number

    def _none_open(self):
        if self._open is not None:
            raise ValueError("an object is already open")

    def _opened(self, object):
        self._open, self._interrupted, self._replacing = object, False, False

    def _row(self, text):
        if self._open is None:
            raise ValueError("no object is open")
        if self._interrupted:
            if self._replacing:
                raise ValueError("another command came after 'replace', so repeat 'replace' first")
            self.do(f"edit O{self._open}")
            self._interrupted = False
        super().do("  " + text)

    def _stamped(self, line):
        answer = self.do(line)
        if answer is None:
            return None
        self._stamp = answer["tick"]
        return self._stamp

    def _value(self, environment, what):
        """Returns one value of an environment, at the time when the last command takes effect if that is later."""
        target = f"{_name('E', environment)}.{what}"
        if self._stamp > self._now:
            self._now = self.time()["tick"]
        return self.eval(target, at=f"{self._stamp}t" if self._stamp > self._now else None)[target]


# Formatting of arguments. A value of the wrong type raises TypeError.


def _name(letter, number):
    return f"{letter}{operator.index(number)}"


def _numbers(values, count, rule):
    values = list(values)
    if len(values) != count or not all(math.isfinite(v) for v in values):
        raise ValueError(rule)
    return " ".join(repr(float(v)).removesuffix(".0") for v in values)


def _point(p):
    return f"({_numbers(p, 3, 'a point is three finite numbers')})"


def _transposed(m):
    return [m[4 * column + row] for row in range(4) for column in range(4)]


def _matrix(m):
    """Formats a matrix. The language uses column vectors, so the columns of `m` become rows."""
    m = list(m)
    if len(m) != 16:
        raise ValueError("a matrix is 16 finite numbers")
    return f"matrix({_numbers(_transposed(m), 16, 'a matrix is 16 finite numbers')})"


def _quoted(text):
    """Formats a text of the language: in quotes, on one line."""
    if not isinstance(text, str):
        raise TypeError(f"a text is a str, not {type(text).__name__}")
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


# Matrices (appendix A of the model): lists of 16 numbers, row by row; p' = p M.


def identity():
    return scale(1, 1, 1)


def translate(x, y, z):
    return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1]


def scale(x, y, z):
    return [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1]


def rotate_x(radians):
    c, s = math.cos(radians), math.sin(radians)
    return [1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1]


def rotate_y(radians):
    c, s = math.cos(radians), math.sin(radians)
    return [c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1]


def rotate_z(radians):
    c, s = math.cos(radians), math.sin(radians)
    return [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


def multiply(a, b):
    """Returns the product a b: first a, then b."""
    return [sum(a[4 * row + k] * b[4 * k + column] for k in range(4)) for row in range(4) for column in range(4)]


def transform(p, m):
    """Returns the point p M."""
    return [p[0] * m[i] + p[1] * m[4 + i] + p[2] * m[8 + i] + m[12 + i] for i in range(3)]


class Picture:
    """A picture that the server has shown: its `width` and `height` in pixels, its pixels in `rgba` (bytes, row by row
    from the top), its time in the film in `seconds`, the `number` of the frame, and the `moment` when it was shown, in
    nanoseconds as time.monotonic_ns() counts them."""

    def __init__(self, width, height, rgba, flicks, number, moment):
        self.width, self.height, self.rgba = width, height, rgba
        self.seconds = flicks / 705_600_000
        self.number, self.moment = number, moment


class Ring(_Closing):
    """Reads the latest pictures of a server that was started with `--to ring:NAME`.

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

    def close(self):
        self._map.close()

    @property
    def written(self):
        """The number of pictures that the server has shown."""
        return self.HEAD.unpack_from(self._map, 0)[8]

    @property
    def over(self):
        """Whether the server has ended."""
        return self.HEAD.unpack_from(self._map, 0)[9] != 0

    def latest(self):
        """Returns the latest picture, or None if there is none yet. It is always a whole picture."""
        while (n := self.written) > 0:
            at = self._first + (n - 1) % self._count * self._stride
            before, flicks, number, moment = self.PICTURE.unpack_from(self._map, at)
            rgba = self._map[at + self._head : at + self._head + 4 * self.width * self.height]
            if before == 2 * n and self.PICTURE.unpack_from(self._map, at)[0] == before:
                return Picture(self.width, self.height, rgba, flicks, number, moment)
        return None

    def wait(self, after=0, timeout=10.0):
        """Waits until more than `after` pictures were shown. Returns the latest, or None after `timeout` seconds."""
        until = time.monotonic() + timeout
        while self.written <= after and not self.over:
            if time.monotonic() > until:
                return None
            time.sleep(0.002)
        return self.latest()
