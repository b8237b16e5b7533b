# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
from collections.abc import Mapping
from datetime import timedelta
from os import PathLike
from typing import Any, Callable, Iterable, Literal, SupportsFloat, Union

import numpy as np
import numpy.typing as npt

from ._player import Player

# A frame number, a time of the language ("24f", "2.5s"), or a duration since the beginning.
Time = Union[SupportsFloat, str, timedelta, np.timedelta64]

Floats = npt.NDArray[np.float64]
Floats32 = npt.NDArray[np.float32]
Indices = npt.NDArray[np.uint32]

version: str

def diff(old: Film, now: Film) -> list[str]: ...
def styles() -> list[str]: ...
def send(name: str, data: bytes) -> str: ...

class Diagnostic:
    """An error, a warning or a notice about a script."""

    @property
    def severity(self) -> str: ...  # "notice", "warning", "error"
    @property
    def code(self) -> str: ...  # "syntax", "name", "type", "range", "file", "machine"
    @property
    def message(self) -> str: ...
    @property
    def hint(self) -> str: ...
    @property
    def file(self) -> str: ...
    @property
    def line(self) -> int: ...  # from 1; 0 if the place is unknown
    @property
    def column(self) -> int: ...
    @property
    def length(self) -> int: ...
    @property
    def text(self) -> str: ...  # the line's text

class Event:
    """A keyframe: a value at a time, and the interpolation to the next one. Times and durations are in frames."""

    @property
    def time(self) -> float: ...
    @property
    def seconds(self) -> float: ...
    @property
    def what(self) -> str: ...  # "value", "keep" (changes only the twerper) or "release" (ends a velocity)
    @property
    def value(self) -> Any: ...
    @property
    def before(self) -> Any: ...  # for a cut, the value at which the track arrives; otherwise None
    @property
    def twerper(self) -> str: ...  # "" if the script names none
    @property
    def arguments(self) -> list[float]: ...
    @property
    def stops(self) -> list[list[float]]: ...
    @property
    def ease_out(self) -> float: ...
    @property
    def ease_in(self) -> float: ...
    @property
    def tangent_in(self) -> Any: ...
    @property
    def tangent_out(self) -> Any: ...
    @property
    def handle_in(self) -> float | None: ...
    @property
    def handle_out(self) -> float | None: ...

class Track:
    """The events of one display function."""

    @property
    def name(self) -> str: ...  # "ball.position"
    @property
    def object(self) -> str: ...
    @property
    def velocity(self) -> bool: ...
    @property
    def layer(self) -> str | None: ...
    @property
    def twerper(self) -> str: ...  # of the whole track; "" if each event has its own
    @property
    def unsaid(self) -> str: ...  # the default twerper of its events
    @property
    def before(self) -> str: ...
    @property
    def after(self) -> str: ...
    @property
    def events(self) -> list[Event]: ...
    def __len__(self) -> int: ...

class Poses:
    """Where all objects are, frame by frame. The arrays are views."""

    @property
    def names(self) -> list[str]: ...
    @property
    def frames(self) -> Floats: ...
    @property
    def world(self) -> Floats: ...  # [frame, object, row, column]
    @property
    def parents(self) -> npt.NDArray[np.int32]: ...  # [frame, object]: index in `names`; -1 without a parent
    def __len__(self) -> int: ...
    def __getitem__(self, name: str) -> Floats: ...  # [frame, row, column] of one object

class Picture:
    """A picture of 8 bits a channel: sRGB, straight opacity, rows from the top."""

    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def pixels(self) -> npt.NDArray[np.uint8]: ...  # [row, column, r g b a], a view
    def __array__(self, dtype: npt.DTypeLike = None) -> npt.NDArray[Any]: ...
    def png(self) -> bytes: ...
    def _repr_png_(self) -> bytes: ...
    def write(self, path: str | PathLike[str], *, overwrite: bool = True) -> None: ...

class MeshPart:
    """A range of triangles with the same look."""

    @property
    def first(self) -> int: ...  # index of its first triangle
    @property
    def count(self) -> int: ...
    @property
    def color(self) -> Floats32: ...  # linear light
    @property
    def texture(self) -> Picture | None: ...
    @property
    def tinted(self) -> bool: ...  # whether the object's own colour multiplies it

