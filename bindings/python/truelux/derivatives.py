# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivatives of irradiance as arrays."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

_STATUS = np.array(["C1", "kink", "discontinuous"])

_KINK = [("receiver", "i8"), ("normal", "f8", 3), ("size", "f8", 3),
         ("faces", "O"), ("edges", "i8", (2, 2))]


class Derivatives:
    """E and its derivatives at receivers of the leading shape (...).

    Numbers of a discontinuous receiver are nan, but for E. At a kink,
    derivatives by the place are the means of those on all sides. Each number is
    the binary64 nearest to the true value if the oracle is certified; `bounds`
    has the same attributes.

    Attributes
    ----------
    irradiance : (..., 3)
        E [W/m^2].
    gradient : (..., 3, 3)
        dE/dr with the normal fixed [W/m^3], per channel.
    tangential : (..., 3, 3)
        Its part in the plane of the receiver's face, else across the normal.
    normal : (..., 3, 3)
        dE/dn per radian, across the normal [W/m^2].
    vector : (..., 3, 3)
        The vector irradiance V over the hemisphere [W/m^2].
    jacobian : (..., 3, 3, 3) or None
        dV_p/dr_k [W/m^3], indices channel, p, k.
    sphere, flux, sphere_jacobian : arrays or None
        The light field vector, the net flux (n.V for n of length 1), and the
        Jacobian of the whole sphere.
    status : (...) of str
        "C1", "kink" or "discontinuous".
    kinks : structured array
        receiver (index into the flattened leading shape), normal m, size b per
        channel [W/m^3], faces (list of numbers), edges (pairs of vertex indices,
        -1: none): E'(r; d) = gradient.d + sum of b abs(m.d).
    bounds : Derivatives
        Bounds on the errors; without status and kinks.
    """

    def __init__(self, found: dict, shape: tuple, sphere: bool,
                 jacobian: bool):
        smoothness = found["smoothness"]
        self.status = _STATUS[smoothness].reshape(shape)
        self.kinks = np.array(
            [tuple(kink) for kink in found["kinks"]], dtype=_KINK)
        gone = smoothness == 2
        self.bounds = Derivatives.__new__(Derivatives)
        for target, values, irradiance in (
                (self, found["values"], found["irradiance"]),
                (self.bounds, found["bounds"], found["irradiance_bound"])):
            target.irradiance = irradiance.reshape(shape + (3,))
            for name, array in values.items():
                is_there = ((sphere or name not in _OF_SPHERE) and
                            (jacobian or "jacobian" not in name))
                if is_there:
                    array[gone] = np.nan
                    array = array.reshape(shape + array.shape[1:])
                setattr(target, name, array if is_there else None)

    def __repr__(self) -> str:
        if not hasattr(self, "status"):
            return f"<truelux.Derivatives: bounds, {self.irradiance.shape}>"
        names, counts = np.unique(self.status, return_counts=True)
        kinds = ", ".join(f"{n} {name}" for name, n in zip(names, counts))
        return f"<truelux.Derivatives: {kinds}>"


_OF_SPHERE = ("sphere", "flux", "sphere_jacobian")


class VertexGradient(NamedTuple):
    """The gradient of a weighted sum of irradiances by the scene's vertices."""

    values: np.ndarray
    """Row k: by the vertex number k + 1 of the input (row k of `vertices` of a
    scene made of arrays); shape (v, 3), in weight W/m^3."""
    one_sided: int
    """How many slopes were one-sided, or jumps: the mean of both sides, or 0,
    was taken."""

    @classmethod
    def _of(cls, numbers: np.ndarray, values: np.ndarray, one_sided: int,
            least: int) -> VertexGradient:
        size = max(least, int(numbers.max(initial=0)))
        dense = np.zeros((size, 3))
        dense[numbers - 1] = values
        return cls(dense, one_sided)


