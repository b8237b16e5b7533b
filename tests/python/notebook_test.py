# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests the player in a notebook."""

import base64
import html.parser
import os
import re
import shutil
import subprocess
import tempfile
import unittest

from support import example

import betwixt

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)

# Presses the button, lets the player play, and records the pictures.
ACTS = """<script>
(function () {
  var player = document.querySelector(".betwixt-player"), image = player.querySelector("img"), shown = [image.src];
  var looks = new MutationObserver(function () {
    shown.push(image.src);
    if (shown.length < 5) return;
    looks.disconnect();
    player.querySelector("button").click();
    var slider = player.querySelector("input");
    slider.value = 1; slider.oninput();
    var pictures = Array.from(new Set(shown)).length, label = player.querySelector("output").value;
    document.title = "done";
    var said = pictures + " " + label + " " + (image.src === shown[1]);
    document.body.insertAdjacentHTML("beforeend", "<p>" + said + "</p>");
  });
  looks.observe(image, {attributes: true, attributeFilter: ["src"]});
  player.querySelector("button").click();
})();
</script>"""


class Parser(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.images, self.script, self.links = [], [], "", []

    def handle_starttag(self, tag, attrs):
        if tag not in ("img", "input"):
            self.open.append(tag)
        if tag == "img":
            self.images.append(dict(attrs)["src"])
        self.links += [v for k, v in attrs if k in ("src", "href") and not v.startswith("data:")]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        if self.open[-1:] == ["script"]:
            self.script += data


class Notebook(unittest.TestCase):
    def setUp(self):
        self.film = betwixt.load(example("bounce.bx"))

    def test_pictures_show_themselves(self):
        self.assertTrue(self.film.picture(1, size=(16, 9))._repr_png_().startswith(b"\x89PNG"))

    def test_a_film_is_a_page_of_its_own(self):
        player = self.film.player(1, 5, size=(32, 18))
        self.assertEqual((player.frames, player.seconds_each), ([1, 2, 3, 4, 5], 1 / 24))
        page = Parser()
        page.feed(player._repr_html_())
        page.close()
        self.assertEqual((page.open, page.links), ([], []))  # all elements are closed, nothing is fetched
        first = base64.b64decode(page.images[0].split(",", 1)[1])
        self.assertEqual(first, self.film.picture(1, size=(32, 18)).png())
        inside = [base64.b64decode(c) for c in re.findall(r'"([A-Za-z0-9+/=]{100,})"', page.script)]
        self.assertEqual(inside, [self.film.picture(t, size=(32, 18)).png() for t in range(1, 6)])
        self.assertNotEqual(player._repr_html_(), player._repr_html_())  # two players have different ids

    def test_long_films_are_shown_in_steps(self):
        player = self.film.player(size=(16, 9), most=10)
        self.assertEqual(player.frames, list(range(1, 73, 8)))
        self.assertAlmostEqual(player.seconds_each, 8 / 24)
        self.assertEqual(len(Parser().images), 0)
        self.assertIn('class="betwixt-player"', betwixt.loads("create b box")._repr_html_())
        for wrong in (lambda: self.film.player(5, 1), lambda: self.film.player(most=0)):
            self.assertRaises(ValueError, wrong)

    def test_names_of_files_are_words(self):
        film = betwixt.loads("create b box", '"><script>alert(1)</script>.bx')
        self.assertNotIn("alert(1)</script>", film.player(1, 1, size=(16, 9))._repr_html_())

    @unittest.skipUnless(shutil.which("node"), "there is no node here")
    def test_its_script_can_be_read(self):
        page = Parser()
        page.feed(self.film.player(1, 3, size=(16, 9))._repr_html_())
        said = subprocess.run(["node", "--check", "-"], input=page.script, capture_output=True, text=True)
        self.assertEqual((said.returncode, said.stderr), (0, ""))

    @unittest.skipUnless(BROWSER, "there is no Chromium here")
    def test_it_plays_in_a_browser(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "page.html")
            with open(path, "w") as page:
                page.write("<!DOCTYPE html><body>" + self.film.player(1, 3, size=(32, 18))._repr_html_() + ACTS)
            said = subprocess.run(
                [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
                 "--virtual-time-budget=5000", "--dump-dom", "file://" + path],
                capture_output=True, text=True, timeout=100)
        self.assertIn("3 2f true", said.stdout, said.stderr[-2000:])
