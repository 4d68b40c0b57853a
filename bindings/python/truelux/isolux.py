# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of light on flat surfaces: jumps and kinks, contours of equal
irradiance, extrema."""

from __future__ import annotations

from typing import NamedTuple, Optional

import numpy as np

from . import _truelux
from .arrays import (check_channel, error, numbers, positive, thread_count,
                     warn, whole, word)
from .progress import Bar

_KINDS = np.array(_truelux.SURFACE_LINE_KINDS)
_PLACES = np.array(_truelux.CONTOUR_PLACES)
_EXTREMA = np.array(_truelux.EXTREMUM_KINDS)


class SurfaceLines:
    """Straight lines on a surface, across which E or its gradient jumps. Which
    there are is decided exactly; each coordinate is rounded once.

    Attributes
    ----------
    kind : (n,) of str
        "jump": a face stands there, or goes through, and E may jump; "kink": E
        is continuous, and its gradient jumps.
    ends : (n, 2, 3)
        From where to where, in the scene's frame.
    size : (n, 3)
        Of a kink: b in its middle [W/m^3]: beside the line the gradient jumps by
        2 b m, m the unit normal of the plane through the edges. 0 of a jump.
    left, right : (n, 3)
        Of a jump: E in its middle [W/m^2], 2^-36 of the surface's size to the
        left and to the right of the way from end to end, as seen from the lit
        side. 0 of a kink.
    faces : list of n lists of int
        The faces that stand there; of a kink those that lie in the plane and are
        seen edge-on; counted from 1.
    edges : list of n lists of pairs
        Of a kink: edges that cover each other as seen from the line, by indices
        into `Scene.vertices`, the lower one first; (-1, -1): where faces pierce
        each other.
    is_complete : bool
        False if the scene has so many edges that only those were looked at in
        pairs that meet in a vertex.
    notes : list of str
        What was told by warnings.
    """

    def __init__(self, found: dict):
        self.kind = _KINDS[found["kind"]]
        for name in ("ends", "size", "left", "right", "faces", "edges",
                     "is_complete", "notes"):
            setattr(self, name, found[name])

    def __len__(self) -> int:
        return len(self.kind)

    def __repr__(self) -> str:
        return f"<truelux.SurfaceLines: {_counted(self.kind, 'no lines')}>"


class IsoluxContour(NamedTuple):
    """A line on which E is a level, with what is larger on its left as seen from
    the lit side."""

    level: float
    """[W/m^2]."""
    face: int
    """A face that looks to the contour's side, for on_face."""
    closed: bool
    """Whether a chord goes from the last vertex to the first."""
    vertices: np.ndarray
    """In the scene's frame; shape (n, 3)."""
    across: np.ndarray
    """Of length 1, along the surface, to larger E; shape (n, 3)."""
    half_width: np.ndarray
    """Of the transversals [length], the segments from ``vertices - half_width *
    across`` to ``vertices + half_width * across``; shape (n,)."""
    certified: np.ndarray
    """Whether E is proven to be below the level at the first end of the
    transversal and above it at the second. E is continuous between them, so that
    the contour passes there; bool, shape (n,)."""
    on: np.ndarray
    """Where vertices lie: "inside"; "kink", a line across which the gradient
    jumps; and where contours end: "jump", at a face that stands on the surface,
    "outline"; str, shape (n,)."""
    widths: np.ndarray
    """How far the contour is from the chord that begins at a vertex, at most
    [length]; inf: not known. Shape (n,) if closed, else (n - 1,)."""

    @property
    def transversals(self) -> np.ndarray:
        """Both ends of each transversal, that of smaller E first; shape
        (n, 2, 3)."""
        way = self.half_width[:, None] * self.across
        return np.stack([self.vertices - way, self.vertices + way], axis=1)

    def __repr__(self) -> str:
        return (f"<truelux.IsoluxContour: {self.level!r} W/m^2, "
                f"{len(self.vertices)} vertices, "
                f"{'closed' if self.closed else 'open'}>")