class Mesh:
    """Triangles in the space of their object. The arrays are views."""

    @property
    def positions(self) -> Floats32: ...
    @property
    def normals(self) -> Floats32: ...
    @property
    def uvs(self) -> Floats32: ...  # (0 0) is the top left of the picture; empty, or one for each position
    @property
    def triangles(self) -> Indices: ...
    @property
    def edges(self) -> Indices: ...
    @property
    def parts(self) -> list[MeshPart]: ...  # empty if the mesh has one look
    @property
    def closed(self) -> bool: ...

class Item:
    """The visible part of an object."""

    @property
    def name(self) -> str: ...
    @property
    def body(self) -> str: ...  # the object that it forms one body with
    @property
    def kind(self) -> str: ...
    @property
    def world(self) -> Floats: ...
    @property
    def color(self) -> Floats: ...  # linear light
    @property
    def transparency(self) -> float: ...
    @property
    def shininess(self) -> float: ...
    @property
    def material(self) -> str: ...
    @property
    def casts(self) -> bool: ...
    @property
    def texture(self) -> Picture | None: ...
    def has_shape_of(self, other: Item) -> bool: ...
    def mesh(self, around: int = 48) -> Mesh: ...

class Light:
    """A lamp, or a sun."""

    @property
    def name(self) -> str: ...
    @property
    def sun(self) -> bool: ...
    @property
    def position(self) -> Floats: ...
    @property
    def direction(self) -> Floats: ...
    @property
    def color(self) -> Floats: ...  # linear light, intensity included
    @property
    def range(self) -> float: ...

class Camera:
    """The active camera."""

    @property
    def name(self) -> str: ...  # "" if the film has no camera
    @property
    def world(self) -> Floats: ...
    @property
    def orthographic(self) -> bool: ...
    @property
    def fov(self) -> float: ...  # horizontal, radians
    @property
    def height(self) -> float: ...  # if orthographic: metres from bottom to top
    @property
    def aspect(self) -> float: ...
    @property
    def shutter(self) -> float: ...  # seconds
    @property
    def aperture(self) -> float: ...  # metres
    @property
    def focus(self) -> float: ...  # metres
    @property
    def shift(self) -> tuple[float, float]: ...  # in halves of the picture

class Frame:
    """Everything visible at one time."""

    @property
    def time(self) -> float: ...
    @property
    def seconds(self) -> float: ...
    @property
    def items(self) -> list[Item]: ...
    @property
    def lights(self) -> list[Light]: ...
    @property
    def camera(self) -> Camera: ...
    @property
    def background(self) -> Floats | None: ...
    @property
    def ambient(self) -> Floats | None: ...
    @property
    def ground(self) -> Floats | None: ...
    @property
    def exposure(self) -> float: ...
    @property
    def sky(self) -> bool: ...
    @property
    def flat(self) -> bool: ...
    @property
    def clear(self) -> bool: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def problems(self) -> list[str]: ...

class KeyPiece:
    """A piece of time in which a value is held, linear or cubic (Hermite)."""

    @property
    def shape(self) -> str: ...  # "held", "straight", "cubic", "leap"
    @property
    def first(self) -> float: ...  # frames
    @property
    def last(self) -> float: ...
    @property
    def begin(self) -> Floats: ...
    @property
    def end(self) -> Floats: ...
    @property
    def leaving(self) -> Floats: ...  # if cubic: the tangent at `first`, per second
    @property
    def arriving(self) -> Floats: ...

class Channel:
    """A value over time, as pieces without gaps. Rotations are quaternions, x y z w."""

    @property
    def width(self) -> int: ...
    @property
    def constant(self) -> bool: ...
    @property
    def keys(self) -> int: ...
    @property
    def pieces(self) -> list[KeyPiece]: ...
    def at(self, time: Time) -> Floats: ...

