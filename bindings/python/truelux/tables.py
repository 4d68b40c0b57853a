# SPDX-License-Identifier: GPL-3.0-or-later
"""Receivers and results in files of NumPy, as tables, and as EXR maps."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np

from ._truelux import exr_bytes, read_exr
from .arrays import error
from .files import whole_file

_PLACE = ("x", "y", "z", "nx", "ny", "nz")


def read_maps(positions: str, normals: str):
    """Points and normals of the texels that have one, and which these are.

    Returns
    -------
    points, normals : (n, 3)
    covered : bool, (height, width)
        Texels whose normal is not 0.
    """
    points, directions = _read_map(positions), _read_map(normals)
    if points.shape != directions.shape:
        raise error(f"{normals}: {directions.shape[1]} x {directions.shape[0]} "
                    f"texels, but {positions} has {points.shape[1]} x "
                    f"{points.shape[0]}")
    covered = directions.any(axis=-1)
    return points[covered], directions[covered], covered


def _read_map(path: str) -> np.ndarray:
    channels = read_exr(path)
    for names in ("RGB", "XYZ", "rgb", "xyz"):
        if all(name in channels for name in names):
            return np.stack([channels[name] for name in names],
                            axis=-1).astype(np.float64)
    raise error(f"{path}: expected the channels R, G, B or X, Y, Z; found "
                f"{', '.join(channels) or 'none'}")


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
    columns = _columns(path, _PLACE, ("on_face",))
    faces = columns.get("on_face")
    if faces is not None:
        faces = np.nan_to_num(faces).astype(np.int64)
    places = np.stack([columns[name] for name in _PLACE], axis=-1)
    return places[:, :3], places[:, 3:], faces


def _columns(path: str, needed, wanted=()) -> dict:
    """Columns of a table by name; an empty cell is nan in one that is wanted."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = csv.reader(file)
        header = [name.strip() for name in next(rows, [])]
        missing = [name for name in needed if name not in header]
        if missing:
            raise error(f"{path}:1: the header lacks {', '.join(missing)}")
        at = {name: header.index(name) for name in (*needed, *wanted)
              if name in header}
        columns: dict = {name: [] for name in at}
        defects = []
        for row in rows:
            if not row:
                continue
            try:
                cells = [float(row[k] or "nan" if name in wanted else row[k])
                         for name, k in at.items()]
            except (ValueError, IndexError) as defect:
                defects.append(f"{path}:{rows.line_num}: {defect}")
                continue
            for name, cell in zip(at, cells):
                columns[name].append(cell)
    if defects:
        raise error(*defects[:100])
    return {name: np.array(column, dtype=np.float64)
            for name, column in columns.items()}


def read_values(path: str, covered=None) -> np.ndarray:
    """Irradiances (..., 3) of another program: arrays, tables, images.

    covered: which texels of a map are receivers; the others are left out.
    """
    suffix = Path(path).suffix.lower()
    try:
        if suffix == ".npy":
            values = np.load(path, allow_pickle=False)
        elif suffix == ".npz":
            with np.load(path, allow_pickle=False) as arrays:
                if "E" not in arrays:
                    raise error(f"{path}: no array E; found "
                                f"{', '.join(arrays.files) or 'none'}")
                values = arrays["E"]
        elif suffix == ".csv":
            names = ("E_r", "E_g", "E_b")
            columns = _columns(path, names)
            values = np.stack([columns[name] for name in names], axis=-1)
        elif suffix == ".exr":
            values = _read_map(path)
        else:
            raise error(f"{path}: expected a name that ends with .npy, .npz, "
                        ".csv or .exr")
    except (ValueError, EOFError) as defect:
        if hasattr(defect, "defects"):
            raise
        raise error(f"{path}: {defect}") from None
    if covered is None:
        return values
    if values.shape != covered.shape + (3,):
        raise error(f"{path}: expected {covered.shape[1]} x {covered.shape[0]} "
                    f"texels of three numbers, found the shape {values.shape}")
    return values[covered]


def write_arrays(path: str, arrays: dict, covered=None) -> None:
    """Arrays by name, under a name that appears when all is written.

    covered: of receivers that are texels of a map, which texels these are; the
    others are nan in arrays and transparent in EXR.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in (".npy", ".npz", ".csv", ".exr"):
        raise error(f"{path}: expected a name that ends with .npy, .npz, .csv "
                    "or .exr")
    if suffix in (".npy", ".exr") and len(arrays) > 1:
        raise error(f"{path}: {', '.join(arrays)} are several arrays; "
                    "expected .npz or .csv")
    if suffix == ".exr" and covered is None and arrays["E"].ndim != 3:
        raise error(f"{path}: an image needs receivers of the shape (height, "
                    f"width); they have {arrays['E'].shape[:-1]}")
    with whole_file(path) as file:
        if suffix == ".csv":
            _write_csv(file, arrays)
        elif suffix == ".exr":
            file.write(_map_bytes(arrays["E"], covered))
        else:
            whole = {name: _spread(array, covered)
                     for name, array in arrays.items()}
            if suffix == ".npy":
                np.save(file, next(iter(whole.values())))
            else:
                np.savez(file, **whole)


def _spread(array: np.ndarray, covered) -> np.ndarray:
    """The texels' values in their places."""
    if covered is None:
        return array
    empty = "" if array.dtype.kind == "U" else np.nan
    whole = np.full(covered.shape + array.shape[1:], empty, dtype=array.dtype)
    whole[covered] = array
    return whole


def _map_bytes(values: np.ndarray, covered) -> bytes:
    """R, G, B and A: 1 where there is a receiver."""
    if covered is None:
        covered = np.ones(values.shape[:2], dtype=bool)
    whole = np.zeros(covered.shape + (3,))
    whole[covered] = values.reshape(-1, 3)
    return exr_bytes(whole, covered, [("comments", "irradiance [W/m^2]")])


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
