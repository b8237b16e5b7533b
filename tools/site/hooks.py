# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Hooks of MkDocs that make the site: they rewrite links out of docs/, add live films, and make search work without a
server."""

import functools
import html
import json
import os
import re
import sys

from mkdocs.structure.files import File

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools"))
import doc_pages  # noqa: E402
import live_films  # noqa: E402

PROGRAM = os.environ["BETWIXT_PROGRAM"]
OUTSIDE = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md")  # pages of the site that are not in docs/
films_of_page = {}  # path of a page in the site's sources -> its live films


def repository_path(uri):
    """Returns the path of a page in the repository."""
    return uri if uri in OUTSIDE else f"docs/{uri}"


def site_path(path):
    """Returns the path of a file on the site, or None for a folder. Source files get the ending .txt, so that a browser
    shows them."""
    if path.startswith("docs/"):
        return path.removeprefix("docs/")
    if path in OUTSIDE:
        return path
    return f"source/{path}.txt" if os.path.isfile(os.path.join(ROOT, path)) else None


def linked_files(page):
    """Yields (link, path in the repository) for each link of a page to a file."""
    for _, link in doc_pages.links(doc_pages.read(page)):
        path = link.partition("#")[0]
        if path and not doc_pages.is_outside(link):
            yield link, os.path.normpath(os.path.join(os.path.dirname(page), path))


def on_files(files, config):
    def add(path, source):
        file = File(path, ROOT, config["site_dir"], False)
        file.abs_src_path = source
        files.append(file)

    for path in OUTSIDE:
        add(path, os.path.join(ROOT, path))
    for name in ("site.css", "search.js"):
        add(name, os.path.join(ROOT, "tools/site", name))
    for file in files.documentation_pages():
        for _, path in linked_files(repository_path(file.src_uri)):
            there = site_path(path)
            if there and there.startswith("source/") and there not in files:
                add(there, os.path.join(ROOT, path))
    return files


@functools.cache
def site_links(page):
    """Returns a map from each link of a page to its target on the site. The target is None for a folder."""
    here = os.path.dirname(site_path(page)) or "."
    leads = {link: (site_path(path), link.partition("#")) for link, path in linked_files(page)}
    return {link: there and os.path.relpath(there, here) + mark + anchor for link, (there, (_, mark, anchor)) in leads.items()}


def with_site_links(markdown, page):
    """Returns a part of a page with its links changed to files of the site. A link to a folder becomes plain text."""
    def one(match):
        link = site_links(page).get(match[2], match[2])
        return f"{match[1]}({link})" if link else match[1][1:-1]

    return doc_pages.LINK.sub(one, markdown)


def for_markdown(text, headings):
    """Changes a part of a page outside code for Python's Markdown: headings get the anchors of GitHub, code in tables
    loses the backslash before `|`, and indented lines are indented twice as far."""
    lines = []
    for line in text.split("\n"):
        if re.match(r"#+ ", line):
            line += " {: #" + next(headings) + " }"
        elif line.startswith("|"):
            line = re.sub(r"`[^`]*`", lambda m: m[0].replace("\\|", "|"), line)
        indent = len(line) - len(line.lstrip(" "))
        lines.append(" " * indent + line)
    return "\n".join(lines)


def on_page_markdown(markdown, page, config, files):
    path = repository_path(page.file.src_uri)
    headings = iter([anchor for _, _, anchor in doc_pages.headings(markdown)])
    films, written = [], []
    for part in live_films.parts(markdown, path):
        if part.code is not None and not part.whole:
            written.append(re.sub(r"^```(\w*).*", r"```\1", part.text))
        elif part.code is None:
            written.append(for_markdown(with_site_links(part.text, path), headings))
        if part.film is not None:
            if written and re.fullmatch(r"!\[[^]]*\]\([^)]*\)", written[-1]):
                written.pop()  # the live film replaces its picture
            live_films.check(PROGRAM, part, path)
            written.append(f'<div data-film="{len(films)}"></div>')
            films.append(part)
    films_of_page[page.file.src_uri] = films
    return "\n\n".join(written)


def on_page_content(content, page, config, files):
    """Puts the scripts of the films into the page, so that search finds them."""
    films = films_of_page.get(page.file.src_uri)
    text = lambda m: f"{m[1]}<pre>{html.escape(films[int(m[2])].film)}</pre>"  # noqa: E731
    return re.sub(r'(<div data-film="(\d+)">)', text, content) if films else content


def on_post_page(output, page, config):
    """Replaces the scripts of the films by players. The search index is made before this, so that it has no packed
    files."""
    films = films_of_page.get(page.file.src_uri)
    if not films:
        return output
    output = re.sub(r'<div data-film="(\d+)">.*?</div>', lambda m: live_films.player(films[int(m[1])].film, "film.bx"), output, flags=re.S)
    packed = live_films.files_of(PROGRAM, [f.film for f in films if not f.wrong], config["site_dir"])
    up = "../" * page.file.dest_uri.count("/")
    return output.replace("</body>", f'{packed}<script src="{up}betwixt-player.js"></script>\n</body>')


def on_post_build(config):
    """Writes the index and the worker of the search as one script. Pages that you open from a folder cannot fetch
    files."""
    site = config["site_dir"]
    worker = next(n for n in os.listdir(f"{site}/assets/javascripts/workers") if n.endswith(".min.js"))
    with open(f"{site}/search/search_index.json", encoding="utf-8") as file:
        index = file.read()
    with open(f"{site}/assets/javascripts/workers/{worker}", encoding="utf-8") as file:
        source = file.read().partition("//# sourceMappingURL")[0]
    with open(f"{site}/search/without_server.js", "w", encoding="utf-8") as file:
        file.write(f"var __search = {{ index: Promise.resolve({index}),\n  worker: URL.createObjectURL(new Blob([{json.dumps(source)}])) }};\n")