class ObjectKeys:
    """The motion of an object. Its matrix is that of its parent times translation, rotation and scale, and times
    `inner`, a further rotation, if it is sheared."""

    @property
    def name(self) -> str: ...
    @property
    def parent(self) -> str | None: ...
    @property
    def sheared(self) -> bool: ...
    @property
    def translation(self) -> Channel: ...
    @property
    def rotation(self) -> Channel: ...
    @property
    def scale(self) -> Channel: ...
    @property
    def inner(self) -> Channel: ...

class Made:
    """The result of making a film: counts and times."""

    @property
    def frames(self) -> int: ...
    @property
    def found(self) -> int: ...  # pictures that already existed
    @property
    def seconds(self) -> float: ...
    @property
    def painting(self) -> float: ...
    @property
    def encoding(self) -> float: ...

class Film:
    """The film of a script. You can read and change it from any thread."""

    def __init__(
        self, text: str | bytes, name: str = "", *, read_anywhere: bool = False, tex: bool = False,
        lets: Mapping[str, object] = {}, language: str | None = None,
    ) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def rate(self) -> float: ...
    @property
    def range(self) -> tuple[float, float]: ...
    @property
    def size(self) -> tuple[int, int] | None: ...
    @property
    def objects(self) -> list[str]: ...
    @property
    def notes(self) -> list[tuple[float, str]]: ...
    @property
    def cuts(self) -> list[tuple[float, str]]: ...
    @property
    def sections(self) -> list[dict[str, Any]]: ...
    @property
    def steps(self) -> list[dict[str, Any]]: ...
    @property
    def descriptions(self) -> list[tuple[float, str]]: ...
    @property
    def kinds(self) -> dict[str, dict[str, Any]]: ...
    def kind(self, name: str) -> str: ...
    def time(self, time: Time) -> float: ...
    def seconds(self, time: Time) -> float: ...
    def breaks(self, after: Time, until: Time) -> list[float]: ...
    def eval(self, target: str, time: Time | Iterable[Time]) -> Any: ...
    def values(self, time: Time, pattern: str = "") -> dict[str, Any]: ...
    def say(self, lines: str) -> str: ...
    def set_track(
        self, target: str, times: Iterable[Time] | Floats, values: npt.ArrayLike, twerper: str = ""
    ) -> str: ...
    def track_numbers(self, target: str) -> tuple[Floats, Floats]: ...
    def undo(self) -> str: ...
    def redo(self) -> str: ...
    def write(self, path: str | PathLike[str]) -> None: ...
    def tracks(self, pattern: str = "") -> list[Track]: ...
    def poses(self, first: Time | None = None, last: Time | None = None, step: float = 1) -> Poses: ...
    def motion(
        self,
        first: Time | None = None,
        last: Time | None = None,
        *,
        style: str = "cubic",
        metres: float = 1e-4,
        radians: float = 1e-4,
        arcs: bool = True,
    ) -> list[ObjectKeys]: ...
    def keys(
        self,
        target: str,
        first: Time | None = None,
        last: Time | None = None,
        *,
        style: str = "cubic",
        tolerance: float = 1e-4,
    ) -> Channel: ...
    def frame(self, time: Time) -> Frame: ...
    def picture(
        self,
        time: Time,
        *,
        size: tuple[int, int] | None = None,
        style: str = "shaded",
        samples: int | Literal["auto"] | None = None,
        pixel_filter: str | None = None,
        shutter: str | None = None,
        subframes: int | None = None,
        denoise: bool = True,
    ) -> Picture: ...
    def render(
        self,
        path: str | PathLike[str],
        *,
        frames: tuple[Time, Time] | None = None,
        size: tuple[int, int] | None = None,
        style: str = "shaded",
        samples: int | Literal["auto"] | None = None,
        pixel_filter: str | None = None,
        shutter: str | None = None,
        subframes: int | None = None,
        denoise: bool = True,
        bits: int = 8,
        colors: str = "srgb",
        jobs: int = 0,
        overwrite: bool = True,
        missing: bool = False,
        progress: Callable[[int, int, float], object] | None = None,
    ) -> Made: ...
    def player(
        self,
        first: Time | None = None,
        last: Time | None = None,
        *,
        size: tuple[int, int] = (480, 270),
        style: str = "shaded",
        most: int = 60,
    ) -> Player: ...
    def _repr_html_(self) -> str: ...
