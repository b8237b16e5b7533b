# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Prints each link of a page whose target file or heading does not exist in this repository, or in the folder that
BETWIXT_PAGES names. Links to other sites are not checked."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "tools"))
from doc_pages import ROOT, headings, is_outside, links, pages, read  # noqa: E402


def main():
    anchors, checked, dead = {}, 0, 0
    for page in pages():
        for line, link in links(read(page)):
            if is_outside(link):
                continue
            path, _, anchor = link.partition("#")
            file = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
            checked += 1
            fine = os.path.exists(os.path.join(ROOT, file))
            if fine and anchor and file.endswith(".md"):
                if file not in anchors:
                    anchors[file] = {a for _, _, a in headings(read(file))}
                fine = anchor in anchors[file]
            if not fine:
                print(f"{page}:{line}: {link}")
                dead += 1
    if checked < 300:
        print(f"only {checked} links were found")
    return dead > 0 or checked < 300


sys.exit(main())
