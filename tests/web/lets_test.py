# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests values from outside and other languages in pages: betwixt web --let and --language, player.lets, engine.open.
# Skipped if the player is not built.
#   lets_test.py PROGRAM
import os, subprocess, sys, tempfile
from browser import Browser
from checks import check, done, player, same, there_is_a_player

program = os.path.abspath(sys.argv[1])
there_is_a_player()
folder_of_test = tempfile.TemporaryDirectory()
folder = folder_of_test.name
environment = {**os.environ, "BETWIXT_PLAYER": player}
film = 'size 64x36\nfilm flat\nlet size = 2\nlet title = "One"\ncreate ball circle radius=size\ncreate word text text=title\ncreate greeting text text="Hello"\n'
files = {"film.bx": film, "own.bx": 'language "de.po"\n' + film, "de.po": 'msgid "Hello"\nmsgstr "Grüß Gott"\n', "fr.po": 'msgid "Hello"\nmsgstr "Salut"\n'}
for name, text in files.items():
    with open(f"{folder}/{name}", "w", encoding="utf-8") as out:
        out.write(text)


def opened(browser, *words):
    said = subprocess.run([program, "web", *words, "-o", "page.html"], cwd=folder, env=environment, capture_output=True, text=True)
    same(f"{words}: a page", said.returncode, 0)
    page = browser.page(f"file://{folder}/page.html")
    page.do("window.p = document.querySelector('betwixt-player')")
    page.until("p.readyState === 4")
    return page


values = "[p.eval('ball.radius', 0), p.eval('word.text', 0), p.eval('greeting.text', 0)]"
with Browser() as browser:
    page = opened(browser, "film.bx")
    same("as it is written", page.ask(values), [2, "One", "Hello"])
    page.do("p.lets = { size: 5, title: 'a \"b\"' }")
    page.until("p.eval('ball.radius', 0) === 5")
    same("other values", page.ask(values), [5, 'a "b"', "Hello"])
    page.do("p.script = p.script.replace('radius=size', 'radius=size*2')")
    page.until("p.eval('ball.radius', 0) === 10")
    page.do("p.film.setTrack('ball.position', [0, 1], [0, 0, 0, 1, 0, 0])")
    same("they stay in edits", page.ask("p.eval('ball.radius', 0)"), 10)
    page.do("p.lets = { siez: 5 }")
    page.until("p.diagnostics.length")
    same("one that the script lacks", page.ask("p.diagnostics[0].text"), "--let siez=5: the script has no 'let siez'")
    page.do(f"const e = await Betwixt.engine(), f = e.open({film!r}, {{ lets: {{ size: 7 }} }}); window.seven = f.eval('ball.radius', 0); f.dispose()")
    same("the engine takes them", page.ask("seven"), 7)
    page.close()
    page = opened(browser, "film.bx", "--let", "size=3", "--let", 'title=<"&', "--language", "fr.po")
    same("those of the page", page.ask(values), [3, '<"&', "Salut"])
    page.close()
    page = opened(browser, "own.bx")
    same("a script with a language", page.ask(values), [2, "One", "Grüß Gott"])
    page.close()
    page = opened(browser, "own.bx", "--language", "")
    same("without it", page.ask(values), [2, "One", "Hello"])
    page.close()
done()
