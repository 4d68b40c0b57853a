# SPDX-License-Identifier: GPL-3.0-or-later
"""Receivers and results in files of NumPy and as tables."""

from __future__ import annotations

import csv
import os
import tempfile
from pathlib import Path

import numpy as np

from .arrays import error

_PLACE = ("x", "y", "z", "nx", "ny", "nz")


def read_receivers(path: str):
    """Points, normals and, where the file has them, face numbers; else None."""
    reader = {".npy": _read_npy, ".npz": _read_npz, ".csv": _read_csv}.get(
        Path(path).suffix.lower())
    if reader is None:
        raise error(f"{path}: expected a name that ends with .npy, .npz or .csv")
    try:
        return reader(path)
    except (ValueError, EOFError) as defect:
        if hasattr(defect, "defects"):
            raise
        raise error(f"{path}: {defect}") from None


def _read_npy(path: str):
    array = np.load(path, allow_pickle=False)
    if array.ndim == 0 or array.shape[-1] != 6:
        raise error(f"{path}: expected the shape (..., 6), points and normals; "
                    f"found {array.shape}")
    return array[..., :3], array[..., 3:], None


def _read_npz(path: str):
    with np.load(path, allow_pickle=False) as arrays:
        missing = [n for n in ("points", "normals") if n not in arrays]
        if missing:
            raise error(f"{path}: no array {' and no array '.join(missing)}; "
                        f"found {', '.join(arrays.files) or 'none'}")
        return (arrays["points"], arrays["normals"],
                arrays["on_face"] if "on_face" in arrays else None)


def _read_csv(path: str):
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = csv.reader(file)
        header = [name.strip() for name in next(rows, [])]
        missing = [name for name in _PLACE if name not in header]
        if missing:
            raise error(f"{path}:1: the header lacks {', '.join(missing)}")
        at = [header.index(name) for name in _PLACE]
        face = header.index("on_face") if "on_face" in header else None
        places, faces, defects = [], [], []
        for row in rows:
            if not row:
                continue
            try:
                places.append([float(row[k]) for k in at])
                if face is not None:
                    faces.append(int(row[face] or 0))
            except (ValueError, IndexError) as defect:
                defects.append(f"{path}:{rows.line_num}: {defect}")
    if defects:
        raise error(*defects[:100])
    array = np.array(places, dtype=np.float64).reshape(-1, 6)
    return array[:, :3], array[:, 3:], np.array(faces) if faces else None


def write_arrays(path: str, arrays: dict) -> None:
    """Arrays by name, under a name that appears when all is written."""
    suffix = Path(path).suffix.lower()
    if suffix not in (".npy", ".npz", ".csv"):
        raise error(f"{path}: expected a name that ends with .npy, .npz or .csv")
    if suffix == ".npy" and len(arrays) > 1:
        raise error(f"{path}: {', '.join(arrays)} are several arrays; "
                    "expected .npz or .csv")
    folder = os.path.dirname(os.path.abspath(path))
    handle, temporary = tempfile.mkstemp(dir=folder, suffix=suffix)
    try:
        with os.fdopen(handle, "wb") as file:
            if suffix == ".npy":
                np.save(file, next(iter(arrays.values())))
            elif suffix == ".npz":
                np.savez(file, **arrays)
            else:
                _write_csv(file, arrays)
        os.chmod(temporary, 0o666 & ~_umask())
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _write_csv(file, arrays: dict) -> None:
    """One row per receiver; columns like E_r, gradient_r_x, jacobian_r_xy."""
    axes = "xyz"
    leading = arrays["E"].shape[:-1]
    names, columns = [], []
    for name, array in arrays.items():
        inner = array.shape[len(leading):]
        flat = array.reshape(-1, *inner)
        for index in np.ndindex(*inner):
            words = [name, *("rgb"[index[0]] for _ in index[:1]),
                     "".join(axes[k] for k in index[1:])]
            names.append("_".join(word for word in words if word))
            columns.append(flat[(slice(None), *index)].tolist())
    lines = [",".join(names)]
    lines += [",".join(str(cell) for cell in row) for row in zip(*columns)]
    file.write(("\n".join(lines) + "\n").encode())
