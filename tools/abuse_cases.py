# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""What abuse.py does to a server: each case is somebody's visit, who may be killed at any moment of it."""

import os
import random
import socket
import time

# A time that no film comes to: what is asked there takes long, and frames do not (`asked` has a radius until then; else
# its first one would hold from the beginning on).
FAR = "100000s"
SLOW_CODE = [
    "string.rep('', 1e15) == '' and 1 or 2",
    "(function() local a = ('x'):rep(1000000) for i = 1, 1e9 do if a .. '' == a then end end return 1 end)()",
    "(function() for i = 1, 1e12 do end return 1 end)()",
    "#('x'):rep(1000000):upper():reverse()",
    "(function() local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(1000) end return 1 end)()",
    "('x'):rep(30000):find(('x?'):rep(3000) .. ('x'):rep(3000)) or 1",
]
# What the clock has to live with for a while: set, and taken back.
FOR_THE_CLOCK = {
    "Lua that never ends": (["set heavy.radius = \"" + SLOW_CODE[2] + "\""], ["set heavy.radius 1"]),
    "Lua's long texts": (["set heavy.radius = \"" + SLOW_CODE[1] + "\""], ["set heavy.radius 1"]),
    "stacked filters": ([f"filter heavy.position smooth width={w}" for w in ("0.001s", "0.04s", "1.7s", "71s", "3600s")],
                        ["filter heavy.position none"]),
    "a text of 20,000 letters": (['set words.text "' + 'x y' * 6666 + '"'], ['set words.text ""']),
    "2,000 spheres in one place": (["set heap/*.display on"], ["set heap/*.display off"]),
}
SCRIPT = """rate 60
ticks 60
create {ball,good} sphere
set {ball,good}.environments (spin)
animate spin every 1t by rotate(3deg, z)
create heavy sphere position=(1000 0 0) display=off
heavy.position.x
  1f 1000 linear
  100000f 2000 linear
create asked sphere radius=1 display=off
create words text display=off
create heap group position=(0 500 0)
create heap/s{1..2000} sphere display=off
procedure spinning command lua "for i = 1, 1e9 do end"
procedure texts command lua "local a = ('x'):rep(1000000) for i = 1, 1e9 do if a .. '' == a then end end"
"""
HALVES = [b"create half sph", b"bundle\nremove ball\n", b"set ball.position (1 2", b'note """', b"ball.position\n  1f (",
          b"(" * 1000, b"token x\n", b"at 9999999999999t halt spin", b"\n" * 1000, b"\x00\xff\xfe\n"]
# Every line of these is refused, and changes nothing, after it has taken its time.
HEAVY = [
    b"spinning\n", b"texts\n",
    b"bundle\ncreate m{1..1000000} sphere\nset m*.radius 2\nnonsense\nend\n",
    b"bundle\nmake l\n  tag t\n  color gold\n  polygon (0 0) (1 0) (0 1)\n" +
    b"".join(b"at %df edit l\n  replace t\n  color red\n" % i for i in range(2, 800)) + b"nonsense\nend\n",
    b'create t text text="' + b"x" * 1_000_000 + b'"\n',
    b"bundle\n" + b"create c{1..1000} like ball\nremove c*\n" * 20 + b"nonsense\nend\n",
    b"bundle\nball.position\n" + b"".join(b"  %df (%d 0 0)\n" % (i, i) for i in range(2, 20000)) + b"nonsense\nend\n",
    b"create x{0..99}{0..99}{0..999} sphere\n",
]
DAMAGED = ["deep.fbx", "cut.obj", "cut.gltf", "noise.dae", "noise.ply", "noise.png", "pipe.obj", "none.obj"]


