# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Makes a web page of docs/tutorial.md with live films (tools/live_films.py).
#   tutorial_page.py PROGRAM PAGE.html     checks each film with PROGRAM; copies betwixt-player.js to the page's folder
import base64, hashlib, html, os, re, subprocess, sys

import live_films

program, out = sys.argv[1:]
root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
films = []  # the live films of the page that have no mistake
read = lambda path: open(os.path.join(root, path), encoding="utf-8").read()


def inline(text):
    pieces = re.split(r"(`[^`]+`)", text)
    for i, piece in enumerate(pieces):
        if i % 2:
            pieces[i] = f"<code>{html.escape(piece[1:-1])}</code>"
        else:
            piece = html.escape(piece, quote=False)
            piece = re.sub(r"!\[[^]]*\]\([^)]*\)", "", piece)  # the live film replaces the picture
            piece = re.sub(r"\*\*(.+?)\*\*", r"<strong>\1</strong>", piece)
            piece = re.sub(r"(?<!\*)\*([^*]+)\*(?!\*)", r"<em>\1</em>", piece)
            pieces[i] = re.sub(r"\[([^]]+)\]\(([^)]+)\)", r'<a href="../../docs/\2">\1</a>', piece)
    return "".join(pieces)


def body(page):
    written = []
    for part in live_films.parts(read(page), page):
        if part.code is not None and not part.whole:
            written.append(f"<pre tabindex=\"0\">{html.escape(part.code, quote=False)}</pre>")
        elif heading := re.fullmatch(r"(#+) (.*)", part.text):
            if len(heading[1]) > 1:
                written.append(f"<h2>{inline(heading[2])}</h2>")
        elif part.code is None and (words := inline(part.text)).strip():
            written.append(f"<p>{words}</p>")
        if part.film is not None:
            live_films.check(program, part, page)
            written.append(live_films.player(part.film, "hop.bx"))
            if not part.wrong:
                films.append(part.film)
    return "\n".join(written) + "\n"


style = """
pre, code { font: 0.86em/1.55 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
pre { max-width: 44rem; overflow: auto; margin: 0 0 1.2rem; padding: 0.7rem 1rem; border-radius: 8px; background: light-dark(#f1efeb, #1d2025); }
code { color: light-dark(#23262b, #dde0e4); }
a { color: light-dark(#0b5394, #8fc3f5); }
betwixt-editor { margin: 0 0 1.8rem; --betwixt-text-height: 26rem; }
"""
look = f'<link rel="stylesheet" href="betwixt-page.css">\n<style>{style}</style>'
# The same policy as src/app/page_policy.cpp gives to pages whose files are in the same folder.
hashed = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
policy = ("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; "
          f"style-src 'self' 'sha256-{hashed}'; connect-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'; "
          "require-trusted-types-for 'script'; trusted-types 'none'\">")
version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout.split()[-1]
parts = {"policy": policy, "version": version, "title": "The tutorial", "look": look, "class": "edited", "films": body("docs/tutorial.md"),
         "files": live_films.files_of(program, films, os.path.dirname(out) or "."), "player": '<script src="betwixt-player.js"></script>'}
page = re.sub(r"\{\{(\w+)\}\}", lambda m: parts[m[1]], read("web/page.html"))
with open(out + ".new", "w", encoding="utf-8") as file:
    file.write(page)
os.replace(out + ".new", out)
print(f"{page.count('<betwixt-editor>')} films, {out}", file=sys.stderr)
