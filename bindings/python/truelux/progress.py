# SPDX-License-Identifier: GPL-3.0-or-later
"""Long calls in parts, with a bar."""

from __future__ import annotations

import sys

import numpy as np

from . import _truelux


class _Line:
    """What stands in for tqdm: a line on standard error."""

    def __init__(self, total: int, unit: str):
        self.total, self.unit, self.n = total, unit, 0

    def update(self, count: int) -> None:
        self.n += count
        print(f"\r{self.n} of {self.total} {self.unit}", end="",
              file=sys.stderr, flush=True)

    def close(self) -> None:
        print(file=sys.stderr)


def _tqdm():
    """The bar of tqdm; a plain line without it."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return _Line
    return tqdm


def in_parts(call, scene, points, normals, on_face, progress: bool):
    """call(points, normals, on_face), whole or, for a bar, in parts.

    Returns a tuple of arrays, of None, or of counts, as call does.
    """
    count = len(points)
    if not progress or not count:
        return call(points, normals, on_face)
    # Parts would name receivers by numbers of their own.
    _truelux.check(scene, points, normals, on_face)
    step = max(64, -(-count // 200))
    parts = []
    with Bar(True) as bar:
        for first in range(0, count, step):
            rows = slice(first, first + step)
            each = on_face if len(on_face) == 1 else on_face[rows]
            parts.append(call(points[rows], normals[rows], each))
            bar.told(min(first + step, count), count, "receivers")
    return tuple(_joined(part) for part in zip(*parts))


def _joined(parts):
    if isinstance(parts[0], np.ndarray):
        return np.concatenate(parts)
    return None if parts[0] is None else sum(parts)


class Bar:
    """A bar for a call that tells how far it is; `told` is what it calls."""

    def __init__(self, progress: bool):
        self._tqdm = _tqdm() if progress else None
        self._bar = None
        self.told = self._tell if progress else None

    def _tell(self, done: int, total: int, things: str) -> None:
        bar = self._bar
        # A part of the call is over where its total, or what is counted, is
        # another, or where fewer are done than before.
        if bar is not None and ((bar.total, bar.unit) != (total, things)
                                or done < bar.n):
            bar.close()
            bar = None
        if bar is None:
            bar = self._bar = self._tqdm(total=total, unit=things)
        if done > bar.n:
            bar.update(done - bar.n)

    def __enter__(self) -> Bar:
        return self

    def __exit__(self, *_) -> None:
        if self._bar is not None:
            self._bar.close()