class Isolux:
    """Contours of a surface, with what is known about those that are missing.

    Attributes
    ----------
    levels : (l,)
        [W/m^2], ascending.
    contours : list of IsoluxContour
        By levels.
    lines : SurfaceLines
        Where E or its gradient jumps.
    outline : (k, 2, 3)
        The surface's outline, each side once.
    open : (k, 3, 3)
        Triangles in which it is not proven which contours there are. All other
        parts of the surface (but for a margin of 2^-36 of its size along
        outlines and jumps) have the contours that are listed, and no others.
    open_range : (k, 2)
        E lies between these there [W/m^2]; 0 and the largest exitance if nothing
        better is known.
    size : float
        The longer side of the surface's extent [length].
    area, open_area : float
        Of the surface, and of `open` [length^2].
    dark_area : float
        At least so much has E = 0, proven [length^2].
    least, most : float
        The least and the largest E that were met [W/m^2]; `Oracle.extrema` has
        proven ones.
    evaluations, search_evaluations, line_evaluations : int
        How often E was evaluated: to settle what is where, and for vertices and
        chords.
    triangles : int
        How many the surface was cut into.
    """

    def __init__(self, found: dict):
        self.contours = [
            IsoluxContour(**{**contour, "on": _PLACES[contour["on"]],
                             "certified": contour["certified"].astype(bool)})
            for contour in found["contours"]]
        self.lines = SurfaceLines(found["lines"])
        for name in ("levels", "outline", "open", "open_range", "size", "area",
                     "open_area", "dark_area", "least", "most",
                     "search_evaluations", "line_evaluations", "triangles"):
            setattr(self, name, found[name])
        self.evaluations = self.search_evaluations + self.line_evaluations

    def __repr__(self) -> str:
        return (f"<truelux.Isolux: {len(self.contours)} contours of "
                f"{len(self.levels)} levels, {self.open_area:.3g} of "
                f"{self.area:.3g} open>")


class UndecidedRegion(NamedTuple):
    """A part of a surface that may have further critical points."""

    triangles: np.ndarray
    """What it consists of; shape (k, 3, 3)."""
    least: float
    """E is not less there [W/m^2]."""
    most: float
    """E is not more there [W/m^2]."""


class SurfaceExtrema:
    """What is known of local maxima, minima and saddles of E on a surface.

    Attributes
    ----------
    kind : (n,) of str
        "maximum": E is nowhere larger near it; "minimum"; "saddle".
    at : (n, 3)
        The best points that were met.
    value : (n,)
        E there [W/m^2].
    range : (n, 2)
        The extremum, or E in the saddle, is proven to be between these [W/m^2].
    radius : (n,)
        And not farther away than this [length]. More than one critical point so
        near would not be told apart.
    on : (n,) of str
        "inside", "kink", "jump" or "outline", as of `IsoluxContour.on`.
    undecided : list of UndecidedRegion
        All critical points that are not listed lie here, or where E is proven to
        be 0.
    undecided_area, area : float
        Of these, and of the surface [length^2].
    dark_area : float
        At least so much has E = 0, proven [length^2].
    least, most : float
        E on the whole surface is proven to be between these [W/m^2].
    size : float
        The longer side of the surface's extent [length].
    evaluations : int
        How often E was evaluated.
    notes : list of str
        What was told by warnings.
    """

    def __init__(self, found: dict):
        self.kind = _EXTREMA[found["kind"]]
        self.on = _PLACES[found["on"]]
        self.undecided = [UndecidedRegion(*each)
                          for each in found["undecided"]]
        for name in ("at", "value", "range", "radius", "undecided_area", "area",
                     "dark_area", "least", "most", "size", "evaluations",
                     "notes"):
            setattr(self, name, found[name])

    def __len__(self) -> int:
        return len(self.kind)

    def __repr__(self) -> str:
        return (f"<truelux.SurfaceExtrema: {_counted(self.kind, 'no points')}; "
                f"{self.undecided_area:.3g} of {self.area:.3g} undecided>")


