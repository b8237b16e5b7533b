#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the documentation as a site: it is built, search finds a page, films play, and nothing is loaded from other
# servers. Tests it from a folder and from a server.
#   site_test.py PROGRAM [FOLDER for pictures]
import glob, os, re, shutil, subprocess, sys, tempfile
from browser import Browser, Served
from checks import check, done, player, root, same

program = os.path.abspath(sys.argv[1])
pictures = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else None
for there, what in ((shutil.which("mkdocs"), "MkDocs is not installed (tools/site-packages.txt)"),
                    (os.path.exists(player), "the player for pages is not built (./betwixt web)")):
    if not there:
        print(f"left out: {what}\n0 passed, 0 failed")
        sys.exit()
folder = tempfile.mkdtemp(prefix="betwixt-site-")
loaded_from_elsewhere = re.compile(r"""<(?:script|img|iframe)[^>]*\ssrc=["']?(?:https?:)?//[^"' >]*|<link[^>]*\srel=["']?(?:stylesheet|icon|preconnect)[^>]*(?:https?:)?//[^>]*""")


def look(page, name):
    if pictures:
        page.picture(f"{pictures}/{name}.png")


def search(page, words):
    """Returns the addresses that search finds. Results come while the query is typed, so the address of each must
    contain the query."""
    page.do("document.querySelector('#__search').checked = true; document.querySelector('.md-search__input').focus()")
    page.type(words)
    page.until(f"document.querySelector('.md-search-result__link')?.href.includes('{words.split()[-1]}') ?? false")
    return page.ask("[...document.querySelectorAll('.md-search-result__link')].map((a) => a.href)")


def film(page, name):
    page.do("window.p = document.querySelector('betwixt-player'); p.scrollIntoView({block: 'center'})")
    page.until("p.readyState === 4")
    page.do("await p.play()")
    check(f"{name}: the film plays", page.until("p.currentTime > 0.2"))
    page.do("p.pause()")


def site(browser, address, way):
    page = browser.page(f"{address}/index.html", size=(1200, 900))
    look(page, f"{way}-front")
    film(page, f"the front page, {way}")
    look(page, f"{way}-film")
    page.go(f"{address}/guide/events.html")
    look(page, f"{way}-guide")
    film(page, f"a page of the guide, {way}")
    found = search(page, "inverse kinematics")
    look(page, f"{way}-search")
    check(f"search finds the section, {way}", any("guide/attachment.html" in a for a in found), found)
    page.go(f"{address}/reference.html#display-functions")
    check(f"an anchor of the reference, {way}", page.ask("document.getElementById('display-functions') !== null"))
    look(page, f"{way}-reference")
    same(f"what the pages complain of, {way}", page.said, [])
    page.close()


try:
    made = subprocess.run([f"{root}/tools/site.sh", program, f"{folder}/site"], capture_output=True, text=True)
    if check("the site is built", made.returncode == 0, made.stdout + made.stderr):
        elsewhere = [m[0] for f in glob.glob(f"{folder}/site/**/*.html", recursive=True)
                     for m in loaded_from_elsewhere.finditer(open(f, encoding="utf-8").read())]
        same("nothing comes from other servers", elsewhere, [])
        with Browser() as browser:
            site(browser, f"file://{folder}/site", "from a folder")
            with Served(f"{folder}/site") as address:
                site(browser, address, "from a server")
finally:
    shutil.rmtree(folder, ignore_errors=True)
done()
