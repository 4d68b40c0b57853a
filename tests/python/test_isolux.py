# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of light on surfaces from Python: jumps, kinks, contours, extrema."""

import numpy as np
import pytest

import truelux
from conftest import FLOOR, LAMP, UP, WALL, interrupt, room

BOARD = [[0, -0.125, 0.5], [0.375, -0.125, 0.5], [0.375, 0.25, 0.5],
         [0, 0.25, 0.5]]
WEIGHTS = np.array([0.2126, 0.7152, 0.0722])


def ends_of(oracle, contour, weights=(1, 0, 0)):
    """E at both ends of all transversals, a little farther out, since adding
    rounds; shape (n, 2)."""
    middle = contour.vertices[:, None]
    ends = middle + 1.001 * (contour.transversals - middle)
    return oracle.irradiance(ends, UP, on_face=1) @ np.array(weights)


def check(oracle, isolux, weights=(1, 0, 0)):
    """Shapes, and every certificate."""
    for contour in isolux.contours:
        n = len(contour.vertices)
        assert contour.vertices.shape == contour.across.shape == (n, 3)
        assert contour.half_width.shape == contour.on.shape == (n,)
        assert contour.certified.shape == (n,)
        assert contour.certified.dtype == bool
        assert contour.widths.shape == (n if contour.closed else n - 1,)
        assert contour.transversals.shape == (n, 2, 3)
        assert contour.closed or set(contour.on[[0, -1]]) <= {"outline", "jump"}
        np.testing.assert_allclose(np.linalg.norm(contour.across, axis=-1), 1,
                                   rtol=1e-12)
        assert contour.certified.all()
        e = ends_of(oracle, contour, weights)
        assert (e[:, 0] < contour.level).all() and \
            (contour.level < e[:, 1]).all()


def test_contours_of_a_square_lamp_are_closed():
    oracle = room()
    levels = [0.1, 0.15, 0.2]
    isolux = oracle.isolux("floor", levels=levels)
    assert repr(isolux) == "<truelux.Isolux: 3 contours of 3 levels, 0 of 16 open>"
    np.testing.assert_array_equal(isolux.levels, levels)
    assert [c.level for c in isolux.contours] == levels
    assert all(c.closed and set(c.on) == {"inside"} for c in isolux.contours)
    check(oracle, isolux)
    for contour in isolux.contours:
        assert (contour.half_width <= 1e-9 * isolux.size).all()
        assert (contour.widths <= 1e-3 * isolux.size).all()
        # What is larger, the inside, is on the left.
        x, y, z = contour.vertices.T
        assert (z == 0).all()
        assert np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) > 0
        assert f"{len(x)} vertices, closed" in repr(contour)
    assert isolux.open.shape == (0, 3, 3)
    assert isolux.open_range.shape == (0, 2)
    assert isolux.outline.shape[1:] == (2, 3)
    assert np.linalg.norm(np.diff(isolux.outline, axis=1),
                          axis=-1).sum() == pytest.approx(16, rel=1e-9)
    assert (isolux.size, isolux.open_area, isolux.dark_area) == (4, 0, 0)
    assert isolux.area == pytest.approx(16, rel=1e-9)
    assert isolux.evaluations == \
        isolux.search_evaluations + isolux.line_evaluations > 0
    assert isolux.triangles > 0
    middle = oracle.irradiance([0, 0, 0], UP, on_face=1)[0]
    assert 0 < isolux.least < 0.1 and 0.2 < isolux.most <= middle


def test_threads_and_progress_change_nothing(progress_units):
    oracle = room(WALL)
    one = oracle.isolux("floor", count=3, threads=1)
    two = oracle.isolux("floor", count=3, threads=3, progress=True)
    assert progress_units
    assert len(one.levels) == 3 and len(one.contours) == len(two.contours) > 0
    for a, b in zip(one.contours, two.contours):
        for x, y in zip(a, b):
            np.testing.assert_array_equal(x, y)
    np.testing.assert_array_equal(one.open, two.open)
    progress_units.clear()
    oracle = room()
    mine = oracle.extrema("floor", threads=1)
    its = oracle.extrema("floor", threads=3, progress=True)
    assert progress_units
    for name in ("kind", "at", "value", "range", "radius", "on"):
        np.testing.assert_array_equal(getattr(mine, name), getattr(its, name))


