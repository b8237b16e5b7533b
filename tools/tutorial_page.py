# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# docs/tutorial.md as a page in which each film is alive. Comments there say what becomes of the film so far:
#   <!-- live: new -->                        the block below is a film
#   <!-- live: below -->                      its lines stand below all that was there
#   <!-- live: above LINE -->                 they stand above that line
#   <!-- live: in place of LINE -->           in place of that line and what is indented below it (a time: of that row)
#   <!-- live: with WORDS for WORDS -->       a mistake, which the next film has not
#   tutorial_page.py PROGRAM PAGE.html     PROGRAM checks each film; betwixt-player.js lies beside the page
import html, os, re, subprocess, sys, tempfile

program, out = sys.argv[1:]
root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
read = lambda path: open(os.path.join(root, path), encoding="utf-8").read()
as_script_text = lambda text: re.sub(r"<(\\*(?:/script|script|!--))", r"<\\\1", text, flags=re.I)


def block_at(lines, first):  # where what is indented below a line ends
    end = first + 1
    while end < len(lines) and lines[end].startswith(" "):
        end += 1
    return end


def changed(film, how, block):
    lines, new = film.split("\n"), block.split("\n")
    if how == "new":
        return block
    if how == "below":
        return film + "\n" + block
    where = how.removeprefix("above ").removeprefix("in place of ")
    found = [i for i, line in enumerate(lines) if line.split(" ")[0] == where or line == where or line.split()[:1] == [where]]
    if len(found) != 1:
        sys.exit(f"docs/tutorial.md: '{where}' stands {len(found)} times in the film so far")
    at = found[0]
    return "\n".join(lines[:at] + new + lines[at if how.startswith("above ") else block_at(lines, at):])


def checked(film, wrong):
    with tempfile.NamedTemporaryFile("w", suffix=".bx") as script:
        script.write(film), script.flush()
        said = subprocess.run([program, "check", script.name], capture_output=True, text=True)
    if (said.returncode != 0) != wrong:
        sys.exit(f"docs/tutorial.md: this film {'has no mistake' if wrong else 'has one'}:\n{film}\n{said.stdout}{said.stderr}")


def player(film, wrong):
    checked(film, wrong)
    return ("<betwixt-editor>\n<betwixt-player controls loop width=\"1280\" height=\"720\">\n"
            f"<script type=\"text/betwixt\" data-name=\"hop.bx\">\n{as_script_text(film)}\n</script>\n</betwixt-player>\n</betwixt-editor>\n")


def inline(text):
    pieces = re.split(r"(`[^`]+`)", text)
    for i, piece in enumerate(pieces):
        if i % 2:
            pieces[i] = f"<code>{html.escape(piece[1:-1])}</code>"
        else:
            piece = html.escape(piece, quote=False)
            piece = re.sub(r"!\[[^]]*\]\([^)]*\)", "", piece)  # the film itself is there
            piece = re.sub(r"\*\*(.+?)\*\*", r"<strong>\1</strong>", piece)
            piece = re.sub(r"(?<!\*)\*([^*]+)\*(?!\*)", r"<em>\1</em>", piece)
            pieces[i] = re.sub(r"\[([^]]+)\]\(([^)]+)\)", r'<a href="../../docs/\2">\1</a>', piece)
    return "".join(pieces)


def parts_of(markdown):  # with blank lines between; those within blocks are theirs
    part, inside = [], False
    for line in markdown.split("\n") + [""]:
        inside ^= line.startswith("```")
        if line or inside:
            part.append(line)
        elif part:
            yield "\n".join(part)
            part = []


def body(markdown):
    out, film, live = [], "", None
    for part in parts_of(markdown):
        if mark := re.match(r"<!-- live: (.*?) -->\n?", part):
            live, part = mark[1], part[mark.end():]
        block = re.fullmatch(r"```\w*\n(.*)\n```", part, re.S)
        if block and live != "new":
            out.append(f"<pre>{html.escape(block[1], quote=False)}</pre>")
        elif heading := re.fullmatch(r"(#+) (.*)", part):
            if len(heading[1]) > 1:
                out.append(f"<h2>{inline(heading[2])}</h2>")
        elif part and not block and (words := inline(part)).strip():
            out.append(f"<p>{words}</p>")
        if live and (mistake := re.fullmatch(r"with (.*) for (.*)", live)):
            out.append(player(film.replace(mistake[2], mistake[1]), True))
        elif live:
            film = changed(film, live, block[1] if block else "")
            out.append(player(film, False))
        live = None
    return "\n".join(out) + "\n"


style = read("web/page.css") + """pre, code { font: 0.86em/1.55 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
pre { max-width: 44rem; overflow: auto; margin: 0 0 1.2rem; padding: 0.7rem 1rem; border-radius: 8px; background: light-dark(#f1efeb, #1d2025); }
code { color: light-dark(#23262b, #dde0e4); }
a { color: light-dark(#0b5394, #8fc3f5); }
betwixt-editor { margin: 0 0 1.8rem; --betwixt-text-height: 26rem; }
"""
version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout.split()[-1]
parts = {"version": version, "title": "The tutorial", "css": style, "class": "edited", "films": body(read("docs/tutorial.md")), "files": "",
         "player": '<script src="betwixt-player.js"></script>'}
page = re.sub(r"\{\{(\w+)\}\}", lambda m: parts[m[1]], read("web/page.html"))
with open(out + ".new", "w", encoding="utf-8") as file:
    file.write(page)
os.replace(out + ".new", out)
print(f"{page.count('<betwixt-editor>')} films, {out}", file=sys.stderr)
