# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivatives as arrays: the program's bits, and identities."""

import numpy as np
import pytest

import truelux
from conftest import LAMP, PLATE, UP, columns_of, obj_of, run, table_of

AXES = "xyz"
NAMES = {
    "gradient": [f"grad_{c}_{a}" for c in "rgb" for a in AXES],
    "tangential": [f"tgrad_{c}_{a}" for c in "rgb" for a in AXES],
    "normal": [f"dn_{c}_{a}" for c in "rgb" for a in AXES],
    "vector": [f"V_{c}_{a}" for c in "rgb" for a in AXES],
    "jacobian": [f"J_{c}_{a}{b}" for c in "rgb" for a in AXES for b in AXES],
    "sphere": [f"L_{c}_{a}" for c in "rgb" for a in AXES],
    "flux": [f"flux_{c}" for c in "rgb"],
    "sphere_jacobian": [f"Jsphere_{c}_{a}{b}" for c in "rgb" for a in AXES
                        for b in AXES],
}


def test_has_the_bits_of_the_program(tmp_path, scene, oracle, grid):
    text = run("gradient", obj_of(tmp_path, scene), "-", "--of",
               "gradient,tangential,normal,vector,sphere,flux,jacobian",
               text=table_of(grid, UP))
    d = oracle.derivatives(grid, UP)
    np.testing.assert_array_equal(d.irradiance, oracle.irradiance(grid, UP))
    for name, columns in NAMES.items():
        np.testing.assert_array_equal(
            getattr(d, name).reshape(len(grid) * 5, -1),
            columns_of(text, *columns), err_msg=name)
    assert d.jacobian.shape == (6, 5, 3, 3, 3) and d.flux.shape == (6, 5, 3)
    assert (d.bounds.gradient >= 0).all() and (d.status == "C1").all()
    assert repr(d) == "<truelux.Derivatives: 30 C1>"


def test_less_is_asked_for(oracle, grid):
    d = oracle.derivatives(grid, UP, sphere=False, jacobian=False)
    assert d.sphere is None and d.jacobian is None and d.flux is None
    assert d.bounds.sphere_jacobian is None
    np.testing.assert_array_equal(d.gradient,
                                  oracle.derivatives(grid, UP).gradient)


def test_differences_approach_the_gradient(oracle, grid):
    d = oracle.derivatives(grid, UP)
    h = 1e-5
    for k in range(3):
        step = h * np.eye(3)[k]
        slope = (oracle.irradiance(grid + step, UP) -
                 oracle.irradiance(grid - step, UP)) / (2 * h)
        np.testing.assert_allclose(slope, d.gradient[..., k], atol=1e-8)


def test_kinks_and_discontinuities():
    # An upright plate, and receivers in its plane, beside it, and on it.
    plate = [[0.2, -0.3, 0.3], [0.2, 0.3, 0.3], [0.2, 0.3, 0.6],
             [0.2, -0.3, 0.6]]
    scene = truelux.Scene(LAMP + plate, [[0, 1, 2, 3], [4, 5, 6, 7]], [1, 0])
    d = truelux.Oracle(scene).derivatives(
        [[0.2, 0, 0], [0.3, 0, 0], [0.2, 0, 0.4]], UP)
    assert d.status.tolist() == ["kink", "C1", "discontinuous"]
    assert np.isnan(d.gradient[2]).all() and not np.isnan(d.gradient[:2]).any()
    assert (d.irradiance > 0).any(axis=-1).all()
    kink, = d.kinks
    assert kink["receiver"] == 0 and kink["faces"] == [2]
    np.testing.assert_array_equal(kink["normal"], [1, 0, 0])
    # One-sided differences are what gradient and kink say.
    oracle = truelux.Oracle(scene)
    here = oracle.irradiance([0.2, 0, 0], UP)
    for side in (-1, 1):
        there = oracle.irradiance([0.2 + side * 1e-7, 0, 0], UP)
        expected = side * d.gradient[0, :, 0] + kink["size"]
        np.testing.assert_allclose((there - here) / 1e-7, expected, rtol=1e-5)


def test_vertex_gradient_moves_the_sum(scene, oracle, grid):
    weights = np.random.default_rng(2).uniform(-1, 1, grid.shape)
    found = oracle.vertex_gradient(grid, UP, weights)
    assert found.values.shape == (7, 3) and found.one_sided == 0

    def value(vertices):
        moved = truelux.Scene(vertices, scene.faces, scene.emission)
        return (weights *
                truelux.Oracle(moved).irradiance(grid, UP)).sum()

    vertices = np.array(LAMP + PLATE, float)
    h = 1e-5
    for v in (4, 5, 6):
        for k in range(3):
            step = np.zeros_like(vertices)
            step[v, k] = h
            slope = (value(vertices + step) - value(vertices - step)) / (2 * h)
            assert slope == pytest.approx(found.values[v, k], abs=1e-7)
    for threads in (1, 3):
        again = truelux.Oracle(scene, threads=threads).vertex_gradient(
            grid, UP, weights)
        np.testing.assert_array_equal(again.values, found.values)


def test_vertex_gradient_is_dense_over_the_input():
    # A point twice, and one that no face uses: rows are the input's.
    vertices = LAMP + [[9, 9, 9]] + PLATE
    scene = truelux.Scene(vertices, [[0, 1, 2, 3], [5, 6, 7]], [1, 0])
    found = truelux.Oracle(scene).vertex_gradient([0, 0, 0], UP, 1.0)
    assert found.values.shape == (8, 3)
    assert (found.values[4] == 0).all() and (found.values[5] != 0).any()
    with pytest.raises(truelux.Error, match="finite"):
        truelux.Oracle(scene).vertex_gradient([0, 0, 0], UP, np.nan)
    with pytest.raises(truelux.Error, match="weights"):
        truelux.Oracle(scene).vertex_gradient([0, 0, 0], UP, [1, 2])
