# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that follow the light, from Python."""

import dataclasses

import numpy as np
import pytest

import truelux
from conftest import FLOOR, LAMP, UP, WALL, interrupt, room

LOW, HIGH = (0.75, 0.25, 0.0), (1.25, 0.75, 0.5)
ARRAYS = ("points", "irradiance", "values", "triangles", "sides", "faces")


def box():
    """The sides and the top of a box that stands on the floor."""
    (x, y, z), (u, v, w) = LOW, HIGH
    return [[[x, y, z], [u, y, z], [u, y, w], [x, y, w]],
            [[u, y, z], [u, v, z], [u, v, w], [u, y, w]],
            [[u, v, z], [x, v, z], [x, v, w], [u, v, w]],
            [[x, v, z], [x, y, z], [x, y, w], [x, v, w]],
            [[x, y, w], [u, y, w], [u, v, w], [x, v, w]]]


@pytest.fixture(scope="module")
def boxed():
    """A box in a room, and the mesh of the floor."""
    oracle = room(*box())
    return oracle, oracle.iso_mesh("floor", count=4)


def corners_of(mesh):
    """Shape (m, 3, 3)."""
    return mesh.points[mesh.triangles]


def ends_of_sides(mesh):
    """The vertices of side k: k + 1 and k + 2; shape (m, 3, 2)."""
    return np.stack([np.roll(mesh.triangles, -1, axis=1),
                     np.roll(mesh.triangles, -2, axis=1)], axis=-1)


def vertices_on(mesh, *sides):
    """Whether vertices are at such sides, or where such ones are; shape (n,)."""
    places = np.unique(
        mesh.points[ends_of_sides(mesh)[np.isin(mesh.sides, sides)].ravel()],
        axis=0)
    return (mesh.points[:, None] == places).all(axis=-1).any(axis=-1)


def test_shapes_and_what_is_told(boxed):
    oracle, mesh = boxed
    n, m = len(mesh.points), len(mesh.triangles)
    assert mesh.points.shape == mesh.irradiance.shape == (n, 3)
    assert mesh.values.shape == (n,)
    assert mesh.triangles.shape == mesh.sides.shape == (m, 3)
    assert mesh.faces.shape == (m,) and (mesh.faces == 1).all()
    assert mesh.triangles.dtype == mesh.faces.dtype == np.int64
    assert mesh.points.dtype == mesh.values.dtype == mesh.irradiance.dtype == float
    np.testing.assert_array_equal(np.unique(mesh.triangles), np.arange(n))
    assert set(mesh.sides.flat) <= {"inside", "contour", "kink", "jump", "outline"}
    assert {"inside", "contour", "jump", "outline"} <= set(mesh.sides.flat)
    assert mesh.evaluations > n
    assert repr(mesh) == (
        f"<truelux.IsoMesh: {n} vertices, {m} triangles, {mesh.unfinished} of "
        f"them above {mesh.error:.3g} W/m^2>")
    # The contours are those of isolux.
    isolux = oracle.isolux("floor", count=4)
    np.testing.assert_array_equal(mesh.isolux.levels, isolux.levels)
    assert len(mesh.isolux.contours) == len(isolux.contours) > 0
    for a, b in zip(mesh.isolux.contours, isolux.contours):
        np.testing.assert_array_equal(a.vertices, b.vertices)
    assert mesh.error == pytest.approx((isolux.most - isolux.least) / 100)


def test_it_cannot_be_changed(boxed):
    _, mesh = boxed
    for name in ARRAYS:
        with pytest.raises(ValueError, match="read-only"):
            getattr(mesh, name)[0] = getattr(mesh, name)[1]
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(mesh, name, None)
    with pytest.raises(dataclasses.FrozenInstanceError):
        mesh.interpolation.most = 0


