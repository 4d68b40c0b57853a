# SPDX-License-Identifier: GPL-3.0-or-later
"""Another program's values beside the truth."""

from __future__ import annotations

import json
import re
from typing import Optional

import numpy as np

from . import _truelux
from .arrays import (error, faces, in_python, numbers, real, receivers,
                     thread_count, word)
from .oracle import Oracle
from .progress import Bar
from .scene import Scene

_CHANNELS = "rgb"
_SHAPES = {"irradiance": (3,), "form-factor": (), "gradient": (3, 3)}


class Comparison:
    """What `compare` found; ``print(report)`` shows what truelux compare prints.

    Attributes
    ----------
    passes : bool
        Whether every receiver is within the tolerance.
    truth : numpy.ndarray, the shape of the values
        The certified values; nan where there is no gradient.
    error : numpy.ndarray, shape (...)
        The error that is held against the tolerance: relative to the truth, the
        largest over the channels; where the truth is 0, to the largest truth.
        Infinite for nan.
    within : numpy.ndarray of bool, shape (...)
        Which receivers pass.
    verdict : {"nothing fails", "mistake", "receivers off their faces", \
"noise", "unexplained"}
    mistake : str
        The name of the mistake that explains the values (docs/compare.md); "" if
        none does.
    factor : float or None
        By which the values are too large, if the mistake is one.
    diagnosis : str
        The reason in a sentence or two.
    worst : list of (index, str)
        The receivers with the largest errors, at most ten, worst first: the
        index into the leading shape, and what the receiver sees.
    """

    def __init__(self, found: dict, shape: tuple, inner: tuple):
        self.passes: bool = found["passes"]
        self.truth: np.ndarray = found["truth"].reshape(shape + inner)
        self.error: np.ndarray = found["error"].reshape(shape)
        self.within: np.ndarray = found["within"].reshape(shape)
        self.verdict: str = found["verdict"]
        self.mistake: str = found["mistake"]
        self.factor: Optional[float] = found["factor"]
        self.diagnosis: str = in_python(found["diagnosis"])
        self.worst = [(_index(i, shape), reason)
                      for i, reason in found["worst"]]
        self._shape = shape
        self._text = in_python(found["text"])
        self._json = in_python(found["json"])

    def to_dict(self) -> dict:
        """All that the report says: the JSON of truelux compare.

        Numbers that are not finite are the strings "inf", "-inf" and "nan".
        """
        return json.loads(self._json)

    def to_json(self) -> str:
        """The same as text."""
        return self._json

    def __bool__(self) -> bool:
        return self.passes

    def text_with(self, place) -> str:
        """The report of truelux compare, with other words for its receivers.

        Parameters
        ----------
        place : callable
            From a receiver's index into the flattened leading shape to what the
            report calls it.
        """
        return re.sub(r"(?m)^( *\d+\. )receiver (\d+):",
                      lambda m: f"{m[1]}{place(int(m[2]))}:", self._text)

    def __str__(self) -> str:
        if len(self._shape) < 2:
            return self._text
        return self.text_with(lambda i: f"receiver {_index(i, self._shape)}")

    def __repr__(self) -> str:
        failing = int(self.error.size - np.count_nonzero(self.within))
        result = "PASS" if self.passes else "FAIL"
        what = self.mistake or self.verdict
        return (f"<truelux.Comparison: {result}, {failing} of "
                f"{self.error.size} receivers fail; {what}>")


def _index(i: int, shape: tuple) -> tuple:
    return tuple(int(k) for k in np.unravel_index(i, shape)) if shape else ()


def compare(scene: Scene | Oracle, points, normals, values, *,
            quantity: str = "irradiance", channel: Optional[str] = None,
            tolerance: float = 1e-6, emission: Optional[str] = None, on_face=None,
            threads: Optional[int] = None, progress: bool = False,
            name: str = "values") -> Comparison:
    """Holds another program's values against the truth, and says what is wrong.

    Parameters
    ----------
    scene : Scene or Oracle
        Of an oracle its scene, with its `emission` and two-sidedness.
    points, normals, on_face
        As for `Oracle.irradiance`.
    values : array_like
        One per receiver, over their common leading shape: irradiances
        (..., 3); form factors (...), E if every face that emits had M = 1;
        gradients dE/dr with the normal fixed (..., 3, 3), by channel and axis.
        With `channel` without the axis of channels. Nan and inf fail.
    quantity : {"irradiance", "form-factor", "gradient"}
    channel : {"r", "g", "b"}, optional
        The only channel that the values are of.
    tolerance : float
        The largest relative error that passes.
    emission : {"exitance", "radiance"}, optional
        How the scene's emission is read; the oracle's, else "exitance".
    threads : int, optional
    progress : bool
        Show a bar (tqdm, if it is installed).
    name : str
        What the report calls the values.

    Returns
    -------
    Comparison
        The errors and, if a receiver fails, the mistake that explains them.

    Raises
    ------
    truelux.Error
        For receivers that cannot be used, or values of another shape.
    """
    shared = scene._shared if isinstance(scene, (Scene, Oracle)) else None
    if isinstance(scene, Oracle):
        emission = emission or scene.emission
        scene = scene.scene
    if shared is None:
        raise error(f"scene: expected a truelux.Scene or a truelux.Oracle, "
                    f"found {type(scene).__name__}")
    if not isinstance(quantity, str) or quantity not in _SHAPES:
        raise error(f"quantity: {quantity!r} is none of {', '.join(_SHAPES)}")
    tolerance = real(tolerance, "tolerance")
    if not tolerance >= 0:
        raise error("tolerance: expected 0 or more")
    inner = _SHAPES[quantity]
    channels = [0, 1, 2]
    if channel is not None:
        if not isinstance(channel, str) or channel not in tuple("rgb") \
                or not inner:
            raise error("channel: expected 'r', 'g' or 'b', and a quantity that "
                        "has channels")
        channels = [_CHANNELS.index(channel)]
    emission = "exitance" if emission is None else emission
    word(emission, "emission")
    name = word(name, "name")
    threads = thread_count(threads)
    choice = _truelux.Choice("contour", "certified", emission, "auto", 2.0**20,
                             threads)
    points, normals, shape = receivers(points, normals)
    on_face = faces(scene, on_face, points, normals, shape, threads)
    given_inner = inner[1:] if channel is not None else inner
    given = numbers(values, "values")
    if given.shape != shape + given_inner:
        raise error(f"values: expected the shape {shape + given_inner}, found "
                    f"{given.shape}")
    if given.size == 0:
        raise error("points: there is no receiver")
    rows = np.zeros((len(points),) + (inner or (3,)))
    if not inner:
        rows[:, 0] = given.reshape(-1)
    else:
        rows[:, channels] = given.reshape((-1, len(channels)) + inner[1:])
    with Bar(progress) as bar:
        if quantity == "gradient":
            found = _truelux.compare_gradients(
                shared, choice, points, normals, on_face, rows, channels,
                tolerance, name, bar.told)
        else:
            found = _truelux.compare(
                shared, choice, points, normals, on_face, rows, channels,
                not inner, tolerance, name, bar.told)
    if not inner:
        found["truth"] = found["truth"][:, 0]
    elif channel is not None:
        found["truth"] = found["truth"][:, channels[0]]
    return Comparison(found, shape, given_inner)
