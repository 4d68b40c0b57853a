# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangle meshes of flat surfaces whose edges follow the light."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

import numpy as np

from . import _truelux
from .arrays import positive, thread_count, warn, whole, word
from .isolux import Isolux, contour_arguments
from .progress import Bar

_SIDES = np.array(_truelux.MESH_SIDES)


@dataclass(frozen=True)
class InterpolationError:
    """How far values that are interpolated between vertices are from the truth
    [W/m^2], measured and not proven.

    Attributes
    ----------
    most : float
        The largest in 10,000 points of the area and in the middles of all
        triangles.
    at_99 : float
        99 % of the points have less.
    mean : float
        Over the points.
    """

    most: float
    at_99: float
    mean: float


@dataclass(frozen=True, eq=False, repr=False)
class IsoMesh:
    """A triangle mesh whose edges are outline, lines at which E or its gradient
    jumps, and contours. Its arrays cannot be written to.

    Attributes
    ----------
    points : (n, 3) of float64
        Vertices, in the scene's frame. Where E jumps there are several in one
        place.
    irradiance : (n, 3) of float64
        E at the vertices [W/m^2], as `Oracle.irradiance` has it. At an outline
        or a jump the receiver is 2^-36 of the surface's size beside it, in the
        triangles that have the vertex; at the end of a jump, where E depends on
        the direction, 2^-32 away in the one triangle that has it.
    values : (n,) of float64
        What contours are of, there [W/m^2].
    triangles : (m, 3) of int64
        Indices into `points`, counter-clockwise as seen from the lit side.
    sides : (m, 3) of str
        Of the side from vertex k + 1 to vertex k + 2, which is opposite to
        vertex k: "inside"; "contour", the chord of a contour; "kink", where the
        gradient jumps; "jump", where a face stands and each side has its own
        vertices; "outline".
    faces : (m,) of int64
        A face that looks to the triangle's side, for on_face.
    isolux : Isolux
        The contours that are in the mesh.
    error : float
        That was asked for [W/m^2].
    unfinished : int
        Triangles that are above it: too small to be divided, or there were too
        many.
    interpolation : InterpolationError
        Of the mesh.
    uniform : InterpolationError
        For comparison: of a Delaunay mesh of the outline alone with triangles of
        one size and as many vertices.
    uniform_vertices : int
        How many that has.
    least_angle : float
        In any triangle [degrees].
    drawn : int
        Contour vertices nearer than 2^-16 of the size to a corner of lines are
        drawn to it: all contours run into the feet of vertical edges.
    most_drawn : float
        The longest way of one [length].
    evaluations : int
        How often E was evaluated for the mesh, without its contours.
    """

    points: np.ndarray
    irradiance: np.ndarray
    values: np.ndarray
    triangles: np.ndarray
    sides: np.ndarray
    faces: np.ndarray
    isolux: Isolux
    error: float
    unfinished: int
    interpolation: InterpolationError
    uniform: InterpolationError
    uniform_vertices: int
    least_angle: float
    drawn: int
    most_drawn: float
    evaluations: int

    @classmethod
    def _of(cls, found: dict) -> IsoMesh:
        mesh = cls(**{**found, "sides": _SIDES[found["sides"]],
                      "isolux": Isolux(found["isolux"]),
                      "interpolation":
                          InterpolationError(*found["interpolation"]),
                      "uniform": InterpolationError(*found["uniform"])})
        for array in (mesh.points, mesh.irradiance, mesh.values, mesh.triangles,
                      mesh.sides, mesh.faces):
            array.flags.writeable = False
        return mesh

    def __repr__(self) -> str:
        return (f"<truelux.IsoMesh: {len(self.points)} vertices, "
                f"{len(self.triangles)} triangles, {self.unfinished} of them "
                f"above {self.error:.3g} W/m^2>")


class MeshAnswers:
    """What an Oracle answers for surfaces as meshes."""

    def iso_mesh(self, surface: str, *, levels=None, count: int = 10,
                 channel: Optional[str] = None,
                 half_width: Optional[float] = None,
                 chord: Optional[float] = None,
                 smallest: Optional[float] = None,
                 most_triangles: Optional[int] = None,
                 error: Optional[float] = None,
                 mesh_smallest: Optional[float] = None,
                 most_vertices: Optional[int] = None,
                 threads: Optional[int] = None,
                 progress: bool = False) -> IsoMesh:
        """A triangle mesh of a flat surface whose edges follow the light.

        Parameters
        ----------
        surface, levels, count, channel, half_width, chord, smallest
            Of the contours, as for `isolux`.
        most_triangles : int, optional
            In the search for contours, as for `isolux`; 4 million.
        error : float, optional
            Triangles are divided until linear interpolation is not farther than
            this from E at three points in each [W/m^2]; 1/100 of the difference
            of the largest and the least value that were met.
        mesh_smallest : float, optional
            Triangles whose sides are all not longer than this are not divided
            [length]; 2^-12 of the surface's size.
        most_vertices : int, optional
            No triangle is divided when there are so many vertices, before they are
            doubled at jumps; 300,000.
        threads, progress
            As for `isolux`.

        Returns
        -------
        IsoMesh
            The same whatever the number of threads.

        Raises
        ------
        truelux.Error
            As of `isolux`.
        KeyboardInterrupt
            After Ctrl-C.

        Warns
        -----
        truelux.Note
            As of `isolux`.

        Notes
        -----
        Values at vertices are certified. How far interpolation is from E is
        measured and not proven: `IsoMesh.interpolation`.
        """
        arguments = contour_arguments(levels, count, channel, half_width, chord,
                                      smallest, most_triangles)
        numbers = [
            0.0 if error is None else positive(error, "error", "number"),
            0.0 if mesh_smallest is None
            else positive(mesh_smallest, "mesh_smallest")]
        vertices = (0 if most_vertices is None
                    else whole(most_vertices, "most_vertices", 2**63))
        with Bar(progress) as bar:
            mesh = IsoMesh._of(_truelux.iso_mesh(
                self._shared, self._choice, word(surface, "surface"), arguments,
                numbers, vertices, thread_count(threads), bar.told))
        warn(mesh.isolux.lines.notes)
        return mesh