def test_values_are_those_of_the_oracle(boxed):
    oracle, mesh = boxed
    inner = ~vertices_on(mesh, "outline", "jump")
    assert inner.sum() > 100 and (~inner).sum() > 20
    assert (inner & vertices_on(mesh, "contour")).any()
    e = oracle.irradiance(mesh.points, UP, on_face=1)
    np.testing.assert_array_equal(mesh.irradiance[inner], e[inner])
    np.testing.assert_array_equal(mesh.values, mesh.irradiance[:, 0])
    # At the outline the receiver is beside the vertex.
    outline = vertices_on(mesh, "outline")
    np.testing.assert_allclose(mesh.irradiance[outline], e[outline], rtol=1e-8,
                               atol=1e-10)
    assert (mesh.irradiance[outline] != e[outline]).any()


def test_triangles_cover_the_floor_once(boxed):
    _, mesh = boxed
    a, b, c = np.moveaxis(corners_of(mesh), 1, 0)
    normal = np.cross(b - a, c - a)
    assert (normal[:, :2] == 0).all() and (normal[:, 2] > 0).all()
    assert normal[:, 2].sum() / 2 == pytest.approx(16, rel=1e-13)
    # Two triangles at each place, at the outline one; both say the same.
    kinds = {}
    for ends, kind in zip(mesh.points[ends_of_sides(mesh)].reshape(-1, 2, 3),
                          mesh.sides.flat):
        kinds.setdefault(tuple(sorted(map(tuple, ends))), []).append(kind)
    assert all(len(found) == (1 if found[0] == "outline" else 2)
               and len(set(found)) == 1 for found in kinds.values())
    outer = mesh.points[ends_of_sides(mesh)[mesh.sides == "outline"]]
    assert np.linalg.norm(outer[:, 1] - outer[:, 0], axis=-1).sum() == \
        pytest.approx(16, rel=1e-13)
    assert (abs(outer[..., :2]).max(axis=-1) == 2).all()


def test_the_least_angle_is_that_of_the_triangles(boxed):
    _, mesh = boxed
    corners = corners_of(mesh)
    angles = []
    for k in range(3):
        u = corners[:, (k + 1) % 3] - corners[:, k]
        v = corners[:, (k + 2) % 3] - corners[:, k]
        angles.append(np.arctan2(np.cross(u, v)[:, 2], (u * v).sum(axis=-1)))
    assert mesh.least_angle == pytest.approx(np.degrees(np.min(angles)), rel=1e-9)


def test_vertices_are_double_along_jumps(boxed):
    _, mesh = boxed
    sides = ends_of_sides(mesh)[mesh.sides == "jump"]
    # Each side of a triangle outside has one inside the box in the same place.
    places = {}
    for ends in sides:
        key = tuple(sorted(map(tuple, mesh.points[ends])))
        places.setdefault(key, []).append(ends)
    assert len(places) >= 4
    length = sum(np.linalg.norm(np.subtract(p, q)) for p, q in places)
    assert length == pytest.approx(2, rel=1e-12)
    assert all(len(both) == 2 for both in places.values())
    assert all(not set(one) & set(other) for one, other in places.values())
    # What is below the box is dark, and what is beside it is not everywhere.
    middles = corners_of(mesh).mean(axis=1)[:, :2]
    below = ((middles > LOW[:2]) & (middles < HIGH[:2])).all(axis=-1)
    assert below.sum() >= 2
    assert (mesh.values[mesh.triangles[below]] == 0).all()
    beside = np.setdiff1d(sides, mesh.triangles[below])
    assert (mesh.values[beside] > 0.05).any()
    a, b, c = np.moveaxis(corners_of(mesh)[below], 1, 0)
    assert np.linalg.norm(np.cross(b - a, c - a), axis=-1).sum() / 2 == \
        pytest.approx(0.25, rel=1e-12)


