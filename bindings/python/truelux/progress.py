# SPDX-License-Identifier: GPL-3.0-or-later
"""Long calls in parts, with a bar."""

from __future__ import annotations

import numpy as np


def _tqdm():
    """The bar of tqdm; None without it."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm


def in_parts(call, points, normals, on_face, progress: bool):
    """call(points, normals, on_face), whole or, for a bar, in parts.

    Returns a tuple of arrays, or of None, as call does.
    """
    count = len(points)
    tqdm = _tqdm() if progress and count else None
    if tqdm is None:
        return call(points, normals, on_face)
    step = max(64, -(-count // 200))
    parts = []
    with tqdm(total=count, unit="receiver") as bar:
        for first in range(0, count, step):
            rows = slice(first, first + step)
            each = on_face if len(on_face) == 1 else on_face[rows]
            parts.append(call(points[rows], normals[rows], each))
            bar.update(len(points[rows]))
    return tuple(None if part[0] is None else np.concatenate(part)
                 for part in zip(*parts))


class Bar:
    """A bar for a call that tells how far it is; `told` is what it calls."""

    def __init__(self, progress: bool):
        self._tqdm = _tqdm() if progress else None
        self._bar = None
        self.told = self._tell if self._tqdm is not None else None

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
        bar.update(done - bar.n)

    def __enter__(self) -> Bar:
        return self

    def __exit__(self, *_) -> None:
        if self._bar is not None:
            self._bar.close()
