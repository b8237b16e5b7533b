#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Lists the texts of the studio that a catalogue lacks, in the form of the catalogue, and the texts in it that the studio
# no longer has.
#   tools/studio-words.py src/studio/words/de.po
import glob
import re
import sys

LITERAL = r'"(?:[^"\\]|\\.)*"'
RUN = rf"((?:{LITERAL}\s*)+)"
SAID = [rf"(?:\btr|QT_TR_NOOP)\(\s*{RUN}", rf'QT_TRANSLATE_NOOP\("\w+",\s*{RUN}',
        rf'\{{"\w+", "[^"]+", (?:{LITERAL}),\s*{RUN},', r'\{"(?:\w+)", ("[^"]+"), ', r'\{("\w+"), "[^"]+", "']


def main():
    names = set(re.findall(r'^msgid "(.*)"$', open(sys.argv[1], encoding="utf-8").read(), re.M))
    found = []
    for file in sorted(glob.glob("src/studio/**/*.cpp", recursive=True) + glob.glob("src/studio/**/*.h", recursive=True)):
        text = open(file, encoding="utf-8").read()
        rows = SAID if file.endswith("/actions.cpp") else SAID[:2]
        for words in (m.group(1) for one in rows for m in re.finditer(one, text)):
            whole = "".join(part[1:-1] for part in re.findall(LITERAL, words))
            if re.search("[A-Za-z]{2}", whole) and whole not in found:
                found.append(whole)
    for words in found:
        if words not in names:
            print(f'\nmsgid "{words}"\nmsgstr ""')


main()