def test_contours_are_sides():
    mesh = room().iso_mesh("floor", levels=[0.1, 0.2])
    assert (mesh.drawn, mesh.most_drawn) == (0, 0)
    ends = ends_of_sides(mesh)[mesh.sides == "contour"]
    assert len(ends) > 20
    values = mesh.values[ends]
    np.testing.assert_allclose(values[:, 0], values[:, 1], rtol=1e-6)
    level = np.where(values[:, 0] > 0.15, 0.2, 0.1)
    np.testing.assert_allclose(values[:, 0], level, rtol=1e-6)
    assert set(level) == {0.1, 0.2}
    assert "jump" not in mesh.sides


def test_kinks_are_sides():
    board = [[0, -0.125, 0.5], [0.375, -0.125, 0.5], [0.375, 0.25, 0.5],
             [0, 0.25, 0.5]]
    oracle = room(board)
    mesh = oracle.iso_mesh("floor", count=3)
    ends = mesh.points[ends_of_sides(mesh)[mesh.sides == "kink"]]
    lines = oracle.surface_lines("floor")
    assert (lines.kind == "kink").all()
    # Both triangles at a side say so.
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1).sum() / 2
    assert length == pytest.approx(np.linalg.norm(
        lines.ends[:, 1] - lines.ends[:, 0], axis=-1).sum(), rel=1e-9)


def test_interpolation_is_better_than_in_a_uniform_mesh(boxed):
    oracle, mesh = boxed
    good, plain = mesh.interpolation, mesh.uniform
    assert 0 < good.mean < good.at_99 < good.most
    assert good.at_99 < plain.at_99 and good.most < plain.most / 2
    assert mesh.uniform_vertices == pytest.approx(len(mesh.points), rel=0.2)
    # The middles of triangles are among the points that were asked.
    middles = corners_of(mesh).mean(axis=1)
    e = oracle.irradiance(middles, UP, on_face=1)[:, 0]
    miss = abs(mesh.values[mesh.triangles].mean(axis=1) - e)
    assert 0 < miss.max() <= good.most * (1 + 1e-9)


def test_what_is_asked_for_is_kept():
    oracle = room()
    words = {"levels": [0.15]}
    fine = oracle.iso_mesh("floor", error=1e-3, **words)
    rough = oracle.iso_mesh("floor", error=1e-2, **words)
    assert (fine.error, rough.error) == (1e-3, 1e-2)
    assert fine.unfinished == rough.unfinished == 0
    assert len(rough.points) < len(fine.points) / 2
    # Three points in each triangle.
    for mesh in (fine, rough):
        weights = (np.ones((3, 3)) + 3 * np.eye(3)) / 6
        at = np.einsum("kc,mcx->mkx", weights, corners_of(mesh))
        e = oracle.irradiance(at, UP, on_face=1)[..., 0]
        miss = abs(mesh.values[mesh.triangles] @ weights - e)
        assert mesh.error / 4 < miss.max() <= mesh.error * (1 + 1e-9)
    # Too small or too many: some stay above the error.
    for limit in ({"mesh_smallest": 0.5}, {"most_vertices": 60}):
        mesh = oracle.iso_mesh("floor", error=1e-3, **words, **limit)
        assert 0 < mesh.unfinished <= len(mesh.triangles)
        assert len(mesh.points) < len(fine.points)
    chords = [oracle.iso_mesh("floor", chord=chord, **words).isolux.contours[0]
              for chord in (1e-2, 1e-4)]
    assert len(chords[0].vertices) < len(chords[1].vertices)


def test_channels_of_a_coloured_lamp():
    oracle = room(emission=(2, 1, 0.5))
    for channel, weights in (("b", (0, 0, 1)), (None, (0.2126, 0.7152, 0.0722))):
        mesh = oracle.iso_mesh("floor", count=2, channel=channel)
        np.testing.assert_allclose(mesh.values, mesh.irradiance @ weights,
                                   rtol=1e-14)
        np.testing.assert_allclose(
            mesh.irradiance, mesh.irradiance[:, :1] * [1, 0.5, 0.25], rtol=1e-14)


