# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Texts of the fuzzer in one file that people can read, and back: corpus.py pack FOLDER FILE, or unpack FILE FOLDER.

A text follows a line `==== N`, N counting them. What cannot be read in it, and a backslash, is \\xNN.
"""

import os
import re
import sys

MOST = 300_000  # bytes in a file: the shortest texts are kept
HEAD = b"==== "


def shown(text):
    return re.sub(rb"[^\n -\[\]-~]", lambda c: b"\\x%02x" % c.group()[0], text)


def meant(text):
    return re.sub(rb"\\x([0-9a-f]{2})", lambda c: bytes([int(c.group(1), 16)]), text)


def pack(folder, file):
    texts = []
    for name in os.listdir(folder):
        with open(os.path.join(folder, name), "rb") as f:
            texts.append(f.read())
    texts.sort(key=lambda text: (len(text), text))
    out, n = b"", 0
    for text in texts:
        # A line of a text that looks like a head would end it.
        piece = re.sub(rb"^====", rb"\\x3d===", shown(text), flags=re.M)
        if len(out) + len(piece) > MOST:
            break
        n += 1
        out += HEAD + b"%d\n" % n + piece + b"\n"
    with open(file, "wb") as f:
        f.write(out)
    print(f"{file}: {n} texts of {len(texts)}, {len(out)} bytes")


def unpack(file, folder):
    with open(file, "rb") as f:
        texts = re.split(rb"^==== [0-9]+\n", f.read(), flags=re.M)[1:]
    for n, text in enumerate(texts):
        with open(os.path.join(folder, f"{n:04}"), "wb") as f:
            f.write(meant(text[:-1]))


if __name__ == "__main__":
    {"pack": pack, "unpack": unpack}[sys.argv[1]](*sys.argv[2:])