def test_channels_of_a_coloured_lamp():
    oracle = room(emission=(2, 1, 0.5))
    for channel, weights in (("r", (1, 0, 0)), ("b", (0, 0, 1)),
                             ("luminance", WEIGHTS), (None, WEIGHTS)):
        level = 0.15 * np.dot(weights, (2, 1, 0.5))
        isolux = oracle.isolux("floor", levels=level, channel=channel)
        assert [c.closed for c in isolux.contours] == [True]
        check(oracle, isolux, weights)


def test_what_is_asked_for_is_kept():
    oracle = room()
    isolux = oracle.isolux("floor", levels=np.array([0.15]), half_width=1e-6,
                           chord=1e-5, smallest=1e-4, most_triangles=10**6)
    check(oracle, isolux)
    contour, = isolux.contours
    assert 1e-9 < contour.half_width.max() <= 1e-6
    assert contour.widths.max() <= 1e-5
    rough = oracle.isolux("floor", levels=[0.15], smallest=2.0)
    assert 0 < rough.open_area <= rough.area
    assert len(rough.open) == len(rough.open_range) > 0
    low, high = rough.open_range.T
    assert ((low <= 0.15) & (0.15 <= high)).all()


def test_a_wall_gives_jumps():
    oracle = room(WALL)
    lines = oracle.surface_lines("floor")
    assert lines.is_complete and lines.notes == []
    jumps = np.flatnonzero(lines.kind == "jump")
    assert len(jumps) > 0
    assert len(lines) == len(lines.kind) == len(lines.faces) == len(lines.edges)
    assert f"{len(jumps)} jump" in repr(lines)
    ends = lines.ends[jumps]
    assert ends.shape == (len(jumps), 2, 3)
    assert (ends[..., 1:] == [1, 0]).all()
    assert abs(ends[..., 0]).max() == 1
    assert np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1).sum() == 2
    for k in jumps:
        assert lines.faces[k] == [3] and lines.edges[k] == []
        assert (lines.size[k] == 0).all()
        # One side of the wall is turned to the lamp, the other is in its shadow.
        assert min(lines.left[k, 0], lines.right[k, 0]) == 0
        middle = ends[list(jumps).index(k)].mean(axis=0)
        e = oracle.irradiance(middle - [0, 2.0**-34, 0], UP, on_face=1)
        np.testing.assert_allclose(np.maximum(lines.left[k], lines.right[k]), e,
                                   rtol=1e-6)
    isolux = oracle.isolux("floor", levels=[0.05, 0.1])
    check(oracle, isolux)
    assert any("jump" in c.on for c in isolux.contours)
    np.testing.assert_array_equal(isolux.lines.ends, lines.ends)
    assert isolux.dark_area > 0


def test_parallel_edges_give_kinks():
    oracle = room(BOARD)
    lines = oracle.surface_lines("floor")
    assert len(lines) > 0 and (lines.kind == "kink").all()
    assert (lines.left == 0).all() and (lines.right == 0).all()
    for k, pairs in enumerate(lines.edges):
        assert pairs and all(isinstance(pair, tuple) for pair in pairs)
        for a, b in pairs:
            assert 0 <= a < b < len(oracle.scene.vertices)
    found = oracle.derivatives(lines.ends.mean(axis=1), UP, on_face=1)
    assert (found.status[(lines.size != 0).any(axis=1)] == "kink").all()
    isolux = oracle.isolux("floor", count=6)
    check(oracle, isolux)
    assert any("kink" in c.on for c in isolux.contours)


def test_extrema_are_proven():
    oracle = room()
    extrema = oracle.extrema("floor")
    inside = extrema.on == "inside"
    assert list(extrema.kind[inside]) == ["maximum"]
    assert set(extrema.kind) <= {"maximum", "minimum", "saddle"}
    n = len(extrema)
    assert extrema.at.shape == (n, 3) and extrema.range.shape == (n, 2)
    assert extrema.value.shape == extrema.radius.shape == (n,)
    assert repr(extrema).startswith("<truelux.SurfaceExtrema: 1 maximum")
    middle = oracle.irradiance([0, 0, 0], UP, on_face=1)[0]
    at, radius = extrema.at[inside][0], extrema.radius[inside][0]
    assert np.linalg.norm(at) <= radius < 1e-3
    low, high = extrema.range[inside][0]
    assert low <= middle <= high and low <= extrema.value[inside][0] <= high
    e = oracle.irradiance(extrema.at, UP, on_face=1)[:, 0]
    np.testing.assert_allclose(extrema.value, e, rtol=1e-12)
    x, y = np.meshgrid(np.linspace(-2, 2, 41)[1:-1], np.linspace(-2, 2, 41)[1:-1])
    e = oracle.irradiance(np.stack([x, y, 0 * x], axis=-1), UP, on_face=1)
    assert (extrema.least <= e).all() and (e <= extrema.most).all()
    assert extrema.area == pytest.approx(16) and extrema.size == 4
    assert extrema.dark_area == 0 and extrema.evaluations > 0
    area = sum(np.linalg.norm(np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]),
                              axis=-1).sum() / 2
               for t, least, most in extrema.undecided)
    assert area == pytest.approx(extrema.undecided_area)
    assert all(extrema.least <= region.least <= region.most <= extrema.most
               for region in extrema.undecided)