def test_threads_and_progress_change_nothing(progress_units):
    oracle = room(*box())
    one = oracle.iso_mesh("floor", count=3, threads=1)
    two = oracle.iso_mesh("floor", count=3, threads=2, progress=True)
    assert {"vertices", "triangles"} <= progress_units
    for field in dataclasses.fields(one):
        a, b = getattr(one, field.name), getattr(two, field.name)
        if field.name in ARRAYS:
            np.testing.assert_array_equal(a, b)
        elif field.name != "isolux":
            assert a == b, field.name
    for a, b in zip(one.isolux.contours, two.isolux.contours, strict=True):
        np.testing.assert_array_equal(a.vertices, b.vertices)


def test_no_light_is_told():
    with pytest.warns(truelux.Note, match="no light reaches") as told:
        mesh = room(emission=(0, 0, 0)).iso_mesh("floor")
    assert told[0].filename == __file__
    assert mesh.isolux.contours == [] and (mesh.values == 0).all()
    assert (mesh.error, mesh.unfinished, mesh.interpolation.most) == (0, 0, 0)
    assert set(mesh.sides.flat) == {"inside", "outline"}


@pytest.mark.parametrize("words, match", [
    ({"levels": []}, "levels: expected the shape"),
    ({"levels": [0.2, 0.1]}, "levels: 0.1 does not come after 0.2"),
    ({"count": 0}, "count: expected a whole number from 1"),
    ({"channel": "x"}, "channel: 'x' is none of luminance, r, g, b"),
    ({"half_width": 0}, "half_width: expected a finite length above 0"),
    ({"chord": -1}, "chord: expected a finite length above 0"),
    ({"smallest": np.nan}, "^smallest: expected a finite length above 0"),
    ({"most_triangles": 0}, "most_triangles: expected a whole number from 1"),
    ({"error": 0}, "error: expected a finite number above 0"),
    ({"error": -1e-3}, "error: expected a finite number above 0"),
    ({"error": np.nan}, "error: expected a finite number above 0"),
    ({"error": "x"}, "error: expected a number, found 'x'"),
    ({"mesh_smallest": 0}, "mesh_smallest: expected a finite length above 0"),
    ({"mesh_smallest": np.inf}, "mesh_smallest: expected a finite length above"),
    ({"mesh_smallest": [1, 2]}, "mesh_smallest: expected a number"),
    ({"most_vertices": 0}, "most_vertices: expected a whole number from 1"),
    ({"most_vertices": 2.5}, "most_vertices: expected a whole number from 1"),
    ({"most_vertices": 2**63}, "most_vertices: expected a whole number from 1"),
    ({"threads": 0}, "threads: expected 1 to 1024"),
])
def test_what_has_no_mesh(words, match):
    with pytest.raises(ValueError, match=match) as raised:
        room().iso_mesh("floor", **words)
    assert isinstance(raised.value, truelux.Error)
    assert "\n" not in str(raised.value)


def test_surfaces_that_are_none():
    oracle = truelux.Oracle(truelux.Scene(
        FLOOR + WALL + LAMP, np.arange(12).reshape(3, 4),
        [[0, 0, 0], [0, 0, 0], [1, 1, 1]], groups=["bent", "bent", "lamp"]))
    for surface, match in (("roof", "no object or group"), ("bent", "flat"),
                           (3, "surface: expected a str")):
        with pytest.raises(truelux.Error, match=match):
            oracle.iso_mesh(surface)


def test_ctrl_c_ends_the_division_of_triangles_and_the_oracle_goes_on():
    # Its one contour takes a tenth of a second, the mesh would take minutes.
    interrupt("oracle.iso_mesh('floor', count=1, error=1e-9)",
              f"truelux.Scene({FLOOR + LAMP}, [[0, 1, 2, 3], [4, 5, 6, 7]], "
              "[[0, 0, 0], [1, 1, 1]], groups=['floor', 'lamp'])")
