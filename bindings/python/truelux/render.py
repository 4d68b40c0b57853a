# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures, a receiver a pixel."""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence

import numpy as np

from . import _truelux
from .arrays import check_channel, error, real, triples, warn, word
from .files import suffix_of, whole_file
from .oracle import Oracle
from .progress import Bar
from .scene import Scene

SHADOW_CLASSES = tuple(_truelux.SHADOW_CLASSES)
"""The names of the numbers in `Picture.shadow_class`."""


class Camera(NamedTuple):
    """A pinhole camera."""

    eye: Sequence[float]
    """Where it is."""
    target: Sequence[float]
    """The point in the middle of the picture."""
    up: Sequence[float]
    """What is above the middle; of any length."""
    fov: float
    """From the lower to the upper edge of the picture [degrees]."""


class Picture:
    """What `render` found: arrays of the shape (height, width, ...), the first
    row at the top. What was not asked for is None.

    Attributes
    ----------
    irradiance : float64 (h, w, 3)
        E [W/m^2]; 0 where nothing is.
    covered : bool (h, w)
        Where there is a receiver.
    points, normals : float64 (h, w, 3)
        The receivers, without meaning where nothing is.
    on_face : int64 (h, w)
        The faces that they lie on, counted from 1; 0: none.
    bound : float64 (h, w, 3)
        With ``bound=True``: bounds on the error of `irradiance`.
    difference : float64 (h, w, 3)
        Of "error": the distance between the methods "double" and "certified".
    arcs : int64 (h, w)
        Of "arcs": the number of arcs of the visible contour.
    shadow_class : uint8 (h, w)
        Of "class": index into `SHADOW_CLASSES`.
    gradient : float64 (h, w, 3)
        Of "gradient": lengths of the tangential gradient [W/m^3].
    kinks : float64 (h, w, 3)
        Of "gradient" on a surface: how far it jumps within the pixel [W/m^3];
        None where there are more places to look at than pixels, too.
    """

    def __init__(self, rendering, also, texts):
        arrays = rendering.arrays()
        for name in ("irradiance", "covered", "points", "normals", "on_face",
                     "bound", "difference", "arcs", "shadow_class", "gradient",
                     "kinks"):
            setattr(self, name, arrays.get(name))
        self._rendering = rendering
        self._also = also
        self._texts = texts

    def write(self, path, *, white: Optional[float] = None,
              exposure: Optional[float] = None, false_colour: bool = False,
              isolux: bool = True, channel: Optional[str] = None) -> None:
        """Writes the irradiance as the file of truelux render.

        Parameters
        ----------
        path : str or path
            Ends with .exr (binary32, linear) or .png. Appears when all is
            written.
        white : float, optional
            What a PNG shows as white, or at the top of the scale [W/m^2];
            without it what suits the picture, with a warning that says it.
        exposure : float, optional
            The same in stops: white is 2 to the power of -exposure.
        false_colour : bool
            One channel by the colours of a scale, with a legend.
        isolux : bool
            Whether false colours have lines of equal irradiance: of a surface
            certified contours with their levels, of a camera's picture the
            pixels at which a level is passed.
        channel : {"luminance", "r", "g", "b"}, optional
            Of false colours; luminance unless it is given.

        Raises
        ------
        truelux.Error
            For another ending, or options that do not go together.
        """
        suffix = suffix_of(path, ".exr", ".png")
        if white is not None and exposure is not None:
            raise error("exposure and white say the same: give one of them")
        if suffix == ".exr" and not (white is exposure is channel is None
                                     and not false_colour and isolux):
            raise error("white, exposure, false_colour, isolux and channel "
                        "belong to a PNG; an EXR file holds the numbers "
                        "themselves")
        if not false_colour and not (channel is None and isolux):
            raise error("channel and isolux belong to false_colour")
        if exposure is not None:
            stops = real(exposure, "exposure")
            if not abs(stops) <= 1000:
                raise error("exposure: expected -1000 to 1000")
            white = 2.0 ** -stops
        elif white is not None:
            white = real(white, "white")
            if not 0 < white < float("inf"):
                raise error("white: expected a finite number above 0")
        check_channel(channel)
        data, notes = self._rendering.picture(
            suffix == ".exr", self._texts, white, bool(false_colour),
            bool(isolux), channel)
        warn(notes)
        with whole_file(path) as file:
            file.write(data)

    def write_also(self, path, which: str, *,
                   channel: Optional[str] = None) -> None:
        """Writes a further picture that was asked for, as PNG with a legend.

        Parameters
        ----------
        path : str or path
        which : {"error", "arcs", "class", "gradient"}
            One of ``also`` of `render`.
        channel : {"luminance", "r", "g", "b"}, optional
            Of "error" and "gradient"; without it the largest of each pixel.

        Raises
        ------
        truelux.Error
            If it was not asked for.
        """
        if which not in self._also:
            raise error(f"which: '{which}' was not asked for by also=")
        suffix_of(path, ".png")
        if channel is not None and which not in ("error", "gradient"):
            raise error("channel: it belongs to 'error' and 'gradient'")
        check_channel(channel)
        data = self._rendering.extra(which, channel)
        with whole_file(path) as file:
            file.write(data)

    def __repr__(self) -> str:
        height, width = self.covered.shape
        return (f"<truelux.Picture: {width} x {height}, "
                f"{int(self.covered.sum())} receivers>")


