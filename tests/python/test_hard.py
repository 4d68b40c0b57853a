# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong around calls: signals, threads that end, odd bytes and types."""

import os
import signal
import subprocess
import sys
import threading
import textwrap

import numpy as np
import pytest

import truelux
from conftest import EXAMPLES, LAMP, UP


def program(text, **options):
    """A Python program of its own, with `box` read."""
    head = ("import os, signal, sys, threading, time, truelux, truelux.progress\n"
            f"box = truelux.Scene.read({str(EXAMPLES / 'lamp.obj')!r})\n")
    return subprocess.run([sys.executable, "-c", head + textwrap.dedent(text)],
                          capture_output=True, text=True, timeout=60, **options)


def test_a_bar_may_call_truelux_and_ctrl_c_works_afterwards():
    done = program("""
        class Bar:
            def __init__(self, total, unit):
                self.total, self.unit, self.n = total, unit, 0
            def update(self, count):
                self.n += count
                truelux.Oracle(box).irradiance([0, 0, 1.0], [0, 0, 1.0])
            def close(self):
                pass
        truelux.progress._tqdm = lambda: Bar
        camera = truelux.Camera((0, -9, 9), (0, 0, 0), (0, 0, 1), 40)
        truelux.render(box, camera=camera, width=16, progress=True)
        try:
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(5)
        except KeyboardInterrupt:
            print("interrupted")
        """)
    assert (done.returncode, done.stdout) == (0, "interrupted\n"), done.stderr


def test_a_daemon_thread_may_be_left_in_a_call():
    done = program("""
        def work():
            camera = truelux.Camera((0, -9, 9), (0, 0, 0), (0, 0, 1), 40)
            while True:
                truelux.render(box, camera=camera, width=10)
                truelux.Oracle(box).irradiance([0, 0, 1.0], [0, 0, 1.0])
                with open(os.devnull, "w") as nothing:
                    pass
        threading.Thread(target=work, daemon=True).start()
        time.sleep(0.5)
        """)
    assert (done.returncode, done.stderr) == (0, ""), done


def test_threads_with_different_numbers_of_threads(oracle, scene, grid):
    expected = oracle.irradiance(grid, UP)
    wrong = []

    def work(threads):
        for _ in range(20):
            e = truelux.Oracle(scene, threads=threads).irradiance(grid, UP)
            if not (e == expected).all():
                wrong.append(threads)

    all_ = [threading.Thread(target=work, args=(k % 3 + 1,)) for k in range(6)]
    for thread in all_:
        thread.start()
    for thread in all_:
        thread.join()
    assert not wrong


def test_names_that_are_not_utf_8(tmp_path):
    (tmp_path / "l.obj").write_bytes(
        b"g caf\xe9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    scene = truelux.Scene.read(tmp_path / "l.obj")
    name, = scene.groups
    assert os.fsencode(name).endswith(b"caf\xe9")
    assert truelux.render(scene, surface="caf\udce9", width=3).covered.all()
    with pytest.raises(truelux.Error, match="no object or group 'nope'"):
        truelux.render(scene, surface="nope", width=3)
    (tmp_path / "l.obj").write_bytes(b"g caf\xe9\nv 0 \xff 0\nv 0\nf 1 2\n")
    with pytest.raises(truelux.Error) as raised:
        truelux.Scene.read(tmp_path / "l.obj")
    assert len(raised.value.defects) >= 2


def test_three_grey_faces_or_one_colour():
    rings = [[0, 1, 2], [0, 2, 3], [0, 1, 3]]
    with pytest.raises(truelux.Error, match=r"expected the shape \(3, 1\)"):
        truelux.Scene(LAMP, rings, [1, 2, 3])
    assert (truelux.Scene(LAMP, rings, [[1], [2], [3]]).emission[1] == 2).all()
    assert (truelux.Scene(LAMP, rings, [[1, 2, 3]]).emission[1]
            == [1, 2, 3]).all()


def test_with_a_bar_receivers_keep_their_numbers(oracle):
    points = np.zeros((500, 3))
    points[300] = np.nan
    points[450] = np.inf
    with pytest.raises(truelux.Error) as raised:
        oracle.irradiance(points, UP, progress=True)
    assert [d[:12] for d in raised.value.defects] == ["receiver 300",
                                                      "receiver 450"]


def test_receivers_just_behind_a_face_are_told():
    box = truelux.Scene(LAMP + [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]],
                        [[0, 1, 2, 3], [4, 5, 6, 7]], [[1, 1, 1], [0, 0, 0]])
    with pytest.warns(truelux.Note, match="2 of 3 receivers get 0"):
        e = truelux.Oracle(box).irradiance(
            [[0, 0, -1e-9], [1, 0, -1e-9], [0, 0, 0.5]], UP)
    assert (e[:2] == 0).all() and (e[2] > 0).all()


