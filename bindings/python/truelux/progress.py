# SPDX-License-Identifier: GPL-3.0-or-later
"""Long calls in parts, with a bar."""

from __future__ import annotations

import numpy as np


def _bar(total: int):
    """A bar of tqdm; None without it."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm(total=total, unit="receiver")


def in_parts(call, points, normals, on_face, progress: bool):
    """call(points, normals, on_face), whole or, for a bar, in parts.

    Returns a tuple of arrays, or of None, as call does.
    """
    count = len(points)
    bar = _bar(count) if progress and count else None
    if bar is None:
        return call(points, normals, on_face)
    step = max(64, -(-count // 200))
    parts = []
    with bar:
        for first in range(0, count, step):
            rows = slice(first, first + step)
            each = on_face if len(on_face) == 1 else on_face[rows]
            parts.append(call(points[rows], normals[rows], each))
            bar.update(len(points[rows]))
    return tuple(None if part[0] is None else np.concatenate(part)
                 for part in zip(*parts))
