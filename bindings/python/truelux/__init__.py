# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact irradiance from uniformly emitting polygons that hide each other.

    >>> import truelux
    >>> scene = truelux.Scene.read("room.obj")
    >>> oracle = truelux.Oracle(scene)
    >>> oracle.irradiance([0.0, 0.0, 0.0], [0.0, 0.0, 1.0])    # W/m^2

Every value is the binary64 nearest to the true one, whatever the scene:
visibility is decided by exact predicates, and the closed formulas are evaluated
until rounding is certain. Arrays have any leading shape.
"""

from ._truelux import Error, version as _version
from .arrays import Note
from .comparison import Comparison, compare
from .derivatives import Derivatives, VertexGradient
from .isolux import (Isolux, IsoluxContour, SurfaceExtrema, SurfaceLines,
                     UndecidedRegion)
from .isomesh import InterpolationError, IsoMesh
from .oracle import Contour, FormFactors, Oracle, irradiance_from_sphere
from .render import SHADOW_CLASSES, Camera, Picture, render
from .scene import Scene
from .tables import read_exr

__version__ = _version()

__all__ = [
    "Camera",
    "Comparison",
    "Contour",
    "Derivatives",
    "Error",
    "FormFactors",
    "InterpolationError",
    "IsoMesh",
    "Isolux",
    "IsoluxContour",
    "Note",
    "Oracle",
    "Picture",
    "SHADOW_CLASSES",
    "Scene",
    "SurfaceExtrema",
    "SurfaceLines",
    "UndecidedRegion",
    "VertexGradient",
    "compare",
    "irradiance_from_sphere",
    "read_exr",
    "render",
]
