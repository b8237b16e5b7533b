# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""The hostile cases. abuse.py takes the methods of Visits: each is a client that may be killed at any moment.
abuse_lines.py takes LINES (lines to send to a server) and DOORS (hostile input to other commands of the program)."""

import json
import os
import random
import re
import socket
import struct
import subprocess
import time
import zlib

# A time that the server's clock never reaches. So the slow code takes effect in questions about that time, and not in
# frames. (`asked` has an own radius before it. Without that, its first value would hold from the beginning on.)
FAR = "100000s"
SLOW_CODE = [
    "string.rep('', 1e15) == '' and 1 or 2",
    "(function() local a = ('x'):rep(1000000) for i = 1, 1e9 do if a .. '' == a then end end return 1 end)()",
    "(function() for i = 1, 1e12 do end return 1 end)()",
    "#('x'):rep(1000000):upper():reverse()",
    "(function() local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(1000) end return 1 end)()",
    "('x'):rep(30000):find(('x?'):rep(3000) .. ('x'):rep(3000)) or 1",
]
# Makes frames take long for a while: name -> (lines that begin it, lines that end it).
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
create line polyline points=((0 0) (1 0) (2 1)) display=off
create heap group position=(0 500 0)
create heap/s{1..2000} sphere display=off
procedure spinning command lua "for i = 1, 1e9 do end"
procedure texts command lua "local a = ('x'):rep(1000000) for i = 1, 1e9 do if a .. '' == a then end end"
"""
HALVES = [b"create half sph", b"bundle\nremove ball\n", b"set ball.position (1 2", b'note """', b"ball.position\n  1f (",
          b"(" * 1000, b"token x\n", b"at 9999999999999t halt spin", b"\n" * 1000, b"\x00\xff\xfe\n"]
# Each of these lines takes long, is refused in the end, and changes nothing.
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


def png(width, height, rows, text=b""):
    """Returns a gray PNG from compressed rows. `text` is a compressed comment, or empty."""
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    beside = chunk(b"zTXt", b"Comment\0\0" + text) if text else b""
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
            beside + chunk(b"IDAT", rows) + chunk(b"IEND", b""))


def wavpack():
    """Returns nine hours of silence as WavPack: blocks of 82 bytes with 131,072 samples each, at 6,000 samples a
    second."""
    silence = bytes.fromhex("02015756030240403f00040400ff00ff00ff00ff05060000000000000000000000000902000800008a030000"
                            "ffff07000000")
    return b"".join(struct.pack("<4sIHBBIIIII", b"wvpk", 74, 1040, 0, 0, 0 if i else 0xffffffff, i << 17 & 0xffffffff,
                                1 << 17, 0x1920, 2319974399) + silence for i in range(1490))


