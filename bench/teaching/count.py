#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares the lengths of the teaching films with the same films in Manim: characters without comments, blank lines, and
# blanks at the beginnings and ends of lines.
import re
import statistics
from pathlib import Path

here = Path(__file__).resolve().parent
examples = here.parent.parent / 'examples'


def length(path, comment):
    lines = [re.sub(comment, '', line).strip() for line in path.read_text().splitlines()]
    return sum(map(len, lines))


ratios = []
print('| film | betwixt | Manim | ratio |\n|---|---|---|---|')
for script in sorted(here.glob('*.py')):
    if script.name == Path(__file__).name:
        continue
    ours = length(examples / f'{script.stem}.bx', r'(^|(?<=\s))#(?=\s|$).*')
    theirs = length(script, r'^\s*#.*')
    ratios.append(ours / theirs)
    print(f'| {script.stem} | {ours} | {theirs} | {ratios[-1]:.2f} |')
print(f'| **median** | | | **{statistics.median(ratios):.2f}** |')
