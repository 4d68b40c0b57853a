# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments as the arrays that the library takes."""

from __future__ import annotations

import warnings
from typing import Iterable

import numpy as np

from ._truelux import Error


class Note(UserWarning):
    """How an input was read: what truelux eval prints as a note."""


def error(*defects: str) -> Error:
    """The exception for these defects."""
    exception = Error("\n".join(defects))
    exception.defects = list(defects)
    return exception


_WORDS = (("--white or --exposure sets it", "white= or exposure= sets it"),
          ("--on-face auto", "on_face='auto'"),
          ("--on-face", "on_face"),
          ("--emission radiance", "emission='radiance'"),
          ("--emission exitance", "emission='exitance'"))


def in_python(text: str) -> str:
    """A text of the library with Python's words for options."""
    for option, argument in _WORDS:
        text = text.replace(option, argument)
    return text


def warn(notes: Iterable[str], stacklevel: int = 3) -> None:
    """Notes as warnings, with the line of whoever called truelux."""
    for note in notes:
        warnings.warn(in_python(note), Note, stacklevel=stacklevel)


def real(value, name: str) -> float:
    """A number."""
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise error(f"{name}: expected a number, found {value!r}") from None


def positive(value, name: str, what: str = "length") -> float:
    """A finite number above 0; what: what it is called where it is none."""
    number = real(value, name)
    if not 0 < number < float("inf"):
        raise error(f"{name}: expected a finite {what} above 0")
    return number


def whole(value, name: str, end: int) -> int:
    """A whole number from 1, below end."""
    if not isinstance(value, (int, np.integer)) or isinstance(value, bool) \
            or not 1 <= value < end:
        raise error(f"{name}: expected a whole number from 1")
    return int(value)


def word(value, name: str) -> bytes:
    """A text, as the bytes that the library takes."""
    if not isinstance(value, str):
        raise error(f"{name}: expected a str, found {type(value).__name__}")
    try:
        return value.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        raise error(f"{name}: the text has characters that no file has") from None


def thread_count(threads) -> int:
    """0 for None: one per core."""
    if threads is None:
        return 0
    if not isinstance(threads, (int, np.integer)) or not 1 <= threads <= 1024:
        raise error("threads: expected 1 to 1024, or None")
    return int(threads)


def check_channel(channel) -> None:
    """Which number of a colour is meant; None is for the library to choose."""
    names = ("luminance", "r", "g", "b")
    if channel is not None and channel not in names:
        raise error(f"channel: {channel!r} is none of {', '.join(names)}")


def numbers(values, name: str) -> np.ndarray:
    """An array of binary64, without a copy if it is one."""
    if np.ma.is_masked(values):
        raise error(f"{name}: some entries are masked; expected numbers for all")
    try:
        array = np.asarray(values)
    except ValueError as defect:
        raise error(f"{name}: {defect}") from None
    if array.dtype == np.float64:
        return array
    if array.dtype.kind not in "fiu":
        raise error(f"{name}: expected real numbers, found {array.dtype}")
    return array.astype(np.float64)


def triples(values, name: str) -> np.ndarray:
    """The same of the shape (..., 3)."""
    array = numbers(values, name)
    if array.ndim == 0 or array.shape[-1] != 3:
        raise error(
            f"{name}: expected the shape (..., 3), found {array.shape}")
    return array


def broadcast(name: str, shape: tuple, array: np.ndarray) -> np.ndarray:
    """Triples over a leading shape, as rows."""
    if array.shape[:-1] != shape:
        try:
            array = np.broadcast_to(array, shape + (3,))
        except ValueError:
            raise error(f"{name}: the shape {array.shape} does not go with "
                        f"{shape + (3,)}") from None
    return array.reshape(-1, 3)


def receivers(points, normals) -> tuple[np.ndarray, np.ndarray, tuple]:
    """Points and normals as rows, and their common leading shape."""
    points = triples(points, "points")
    normals = triples(normals, "normals")
    try:
        shape = np.broadcast_shapes(points.shape[:-1], normals.shape[:-1])
    except ValueError:
        raise error(f"points and normals: the shapes {points.shape} and "
                    f"{normals.shape} do not go together") from None
    return (broadcast("points", shape, points),
            broadcast("normals", shape, normals), shape)


_NO_FACE = np.zeros(1, dtype=np.int64)


def faces(scene, on_face, points, normals, shape, threads) -> np.ndarray:
    """Face numbers: one for all receivers, or one each."""
    if on_face is None:
        return _NO_FACE
    if isinstance(on_face, str) and on_face.isascii() and on_face.isdecimal():
        on_face = np.array(min(int(on_face[:12]), 2**40))
    if isinstance(on_face, str):
        name = None if on_face == "auto" else on_face
        found = scene._shared.faces_near(
            points, normals, None if name is None else word(name, "on_face"),
            None, threads)
        if name is not None and found.size and not found.any():
            raise error(f"on_face: no face with an area has the name '{name}'")
        return found
    given = np.asarray(on_face)
    if given.dtype.kind not in "iu":
        raise error("on_face: expected None, 'auto', a name, or face numbers")
    if given.ndim == 0:
        return given.reshape(1).astype(np.int64)
    try:
        given = np.broadcast_to(given, shape)
    except ValueError:
        raise error(f"on_face: the shape {given.shape} does not go with "
                    f"{shape}") from None
    return np.ascontiguousarray(given, dtype=np.int64).reshape(-1)
