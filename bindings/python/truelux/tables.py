# SPDX-License-Identifier: GPL-3.0-or-later
"""Receivers, results and other programs' values in files of NumPy, as tables,
and as EXR maps."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ._truelux import exr_bytes, read_exr as _read_exr
from .arrays import error
from .csv_tables import PLACE, face_choices, read_columns, write_table
from .files import suffix_of, whole_file

VALUES = {"irradiance": ("E", ("E_r", "E_g", "E_b"), (3,)),
          "form-factor": ("F", ("F",), ()),
          "gradient": ("gradient",
                       tuple(f"grad_{c}_{k}" for c in "rgb" for k in "xyz"),
                       (3, 3))}
"""By quantity: the array of an .npz, the columns of a table, the shape of one."""


def read_exr(path) -> dict:
    """The channels of an OpenEXR image by their names.

    Parameters
    ----------
    path : str or path

    Returns
    -------
    dict of str to numpy.ndarray of float32, shape (height, width)

    Raises
    ------
    truelux.Error
        If it is no such image.
    """
    return _read_exr(str(path).encode("utf-8", "surrogateescape"))[0]


def read_maps(positions: str, normals: str):
    """Points and normals of the texels that have one, and which these are.

    Returns
    -------
    points, normals : (n, 3)
    covered : bool, (height, width)
        Texels whose normal is not 0.
    origin : (x, y)
        Of the maps' data windows.
    """
    (points, origin), (directions, other) = (_read_map(positions),
                                             _read_map(normals))
    if points.shape != directions.shape:
        raise error(f"{normals}: {directions.shape[1]} x {directions.shape[0]} "
                    f"texels, but {positions} has {points.shape[1]} x "
                    f"{points.shape[0]}")
    if origin != other:
        raise error(f"{normals}: the data window begins at {other}, but that of "
                    f"{positions} at {origin}")
    covered = directions.any(axis=-1)
    return points[covered], directions[covered], covered, origin


def _read_map(path: str):
    channels, origin = _read_exr(path.encode("utf-8", "surrogateescape"))
    for names in ("RGB", "XYZ", "rgb", "xyz"):
        if all(name in channels for name in names):
            return np.stack([channels[name] for name in names],
                            axis=-1).astype(np.float64), origin
    raise error(f"{path}: expected the channels R, G, B or X, Y, Z; found "
                f"{', '.join(channels) or 'none'}")


def _load(path: str):
    """The array of an .npy, or the arrays of an .npz by name."""
    try:
        loaded = np.load(path, allow_pickle=False)
        if isinstance(loaded, np.ndarray):
            return loaded
        with loaded:
            return {name: loaded[name] for name in loaded.files}
    except (OSError, KeyboardInterrupt):
        raise
    except Exception as defect:  # NumPy lets through what its parts throw
        raise error(f"{path}: not a file of NumPy that can be read: "
                    f"{defect or type(defect).__name__}") from None


def _array(path: str) -> np.ndarray:
    loaded = _load(path)
    if isinstance(loaded, dict):
        raise error(f"{path}: several arrays; their name should end with .npz")
    return loaded


def _arrays(path: str, *needed: str) -> dict:
    loaded = _load(path)
    if not isinstance(loaded, dict):
        raise error(f"{path}: one array; its name should end with .npy")
    missing = [name for name in needed if name not in loaded]
    if missing:
        raise error(f"{path}: no array {' and no array '.join(missing)}; found "
                    f"{', '.join(loaded) or 'none'}")
    return loaded


def read_receivers(path: str):
    """Points, normals and, where the file has them, faces; else None."""
    suffix = Path(path).suffix.lower()
    if suffix == ".npy":
        array = _array(path)
        if array.ndim == 0 or array.shape[-1] != 6:
            raise error(f"{path}: expected the shape (..., 6), points and "
                        f"normals; found {array.shape}")
        return array[..., :3], array[..., 3:], None
    if suffix == ".npz":
        arrays = _arrays(path, "points", "normals")
        return arrays["points"], arrays["normals"], arrays.get("on_face")
    if suffix == ".csv":
        columns = read_columns(path, PLACE, ("on_face",), ("on_face",))
        cells = columns.get("on_face")
        places = np.stack([columns[name] for name in PLACE], axis=-1)
        return (places[:, :3], places[:, 3:],
                None if cells is None else face_choices(path, cells))
    raise error(f"{path}: expected a name that ends with .npy, .npz or .csv")


def quantity_of(path: str) -> str:
    """What a file of values holds, unless it is said: gradients, if it has some."""
    suffix = Path(path).suffix.lower()
    if suffix == ".npz":
        names = _arrays(path)
    elif suffix == ".csv":
        names = read_columns(path, (), VALUES["gradient"][1])
    else:
        return "irradiance"
    has_gradient = "gradient" in names or VALUES["gradient"][1][0] in names
    return "gradient" if has_gradient else "irradiance"


def read_values(path: str, quantity: str, covered=None,
                origin=(0, 0)) -> np.ndarray:
    """Values of another program: arrays, tables, images.

    covered: which texels of a map at `origin` are receivers; the others are left
    out.
    """
    name, columns, inner = VALUES[quantity]
    suffix = Path(path).suffix.lower()
    if suffix == ".npy":
        values = _array(path)
    elif suffix == ".npz":
        values = _arrays(path, name)[name]
    elif suffix == ".csv":
        table = read_columns(path, columns)
        values = np.stack([table[c] for c in columns], axis=-1)
        return values.reshape(len(values), *inner)
    elif suffix == ".exr" and quantity == "irradiance":
        values, found = _read_map(path)
        if covered is not None and found != origin:
            raise error(f"{path}: the data window begins at {found}, but those "
                        f"of the maps at {origin}")
    else:
        raise error(f"{path}: expected a name that ends with .npy, .npz, .csv "
                    "or, of irradiances, .exr")
    if covered is None:
        return values
    if values.shape != covered.shape + inner:
        raise error(f"{path}: expected {covered.shape[1]} x {covered.shape[0]} "
                    f"texels, found the shape {values.shape}")
    return values[covered]


def check_output(path: str, count: int) -> None:
    """Whether results that are `count` arrays can have this name."""
    suffix = suffix_of(path, ".npy", ".npz", ".csv", ".exr")
    if suffix in (".npy", ".exr") and count > 1:
        raise error(f"{path}: the results are {count} arrays; expected .npz or "
                    ".csv")


def write_arrays(path: str, receivers, arrays: dict, covered=None) -> None:
    """Arrays by name, under a name that appears when all is written.

    receivers: points, normals, face numbers. covered: of receivers that are
    texels of a map, which texels these are; the others are nan in arrays and
    transparent in EXR.
    """
    suffix = suffix_of(path, ".npy", ".npz", ".csv", ".exr")
    if suffix == ".exr" and covered is None and arrays["E"].ndim != 3:
        raise error(f"{path}: an image needs receivers of the shape (height, "
                    f"width); they have {arrays['E'].shape[:-1]}")
    with whole_file(path) as file:
        if suffix == ".csv":
            write_table(file, *receivers, arrays, covered)
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
