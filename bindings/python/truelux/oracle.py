# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers for one scene."""

from __future__ import annotations

from typing import NamedTuple, Optional

import numpy as np

from . import _truelux
from .arrays import (broadcast, error, faces, numbers, receivers,
                     real, thread_count, triples, warn, word)
from .derivatives import Derivatives, VertexGradient
from .isolux import SurfaceAnswers
from .isomesh import MeshAnswers
from .progress import in_parts
from .scene import Scene


class FormFactors(NamedTuple):
    """Form factors of all faces that emit."""

    faces: np.ndarray
    """Numbers of the faces, counted from 1; shape (s,)."""
    values: np.ndarray
    """F [1]: E if that face alone emitted, M = 1; shape (..., s)."""
    bounds: np.ndarray
    """Bounds on the errors of `values`."""


class Contour(NamedTuple):
    """The visible contour of every source, seen from one receiver."""

    vertices: np.ndarray
    """Structured: kind ("intrinsic", "apparent", "horizon"), conjunctive, planes,
    vertex (index into Scene.vertices; -1), direction (3)."""
    arcs: np.ndarray
    """Structured: from, to (indices into `vertices`), source, edge_face (face
    numbers; 0: the horizon), plane_normal (3), to the visible side."""


class Oracle(SurfaceAnswers, MeshAnswers):
    """Answers for one scene; every number is certified by default.

    Parameters
    ----------
    scene : Scene
    method : {"certified", "double"}
        The binary64 nearest to the true value; or sums in double over the same
        exact visibility, with proven bounds.
    engine : {"contour", "arrangement", "angular-spans"}
        How visibility is decided; all give the same bits.
    emission : {"exitance", "radiance"}
        How the scene's emission is read; M = pi L.
    formula : str
        What "double" sums: "auto", or a formula by name (docs/stability.md).
    two_sided : bool
        Faces that emit do so to both sides, whatever the scene was made with.
    threads : int, optional
        How many threads calls may use; by default one per core.

    Raises
    ------
    truelux.Error
        For words that are none of these.
    """

    def __init__(self, scene: Scene, *, method: str = "certified",
                 engine: str = "contour", emission: str = "exitance",
                 formula: str = "auto", two_sided: bool = False,
                 threads: Optional[int] = None):
        if not isinstance(scene, Scene):
            raise error(f"scene: expected a truelux.Scene, found "
                        f"{type(scene).__name__}")
        for text, name in ((method, "method"), (engine, "engine"),
                           (emission, "emission"), (formula, "formula")):
            word(text, name)
        self._threads = thread_count(threads)
        self._scene = scene
        self._shared = (scene._shared.two_sided() if two_sided
                        else scene._shared)
        self._choice = _truelux.Choice(engine, method, emission, formula,
                                       2.0**20, self._threads)
        if formula != "auto" and method == "certified":
            raise error("formula: it belongs to method='double'")
        self._words = (method, engine, emission)

    @property
    def scene(self) -> Scene:
        """The scene that was given."""
        return self._scene

    @property
    def emission(self) -> str:
        """How the scene's emission is read: "exitance" or "radiance"."""
        return self._words[2]

    def _receivers(self, points, normals, on_face):
        points, normals, shape = receivers(points, normals)
        on_face = faces(self._scene, on_face, points, normals, shape,
                        self._threads)
        return points, normals, on_face, shape

    def irradiance(self, points, normals, *, on_face=None, bound: bool = False,
                   progress: bool = False):
        """The irradiance E at receivers.

        Parameters
        ----------
        points, normals : array_like, shapes that broadcast to (..., 3)
            Finite; normals of any length but zero.
        on_face : None, "auto", str, int or array_like of int
            The face that a receiver lies on up to rounding, so that neither it
            nor what lies in its plane is seen: numbers, counted from 1 (0:
            none), that broadcast to (...); "auto": `Scene.face_near`; another
            word: the nearest face of that object or group.
        bound : bool
            Whether to return bounds, too.
        progress : bool
            Show a bar (tqdm, if it is installed).

        Returns
        -------
        numpy.ndarray of float64, shape (..., 3)
            E [W/m^2] in red, green and blue. With ``bound=True`` a pair: E and
            bounds on its error, half an ulp if certified.

        Raises
        ------
        truelux.Error
            For receivers that cannot be used: all, up to 100.
        KeyboardInterrupt
            After Ctrl-C, within a second.

        Warns
        -----
        truelux.Note
            If receivers on no face get 0 and lie just behind one.

        Notes
        -----
        The value does not depend on the engine, the threads, or what else is in
        the arrays: it has the bits of ``truelux eval``. Stark, Vertex-Based
        Formulations of Irradiance from Polygonal Sources (2000), equation (3).
        """
        points, normals, on_face, shape = self._receivers(points, normals,
                                                          on_face)
        values, bounds, behind = in_parts(
            lambda p, n, f: _truelux.irradiances(self._shared, self._choice, p,
                                                 n, f, bound),
            self._shared, points, normals, on_face, progress)
        if behind:
            warn([f"{behind} of {len(points)} receivers get 0 and lie behind a "
                  "face, no farther than rounding moves a point; on_face='auto' "
                  "takes them as lying on it"])
        shape += (3,)
        if bound:
            return values.reshape(shape), bounds.reshape(shape)
        return values.reshape(shape)

    def form_factors(self, points, normals, *, on_face=None) -> FormFactors:
        """The form factors of all faces that emit, decided together.

        Parameters
        ----------
        points, normals, on_face
            As for `irradiance`.

        Returns
        -------
        FormFactors
            Faces (s,), values and bounds (..., s).

        Raises
        ------
        truelux.Error
            For receivers that cannot be used.
        """
        points, normals, on_face, shape = self._receivers(points, normals,
                                                          on_face)
        numbers_, values, bounds = _truelux.form_factors(
            self._shared, self._choice, points, normals, on_face)
        shape += (len(numbers_),)
        return FormFactors(numbers_, values.reshape(shape),
                           bounds.reshape(shape))

    def contour(self, point, normal, *, on_face=None) -> Contour:
        """The visible contour of every source that one receiver sees.

        Parameters
        ----------
        point, normal : array_like, shape (3,)
        on_face
            As for `irradiance`.

        Returns
        -------
        Contour
            Vertices and arcs as structured arrays.

        Raises
        ------
        truelux.Error
            For a receiver that cannot be used.
        """
        points, normals, on_face, shape = self._receivers(point, normal,
                                                          on_face)
        if shape != ():
            raise error("contour: expected one point and one normal")
        columns = _truelux.contour(self._shared, self._choice, points, normals,
                                   on_face)
        return Contour(_structured(columns, _VERTEX), _structured(columns, _ARC))

    def derivatives(self, points, normals, *, on_face=None,
                    sphere: bool = True, jacobian: bool = True) -> Derivatives:
        """E and how it changes when receivers move or turn.

        Parameters
        ----------
        points, normals, on_face
            As for `irradiance`.
        sphere : bool
            Also the light field vector, its Jacobian and the net flux.
        jacobian : bool
            Also Jacobians: much slower for receivers that lie in the planes of
            faces, as on a floor (docs/python.md, "What it costs").

        Returns
        -------
        Derivatives

        Raises
        ------
        truelux.Error
            For receivers that cannot be used.

        Notes
        -----
        Arvo, The Irradiance Jacobian for Partially Occluded Polyhedral Sources
        (1994); docs/derivatives.md.
        """
        points, normals, on_face, shape = self._receivers(points, normals,
                                                          on_face)
        found = _truelux.derivatives(self._shared, self._choice, points, normals,
                                     on_face, sphere, jacobian)
        return Derivatives(found, shape, sphere, jacobian)

    def vertex_gradient(self, points, normals, weights, *,
                        on_face=None) -> VertexGradient:
        """The gradient by all scene vertices of a weighted sum of irradiances.

        Parameters
        ----------
        points, normals, on_face
            As for `irradiance`.
        weights : array_like, broadcasts to (..., 3)
            Of the receivers' channels.

        Returns
        -------
        VertexGradient
            The sum over receivers and channels of weight times dE/dv; the same
            bits whatever the number of threads.

        Raises
        ------
        truelux.Error
            For receivers that cannot be used.
        """
        points, normals, on_face, shape = self._receivers(points, normals,
                                                          on_face)
        given = numbers(weights, "weights")
        if given.ndim == 0:
            given = np.full(3, float(given))
        weights = broadcast("weights", shape, triples(given, "weights"))
        if not np.isfinite(weights).all():
            raise error("weights: expected finite numbers")
        found = _truelux.vertex_gradient(self._shared, self._choice, points,
                                         normals, on_face,
                                         np.ascontiguousarray(weights))
        return VertexGradient._of(*found, self._scene._input_vertices)

    def __repr__(self) -> str:
        return f"<truelux.Oracle: {', '.join(self._words)}; {self._scene!r}>"