def lay_out(folder):
    """Files that nobody should read."""
    def put(name, data):
        with open(os.path.join(folder, name), "wb") as f:
            f.write(data)
    put("deep.fbx", b"; FBX 7.4.0 project file\n" + b"A: {" * 50000)
    put("cut.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9999999\nf 1/")
    put("cut.gltf", b'{"asset":{"version":"2.0"},"buffers":[{"byteLength":99999999999}],"meshes":[{"primitives":[{')
    put("noise.dae", b"<COLLADA>" + random.randbytes(100_000))
    put("noise.ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n" +
        random.randbytes(1000))
    put("noise.png", b"\x89PNG\r\n\x1a\n" + random.randbytes(10_000))
    put("noise.bx", random.randbytes(10_000))
    os.mkfifo(os.path.join(folder, "pipe.obj"))
    os.mkfifo(os.path.join(folder, "pipe.bx"))


class Visits:
    """`port`, `token`: where the server is; `folder`: where what was given is written down."""

    def __init__(self, port, token, folder):
        self.port, self.token, self.folder = port, token, folder

    def stranger(self):
        c = socket.create_connection(("127.0.0.1", self.port), 5)
        c.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return c

    def connect(self):
        c = self.stranger()
        c.sendall(b"token " + self.token.encode() + b"\n")
        if b'"ok":true' not in c.recv(1000):
            raise OSError("there is no room")
        return c

    def converse(self, text, answers=1, wait=30):
        """Says something and waits for so many answers."""
        c = self.connect()
        c.settimeout(wait)
        c.sendall(text)
        got = b""
        while got.count(b"\n") < answers:
            more = c.recv(1 << 16)
            if not more:
                break
            got += more
        return got

    # ---- bytes

    def garbage(self):
        c = self.connect()
        for _ in range(random.randrange(1, 40)):
            c.sendall(random.randbytes(random.randrange(1, 65536)))

    def half(self):
        self.connect().sendall(random.choice(HALVES))

    def flood(self):
        c = self.connect()
        while True:
            c.sendall(b"bundle\ncreate {a,b,c} sphere\nremove ball\nremo")

    def long_line(self):
        c = self.connect()
        for _ in range(1024):
            c.sendall(b"x" * 2**20)
        c.sendall(b"\ntime\n")
        c.recv(1000)

    def deaf(self):
        c = self.connect()
        while True:
            c.sendall(b"help\n" * 100)

    # ---- many

    def crowd(self):
        all_of_them = [self.connect() for _ in range(300)]
        for c in all_of_them:
            c.sendall(b"time\nhelp\n")
        time.sleep(1)

    def strangers(self):
        all_of_them = [self.stranger() for _ in range(200)]
        for c in all_of_them[::2]:
            c.sendall(random.choice([b"token x\n", b"tok", b"create a sphere\n", b"x" * 5000]))
        time.sleep(1)

    def names(self):
        got = self.converse(b"names\n" * 20, 20)
        with open(os.path.join(self.folder, "names"), "ab") as f:
            f.write(got)

    # ---- work

    def heavy_line(self):
        for _ in range(3):
            self.converse(random.choice(HEAVY), 1)

    def takes_back(self):
        for _ in range(20):
            c = self.connect()
            c.sendall(random.choice(HEAVY))
            time.sleep(random.random() * 0.05)
            c.close()

    def slow_question(self):
        self.converse(b"at " + FAR.encode() + b' asked.radius = "' + random.choice(SLOW_CODE).encode() +
                      b'"\neval asked.radius at 100001s\n' + b"eval * at %ds\n" % random.randrange(10, 1000), 3)

    def contacts(self):
        self.converse(b"subscribe contacts changes notes frames\n", 100, 2)

    def files(self):
        lines = [f'create f mesh file="{name}"\n' for name in DAMAGED]
        lines += ['create f sphere texture="noise.png"\n', "use noise.bx\n", "use pipe.bx\n", 'use "/etc/passwd"\n',
                  'use "/dev/zero"\n']
        random.shuffle(lines)
        got = self.converse("".join(lines).encode(), len(lines))
        if b'"ok":true' in got:
            with open(os.path.join(self.folder, "wrong"), "ab") as f:
                f.write(got)


CASES = ["garbage", "half", "half", "flood", "deaf", "crowd", "long_line", "strangers", "names", "heavy_line",
         "heavy_line", "takes_back", "slow_question", "contacts", "files"]
