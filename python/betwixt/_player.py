# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""The player that a notebook shows for a film: pictures, a button and a slider. It needs no other files."""

from __future__ import annotations

import base64
import html
import itertools
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._core import Film, Time

_numbers = itertools.count(1)

# Without scripts the page shows the first picture. Playing stops when the element leaves the page.
_PAGE = """<div id="{id}" class="betwixt-player" style="display:inline-block">
<img src="{first}" width="{width}" height="{height}" alt="{name}" style="display:block">
<div style="display:flex;gap:.5em;align-items:center;font:13px sans-serif">
<button type="button" title="play and pause">&#9654;</button>
<input type="range" min="0" max="{last}" value="0" style="flex:1">
<output style="min-width:5em;text-align:right">{label}</output></div>
<script>(function () {{
  var player = document.getElementById("{id}"), image = player.querySelector("img");
  var button = player.querySelector("button"), slider = player.querySelector("input");
  var said = player.querySelector("output");
  var pictures = [{pictures}], labels = [{labels}], wait = {wait}, timer = null;
  function show(k) {{ image.src = "data:image/png;base64," + pictures[k]; slider.value = k; said.value = labels[k]; }}
  function pause() {{ clearInterval(timer); timer = null; button.innerHTML = "&#9654;"; }}
  function step() {{ if (!player.isConnected) return pause(); show((Number(slider.value) + 1) % pictures.length); }}
  button.onclick = function () {{
    if (timer !== null) return pause();
    timer = setInterval(step, wait); button.innerHTML = "&#10074;&#10074;";
  }};
  slider.oninput = function () {{ pause(); show(Number(slider.value)); }};
}})();</script></div>"""


class Player:
    """Pictures of a film for a notebook, which can play them: at most `most` pictures at equal steps of time."""

    def __init__(self, film: Film, first: Time | None = None, last: Time | None = None, *,
                 size: tuple[int, int] = (480, 270), style: str = "shaded", most: int = 60) -> None:
        start, end = film.range
        start = start if first is None else film.time(first)
        end = end if last is None else film.time(last)
        if most < 1 or end < start:
            raise ValueError("a player shows one picture or more, from the first to the last")
        step = max(1, -(-int(end - start + 1) // most))
        self.frames = [start + step * k for k in range(int((end - start) // step) + 1)]
        self.size = size
        self.seconds_each = step / film.rate
        self.name = film.name
        self.pictures = [film.picture(t, size=size, style=style).png() for t in self.frames]

    def __repr__(self) -> str:
        return f"<Player of {len(self.frames)} pictures>"

    def _repr_html_(self) -> str:
        """Returns the player as HTML, which notebooks show."""
        coded = [base64.b64encode(p).decode() for p in self.pictures]
        labels = [f"{t:g}f" for t in self.frames]
        return _PAGE.format(
            id=f"betwixt-player-{next(_numbers)}-{id(self):x}", name=html.escape(self.name or "film", quote=True),
            width=self.size[0], height=self.size[1], first="data:image/png;base64," + coded[0], label=labels[0],
            last=len(coded) - 1, pictures=",".join(f'"{c}"' for c in coded), labels=",".join(f'"{w}"' for w in labels),
            wait=round(1000 * self.seconds_each))