def irradiance_from_sphere(points, normals, center, radius: float,
                           exitance) -> np.ndarray:
    """The irradiance from a uniformly emitting sphere that nothing hides.

    Parameters
    ----------
    points, normals : array_like, shapes that broadcast to (..., 3)
    center : array_like, shape (3,)
    radius : float
        More than 0, in the unit of the coordinates.
    exitance : array_like, shape (3,) or a number
        M [W/m^2].

    Returns
    -------
    numpy.ndarray, shape (..., 3)
        E [W/m^2], in double: off by 4e-15 of it at most, as measured.

    Raises
    ------
    truelux.Error
        For a receiver inside the sphere, or a number that is not finite.

    Notes
    -----
    Heitz, Geometric Derivation of the Irradiance of Polygonal Lights (2017),
    equation (16).
    """
    points, normals, shape = receivers(points, normals)
    center = triples(center, "center")
    exitance = np.broadcast_to(numbers(exitance, "exitance"), (3,))
    if center.shape != (3,):
        raise error(f"center: expected the shape (3,), found {center.shape}")
    values = _truelux.irradiance_from_sphere(points, normals, center.tolist(),
                                             real(radius, "radius"), exitance.tolist())
    return values.reshape(shape + (3,))


_VERTEX = [("kind", "U16"), ("conjunctive", "?"), ("planes", "i8"),
           ("vertex", "i8"), ("direction", "f8", 3)]
_ARC = [("from", "i8"), ("to", "i8"), ("source", "i8"), ("edge_face", "i8"),
        ("plane_normal", "f8", 3)]


def _structured(columns: dict, dtype: list) -> np.ndarray:
    """Columns by name as one array."""
    array = np.empty(len(columns[dtype[0][0]]), dtype=dtype)
    for name, *_ in dtype:
        array[name] = columns[name]
    return array