def test_there_is_a_saddle_between_two_lamps():
    left, right = ([[x, -1, 1.5], [x, 1, 1.5], [x + 0.5, 1, 1.5],
                    [x + 0.5, -1, 1.5]] for x in (-1.25, 1.0))
    oracle = truelux.Oracle(truelux.Scene(
        FLOOR + left + right, np.arange(12).reshape(3, 4),
        [[0, 0, 0], [1, 1, 1], [1, 1, 1]], groups=["floor", "a", "b"]))
    extrema = oracle.extrema("floor")
    inside = extrema.on == "inside"
    assert sorted(extrema.kind[inside]) == ["maximum", "maximum", "saddle"]
    saddle = inside & (extrema.kind == "saddle")
    way = extrema.at[saddle][0] - [0.125, 0, 0]
    assert np.linalg.norm(way) <= extrema.radius[saddle][0] < 1e-3


def test_no_light_is_told():
    oracle = room(emission=(0, 0, 0))
    with pytest.warns(truelux.Note, match="no light reaches"):
        isolux = oracle.isolux("floor")
    assert isolux.levels.shape == (0,) and isolux.contours == []
    assert len(isolux.lines.notes) == 1


@pytest.mark.parametrize("words, match", [
    ({"levels": []}, "levels: expected the shape"),
    ({"levels": [[0.1]]}, "levels: expected the shape"),
    ({"levels": "high"}, "levels: expected real numbers"),
    ({"levels": [0, 0.1]}, "levels: 0 is not above 0"),
    ({"levels": [-0.1]}, "levels: -0.1 is not above 0"),
    ({"levels": [np.inf]}, "levels: inf is not"),
    ({"levels": [np.nan]}, "levels: nan is not"),
    ({"levels": [0.2, 0.1]}, "levels: 0.1 does not come after 0.2"),
    ({"levels": [0.1, 0.1]}, "levels: 0.1 does not come after 0.1"),
    ({"count": 0}, "count: expected a whole number from 1"),
    ({"count": 2.5}, "count: expected a whole number from 1"),
    ({"count": 2**31}, "count: expected a whole number from 1"),
    ({"channel": "x"}, "channel: 'x' is none of luminance, r, g, b"),
    ({"half_width": 0}, "half_width: expected a finite length above 0"),
    ({"chord": -1}, "chord: expected a finite length above 0"),
    ({"smallest": np.nan}, "smallest: expected a finite length above 0"),
    ({"smallest": "x"}, "smallest: expected a number"),
    ({"most_triangles": 0}, "most_triangles: expected a whole number from 1"),
    ({"threads": 0}, "threads: expected 1 to 1024"),
    ({"threads": 1025}, "threads: expected 1 to 1024"),
])
def test_what_has_no_contours(words, match):
    with pytest.raises(ValueError, match=match) as raised:
        room().isolux("floor", **words)
    assert isinstance(raised.value, truelux.Error)
    assert "\n" not in str(raised.value)


def test_surfaces_that_are_none():
    oracle = truelux.Oracle(truelux.Scene(
        FLOOR + WALL + LAMP, np.arange(12).reshape(3, 4),
        [[0, 0, 0], [0, 0, 0], [1, 1, 1]], groups=["bent", "bent", "lamp"]))
    for call in (oracle.surface_lines, oracle.isolux, oracle.extrema):
        for surface, match in (("roof", "no object or group"),
                               ("bent", "not flat|one plane|flat"),
                               (3, "surface: expected a str")):
            with pytest.raises(truelux.Error, match=match):
                call(surface)
    with pytest.raises(truelux.Error, match="channel: 'x'"):
        oracle.extrema("lamp", channel="x")
    with pytest.raises(truelux.Error, match="threads: "):
        oracle.extrema("lamp", threads=1.5)


@pytest.mark.parametrize("call", [
    "oracle.isolux('floor', count=1000, chord=1e-9)",
    "oracle.extrema('floor')",
])
def test_ctrl_c_ends_a_call_and_the_oracle_goes_on(call):
    interrupt(call)