def test_one_number_of_a_face_is_one_defect(oracle, grid):
    with pytest.raises(truelux.Error) as raised:
        oracle.irradiance(grid, UP, on_face=99)
    assert len(raised.value.defects) == 1


def test_a_comparison_is_true_if_it_passes(scene, oracle, grid):
    e = oracle.irradiance(grid, UP)
    assert truelux.compare(oracle, grid, UP, e)
    assert not truelux.compare(scene, grid, UP, e * 2)
    report = truelux.compare(scene, grid, UP, e * 2, name="a\nb\x1b")
    assert "candidate       a\\x0ab\\x1b," in str(report)
    index, _ = report.worst[0]
    assert f"1. receiver {index}: at" in str(report)


@pytest.mark.parametrize("call, match", [
    (lambda o, p, e: truelux.Oracle(o.scene, threads=1.5), "threads"),
    (lambda o, p, e: truelux.Oracle(o.scene, threads=10**12), "threads"),
    (lambda o, p, e: truelux.Oracle(o.scene, method=None), "method"),
    (lambda o, p, e: truelux.Oracle(o.scene, formula="unified"), "formula"),
    (lambda o, p, e: o.irradiance([[1, 2, 3], [1, 2]], UP), "points"),
    (lambda o, p, e: o.irradiance(np.ma.masked_equal(p, p[0, 0, 0]), UP),
     "masked"),
    (lambda o, p, e: o.irradiance(p, UP, on_face="\ud800"), "on_face"),
    (lambda o, p, e: truelux.compare(o, p, UP, e, tolerance="1e-3x"),
     "tolerance"),
    (lambda o, p, e: truelux.compare(o, p, UP, e, threads=0), "threads"),
    (lambda o, p, e: truelux.compare(o, p, UP, e, name=5), "name"),
    (lambda o, p, e: truelux.compare(o, p, UP, e, quantity=["E"]), "quantity"),
    (lambda o, p, e: truelux.render(o, surface=5), "surface"),
    (lambda o, p, e: truelux.render(o, surface="x", on_face=0), "on_face"),
    (lambda o, p, e: truelux.render(o, camera=(1, 2, 3)), "camera"),
    (lambda o, p, e: truelux.render(o, camera=((0, 0, 0), (0, 0, 1), (0, 1, 0),
                                               40, 1)), "camera"),
    (lambda o, p, e: truelux.render(o, camera=((0, 0, 0), (0, 0, 1), (0, 1, 0),
                                               "w")), "camera.fov"),
    (lambda o, p, e: truelux.Scene(LAMP, [[0, 1, 2], []]), "faces: entry 1"),
    (lambda o, p, e: truelux.Scene.read("x.obj", opaque_from="x"),
     "opaque_from"),
])
def test_arguments_of_wrong_kinds_are_one_clear_error(oracle, grid, call, match):
    e = oracle.irradiance(grid, UP)
    with pytest.raises(truelux.Error, match=match) as raised:
        call(oracle, grid, e)
    assert "\n" not in str(raised.value)


def test_ctrl_c_while_a_scene_is_built():
    done = program("""
        import numpy as np
        n = 700
        x, y = np.meshgrid(np.arange(n), np.arange(n))
        v = np.stack([x, y, np.sin(x) + y * 0.5], axis=-1).reshape(-1, 3)
        k = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).reshape(-1)
        f = np.stack([k, k + 1, k + n + 1], axis=-1)
        threading.Timer(0.7, os.kill, (os.getpid(), signal.SIGINT)).start()
        try:
            truelux.Scene(v, f)
            time.sleep(5)
        except KeyboardInterrupt:
            print("interrupted")
        """)
    assert (done.returncode, done.stdout) == (0, "interrupted\n"), done.stderr
