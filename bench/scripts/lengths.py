#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares the lengths of the gallery's scripts with the same films in other tools: lines and characters, without
# comments, blank lines, and blanks at the beginnings and ends of lines. Prints the table of docs/gallery.md.
import re
import statistics
from pathlib import Path

here = Path(__file__).resolve().parent
root = here.parent.parent
tools = {'three': 'three.js', 'manim': 'Manim', 'gsap': 'GSAP', 'motion-canvas': 'Motion Canvas', 'blender': 'Blender'}
comments = {
    '.bx': r'(^|(?<=\s))#(?=\s|$)[^\n]*',
    '.py': r'(?m)^\s*#[^\n]*',
    '.js': r'(?m)^\s*//[^\n]*',
    '.ts': r'(?m)^\s*//[^\n]*',
    '.html': r'(?s)<!--.*?-->',
}


def length(path):
    text = re.sub(comments[path.suffix], '', path.read_text(), flags=re.M)
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return len(lines), sum(map(len, lines))


def table():
    rows = []
    for peer in sorted(here.glob('*.*.*')):
        name, tool = peer.name.split('.')[:2]
        rows.append((name, tools[tool], length(root / 'examples' / f'{name}.bx'), length(peer)))
    out = ['| film | lines | characters | beside | lines | characters | ratio of lines | of characters |',
           '|---|---|---|---|---|---|---|---|']
    for name, tool, ours, theirs in rows:
        out.append(f'| {name} | {ours[0]} | {ours[1]} | {tool} | {theirs[0]} | {theirs[1]} '
                   f'| {ours[0] / theirs[0]:.2f} | {ours[1] / theirs[1]:.2f} |')
    middle = [statistics.median(o[k] / t[k] for _, _, o, t in rows) for k in (0, 1)]
    out.append(f'| **median** | | | | | | **{middle[0]:.2f}** | **{middle[1]:.2f}** |')
    return '\n'.join(out)


print(table())
