# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Betwixt makes films from scripts: a script says what happens to objects and when.

    import betwixt
    film = betwixt.load("bounce.bx")
    film.eval("ball.position", 24)          # at frame 24; words too: "24f", "2.5s"
    film.say("at 24f hide ball")            # any line of the language; film.undo() takes it back

All of it is on the page "From Python", docs/python.md.
"""

from __future__ import annotations

import os

from . import _core
from ._core import (
    Camera,
    Channel,
    Diagnostic,
    Event,
    Film,
    Frame,
    Item,
    KeyPiece,
    Light,
    Made,
    Mesh,
    MeshPart,
    ObjectKeys,
    Picture,
    Poses,
    Track,
    styles,
)
from ._errors import Error, Warning
from ._player import Player

__all__ = ["Camera", "Channel", "Diagnostic", "Error", "Event", "Film", "Frame", "Item", "KeyPiece", "Light", "Made",
           "Mesh", "MeshPart", "ObjectKeys", "Picture", "Player", "Poses", "Track", "Warning", "load", "loads",
           "styles"]
__version__ = _core.version

def load(path: str | os.PathLike[str], *, read_anywhere: bool = False, tex: bool = False) -> Film:
    """The film of a script. It reads meshes and pictures below the script's folder only, but with `read_anywhere`; with
    `tex`, formulas are set by the programs latex and dvisvgm."""
    with open(path, "rb") as script:
        text = script.read()
    return Film(text, os.fspath(path), read_anywhere=read_anywhere, tex=tex)


def loads(text: str, name: str = "", *, read_anywhere: bool = False, tex: bool = False) -> Film:
    """The film of a text. `name` is that of the file in which it could stand: errors say it, and files are found from
    there."""
    return Film(text, name, read_anywhere=read_anywhere, tex=tex)


for _ in [globals()[name] for name in __all__]:
    if isinstance(_, type):
        _.__module__ = __name__  # where users find them
