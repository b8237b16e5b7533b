# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Counts phrases that readers often have to read twice, in documentation, comments and messages.

    plain_words.py         prints each group of files with more of them than its limit, and the first five lines
    plain_words.py -v      prints all lines with such phrases

A count above the limit is a reason to read the text again. A count below it is no proof that the text is good.
"""

import glob
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# The groups of files, with the limit of each: phrases in a thousand words.
USUAL = 2
GROUPS = {
    "docs": (USUAL, ["README.md", "docs/*.md", "docs/*/*.md", "*/README.md"]),
    "headers": (USUAL, ["include/betwixt/*.h"]),
    "others": (USUAL, ["python/**/*.py", "python/**/*.pyi", "clients/**/*.py", "web/*.js", "web/*.ts"]),
}
HIGHER = {"render": 3}  # comments of shaders
ROOMS = {room: HIGHER.get(room, USUAL) for room in sorted(os.listdir(f"{ROOT}/src"))}
GROUPS.update({f"src/{room}": (limit, [f"src/{room}/*.h", f"src/{room}/*.cpp"]) for room, limit in ROOMS.items()})

CLAUSE_START = r"(?:^|[.;:!?(|,—] ?)"  # the start of a clause
PHRASES = re.compile("|".join((
    CLAUSE_START + r"(?:[Ww]ho|[Ww]hoever|Whose|Whom) (?!(?:is|are|was|does|can|has)\b[^.]*\?)[a-z]+",
    CLAUSE_START + r"[Ww]hat (?:is|was|are|has|had|goes|comes|stands|lies|moves|hangs|must|can|needs|takes|makes)\b(?![^.]*\?)",
    r"\b(?:of|by|to|for|from|with|in|at|on) (?:whatever|whom|whoever)\b",
    r"\b(?:nobody|somebody|anybody|everybody)\b",
    r"\b(?:stands|stood|lies|goes on|went on|gone on)\b(?! for\b)",
    r"\b(?:is|are|was|were|be|been) (?:said|told|asked|spoken|heard)\b",
    r"[;,] else\b|\b(?:meanwhile|thereby|therein|thereof|whereby|wherein)\b",
    r"\b(?:none|empty|nothing|null): [a-z]",
)), re.M)


def readable_lines(path):
    """Returns the lines that people read: a page without its code; the comments and longer strings of a source file."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if path.endswith(".md"):
        text = re.sub(r"```.*?```", "", text, flags=re.S)
        return re.sub(r"`[^`\n]*`", "X", re.sub(r"\]\([^)]*\)", "]", text)).split("\n")
    comment = re.compile(r"(?:^|\s)(?:# |//+ ?)(.*)" if path.endswith(".py") else r"(?:^|\s)//+ ?(.*)")
    lines = []
    for line in text.split("\n"):
        found = comment.search(line)
        if found and "SPDX" not in line and "://" not in line:
            lines.append(found[1])
        lines += [quoted for quoted in re.findall(r'"((?:[^"\\]|\\.)*)"', line) if len(quoted.split()) > 3]
    return lines


def main(verbose):
    failed = False
    for name, (limit, patterns) in GROUPS.items():
        files = [f for p in patterns for f in sorted(glob.glob(p, root_dir=ROOT, recursive=True))]
        lines = [(f, line) for f in files for line in readable_lines(os.path.join(ROOT, f))]
        words = sum(len(re.findall(r"[A-Za-z']+", line)) for _, line in lines)
        found = [(f, line) for f, line in lines for _ in PHRASES.finditer(line)]
        share = 1000 * len(found) / max(1, words)
        if share > limit:
            failed = True
            print(f"{name}: {share:.1f} phrases in a thousand words are hard to read; the limit is {limit}")
        if verbose or share > limit:
            for f, line in found if verbose else found[:5]:
                print(f"  {f}: {line.strip()[:140]}")
    return failed


if __name__ == "__main__":
    sys.exit(main("-v" in sys.argv[1:]))
