# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Measures transparency and brightness in files, read by ffmpeg and by its own reader of OpenEXR. Each command prints
# one line. A failed assertion is its message.
#   alpha.py COMMAND FILE…
import math
import struct
import subprocess
import sys
import zlib


def pixels(path, layout="rgba", picture=0):
    """Returns a picture of a film as ffmpeg decodes it: four numbers a pixel, or planes of floats for such layouts."""
    words = ["ffmpeg", "-v", "error"] + (["-c:v", "libvpx-vp9"] if path.endswith(".webm") else [])
    words += ["-i", path, "-vf", f"select=eq(n\\,{picture})", "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", layout, "-"]
    raw = subprocess.run(words, stdout=subprocess.PIPE, check=True).stdout
    if layout == "rgba64le":
        return struct.unpack(f"<{len(raw) // 2}H", raw)
    if layout == "gbrapf32le":
        return struct.unpack(f"<{len(raw) // 4}f", raw)
    return raw


def text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def exr(path):
    """Reads an OpenEXR file of half floats by its specification. Returns its attributes, and the pixels as (r, g, b,
    a)."""
    data = open(path, "rb").read()
    assert struct.unpack_from("<II", data) == (20000630, 2), "magic and version"
    at, head = 8, {}
    while data[at]:
        name, at = text(data, at)
        kind, at = text(data, at)
        size = struct.unpack_from("<I", data, at)[0]
        head[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    left, top, right, bottom = struct.unpack("<4i", head["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    channels, c = [], 0
    while head["channels"][c]:
        name, c = text(head["channels"], c)
        assert struct.unpack_from("<i", head["channels"], c)[0] == 1, "half floats"
        channels.append(name)
        c += 16
    assert head["compression"] == b"\3", "zip, 16 lines each"
    lines = (height + 15) // 16
    planes = {name: [] for name in channels}
    for k in range(lines):
        start = struct.unpack_from("<Q", data, at + 1 + 8 * k)[0]
        y, size = struct.unpack_from("<iI", data, start)
        rows = min(16, bottom - y + 1)
        packed = data[start + 8:start + 8 + size]
        wanted = rows * width * 2 * len(channels)
        if size < wanted:
            flat = bytearray(zlib.decompress(packed))
            for i in range(1, len(flat)):
                flat[i] = (flat[i - 1] + flat[i] - 128) & 255
            half = (len(flat) + 1) // 2
            packed = bytearray(len(flat))
            packed[0::2], packed[1::2] = flat[:half], flat[half:]
        for row in range(rows):
            for i, name in enumerate(channels):
                planes[name] += struct.unpack_from(f"<{width}e", packed, 2 * width * (row * len(channels) + i))
    return head, width, height, list(zip(*(planes[name] for name in "RGBA")))


def encoded(c):
    c = min(max(c, 0), 1)
    return 12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055


def compare(reference, path, over, alpha, brim):
    """Compares two pictures with straight opacity. Over black and over white their average difference is at most
    `over`. The opacity differs by at most `alpha`, and the colour of half transparent pixels by at most `brim`. A
    colour that was multiplied by its opacity is too dark there."""
    a, b = pixels(reference), pixels(path)
    assert len(a) == len(b), f"{len(a)} and {len(b)} bytes"
    most = max(abs(a[i] - b[i]) for i in range(3, len(a), 4))
    assert most <= alpha, f"opacity differs by {most}"
    for ground in (0, 255):
        apart = 0
        for i in range(len(a)):
            if i % 4 < 3:
                s, t = a[i | 3], b[i | 3]
                apart += abs(a[i] * s + ground * (255 - s) - b[i] * t - ground * (255 - t)) / 255
        apart /= len(a) * 3 / 4
        assert apart <= over, f"over {ground} it differs by {apart:.2f}"
    half = [abs(a[i + c] - b[i + c]) for i in range(0, len(a), 4) if 64 < a[i + 3] < 192 for c in range(3)]
    assert len(half) > 100, "something is seen half through"
    assert sum(half) / len(half) <= brim, f"colours seen half through differ by {sum(half) / len(half):.2f}"


def clear(path):
    """The 8-bit film of the test is transparent at the corners and has every opacity between none and full."""
    p = pixels(path)
    assert p[0:4] == bytes(4) and p[-4:] == bytes(4), "the corners are clear"
    opacities = set(p[3::4])
    assert 0 in opacities and 255 in opacities and len(opacities) > 4, sorted(opacities)
    return len(opacities)


def one_color(path, *wanted):
    """All pixels that are not fully transparent have this colour."""
    p = pixels(path)
    seen = [p[i:i + 4] for i in range(0, len(p), 4) if p[i + 3] > 20]
    assert len({q[3] for q in seen}) > 20, "much of it is half clear"
    for q in seen:
        assert all(abs(q[c] - int(wanted[c])) <= 2 for c in range(3)), tuple(q)


def on_or_off(reference, path):
    a, b = pixels(reference), pixels(path)
    for i in range(3, len(a), 4):
        assert b[i] == (255 if a[i] >= 128 else 0), f"opacity {a[i]} became {b[i]}"


def sixteen(eight, path):
    a, b = pixels(eight), pixels(path, "rgba64le")
    for i in range(len(a)):
        assert abs(257 * a[i] - b[i]) <= 140, f"{a[i]} and {b[i]}"


def light(shown, path):
    """A linear picture with premultiplied opacity. Converted by the sRGB standard it equals the picture of 16 bits."""
    head, width, height, p = exr(path)
    primaries = struct.unpack("<8f", head["chromaticities"])
    bt709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
    assert all(abs(a - b) < 1e-4 for a, b in zip(primaries, bt709)), primaries
    q = pixels(shown, "rgba64le")
    assert len(q) == 4 * len(p)
    for i, (r, g, b, a) in enumerate(p):
        assert abs(a * 65535 - q[4 * i + 3]) <= 1, f"opacity {a} and {q[4 * i + 3]}"
        for c, value in enumerate((r, g, b)):
            straight = encoded(value / a) if a > 0 else 0
            assert abs(65535 * straight - q[4 * i + c]) <= 2, f"{value} through {a} and {q[4 * i + c]}"
    planes = pixels(path, "gbrapf32le")  # ffmpeg reads the same file
    n = width * height
    for i, (r, g, b, a) in enumerate(p):
        assert (planes[2 * n + i], planes[i], planes[n + i], planes[3 * n + i]) == (r, g, b, a), "as ffmpeg reads it"


def bright(path):
    """Prints the largest value of the picture, to a tenth."""
    return f"{max(max(p[:3]) for p in exr(path)[3]):.1f}"


commands = {
    "compare": lambda a, b, *limits: compare(a, b, *map(float, limits)),
    "clear": clear, "one-colour": one_color, "on-or-off": on_or_off, "sixteen": sixteen, "light": light, "bright": bright,
}
try:
    print(commands[sys.argv[1]](*sys.argv[2:]) or "well")
except AssertionError as e:
    print(f"{sys.argv[1:]}: {e}")
