# SPDX-License-Identifier: GPL-3.0-or-later
"""The module's numbers are the program's, bit for bit, whatever the layout."""

import gc
import os
import signal
import subprocess
import sys
import textwrap
import time

import numpy as np
import pytest

import truelux
from conftest import EXAMPLES, UP, columns_of, obj_of, run, table_of


def test_has_the_bits_of_the_program(tmp_path, scene, oracle, grid):
    text = run("eval", obj_of(tmp_path, scene), "-", text=table_of(grid, UP))
    expected = columns_of(text, "E_r", "E_g", "E_b").reshape(grid.shape)
    e, bound = oracle.irradiance(grid, UP, bound=True)
    assert e.dtype == np.float64 and e.shape == (6, 5, 3)
    np.testing.assert_array_equal(e, expected)
    assert (e > 0).all()
    np.testing.assert_array_equal(bound, np.spacing(e) / 2)


def test_in_double_with_bounds(tmp_path, scene, grid):
    text = run("eval", obj_of(tmp_path, scene), "-", "--method", "double",
               text=table_of(grid, UP))
    rough = truelux.Oracle(scene, method="double")
    e, bound = rough.irradiance(grid, UP, bound=True)
    np.testing.assert_array_equal(
        e.reshape(-1, 3), columns_of(text, "E_r", "E_g", "E_b"))
    np.testing.assert_array_equal(
        bound.reshape(-1, 3),
        columns_of(text, "bound_r", "bound_g", "bound_b"))


@pytest.mark.parametrize("engine", ["arrangement", "angular-spans"])
def test_engines_agree(scene, oracle, grid, engine):
    other = truelux.Oracle(scene, engine=engine)
    np.testing.assert_array_equal(other.irradiance(grid, UP),
                                  oracle.irradiance(grid, UP))


def test_radiance_is_pi_times_as_much(scene, oracle, grid):
    radiance = truelux.Oracle(scene, emission="radiance")
    np.testing.assert_allclose(radiance.irradiance(grid, UP),
                               np.pi * oracle.irradiance(grid, UP), rtol=1e-15)


def test_any_layout_gives_the_same_bits(oracle, grid):
    expected = oracle.irradiance(grid, UP)
    every_other = np.repeat(grid, 2, axis=0)[::2]
    backwards = grid[::-1][::-1]
    fortran = np.asfortranarray(grid)
    wide = np.zeros(grid.shape[:2] + (7,))
    wide[..., 2:5] = grid
    for points in (every_other, backwards, fortran, wide[..., 2:5],
                   grid.tolist()):
        np.testing.assert_array_equal(oracle.irradiance(points, UP), expected)
    normals = np.broadcast_to(UP, grid.shape)
    np.testing.assert_array_equal(oracle.irradiance(grid, normals), expected)
    # binary32 numbers are binary64 numbers; integers, too.
    narrow = grid.astype(np.float32)
    np.testing.assert_array_equal(
        oracle.irradiance(narrow, UP),
        oracle.irradiance(narrow.astype(np.float64), UP))
    np.testing.assert_array_equal(oracle.irradiance([0, 0, 0], [0, 0, 1]),
                                  oracle.irradiance([0.0, 0.0, 0.0], UP))
    # One point, many normals.
    tilted = np.array([[0.1 * k, 0, 1] for k in range(4)])
    assert oracle.irradiance([0, 0, 0], tilted).shape == (4, 3)
    assert oracle.irradiance(np.zeros((0, 3)), UP).shape == (0, 3)


def test_what_cannot_be_used_is_told_all_at_once(oracle):
    points = np.zeros((4, 3))
    points[1, 2] = np.nan
    points[3, 0] = np.inf
    normals = np.array([[0, 0, 1], [0, 0, 1], [0, 0, 0], [0, 0, 1.0]])
    with pytest.raises(truelux.Error) as caught:
        oracle.irradiance(points, normals)
    assert caught.value.defects == [
        "receiver 1: the point is not finite",
        "receiver 2: the normal is zero",
        "receiver 3: the point is not finite",
    ]
    assert isinstance(caught.value, ValueError)
    with pytest.raises(truelux.Error, match="first hundred"):
        oracle.irradiance(np.full((500, 3), np.nan), UP)


