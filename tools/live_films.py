# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Live films: films that play in a page and can be edited there. A comment above a block of code in a Markdown page
makes a live film. It says how the block changes the film so far:

    <!-- live: new -->                        the block is a new film
    <!-- live: below -->                      the lines of the block go to the end of the film
    <!-- live: above LINE -->                 they go above this line
    <!-- live: in place of LINE -->           they replace this line and the indented lines below it
    <!-- live: with WORDS for WORDS -->       the film has the first words instead of the second: a mistake, only here

LINE is a whole line, or its first word. The time of an event row also works; then only that row is replaced.
"""

import html
import os
import re
import subprocess
import sys
import tempfile
from typing import NamedTuple, Optional


class Part(NamedTuple):
    """A part of a page between two blank lines."""

    text: str  # without the comment
    code: Optional[str] = None  # the content of a block of code; None for other parts
    film: Optional[str] = None  # the live film after this part; None if the part has no comment
    whole: bool = False  # the block is the whole film
    wrong: bool = False  # the film has a mistake on purpose


def as_script_text(text):
    return re.sub(r"<(\\*(?:/script|script|!--))", r"<\\\1", text, flags=re.I)


def block_end(lines, first):
    """Returns the index after the last indented line below a line."""
    end = first + 1
    while end < len(lines) and lines[end].startswith(" "):
        end += 1
    return end


def changed(film, how, block, page):
    """Returns the film, changed by a block as its comment says. Ends the program if the line is not exactly once in
    it."""
    lines, new = film.split("\n"), block.split("\n")
    if how == "new":
        return block
    if how == "below":
        return film + "\n" + block
    where = how.removeprefix("above ").removeprefix("in place of ")
    found = [i for i, line in enumerate(lines) if line.split(" ")[0] == where or line == where or line.split()[:1] == [where]]
    if len(found) != 1:
        sys.exit(f"{page}: '{where}' is {len(found)} times in the film")
    at = found[0]
    return "\n".join(lines[:at] + new + lines[at if how.startswith("above ") else block_end(lines, at):])


def texts(markdown):
    """Yields the parts of a page as texts. Blank lines within a block of code do not divide it."""
    part, inside = [], False
    for line in markdown.split("\n") + [""]:
        inside ^= line.startswith("```")
        if line or inside:
            part.append(line)
        elif part:
            yield "\n".join(part)
            part = []


def parts(markdown, page):
    film = ""
    for text in texts(markdown):
        mark = re.match(r"<!-- live: (.*?) -->\n?", text)
        text = text[mark.end():] if mark else text
        block = re.fullmatch(r"```[^\n]*\n(.*)\n```", text, re.S)
        code = block[1] if block else None
        if not mark:
            yield Part(text, code)
        elif mistake := re.fullmatch(r"with (.*) for (.*)", mark[1]):
            yield Part(text, code, film.replace(mistake[2], mistake[1]), wrong=True)
        else:
            film = changed(film, mark[1], code or "", page)
            yield Part(text, code, film, whole=mark[1] == "new")


def check(program, part, page):
    """Ends the program if a film has a mistake, or if it has none and `part.wrong` is set."""
    with tempfile.NamedTemporaryFile("w", suffix=".bx") as script:
        script.write(part.film), script.flush()
        run = subprocess.run([program, "check", script.name], capture_output=True, text=True)
    if (run.returncode != 0 or "warning:" in run.stdout + run.stderr) != part.wrong:
        sys.exit(f"{page}: this film {'has no mistake' if part.wrong else 'has one'}:\n{part.film}\n{run.stdout}{run.stderr}")


def player(film, name):
    return ("<betwixt-editor>\n<betwixt-player controls loop width=\"1280\" height=\"720\">\n"
            f"<script type=\"text/betwixt\" data-name=\"{html.escape(name)}\">\n{as_script_text(film)}\n</script>\n"
            "</betwixt-player>\n</betwixt-editor>\n")


def files_of(program, films, folder):
    """Returns the HTML element with the files that the films need. Copies the player and its style into the folder."""
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as scripts:
        paths = [f"{scripts}/{i}.bx" for i in range(len(films))]
        for path, film in zip(paths, films):
            with open(path, "w", encoding="utf-8") as script:
                script.write(film + "\n")
        made = subprocess.run([program, "web", *paths, "-o", f"{scripts}/all.html", "--link"], capture_output=True, text=True)
        if made.returncode != 0:
            sys.exit(made.stderr)
        for name in ("betwixt-player.js", "betwixt-page.css"):
            with open(f"{scripts}/{name}", "rb") as file, open(os.path.join(folder, name), "wb") as copy:
                copy.write(file.read())
        with open(f"{scripts}/all.html", encoding="utf-8") as page:
            found = re.search(r'<script type="application/json" data-betwixt-files>.*?</script>\n', page.read(), re.S)
    return found[0] if found else ""
