# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# docs/tutorial.md as a page in which each film is alive. Comments there say what becomes of the film so far:
#   <!-- live: new -->                        the block below is a film
#   <!-- live: below -->                      its lines stand below all that was there
#   <!-- live: above LINE -->                 they stand above that line
#   <!-- live: in place of LINE -->           in place of that line and what is indented below it (a time: of that row)
#   <!-- live: with WORDS for WORDS -->       a mistake, which the next film has not
#   tutorial_page.py PROGRAM PAGE.html     PROGRAM checks each film; betwixt-player.js is put beside the page
import base64, hashlib, html, os, re, subprocess, sys, tempfile

program, out = sys.argv[1:]
root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
films = []  # of the page
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
    if (said.returncode != 0 or "warning:" in said.stdout + said.stderr) != wrong:
        sys.exit(f"docs/tutorial.md: this film {'has no mistake' if wrong else 'has one'}:\n{film}\n{said.stdout}{said.stderr}")


def player(film, wrong):
    checked(film, wrong)
    if not wrong:
        films.append(film)
    return ("<betwixt-editor>\n<betwixt-player controls loop width=\"1280\" height=\"720\">\n"
            f"<script type=\"text/betwixt\" data-name=\"hop.bx\">\n{as_script_text(film)}\n</script>\n</betwixt-player>\n</betwixt-editor>\n")


# What the films need besides: the program knows, and makes a page of all of them.
def files_of(films):
    with tempfile.TemporaryDirectory() as folder:
        scripts = [f"{folder}/{i}.bx" for i in range(len(films))]
        for path, film in zip(scripts, films):
            with open(path, "w", encoding="utf-8") as script:
                script.write(film + "\n")
        made = subprocess.run([program, "web", *scripts, "-o", f"{folder}/all.html", "--link"], capture_output=True, text=True)
        if made.returncode != 0:
            sys.exit(made.stderr)
        for name in ("betwixt-player.js", "betwixt-page.css"):
            os.replace(f"{folder}/{name}", os.path.join(os.path.dirname(out) or ".", name))
        page = open(f"{folder}/all.html", encoding="utf-8").read()
    found = re.search(r'<script type="application/json" data-betwixt-files>.*?</script>\n', page, re.S)
    return found[0] if found else ""


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
    written, film, live = [], "", None
    for part in parts_of(markdown):
        if mark := re.match(r"<!-- live: (.*?) -->\n?", part):
            live, part = mark[1], part[mark.end():]
        block = re.fullmatch(r"```\w*\n(.*)\n```", part, re.S)
        if block and live != "new":
            written.append(f"<pre tabindex=\"0\">{html.escape(block[1], quote=False)}</pre>")
        elif heading := re.fullmatch(r"(#+) (.*)", part):
            if len(heading[1]) > 1:
                written.append(f"<h2>{inline(heading[2])}</h2>")
        elif part and not block and (words := inline(part)).strip():
            written.append(f"<p>{words}</p>")
        if live and (mistake := re.fullmatch(r"with (.*) for (.*)", live)):
            written.append(player(film.replace(mistake[2], mistake[1]), True))
        elif live:
            film = changed(film, live, block[1] if block else "")
            written.append(player(film, False))
        live = None
    return "\n".join(written) + "\n"


style = """
pre, code { font: 0.86em/1.55 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
pre { max-width: 44rem; overflow: auto; margin: 0 0 1.2rem; padding: 0.7rem 1rem; border-radius: 8px; background: light-dark(#f1efeb, #1d2025); }
code { color: light-dark(#23262b, #dde0e4); }
a { color: light-dark(#0b5394, #8fc3f5); }
betwixt-editor { margin: 0 0 1.8rem; --betwixt-text-height: 26rem; }
"""
look = f'<link rel="stylesheet" href="betwixt-page.css">\n<style>{style}</style>'
# As src/app/page_policy.cpp says it of pages with their files beside them.
hashed = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
policy = ("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; "
          f"style-src 'self' 'sha256-{hashed}'; connect-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'; "
          "require-trusted-types-for 'script'; trusted-types 'none'\">")
version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout.split()[-1]
parts = {"policy": policy, "version": version, "title": "The tutorial", "look": look, "class": "edited", "films": body(read("docs/tutorial.md")),
         "files": files_of(films), "player": '<script src="betwixt-player.js"></script>'}
page = re.sub(r"\{\{(\w+)\}\}", lambda m: parts[m[1]], read("web/page.html"))
with open(out + ".new", "w", encoding="utf-8") as file:
    file.write(page)
os.replace(out + ".new", out)
print(f"{page.count('<betwixt-editor>')} films, {out}", file=sys.stderr)