def bombs():
    """Returns small files that become very large when they are read: name -> bytes."""
    gltf = {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "buffers": [{"byteLength": 16, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAAA=="}],
            "bufferViews": [{"buffer": 0, "byteLength": 16}],
            "accessors": [{"componentType": 5126, "count": 190_000_000, "type": "VEC3", "sparse": {
                "count": 1, "indices": {"bufferView": 0, "componentType": 5121}, "values": {"bufferView": 0}}}]}
    rows = zlib.compressobj(9)
    packed = b"".join(rows.compress(bytes(16385) * 256) for _ in range(64)) + rows.flush()
    laughs = "".join(f'<!ENTITY l{i} "{f"&l{i - 1};" * 10}">' for i in range(1, 10))
    uses = "".join(f'<g id="u{i}">' + f'<use href="#u{i - 1}"/>' * 10 + "</g>" for i in range(1, 10))
    side = range(500)
    mesh = ["".join(f"v {x} {y} 0\n" for x in side for y in side)]
    mesh += [f"f {a} {a + 1} {a + 501}\nf {a} {a + 501} {a + 500}\n" for x in side[:-1] for a in range(500 * x + 1, 500 * x + 500)]
    svg = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">'
    return {"bomb.gltf": json.dumps(gltf, separators=(",", ":")).encode(), "bomb.png": png(16384, 16384, packed),
            "wide.png": png(2**31 - 1, 2**31 - 1, b""),
            "text.png": png(1, 1, zlib.compress(bytes(2)), zlib.compress(bytes(300 << 20), 1)),
            "bomb.hdr": b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n" + b"\2\2\x40\0\xff\0" * 1000,
            "bomb.wv": wavpack(), "list.wav": b"ffconcat version 1.0\nfile /etc/passwd\n",
            "laughs.svg": f'<!DOCTYPE svg [<!ENTITY l0 "ha">{laughs}]>{svg}<title>&l9;</title><path d="M0 0h9v9z"/></svg>'.encode(),
            "uses.svg": f'{svg}<defs><path id="u0" d="M0 0h9v9z"/>{uses}</defs><use href="#u9"/></svg>'.encode(),
            "large.obj": "".join(mesh).encode(),
            "deep.dae": b'<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" '
                        b'version="1.4.1"><library_visual_scenes><visual_scene id="s">' + b"<node>" * 50_000 +
                        b"</node>" * 50_000 + b"</visual_scene></library_visual_scenes></COLLADA>",
            "bomb.bvh": b"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
                        b"Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 2000000000\nFrame Time: 0.01\n0 0 0 0 0 0\n",
            "itself.bx": b"use itself.bx\n"}


def lay_out(folder):
    """Writes damaged files, the files of bombs() and named pipes into the folder."""
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
    for name, data in bombs().items():
        put(name, data)
    os.mkfifo(os.path.join(folder, "pipe.obj"))
    os.mkfifo(os.path.join(folder, "pipe.bx"))


class Visits:
    """One method for each kind of hostile client. The server is at `port` and takes `token`. The methods write what has
    to be checked later into `folder`: the file `names` has the answers to `names`, `wrong` the answers that should not
    be ok."""

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
        """Sends a text, waits for so many answers, at most `wait` seconds, and returns them."""
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


# ---- hostile lines: one host sends them once, while another host is connected (abuse_lines.py)

def code(text, target="ball.radius"):
    return f'set {target} = "{text}"'.replace('"' + text + '"', '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"')


def spheres(count, *then):
    return [f"create o{{1..{count}}} sphere", *then]


def sent(name, data):
    """The line and the bytes that send a file."""
    return f"send {name} {len(data)}\n".encode() + data


def small(name, side, value):
    """Sends a picture whose bytes are all the same."""
    return sent(name, png(side, side, zlib.compress((b"\0" + bytes([value % 256]) * side) * side)))


LOOP = "for i = 1, 1e9 do end return 1"
# Name in the report -> what to send. A string is sent at once. The lines of a list are sent one by one, each after the
# answer to the line before.
LINES = {
    # Code: lines that once did harm, and variations of them.
    "an error that looks like ours": code("error('procedure:', 0)"),
    "an error without words": code("error()"),
    "an error that is a list": code("error({1, {2}})"),
    "an error of 8 MB": code("error(('x'):rep(8000000))"),
    "an error with a title for the terminal": code("error('\\27]0;owned\\7\\27[2J', 0)"),
    "U+009B in a text of code": code("'\\u{9b}2J'", "words.text"),
    "U+202E in a text": 'set words.text "\u202egnp.exe"',
    "U+202E in an error": code("error('\\u{202e}dab si siht', 0)"),
    "bytes that are no text in a text of code": code("'\\xff\\xfe\\x00\\x01'", "words.text"),
    "a sort of equal texts of 8 MB": code("local t = {} for i = 1, 50 do t[i] = ('x'):rep(8000000) end table.sort(t) return 1"),
    "max of 100,000": code("local t = {} for i = 1, 100000 do t[i] = i end local m = 0 for i = 1, 1000 do m = m + math.max(table.unpack(t)) end return m"),
    "value() of 150,000 points": ["create cloud points points=(" + " ".join("(i 0 0)" for _ in range(1)) + ")",
                                  code("local p = {} for i = 1, 150000 do p[i] = vec(i, 0) end return p", "cloud.points"),
                                  code("local n = 0 for i = 1, 20 do n = n + #value('cloud.points', t - i) end return n")],
    "pairs over long keys": code("local t = {} for i = 1, 500 do t[('x'):rep(10000) .. i] = 1 end local n = 0 for i = 1, 1e6 do for k in pairs(t) do n = n + #k end end return n"),
    "16 MB in each of 200 nested calls": [code("local s = ('x'):rep(15000000) return value('ball.radius', t - 0.1) + #s * 0")],
    "a loop without an end": code(LOOP),
    "loops on 1,000 things": spheres(1000, code(LOOP, "o*.radius")),
    "a loop in pcall": code("while true do pcall(function() for i = 1, 1e9 do end end) end return 1"),
    "a call of itself": code("local function f(n) return f(n + 1) + 1 end return f(1)"),
    "a tail call of itself": code("local function f(n) return f(n + 1) end return f(1)"),
    "a text doubled 40 times": code("local s = 'x' for i = 1, 40 do s = s .. s end return #s"),
    "a list without an end": code("local t = {} for i = 1, 1e9 do t[i] = {} end return 1"),
    "insert in front, again and again": code("local t = {} for i = 1, 200000 do table.insert(t, 1, i) end return 1"),
    "move of a billion": code("table.move({}, 1, 1000000000, 2) return 1"),
    "concat of a billion": code("return #table.concat({}, 'x', 1, 1000000000)"),
    "rep of a petabyte": code("return #string.rep('x', 1000000000000000)"),
    "format as wide as can be": code("local n = 0 for i = 1, 1e6 do n = n + #string.format('%99s%99s%99s', i, i, i) end return n"),
    "upper of a megabyte, for ever": code("local s = ('x'):rep(1000000) for i = 1, 1e6 do s = s:upper():reverse():lower() end return 1"),
    "byte of a megabyte": code("return select('#', string.byte(('x'):rep(900000), 1, -1))"),
    "unpack of a million": code("return select('#', table.unpack({}, 1, 1000000))"),
    "pack of what is unpacked": code("local t = {} for i = 1, 1e6 do t = table.pack(table.unpack(t)) t[#t + 1] = i end return 1"),
    "a sort with an inconsistent order": code("local t = {} for i = 1, 5000 do t[i] = i % 7 end table.sort(t, function(a, b) return true end) return 1"),
    "a metatable that asks itself": code("local t = setmetatable({}, {__index = function(t, k) return t[k + 1] end}) return t[1]"),
    "a finalizer without an end": code("setmetatable({}, {__gc = function() for i = 1, 1e9 do end end}) return 1"),
    "a __close without an end": code("local x <close> = setmetatable({}, {__close = function() for i = 1, 1e9 do end end}) return 1"),
    "a __tostring of 9 MB": code("tostring(setmetatable({}, {__tostring = function() return ('x'):rep(9000000) end}))", "words.text"),
    "not a number": code("0/0"),
    "infinity": code("1e308 * 10"),
    "a million points of code": code("local p = {} for i = 1, 1000000 do p[i] = vec(i, i) end return p", "line.points"),
    "code that gives other letters each time": code("(tostring(t) .. ' '):rep(1000)", "words.text"),
    "noise a million times": code("local s = 0 for i = 1, 1e6 do s = s + noise(i, t) end return s"),
    "a circle through 1,000 things": spheres(1000, *(f'set o{i}.radius = "value(\'o{i % 1000 + 1}.radius\')"' for i in (1, 2, 3)),
                                             "set o{4..999}.radius = \"value('o' .. (i + 4) .. '.radius')\""),
    "a radius that looks back 1,000 times": code("local s = 0 for i = 1, 1000 do s = s + value('.radius', t - i / 60) end return s"),
    "each of 300 asks all others": spheres(300, "set o*.radius = \"(function() local s = 0 for k = 1, 300 do s = s + value('o' .. k .. '.position.x', t - k) end return s end)()\""),
    "touching() of 1,000 things": spheres(1000, "set o*.radius = \"1 + #touching(self) * 0\""),
    "a command without an end": ['procedure forever command lua "while true do end"', "forever"],
    "a command that makes things for ever": ['procedure maker command lua "for i = 1, 1e9 do run(\'create m\' .. i .. \' sphere\') end"', "maker"],
    "a command that runs itself": ['procedure again command lua "run(\'again\')"', "again"],
    "a filter without an end": ['procedure slow filter lua "for i = 1, 1e9 do end return input()"', "filter ball.position slow"],
    "a twerper without an end": ['procedure late twerper lua "for i = 1, 1e9 do end return u"', "at 1f ball.position (0 0 0) late",
                                 "at 1000f ball.position (9 0 0)"],
    "a twerper without an end on 300 things": spheres(300, 'procedure late twerper lua "for i = 1, 1e9 do end return u"',
                                                      "bundle\nat 1f o*.position (0 0 0) late\nat 100000f o*.position (9 0 0)\nend"),
    "a shape between two of 5,000 points": ["bundle\n" + "".join(
        f"create form{i} polygon points=(" + " ".join(f"({n % 71} {n * i % 53})" for n in range(5000)) + ")\n" for i in (1, 2)) +
        "create form polygon\nat 1f form.geometry shape(form1) linear\nat 100000f form.geometry shape(form2)\nend"],
    "a filter that looks everywhere": ['procedure wide filter lua "local s = input() for i = 1, 1e5 do s = s + input(t + i) end return s"',
                                       "filter ball.radius wide"],
    "a megabyte of 't and t and'": "set ball.radius = \"" + "t and " * 170000 + "t\"",
    "64 kB of nested brackets": "set ball.radius = \"" + "(" * 32000 + "1" + ")" * 32000 + "\"",
    "300 local variables": code(" ".join(f"local a{i} = {i}" for i in range(300)) + " return 1"),
    "10,000 procedures": ["bundle\n" + "".join(f'procedure p{i} lua "{i}"\n' for i in range(10000)) + "end"],
    # Filters, lines, texts and shapes.
    "six stacked filters": [f"filter ball.position smooth width={w}" for w in ("0.001s", "0.04s", "1.7s", "71s", "600s", "3600s")],
    "200 stacked filters": ["bundle\n" + "filter ball.position smooth width=3s\n" * 200 + "end"],
    "springs on springs": ["bundle\n" + "filter ball.position spring frequency=0.01\n" * 20 + "end"],
    "a filter on 2,000 things": spheres(2000, "filter o*.position smooth width=3600s"),
    "a text of 20,000 letters": 'set words.text "' + "x y" * 6666 + '"',
    "a text of a megabyte": 'set words.text "' + "x" * 1_000_000 + '"',
    "a split text": ['create long text text="' + "x y" * 6000 + '"', "split long into letters"],
    "a text of 20,000 letters, traced": ['create long text text="' + "xy " * 6000 + '"', "create t trace of=long within=ball"],
    "a trace of a thousand hours": ["set ball.position = \"vec(sin(t * 100), cos(t * 77))\"", "at 3600000s ball.color red", "create t trace of=ball from=1f"],
    "along a path of a million points": [code("local p = {} for i = 1, 900000 do p[i] = vec(i, i % 7) end return p", "line.points"),
                                         "at 1f ball.position along line 0", "at 9f ball.position along line 1", "set ball.position along line 0.5"],
    "along a line of 150,000 points": ["create road polyline points=(" + "(1 2)(3 4)" * 75000 + ")", "set ball.position along road 0.5 "],
    "a star of 10,000 points": ["set good.display on", "create star1 star points=10000"],
    "a gear of 10,000 teeth": "create g gear teeth=10000",
    "10,000 dashes, over and over": "create d polyline points=((0 0) (1e9 0)) dash=(1e-6 1e-6)",
    # Many objects, names, events or letters.
    "eval of 100,000 things": spheres(100000, "eval o*.*"),
    "eval of 200,000 positions": spheres(200000, "eval o*.position"),
    "a list with long names": ["create " + "n" * 900 + "{1..10000} sphere", "list " + "*n" * 300 + "*x"],
    "describe many": spheres(20000, "describe o*"),
    "an alias of many": spheres(100000, "alias all = o*", "set all.radius 2", "alias more = all o* o*"),
    "frame all": spheres(100000, "create eye camera", "frame o*"),
    "rows of many": spheres(20000, "o*.position\n  1f (0 0 0)\n  2f (1 0 0)\n  3f (2 0 0)"),
    "undo of 900,000": ["create o{1..900000} sphere", "undo", "redo", "undo"],
    "make and take back, 200 times": ["bundle\ncreate q{1..1000} sphere\nend", *["undo", "redo"] * 100],
    "20,000 points for 100,000 lines": ["create l{1..100000} polyline", "set l*.points (" + "(i 0) " * 20000 + ")"],
    "texts of a megabyte for 1,000": ["create w{1..1000} text", 'set w*.text "' + "x" * 900_000 + '"'],
    "a million names": "create n{1..1000000} sphere",
    "names of braces in braces": "create " + "{a,b}" * 30 + " sphere",
    "a pattern of 10,000 stars": "list " + "*a" * 10000,
    "a pattern that is open": "list " + "[" * 1000,
    "a bundle of 50,000": ["bundle\n" + "set ball.radius 2\n" * 50000 + "end"],
    "a bundle that never ends": "bundle\n" + "create a sphere\n" * 100_000,
    "100,000 events": ["ball.position\n" + "".join(f"  {i}f ({i} 0 0)\n" for i in range(2, 100_000)) + "nothing"],
    "copies of copies": ["at 1f ball.radius 1", "at 2f ball.radius 2", *["copy ball.radius 1f..100000f to 100001f times 100000"] * 2],
    "couples 5,000 deep": ["create c{1..5000} group", "bundle\n" + "".join(f"couple c{i} to c{i + 1}\n" for i in range(1, 5000)) + "end", "eval c1.world"],
    "a circle of couples": ["create {x,y} group", "couple x to y", "couple y to x"],
    "a copy of a copy of all": [*spheres(1000), "create all group", *(f"create all{i} like all" for i in range(10)), "create more{1..1000} like ball"],
    "10,000 lights": "create light{1..10000} light",
    "2,000 spheres in one place": ["set heap/*.display on", "subscribe contacts"],
    "contacts of 20,000 in one place": spheres(20000, "eval o1.touching", "subscribe contacts"),
    "bake for a year": "bake ball.position 1f..1000000000f every 1t",
    "stagger many": spheres(50000, "at 1f o*.radius 2", "stagger o*.radius by 1f from random 7"),
    "arrange many": spheres(50000, "arrange o* in grid gap=0.1"),
    "rename many": spheres(20000, "create top group", "rename o1 top/o1", "rename top bottom"),
    "a formula of a megabyte": "set ball.radius (" + "1+" * 500_000 + "1)",
    "a formula 10,000 deep": "set ball.radius (" + "(" * 10000 + "1" + ")" * 10000 + ")",
    "powers of powers": "set ball.radius (" + "9^" * 1000 + "9)",
    "a display list of 100,000 rows": "make l\n" + "  point 0 0 0\n" * 100_000 + "nonsense",
    "a note of a megabyte": 'at 1s note "' + "\u202e" * 300_000 + '"',
    # Times.
    "seek too far, then drive": ["seek 4600000000s", "set ball.drive (e2)", "seek 1s"],
    "seek to the end of times": ["seek 4611686018s", "animate late every 1t by rotate(1deg, z)", "seek 1s"],
    "a time above the largest": "at 1e300s ball.radius 2",
    "a rate of a million": "rate 1000000",
    "a billion ticks a second": "ticks 1000000000",
    "an environment that wanders": ["set ball.environments (w)", "animate w every 1t by rotate(1deg, (1 2 3)) translate(0.1 0 0) scale(1.0001)", "seek 100000000s", "eval ball.world", "seek 2s"],
    "10,000 environments": ["bundle\n" + "".join(f"animate e{i} every 1t by rotate({i % 360}deg, z)\n" for i in range(2000)) + "end"],
    "eval at a far time": ["set ball.position = \"value('.position', t - 1 / 60) + vec(0.001, 0)\"", "eval ball.position at 1000000s"],
    "falls for ever": "at 1f fall ball for 1000000s bounce=0.999999",
    "pause, go, seek": ["pause", "seek 5s", "seek 1s", "seek 100s", "seek 2s", "go"] * 20,
    # Files.
    "383 bytes of glTF": 'create m mesh file="bomb.gltf"',
    "a picture of 261 kB": 'create m sphere texture="bomb.png"',
    "a picture of 2^31 by 2^31 pixels": 'create m sphere texture="wide.png"',
    "a picture with 300 MB of comment": 'create m sphere texture="text.png"',
    "a picture in the HDR format": 'create m sphere texture="bomb.hdr"',
    "122 kB of WavPack": 'create s sound file="bomb.wv"',
    "a sound that is a list of files": 'create s sound file="list.wav"',
    "entities in entities": 'create d scene file="laughs.svg"',
    "uses of uses": 'create d scene file="uses.svg"',
    "a mesh of a million triangles": 'create m mesh file="large.obj"',
    "a mesh a thousand nodes deep": 'create m mesh file="deep.dae"',
    "a movement of a million frames": 'create b scene file="bomb.bvh"',
    "a pipe": 'create m mesh file="pipe.obj"',
    "the machine's own files": ['use "/etc/passwd"', 'use "/dev/zero"', 'create m mesh file="../../../../etc/passwd"', 'create s sound file="/etc/passwd"'],
    "a script that uses itself": 'use "itself.bx"',
    "three hosts, three files": ['create s sound file="bomb.wv"', 'create m mesh file="large.obj"', "set ball.radius = \"" + "t and " * 10000 + "t\""],
    # The protocol.
    # Files that hosts send.
    "a picture of 261 kB that is sent": [sent("bomb.png", bombs()["bomb.png"])],
    "500 small pictures, then ten of 1024 x 1024": [*(small("p.png", 4, i) for i in range(500)),
                                                    *(small("q.png", 1024, i) for i in range(10))],
    "noise with each ending": [sent("noise." + end, random.randbytes(100_000)) for end in
                               ("png", "jpg", "obj", "stl", "glb", "gltf", "svg", "wav", "mp3", "ogg", "flac", "ttf", "otf")],
    "2 GB of one picture": [b"send a.png 2147483648\n" + bytes(64 << 20)],
    "64 MiB of a mesh": [sent("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n" + b"f 1 2 3\n" * 8_000_000)],
    "half a picture, and no more": b"send a.png 100000\n" + bytes(50_000),
    "a line of 64 MB": "x" * (64 << 20),
    "a million empty lines": "\n" * 1_000_000,
    "brackets that stay open": "set ball.position (" * 20_000,
    "a text that stays open": 'note """' + "x\n" * 200_000,
    "bytes": bytes(range(256)) * 4000,
    "questions by the thousand": ["list", "stats", "time", "help", "names", "history"] * 100,
    "all subscriptions": ["subscribe changes contacts notes frames"] + ["create z sphere", "remove z"] * 200,
}


# ---- other commands of the program: each function takes the program and a folder of its own, and returns the failures

FILM_THAT_ERRS = "create ball sphere\nset ball.radius = \"error('procedure:', 0)\"\n"


def called(program, folder, *words, given=b"", codes=(0, 1, 2, 3), most=10, **environment):
    """Runs the program with these words and this standard input. Returns the failures: no end in `most` seconds, an
    exit code that is not in `codes`, or output with control characters."""
    begun = time.monotonic()
    try:
        ended = subprocess.run([program, *words], cwd=folder, input=given, capture_output=True, timeout=most,
                               env={**os.environ, **environment})
    except subprocess.TimeoutExpired:
        return [f"{words[0]} has not ended in {most} s"]
    said = ended.stdout + ended.stderr
    if ended.returncode not in codes or b"machine failed" in said:
        return [f"{' '.join(words)} ended with {ended.returncode} after {time.monotonic() - begun:.1f} s: {said[-200:]!r}"]
    return ["control characters were printed as they are"] if re.search(rb"[\0-\x08\x0b-\x1f]|\xc2[\x80-\x9f]|\xe2\x80[\xaa-\xae]", said) else []


def written(folder, name, text):
    with open(os.path.join(folder, name), "wb") as f:
        f.write(text if isinstance(text, bytes) else text.encode())
    return name


def each_command(text):
    """Gives one film to several commands."""
    def do(program, folder):
        film = written(folder, "errs.bx", text)
        return (called(program, folder, "check", film) + called(program, folder, "eval", film, "ball.*", "--at", "2f") +
                called(program, folder, "export", film, "-o", "errs.glb") +
                called(program, folder, "frame", film, "--size", "32x18", "--samples", "1", "-o", "errs.png", most=30) +
                called(program, folder, "shell", film, given=b"eval ball.radius\nhelp ball\nlist\nquit\n"))
    return do


def framed(*messages, length=None):
    """Returns messages with the headers of the Language Server Protocol."""
    out = b""
    for m in messages:
        body = m if isinstance(m, bytes) else json.dumps(m).encode()
        out += b"Content-Length: %d\r\n\r\n" % (len(body) if length is None else length) + body
    return out


def language_server(hostile):
    """Sends hostile bytes to the language server. It must still answer the request `shutdown` that follows them."""
    def do(program, folder):
        begin = framed({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"capabilities": {}}},
                       {"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {"textDocument": {
                           "uri": "file:///errs.bx", "languageId": "betwixt", "version": 1, "text": FILM_THAT_ERRS}}})
        end = framed({"jsonrpc": "2.0", "id": 77, "method": "shutdown"}, {"jsonrpc": "2.0", "method": "exit"})
        try:
            ended = subprocess.run([program, "lsp"], cwd=folder, input=begin + hostile + end, capture_output=True, timeout=10)
        except subprocess.TimeoutExpired:
            return ["the language server has not ended in 10 s"]
        answered = re.search(rb'"id": ?77\b', ended.stdout)
        return [] if answered and ended.returncode == 0 else [f"it ended with {ended.returncode}; "
                                                              f"`shutdown` was answered: {bool(answered)}"]
    return do


