# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Reads the Markdown pages of the repository: their paths, headings, links and blocks of code."""

import glob
import os
import re

ROOT = os.environ.get("BETWIXT_PAGES") or os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FENCE = re.compile(r"^ *```(.*)\n((?:.*\n)*?) *```$", re.M)


def pages():
    """Returns the paths of all pages, relative to the root of the repository."""
    found = [f for p in ("*.md", "*/*.md", "*/*/*.md") for f in glob.glob(p, root_dir=ROOT)]
    return sorted(f for f in found if not f.startswith("build/"))


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def blocks(text):
    """Returns (words after the opening fence, code) for each block of code."""
    return [(m[1].split(), m[2]) for m in FENCE.finditer(text)]


def without_code(text):
    """Returns the text without blocks and spans of code. The other lines keep their line numbers."""
    text = FENCE.sub(lambda m: "\n" * m[0].count("\n"), text)
    return re.sub(r"(`+)(?:(?!`).|\n(?!\n))*?\1(?!`)", lambda m: "`" + "\n" * m[0].count("\n") + "`", text)


def slug(heading):
    """Returns the anchor that GitHub gives to a heading."""
    plain = re.sub(r"!?\[([^]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", plain.strip().lower()).replace(" ", "-")


def headings(text):
    """Returns (level, heading, anchor) for each heading. Repeated anchors get a number: size, size-1."""
    seen, found = {}, []
    for mark, heading in re.findall(r"^(#+) +(.*?) *#*$", FENCE.sub("", text), re.M):
        anchor = slug(heading)
        seen[anchor] = seen.get(anchor, -1) + 1
        found.append((len(mark), heading, f"{anchor}-{seen[anchor]}" if seen[anchor] else anchor))
    return found


LINK = re.compile(r"(!?\[[^]\n]*(?:\n[^]\n]*)?\])\(([^)\s]+)\)")


def links(text):
    """Returns (line number, target) for each link and picture."""
    plain = without_code(text)
    return [(plain.count("\n", 0, m.start()) + 1, m[2]) for m in LINK.finditer(plain)]


def is_outside(link):
    return re.match(r"[a-z]+:", link) is not None
