# SPDX-License-Identifier: GPL-3.0-or-later
"""Irradiance as a function that PyTorch differentiates, exactly.

    >>> import torch, truelux.torch
    >>> e = truelux.torch.irradiance(points, normals, vertices, faces, exitance)
    >>> e.sum().backward()    # vertices.grad: dE/dv, with all shadows

Values and derivatives are those of truelux.Oracle: certified, whatever the
scene. There is no other module of this package that needs PyTorch.
"""

from __future__ import annotations

import warnings

import numpy as np
import torch

from .arrays import Note
from .oracle import Oracle
from .scene import Scene


def irradiance(points, normals, vertices, faces, exitance, *, on_face=None,
               groups=None, **oracle) -> torch.Tensor:
    """The irradiance at receivers in a scene, with derivatives.

    Parameters
    ----------
    points, normals : torch.Tensor, shapes that broadcast to (..., 3)
    vertices : torch.Tensor, shape (v, 3)
    faces : sequence
        Rings of vertex indices, as for `truelux.Scene`.
    exitance : torch.Tensor, shape (f, 3)
        M [W/m^2] of the faces; L [W/m^2/sr] with ``emission="radiance"``.
    on_face : as for `truelux.Oracle.irradiance`
    groups : sequence of str, optional
    oracle : keyword arguments of `truelux.Oracle`
        emission="radiance", threads=.. and so on; method is "certified".

    Returns
    -------
    torch.Tensor, shape (..., 3), dtype and device of `points`
        E [W/m^2]. Differentiable once, by points, normals, vertices and, of
        faces that emit, by exitance.

    Raises
    ------
    truelux.Error
        For a scene or receivers that cannot be used.

    Notes
    -----
    At a kink the derivative is the mean of those on all sides; where E is
    discontinuous, or jumps as a vertex moves, it is 0, with a warning. The
    numbers are found in binary64 on the processor, whatever the tensors.
    """
    return _Irradiance.apply(points, normals, vertices, exitance,
                             (faces, on_face, groups, oracle))


def _array(tensor: torch.Tensor) -> np.ndarray:
    return tensor.detach().cpu().to(torch.float64).numpy()


def _summed_to(gradient: np.ndarray, like: torch.Tensor) -> torch.Tensor:
    """The gradient by what was broadcast, from that by all copies."""
    extra = gradient.ndim - like.ndim
    gradient = gradient.sum(axis=tuple(range(extra)))
    stretched = tuple(k for k, size in enumerate(like.shape)
                      if size == 1 and gradient.shape[k] != 1)
    gradient = gradient.sum(axis=stretched, keepdims=True)
    return torch.from_numpy(np.ascontiguousarray(gradient)).to(like)


class _Irradiance(torch.autograd.Function):

    @staticmethod
    def forward(ctx, points, normals, vertices, exitance, fixed):
        faces, on_face, groups, options = fixed
        oracle = Oracle(
            Scene(_array(vertices), faces, _array(exitance), groups=groups),
            **options)
        ctx.save_for_backward(points, normals, vertices, exitance)
        ctx.oracle = oracle
        ctx.on_face = on_face
        values = oracle.irradiance(_array(points), _array(normals),
                                   on_face=on_face)
        return torch.from_numpy(values).to(points)

    @staticmethod
    @torch.autograd.function.once_differentiable
    def backward(ctx, weights):
        points, normals, vertices, exitance = ctx.saved_tensors
        weights = _array(weights)
        by_points = by_normals = by_vertices = by_exitance = None
        place = (_array(points), _array(normals))
        if ctx.needs_input_grad[0] or ctx.needs_input_grad[1]:
            found = ctx.oracle.derivatives(*place, on_face=ctx.on_face,
                                           sphere=False, jacobian=False)
            missing = int((found.status == "discontinuous").sum())
            if missing:
                warnings.warn(f"E is discontinuous at {missing} receivers: "
                              "derivatives there are taken as 0", Note,
                              stacklevel=2)
            if ctx.needs_input_grad[0]:
                by_points = _summed_to(_weighted(weights, found.gradient),
                                       points)
            if ctx.needs_input_grad[1]:
                # E does not depend on the length of a normal.
                length = np.linalg.norm(place[1], axis=-1, keepdims=True)
                by_normals = _summed_to(
                    _weighted(weights, found.normal) / length, normals)
        if ctx.needs_input_grad[2]:
            found = ctx.oracle.vertex_gradient(*place, weights,
                                               on_face=ctx.on_face)
            by_vertices = torch.from_numpy(found.values).to(vertices)
        if ctx.needs_input_grad[3]:
            by_exitance = torch.from_numpy(
                _by_exitance(ctx.oracle, place, ctx.on_face, weights,
                             tuple(exitance.shape))).to(exitance)
        return by_points, by_normals, by_vertices, by_exitance, None


def _weighted(weights: np.ndarray, gradient: np.ndarray) -> np.ndarray:
    """The sum over channels of weight times gradient; 0 where there is none."""
    return np.einsum("...c,...ck->...k", weights, np.nan_to_num(gradient))


def _by_exitance(oracle, place, on_face, weights, shape) -> np.ndarray:
    factors = oracle.form_factors(*place, on_face=on_face)
    scale = np.pi if oracle.emission == "radiance" else 1.0
    result = np.zeros(shape)
    result[factors.faces - 1] = scale * np.einsum(
        "ns,nc->sc", factors.values.reshape(-1, len(factors.faces)),
        weights.reshape(-1, 3))
    return result
