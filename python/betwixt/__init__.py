# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Betwixt makes animated films from scripts. A script gives values at times.

    import betwixt
    film = betwixt.load("bounce.bx")
    film.eval("ball.position", 24)          # at frame 24; also "24f" or "2.5s"
    film.say("at 24f hide ball")            # any line of the language; film.undo() takes it back

The page "From Python" explains the module: python.md in /usr/share/doc/betwixt, and the description of the wheel.
"""

from __future__ import annotations

import os
from collections.abc import Mapping

try:
    from . import _core
except ImportError as _why:  # the linker's words name a file, not what installs it
    if "cannot open shared object" in str(_why):
        raise ImportError(f"betwixt needs a library that is not installed ({_why}). Debian's package betwixt installs "
                          "it: sudo apt install ./betwixt_*.deb") from None
    if "'_core'" in str(_why):
        raise ImportError("this module betwixt is built for another Python than this one. Debian's Python can import "
                          "it: /usr/bin/python3") from None
    raise
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
    diff,
    send,
    styles,
)
from ._errors import Error, Warning
from ._player import Player

__all__ = ["Camera", "Channel", "Diagnostic", "Error", "Event", "Film", "Frame", "Item", "KeyPiece", "Light", "Made",
           "Mesh", "MeshPart", "ObjectKeys", "Picture", "Player", "Poses", "Track", "Warning", "diff", "load", "loads",
           "send", "styles"]
__version__ = _core.version

def load(path: str | os.PathLike[str], *, read_anywhere: bool = False, tex: bool = False,
         lets: Mapping[str, object] = {}, language: str | None = None) -> Film:
    """Returns the film of a script file. The script reads only files below its own folder, unless `read_anywhere` is
    true. With `tex`, the programs latex and dvisvgm set its TeX formulas. `lets` has other values for lets of the
    script: {"size": 2, "title": "The end"}. `language` is a gettext catalogue of its texts, a .po file."""
    with open(path, "rb") as script:
        text = script.read()
    return Film(text, os.fspath(path), read_anywhere=read_anywhere, tex=tex, lets=lets, language=language)


def loads(text: str, name: str = "", *, read_anywhere: bool = False, tex: bool = False,
          lets: Mapping[str, object] = {}, language: str | None = None) -> Film:
    """Returns the film of a text. `name` is a file name for the text: errors show it, and paths in the script are
    relative to its folder."""
    return Film(text, name, read_anywhere=read_anywhere, tex=tex, lets=lets, language=language)


for _ in [globals()[name] for name in __all__]:
    if isinstance(_, type):
        _.__module__ = __name__  # so that help and errors show betwixt.Film instead of betwixt._core.Film
