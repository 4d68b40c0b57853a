# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes, from files and from arrays."""

from __future__ import annotations

import os
from typing import Optional, Sequence

import numpy as np

from . import _truelux
from .arrays import error, numbers, real, receivers, triples, warn, word


class Scene:
    """Polygons, some of which emit. Immutable.

    Parameters
    ----------
    vertices : array_like, shape (v, 3)
        Points in any unit of length.
    faces : sequence
        Rings of vertex indices, counted from 0, counter-clockwise seen from the
        side that emits: an integer array of the shape (f, k), or any sequence
        of sequences, of which the lengths may differ.
    emission : array_like, optional
        Radiant exitance M [W/m^2] of the faces (radiance L [W/m^2/sr] for an
        oracle with ``emission="radiance"``), which broadcasts to (f, 3); of the
        shape (f,) it is the same in red, green and blue (three numbers for three
        faces are an error: they could be either). By default nothing emits.
    groups : sequence of str, optional
        The object or group of every face.
    two_sided : bool
        Whether faces that emit do so to both sides.
    lenient : bool
        Whether rings that are no polygons are left out, with a note, instead of
        being errors.

    Raises
    ------
    truelux.Error
        With all defects: an index that does not exist, a number that is not
        finite, a ring that is no polygon.

    Warns
    -----
    truelux.Note
        Faces without area, or that are not planar and so split into triangles.
    """

    def __init__(self, vertices, faces, emission=None, *,
                 groups: Optional[Sequence[str]] = None,
                 two_sided: bool = False, lenient: bool = False):
        vertices = triples(vertices, "vertices")
        if vertices.ndim != 2:
            raise error(f"vertices: expected the shape (v, 3), found "
                        f"{vertices.shape}")
        corners, counts = _rings(faces)
        ke = _emission(emission, len(counts))
        if groups is not None and len(groups) != len(counts):
            raise error(f"groups: {len(groups)} names, but {len(counts)} faces")
        self._shared, notes = _truelux.Scene.from_arrays(
            np.ascontiguousarray(vertices), corners, counts, ke,
            [word(str(g), "groups") for g in groups or []], lenient, two_sided)
        self._input_vertices = len(vertices)
        warn(notes)

    @classmethod
    def read(cls, path, *, lenient: bool = False, two_sided: bool = False,
             opaque_from: Optional[float] = None) -> Scene:
        """Read a Wavefront OBJ and its materials (docs/scene_format.md).

        Parameters
        ----------
        path : str or os.PathLike
        lenient : bool
            Leave out faces that are errors, and take faces of undefined
            materials as blockers.
        two_sided : bool
            Faces that emit do so to both sides.
        opaque_from : float, optional
            Leave out faces that do not emit and whose material has an opacity d
            (or 1 - Tr) below this.

        Returns
        -------
        Scene

        Raises
        ------
        truelux.Error
            With all defects of the file, up to 100.

        Warns
        -----
        truelux.Note
            How the file was read.
        """
        shared, notes = _truelux.Scene.read(
            os.fsencode(path), lenient, two_sided,
            None if opaque_from is None else real(opaque_from, "opaque_from"))
        scene = cls._of(shared)
        warn(notes)
        return scene

    @classmethod
    def _of(cls, shared) -> Scene:
        scene = cls.__new__(cls)
        scene._shared = shared
        scene._input_vertices = 0
        return scene

    @property
    def vertices(self) -> np.ndarray:
        """Corners of all faces, each point once; shape (v, 3)."""
        return self._shared.vertices()

    @property
    def faces(self) -> list[np.ndarray]:
        """Rings of indices into `vertices`, in the order of the input."""
        return _split(self._shared.corners(), self._shared.corner_counts())

    @property
    def vertex_numbers(self) -> list[np.ndarray]:
        """The input's numbers of the vertices of every ring, counted from 1."""
        return _split(self._shared.corner_numbers(),
                      self._shared.corner_counts())

    @property
    def emission(self) -> np.ndarray:
        """What the faces emit, as it was given; shape (f, 3)."""
        return self._shared.emission()

    @property
    def groups(self) -> list[str]:
        """The object or group of every face, as "object/group"."""
        names = self._shared.group_names()
        return [names[g] for g in self._shared.groups()]

    def face_near(self, points, normals, *, name: Optional[str] = None,
                  limit: Optional[float] = None) -> np.ndarray:
        """The faces that receivers near them lie on, for `on_face`.

        Parameters
        ----------
        points, normals : array_like, shapes that broadcast to (..., 3)
        name : str, optional
            Only faces of this object or group; the nearest then, at any
            distance.
        limit : float, optional
            How far a face may be, in the scene's unit; by default somewhat more
            than rounding to binary32 moves a point.

        Returns
        -------
        numpy.ndarray of int64, shape (...)
            Face numbers, counted from 1; 0 where there is none.

        Raises
        ------
        truelux.Error
            For receivers that cannot be used.
        """
        points, normals, shape = receivers(points, normals)
        return self._shared.faces_near(
            points, normals, None if name is None else word(name, "name"),
            None if limit is None else real(limit, "limit"), 0).reshape(shape)

    def __repr__(self) -> str:
        lit = int(self.emission.any(axis=1).sum())
        return (f"<truelux.Scene: {self._shared.face_count()} faces, {lit} of "
                f"them emit, {self._shared.vertex_count()} points>")


def _split(values: np.ndarray, counts: np.ndarray) -> list[np.ndarray]:
    return np.split(values, np.cumsum(counts)[:-1]) if len(counts) else []


def _rings(faces) -> tuple[np.ndarray, np.ndarray]:
    """Indices of all rings one after the other, and the rings' lengths."""
    if isinstance(faces, np.ndarray) and faces.ndim == 2:
        rings = faces
        counts = np.full(len(faces), faces.shape[1], dtype=np.int64)
        flat = faces.reshape(-1)
    else:
        rings = [np.asarray(ring) for ring in faces]
        for k, ring in enumerate(rings):
            if ring.ndim != 1 or not ring.size or ring.dtype.kind not in "iu":
                raise error(f"faces: entry {k} is no sequence of indices")
        counts = np.array([len(ring) for ring in rings], dtype=np.int64)
        flat = np.concatenate(rings) if rings else np.zeros(0, dtype=np.int64)
    if flat.size and flat.dtype.kind not in "iu":
        raise error(f"faces: expected integers, found {flat.dtype}")
    return np.ascontiguousarray(flat, dtype=np.int64), counts


def _emission(emission, count: int) -> np.ndarray:
    if emission is None:
        return np.zeros((count, 3))
    given = numbers(emission, "emission")
    if given.shape == (3,) and count == 3:
        raise error("emission: three numbers for three faces: expected the shape "
                    "(3, 1) for grey faces, or (1, 3) for one colour")
    if given.shape == (count,) or given.ndim == 0:
        given = given.reshape(-1, 1)
    try:
        return np.array(np.broadcast_to(given, (count, 3)), order="C")
    except ValueError:
        raise error(f"emission: the shape {given.shape} does not go with "
                    f"({count}, 3), or with ({count},) for grey") from None