class SurfaceAnswers:
    """What an Oracle answers for whole surfaces."""

    def surface_lines(self, surface: str) -> SurfaceLines:
        """All straight lines on a flat surface where E or its gradient jumps.

        Parameters
        ----------
        surface : str
            The name of an object or group whose faces lie in one plane.

        Returns
        -------
        SurfaceLines

        Raises
        ------
        truelux.Error
            If there is no such surface, or it is not flat.
        KeyboardInterrupt
            After Ctrl-C.

        Notes
        -----
        Arvo, The Irradiance Jacobian for Partially Occluded Polyhedral Sources
        (1994), section 5.
        """
        lines = SurfaceLines(_truelux.surface_lines(
            self._shared, self._choice, word(surface, "surface")))
        warn(lines.notes)
        return lines

    def isolux(self, surface: str, *, levels=None, count: int = 10,
               channel: Optional[str] = None,
               half_width: Optional[float] = None,
               chord: Optional[float] = None, smallest: Optional[float] = None,
               most_triangles: Optional[int] = None,
               threads: Optional[int] = None,
               progress: bool = False) -> Isolux:
        """Contours of equal irradiance on a flat surface.

        Parameters
        ----------
        surface : str
            The name of an object or group whose faces lie in one plane.
        levels : array_like, shape (l,), or a number, optional
            Ascending, above 0 [W/m^2].
        count : int
            Without levels: so many, with equal steps between the least and the
            largest value that were met, each rounded to three digits or more.
        channel : {"luminance", "r", "g", "b"}, optional
            What contours are of. Without it luminance, 0.2126 R + 0.7152 G +
            0.0722 B, or the one value of a scene whose channels are all alike.
        half_width : float, optional
            Of transversals [length]; 1e-9 of the surface's size.
        chord : float, optional
            How far a contour may be from its chords [length]; 1e-3 of the size.
        smallest : float, optional
            Triangles that are searched get no smaller [length]; 2^-18 of the
            size. What is not settled then is in `Isolux.open`.
        most_triangles : int, optional
            Nor more than so many; 4 million.
        threads : int, optional
            How many threads the call may use; by default those of the oracle.
        progress : bool
            Show a bar (tqdm, if it is installed).

        Returns
        -------
        Isolux
            The same whatever the number of threads.

        Raises
        ------
        truelux.Error
            If there is no such surface, if it is not flat, for levels that are
            not above 0 or do not ascend, or for a number outside its range.
        KeyboardInterrupt
            After Ctrl-C.

        Warns
        -----
        truelux.Note
            If there are no levels to choose, as where no light arrives.

        Notes
        -----
        Each vertex is proven: `IsoluxContour.certified`; that there are no other
        contours is proven outside `Isolux.open`.
        """
        arguments = contour_arguments(levels, count, channel, half_width, chord,
                                      smallest, most_triangles)
        with Bar(progress) as bar:
            isolux = Isolux(_truelux.isolux(
                self._shared, self._choice, word(surface, "surface"), arguments,
                thread_count(threads), bar.told))
        warn(isolux.lines.notes)
        return isolux

    def extrema(self, surface: str, *, channel: Optional[str] = None,
                threads: Optional[int] = None,
                progress: bool = False) -> SurfaceExtrema:
        """All local maxima, minima and saddles of E on a flat surface, those at
        its outline, at walls and on kinks included.

        Parameters
        ----------
        surface, channel, threads, progress
            As for `isolux`.

        Returns
        -------
        SurfaceExtrema
            Proven points and regions, and proven bounds on E.

        Raises
        ------
        truelux.Error
            If there is no such surface, or it is not flat.
        KeyboardInterrupt
            After Ctrl-C.
        """
        check_channel(channel)
        with Bar(progress) as bar:
            extrema = SurfaceExtrema(_truelux.extrema(
                self._shared, self._choice, word(surface, "surface"), channel,
                thread_count(threads), bar.told))
        warn(extrema.notes)
        return extrema


def contour_arguments(levels, count, channel, half_width, chord, smallest,
                      most_triangles) -> tuple:
    """Those of `SurfaceAnswers.isolux`, checked, as the library takes them."""
    given = _levels(levels)
    count = whole(count, "count", 2**31)
    check_channel(channel)
    lengths = [0.0 if length is None else positive(length, name)
               for length, name in ((half_width, "half_width"),
                                    (chord, "chord"), (smallest, "smallest"))]
    return (given, count, channel, lengths,
            0 if most_triangles is None
            else whole(most_triangles, "most_triangles", 2**63))


def _counted(words: np.ndarray, nothing: str) -> str:
    """How many of each."""
    names, counts = np.unique(words, return_counts=True)
    return ", ".join(f"{n} {name}" for name, n in zip(names, counts)) or nothing


def _levels(levels) -> list:
    """None: none."""
    if levels is None:
        return []
    array = np.atleast_1d(numbers(levels, "levels"))
    if array.ndim != 1 or not len(array):
        raise error(f"levels: expected the shape (l,), l from 1, found "
                    f"{array.shape}; count= chooses levels")
    return array.tolist()