@pytest.mark.parametrize("points, normals, words", [
    ([0, 0], UP, r"points: expected the shape \(..., 3\), found \(2,\)"),
    (0.0, UP, r"points: expected the shape"),
    ([[0, 0, 0]], [[0, 1]], "normals: expected the shape"),
    (np.zeros((2, 3)), np.zeros((5, 3)), "do not go together"),
    (np.zeros((2, 3), complex), UP, "expected real numbers"),
    (["a", "b", "c"], UP, "expected real numbers"),
    (None, UP, "expected real numbers"),
])
def test_wrong_shapes_and_types(oracle, points, normals, words):
    with pytest.raises(truelux.Error, match=words):
        oracle.irradiance(points, normals)


def test_huge_and_tiny_numbers(scene):
    oracle = truelux.Oracle(scene)
    far = oracle.irradiance([0, 0, -1e300], UP)
    assert (far == 0).all() or (far > 0).all() and np.isfinite(far).all()
    assert (oracle.irradiance([0, 0, 5e-324], UP) > 0).all()
    np.testing.assert_array_equal(oracle.irradiance([0, 0, 0], 1e-300 * UP),
                                  oracle.irradiance([0, 0, 0], 1e300 * UP))


def test_on_face_in_every_form():
    scene = truelux.Scene.read(EXAMPLES / "figure7_b.obj")
    oracle = truelux.Oracle(scene)
    points = np.array([[0.5, 0.25, 1e-9], [1, 1, -1e-9]])
    by_number = oracle.irradiance(points, UP, on_face=1)
    for on_face in ("auto", "floor", [1, 1], np.array([1, 1], np.int32)):
        np.testing.assert_array_equal(
            oracle.irradiance(points, UP, on_face=on_face), by_number)
    assert (by_number > 0).all()
    # Below its own floor, a receiver sees nothing else.
    assert (oracle.irradiance(points[1], UP) == 0).all()
    np.testing.assert_array_equal(scene.face_near(points, UP), [1, 1])
    for on_face, words in ((9999, "out of range"), (-1, "out of range"),
                           (2**40, "out of range"), ([1, 1, 1], "does not go"),
                           ("nobody", "no face"), (1.5, "expected None")):
        with pytest.raises(truelux.Error, match=words):
            oracle.irradiance(points, UP, on_face=on_face)


def test_threads_and_progress_change_nothing(scene):
    points = np.random.default_rng(3).uniform(-1, 1, (700, 3)) * [1, 1, 0]
    one = truelux.Oracle(scene, threads=1).irradiance(points, UP)
    for threads in (2, 5):
        many = truelux.Oracle(scene, threads=threads)
        np.testing.assert_array_equal(many.irradiance(points, UP), one)
    np.testing.assert_array_equal(
        truelux.Oracle(scene).irradiance(points, UP, progress=True), one)


def test_form_factors_sum_to_the_irradiance(scene, oracle, grid):
    found = oracle.form_factors(grid, UP)
    np.testing.assert_array_equal(found.faces, [1])
    assert found.values.shape == (6, 5, 1)
    np.testing.assert_allclose(found.values * [2, 1, 0.5],
                               oracle.irradiance(grid, UP), rtol=1e-15)
    assert (found.bounds <= np.spacing(found.values)).all()


def test_contour_is_closed_and_names_faces(oracle):
    contour = oracle.contour([0, 0, 0], UP)
    vertices, arcs = contour
    assert len(arcs) >= 4
    np.testing.assert_array_equal(np.sort(arcs["from"]), np.sort(arcs["to"]))
    assert set(arcs["source"]) == {1} and set(arcs["edge_face"]) == {1, 2}
    assert "apparent" in vertices["kind"]
    # The visible side is where the plane's normal points.
    d = vertices["direction"]
    crossed = np.cross(d[arcs["from"]], d[arcs["to"]])
    assert (np.einsum("ij,ij->i", crossed, arcs["plane_normal"]) >= 0).all()
    with pytest.raises(truelux.Error, match="one point"):
        oracle.contour(np.zeros((2, 3)), UP)


def test_sphere():
    e = truelux.irradiance_from_sphere([[0, 0, 0], [0, 0, 1]], UP, [0, 0, 5],
                                       2, [1, 2, 3])
    np.testing.assert_allclose(e[0], np.array([1, 2, 3]) * 4 / 25, rtol=1e-14)
    np.testing.assert_allclose(e[1], np.array([1, 2, 3]) * 4 / 16, rtol=1e-14)
    with pytest.raises(truelux.Error, match="receiver 0"):
        truelux.irradiance_from_sphere([0, 0, 5], UP, [0, 0, 5], 2, 1)


