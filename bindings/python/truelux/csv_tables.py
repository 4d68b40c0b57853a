# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables as truelux eval reads and writes them."""

from __future__ import annotations

import csv

import numpy as np

from .arrays import error

PLACE = ("x", "y", "z", "nx", "ny", "nz")

_COLUMNS = {"gradient": "grad", "tangential": "tgrad", "normal": "dn",
            "vector": "V", "jacobian": "J", "sphere": "L",
            "sphere_jacobian": "Jsphere"}
"""Names of the program's columns where they differ from Python's."""


def read_columns(path: str, needed, wanted=(), words=()) -> dict:
    """Columns by name, small: arrays of numbers, or lists of texts.

    Commas, semicolons, tabs or blanks between fields; names in any case; a table
    of numbers alone has the columns x,y,z,nx,ny,nz; lines that begin with # are
    comments.

    Parameters
    ----------
    needed, wanted : sequences of str
        Columns that must, and that may be there. An empty cell of one that is
        wanted is nan.
    words : sequence of str
        Of the wanted ones, those whose cells are texts.
    """
    rows = _rows(path)
    if not rows:
        raise error(f"{path}: the table is empty")
    header = [cell.lower() for cell in rows[0][1]]
    if all(_is_number(cell) for cell in header):
        header = list(PLACE)[:len(header)]
        line, body = rows[0][0], rows
    else:
        line, body = rows[0][0], rows[1:]
    defects = [f"{path}:{line}: the column {name} is there twice"
               for name in dict.fromkeys(header) if header.count(name) > 1
               and name in (*needed, *wanted)]
    missing = [name for name in needed if name.lower() not in header]
    if missing:
        defects.append(f"{path}:{line}: the header lacks {', '.join(missing)}")
    if defects:
        raise error(*defects)
    at = {name: header.index(name.lower()) for name in (*needed, *wanted)
          if name.lower() in header}
    columns: dict = {name: [] for name in at}
    for line, row in body:
        if len(row) < len(header):
            defects.append(f"{path}:{line}: {len(row)} fields; the header has "
                           f"{len(header)}")
            continue
        for name, k in at.items():
            if name in words:
                columns[name].append(row[k])
                continue
            cell = row[k] or ("nan" if name in wanted else "")
            if not _is_number(cell):
                defects.append(f"{path}:{line}: {name}: '{cell[:40]}' is not a "
                               "number")
                cell = "nan"
            columns[name].append(float(cell))
    if defects:
        raise error(*defects[:100])
    return {name: column if name in words else np.array(column, np.float64)
            for name, column in columns.items()}


def _rows(path: str) -> list:
    """Numbers of lines, and their fields."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            lines = [(k, line) for k, line in enumerate(file, 1)
                     if line.strip() and not line.startswith("#")]
    except UnicodeDecodeError as defect:
        raise error(f"{path}: no text in UTF-8: {defect.reason}") from None
    if not lines:
        return []
    between = next((s for s in ";\t," if s in lines[0][1]), None)
    if between is None:
        return [(k, line.split()) for k, line in lines]
    try:
        fields = list(csv.reader((line for _, line in lines),
                                 delimiter=between))
    except csv.Error as defect:
        raise error(f"{path}: {defect}") from None
    if len(fields) != len(lines):
        raise error(f"{path}: a quote is not closed on its line")
    return [(k, [cell.strip() for cell in row])
            for (k, _), row in zip(lines, fields)]


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True


def face_choices(path: str, cells: list):
    """The column on_face: numbers, 0 for none; or texts, if some are names."""
    if all(not cell or cell.isascii() and cell.isdecimal() for cell in cells):
        return np.array([min(int(cell[:12] or 0), 2**40) for cell in cells],
                        dtype=np.int64)
    defects = [f"{path}: on_face: '{cell}' is neither a whole number nor a name"
               for cell in dict.fromkeys(cells)
               if _is_number(cell) and not cell.isdecimal()]
    if defects:
        raise error(*defects[:100])
    return np.array(cells, dtype=object)


def write_table(file, points, normals, on_face, arrays: dict,
                covered=None) -> None:
    """One row per receiver: x .. nz, on_face unless it is 0 for all, px and py
    of texels, and columns like E_r, grad_r_x, J_r_xy."""
    columns = {name: array.reshape(-1, 3)[:, k].tolist()
               for array, names in ((points, PLACE[:3]), (normals, PLACE[3:]))
               for k, name in enumerate(names)}
    count = len(columns["x"])
    if on_face.any():
        columns["on_face"] = np.broadcast_to(on_face, count).tolist()
    if covered is not None:
        rows, texels = np.nonzero(covered)
        columns["px"], columns["py"] = texels.tolist(), rows.tolist()
    for name, array in arrays.items():
        inner = array.shape[arrays["E"].ndim - 1:]
        flat = array.reshape(count, *inner)
        for index in np.ndindex(*inner):
            words = [_COLUMNS.get(name, name),
                     *("rgb"[index[0]] for _ in index[:1]),
                     "".join("xyz"[k] for k in index[1:])]
            columns["_".join(word for word in words if word)] = \
                flat[(slice(None), *index)].tolist()
    file.write((",".join(columns) + "\n").encode())
    for row in zip(*columns.values()):
        file.write((",".join(map(str, row)) + "\n").encode())