def _view(camera) -> tuple:
    """Eye, target, up and fov; anything without a camera."""
    if camera is None:
        return [0.0] * 3, [0.0] * 3, [0.0] * 3, 0.0
    try:
        eye, target, up, fov = camera
    except (TypeError, ValueError):
        raise error("camera: expected a truelux.Camera: eye, target, up and "
                    "fov") from None
    vectors = []
    for values, name in ((eye, "eye"), (target, "target"), (up, "up")):
        vector = triples(values, f"camera.{name}")
        if vector.shape != (3,):
            raise error(f"camera.{name}: expected the shape (3,), found "
                        f"{vector.shape}")
        vectors.append(vector.tolist())
    fov = real(fov, "camera.fov")
    if not np.isfinite([*np.ravel(vectors), fov]).all():
        raise error("camera: expected finite numbers")
    return (*vectors, fov)


def _on_face(on_face) -> Optional[bytes]:
    """As the library's word."""
    if on_face is None:
        return None
    if isinstance(on_face, str):
        return word(on_face, "on_face")
    if not isinstance(on_face, (int, np.integer)) or isinstance(on_face, bool) \
            or on_face < 1:
        raise error("on_face: expected None, 'auto', a name, or a face number "
                    "from 1")
    return str(on_face).encode()


def render(oracle: Oracle | Scene, *, surface: Optional[str] = None,
           camera: Optional[Camera] = None, width: int = 256,
           height: Optional[int] = None, on_face=None,
           also: Sequence[str] = (), bound: bool = False,
           progress: bool = False) -> Picture:
    """The irradiance over a flat surface, or as a camera sees it.

    Parameters
    ----------
    oracle : Oracle or Scene
        What answers; for a scene the oracle that ``Oracle(scene)`` is.
    surface : str, optional
        The name of an object or group whose faces lie in one plane.
    camera : Camera, optional
        Instead of a surface: (eye, target, up, fov).
    width, height : int
        Pixels. Without height those of a surface are about square, and a
        camera's picture is.
    on_face : None, "auto", str or int
        The face that receivers lie on, as for `Oracle.irradiance`; by default
        the face that each pixel shows.
    also : sequence of {"error", "arcs", "class", "gradient"}
        What else is wanted.
    bound : bool
        Whether bounds are wanted.
    progress : bool
        Show a bar (tqdm, if it is installed).

    Returns
    -------
    Picture

    Raises
    ------
    truelux.Error
        If there is no such surface, if it is not flat, if the camera cannot see,
        or if the picture has more than 2^26 pixels.
    KeyboardInterrupt
        After Ctrl-C, within a second.
    """
    if isinstance(oracle, Scene):
        oracle = Oracle(oracle)
    if not isinstance(oracle, Oracle):
        raise error(f"oracle: expected a truelux.Oracle or a truelux.Scene, "
                    f"found {type(oracle).__name__}")
    if (surface is None) == (camera is None):
        raise error("surface, camera: expected one of them")
    also = [also] if isinstance(also, str) else list(also or ())
    for which in also:
        if which not in _truelux.EXTRA_PICTURES:
            raise error(f"also: '{which}' is none of "
                        f"{', '.join(_truelux.EXTRA_PICTURES)}")
    sides = [width] if height is None else [width, height]
    if not all(isinstance(n, (int, np.integer)) and 1 <= n < 2**31
               for n in sides):
        raise error("width, height: expected whole numbers from 1")
    view = _view(camera)
    if surface is not None:
        surface = word(surface, "surface")
    with Bar(progress) as bar:
        rendering = _truelux.render(
            oracle._shared, oracle._choice, surface, view, int(width),
            int(height or 0), _on_face(on_face), also, bool(bound), bar.told)
    warn(rendering.notes())
    method, engine, emission = oracle._words
    texts = [("comments", f"irradiance [W/m^2] by truelux {_truelux.version()}: "
              f"the binary64 value ({method}) rounded once more to binary32"),
             ("method", method), ("emission", emission), ("engine", engine)]
    return Picture(rendering, also, texts)