def linked(program, folder):
    """`betwixt web --link` must not write its player over a file of another program, nor into a pipe."""
    film, player = written(folder, "ball.bx", "create ball sphere\n"), written(folder, "player.js", "// Betwixt 9\n")
    os.mkdir(os.path.join(folder, "theirs"))
    written(folder, "theirs/betwixt-player.js", "mine\n")
    os.mkdir(os.path.join(folder, "pipes"))
    os.mkfifo(os.path.join(folder, "pipes/betwixt-player.js"))
    wrong = []
    for place in ("theirs", "pipes"):
        wrong += called(program, folder, "web", film, "-o", f"{place}/page.html", "--link", codes=(2,),
                        BETWIXT_PLAYER=os.path.join(folder, player))
    with open(os.path.join(folder, "theirs/betwixt-player.js")) as f:
        return wrong + ([] if f.read() == "mine\n" else ["a file was replaced"])


def farm(program, folder):
    """Settings in the folder of a farm are data: no command in them may run."""
    os.mkdir(os.path.join(folder, "film.mp4.farm"))
    for i, line in enumerate(("program $(touch ran)", "first a[$(touch ran)]", "chunk 3; touch ran", "PATH=.; ran")):
        written(folder, "film.mp4.farm/settings", f"version 1\n{line}\n")
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../clients/slurm/betwixt-farm")
        subprocess.run([script, "--resume", "film.mp4"], cwd=folder, capture_output=True, timeout=10)
        if os.path.exists(os.path.join(folder, "ran")):
            return [f"line {i + 1} was run"]
    return []