@pytest.mark.parametrize("words, match", [
    ({"method": "exact"}, "method: 'exact' is none of certified, double"),
    ({"engine": "ray"}, "engine: 'ray' is none of"),
    ({"emission": "flux"}, "emission: 'flux' is none of"),
    ({"formula": "x"}, "formula: 'x' is none of auto"),
    ({"threads": 0}, "threads: expected"),
    ({"threads": 5000}, "threads: expected"),
])
def test_words_of_an_oracle(scene, words, match):
    with pytest.raises(truelux.Error, match=match):
        truelux.Oracle(scene, **words)
    with pytest.raises(truelux.Error, match="expected a truelux.Scene"):
        truelux.Oracle("room.obj")


def test_two_sided(scene):
    above = [0, 0, 3]
    down = -UP
    assert (truelux.Oracle(scene).irradiance(above, down) == 0).all()
    both = truelux.Oracle(scene, two_sided=True).irradiance(above, down)
    assert (both > 0).all()
    made = truelux.Scene(scene.vertices, scene.faces, scene.emission,
                         two_sided=True)
    np.testing.assert_array_equal(
        truelux.Oracle(made).irradiance(above, down), both)


def test_other_threads_go_on_meanwhile(scene):
    # A call without the interpreter's lock lets another thread count.
    import threading
    box = truelux.Scene.read(EXAMPLES / "figure7_b.obj")
    oracle = truelux.Oracle(box, threads=1)
    counted = []
    thread = threading.Thread(target=lambda: oracle.irradiance(
        np.random.default_rng(1).uniform(-3, 3, (4000, 3)) * [1, 1, 0], UP,
        on_face=1))
    thread.start()
    while thread.is_alive():
        counted.append(time.monotonic())
        time.sleep(0.001)
    assert len(counted) > 5


def test_ctrl_c_ends_a_call_and_the_oracle_goes_on(tmp_path):
    script = textwrap.dedent("""
        import sys, time, numpy as np, truelux
        scene = truelux.Scene.read(sys.argv[1])
        oracle = truelux.Oracle(scene)
        points = np.random.default_rng(1).uniform(-3, 3, (3_000_000, 3))
        points[:, 2] = 0
        print("ready", flush=True)
        try:
            oracle.irradiance(points, [0, 0, 1], on_face=1)
        except KeyboardInterrupt:
            print("interrupted", time.time(), flush=True)
        oracle.irradiance(points[:10], [0, 0, 1], on_face=1)
        print("goes on", flush=True)
        """)
    process = subprocess.Popen(
        [sys.executable, "-c", script, str(EXAMPLES / "figure7_b.obj")],
        stdout=subprocess.PIPE, text=True, env=os.environ)
    assert process.stdout.readline() == "ready\n"
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    sent = time.time()
    word, when = process.stdout.readline().split()
    assert word == "interrupted"
    assert float(when) - sent < 5  # 1 s is meant; the machine may be busy
    assert process.stdout.readline() == "goes on\n"
    assert process.wait() == 0


def resident():
    with open("/proc/self/statm") as f:
        return int(f.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def grown(work, times):
    """Bytes that so many calls leave behind."""
    if not os.path.exists("/proc/self/statm"):
        pytest.skip("no /proc")
    if "libasan" in os.environ.get("LD_PRELOAD", ""):
        pytest.skip("AddressSanitizer keeps what is freed for a while")
    for _ in range(times // 10):
        work()
    gc.collect()
    before = resident()
    for _ in range(times):
        work()
    gc.collect()
    return resident() - before


def test_calls_leave_nothing_behind(oracle, scene):
    def work():
        oracle.irradiance([0, 0, 0], UP)
        oracle.derivatives([0, 0, 0], UP)
        with pytest.raises(truelux.Error):
            oracle.irradiance([0, 0, 0], 0 * UP)
    assert grown(work, 3000) < 2_000_000


def test_threads_leave_nothing_behind(scene, grid):
    oracle = truelux.Oracle(scene, threads=2)
    camera = truelux.Camera((0, 0, -3), (0, 0, 1), (0, 1, 0), 40)
    e = oracle.irradiance(grid, UP)

    def work():
        oracle.irradiance(grid, UP)
        truelux.render(oracle, camera=camera, width=12)
        truelux.compare(scene, grid, UP, e * 2, threads=2)
    assert grown(work, 500) < 2_000_000