def vanished(program, folder):
    """A server must refuse commands when its journal has been moved away and cannot keep them any more."""
    from abuse_lines import Serving
    server = Serving(program, folder, "film.bx")
    try:
        with server.host() as host:
            host.do("set good.radius 2")
            os.rename(os.path.join(folder, ".kept.bx.journal"), os.path.join(folder, "gone"))
            answers = []
            for _ in range(2):
                try:
                    host.do("set good.radius 3")
                    answers.append("ok")
                except OSError as why:
                    return [f"the host's connection failed: {why}"]
                except Exception as why:  # refused
                    answers.append(str(why))
        return [] if "ok" not in answers else [f"the answers were {answers}"]
    finally:
        server.stop()


DOORS = {
    "an error that looks like ours, to each command": each_command(FILM_THAT_ERRS),
    "an error with a title, to each command": each_command("create ball sphere\nset ball.radius = \"error('\\\\27]0;x\\\\7\\\\u{202e}', 0)\"\n"),
    "a file of bytes, to each command": each_command(bytes(range(256)) * 100),
    "a line of escapes, to each command": each_command("create ball sphere\n\x1b]0;x\x07 \u202e \u009b2J\n"),
    "an id 200,000 deep": language_server(framed(b'{"jsonrpc":"2.0","id":' + b"[" * 200_000 + b"]" * 200_000 + b',"method":"x"}')),
    "lengths that are wrong": language_server(b"Content-Length: 18446744073709551617\r\n\r\n{}" + b"Content-Length: -1\r\n\r\n{}" +
                                              b"Content-Length: x\r\n\r\n{}\r\n"),
    "a hover over what errs": language_server(framed({"jsonrpc": "2.0", "id": 2, "method": "textDocument/hover", "params": {
        "textDocument": {"uri": "file:///errs.bx"}, "position": {"line": 1, "character": 6}}})),
    "a player where another file is, and a pipe": linked,
    "a stranger's folder of a farm": farm,
    "a journal that vanishes": vanished,
}
