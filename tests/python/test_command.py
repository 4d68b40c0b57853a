# SPDX-License-Identifier: GPL-3.0-or-later
"""python3 -m truelux over files."""

import json
import subprocess
import sys

import numpy as np
import pytest

import truelux
from truelux import _truelux
from conftest import UP, columns_of, obj_of, run, table_of


def command(*words):
    return subprocess.run([sys.executable, "-m", "truelux", *map(str, words)],
                          capture_output=True, text=True)


def test_npy_npz_and_csv_give_the_same(tmp_path, scene, oracle, grid):
    obj = obj_of(tmp_path, scene)
    expected = oracle.irradiance(grid, UP)
    normals = np.broadcast_to(UP, grid.shape)
    np.save(tmp_path / "in.npy", np.concatenate([grid, normals], axis=-1))
    np.savez(tmp_path / "in.npz", points=grid, normals=UP)
    (tmp_path / "in.csv").write_text(table_of(grid, UP))
    for source in ("in.npy", "in.npz", "in.csv"):
        done = command("eval", obj, tmp_path / source, "-o", tmp_path / "e.npy")
        assert done.returncode == 0, done.stderr
        e = np.load(tmp_path / "e.npy")
        np.testing.assert_array_equal(e.reshape(-1, 3), expected.reshape(-1, 3))
    done = command("eval", obj, tmp_path / "in.npy", "-o", tmp_path / "e.csv",
                   "--threads", 2, "--progress")
    assert done.returncode == 0, done.stderr
    np.testing.assert_array_equal(
        columns_of((tmp_path / "e.csv").read_text(), "E_r", "E_g", "E_b"),
        expected.reshape(-1, 3))


def test_gradients(tmp_path, scene, oracle, grid):
    obj = obj_of(tmp_path, scene)
    np.savez(tmp_path / "in.npz", points=grid, normals=UP,
             on_face=np.zeros((6, 5), int))
    done = command("gradient", obj, tmp_path / "in.npz", "-o",
                   tmp_path / "g.npz", "--of", "gradient,flux")
    assert done.returncode == 0, done.stderr
    d = oracle.derivatives(grid, UP)
    with np.load(tmp_path / "g.npz") as found:
        assert found.files == ["E", "status", "gradient", "flux"]
        np.testing.assert_array_equal(found["gradient"], d.gradient)
        np.testing.assert_array_equal(found["flux"], d.flux)
    done = command("gradient", obj, tmp_path / "in.npz", "-o",
                   tmp_path / "g.csv", "--of", "jacobian")
    assert done.returncode == 0, done.stderr
    text = run("gradient", obj, "-", "--of", "jacobian",
               text=table_of(grid, UP))
    np.testing.assert_array_equal(
        columns_of((tmp_path / "g.csv").read_text(), "J_g_xy"),
        columns_of(text, "J_g_xy"))


def test_maps_of_positions_and_normals(tmp_path, scene):
    # A floor of texels, some of which are none, a rounding error below it.
    floor = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
    room = truelux.Scene(np.concatenate([scene.vertices, floor]),
                         [*scene.faces, [7, 8, 9, 10]],
                         [*scene.emission, [0, 0, 0]])
    obj = obj_of(tmp_path, room)
    x, y = np.meshgrid(np.linspace(-0.9, 0.9, 16), np.linspace(-0.9, 0.9, 12))
    normals = np.zeros((12, 16, 3), np.float32)
    normals[2:, :, 2] = 1
    points = np.stack([x, y, np.full_like(x, -1e-9)], axis=-1)
    points = points.astype(np.float32)
    for name, maps in (("p.exr", points), ("n.exr", normals)):
        (tmp_path / name).write_bytes(
            _truelux.exr_bytes(maps, np.ones((12, 16), bool), []))
    for output in ("e.exr", "e.npy"):
        done = command("eval", obj, tmp_path / "p.exr", "--normals",
                       tmp_path / "n.exr", "-o", tmp_path / output)
        assert done.returncode == 0, done.stderr
    expected = truelux.Oracle(room).irradiance(points[2:], UP, on_face=3)
    assert (expected > 0).all()
    e = np.load(tmp_path / "e.npy")
    np.testing.assert_array_equal(e[2:], expected)
    assert np.isnan(e[:2]).all()
    read = truelux.read_exr(tmp_path / "e.exr")
    assert sorted(read) == ["A", "B", "G", "R"]
    np.testing.assert_array_equal(read["G"][2:],
                                  expected[..., 1].astype(np.float32))
    np.testing.assert_array_equal(read["A"], normals[..., 2])
    assert (read["R"][:2] == 0).all()
    # As if they lay on no face, all is dark.
    done = command("eval", obj, tmp_path / "p.exr", "--normals",
                   tmp_path / "n.exr", "--on-face", "none", "-o",
                   tmp_path / "dark.npy")
    assert done.returncode == 0, done.stderr
    assert (np.load(tmp_path / "dark.npy")[2:] == 0).all()
    for words, match in (
            (("p.exr",), "needs --normals"),
            (("p.exr", "--normals", obj), "s.obj:"),
            (("p.exr", "--normals", tmp_path / "none.exr"), "none.exr:")):
        done = command("eval", obj, tmp_path / words[0], *words[1:], "-o",
                       tmp_path / "x.exr")
        assert done.returncode == 2 and match in done.stderr, done.stderr
    assert not (tmp_path / "x.exr").exists()


def test_compare(tmp_path, scene, oracle, grid):
    obj = obj_of(tmp_path, scene)
    np.savez(tmp_path / "in.npz", points=grid, normals=UP)
    truth = oracle.irradiance(grid, UP)
    np.save(tmp_path / "e.npy", truth)
    np.savez(tmp_path / "e.npz", E=truth)
    done = command("eval", obj, tmp_path / "in.npz", "-o", tmp_path / "e.csv")
    assert done.returncode == 0, done.stderr
    for values, receivers in (("e.npy", "in.npz"), ("e.npz", "in.npz"),
                              ("e.csv", "in.csv")):
        (tmp_path / "in.csv").write_text(table_of(grid, UP))
        done = command("compare", obj, tmp_path / receivers, tmp_path / values)
        assert done.returncode == 0, done.stdout + done.stderr
        assert f"candidate       {values}" in done.stdout
    np.save(tmp_path / "e.npy", truth * 2)
    done = command("compare", obj, tmp_path / "in.npz", tmp_path / "e.npy",
                   "--tolerance", 0.5, "--json", tmp_path / "r.json")
    assert done.returncode == 1 and "constant factor" in done.stdout
    assert json.loads((tmp_path / "r.json").read_text())["tolerance"] == 0.5
    np.save(tmp_path / "e.npy", truth[0])
    for words, match in (
            (("e.npy",), r"values: expected the shape (6, 5, 3)"),
            (("in.npz",), "no array E; found points, normals"),
            (("in.csv",), "lacks E_r, E_g, E_b"),
            (("e.txt",), "expected a name that ends with"),
            (("none.npy",), "none.npy")):
        done = command("compare", obj, tmp_path / "in.npz",
                       *(tmp_path / word for word in words))
        assert done.returncode == 2 and match in done.stderr, done.stderr


def test_compare_of_maps(tmp_path, scene):
    normals = np.zeros((4, 6, 3))
    normals[1:, :, 2] = 1
    points = np.zeros((4, 6, 3))
    points[..., 0] = np.linspace(-0.5, 0.5, 6)
    points[..., 1] = np.linspace(-0.5, 0.5, 4)[:, None]
    points = points.astype(np.float32).astype(float)
    e = truelux.Oracle(scene).irradiance(points[1:], UP)
    values = np.concatenate([np.full((1, 6, 3), 7.0), e])
    covered = np.ones((4, 6), bool)
    for name, array in (("p", points), ("n", normals), ("e", values),
                        ("small", values[:3])):
        (tmp_path / f"{name}.exr").write_bytes(
            _truelux.exr_bytes(array, covered[:len(array)], []))
    words = ("compare", obj_of(tmp_path, scene), tmp_path / "p.exr")
    maps = ("--normals", tmp_path / "n.exr")
    done = command(*words, tmp_path / "e.exr", *maps)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "0 of 18 receivers fail" in done.stdout
    done = command(*words, tmp_path / "e.exr", *maps, "--tolerance", 0)
    assert done.returncode == 1  # binary32
    done = command(*words, tmp_path / "small.exr", *maps)
    assert done.returncode == 2 and "expected 6 x 4 texels" in done.stderr


@pytest.mark.parametrize("source, output, words", [
    ("in.txt", "e.npy", "in.txt: expected a name that ends with"),
    ("wide.npy", "e.npy", "expected the shape (..., 6)"),
    ("empty.npz", "e.npy", "no array points and no array normals"),
    ("in.csv", "e.txt", "e.txt: expected a name that ends with"),
    ("half.csv", "e.npy", "half.csv:1: the header lacks nz"),
    ("word.csv", "e.npy", "word.csv:3: y: 'a' is not a number"),
    ("junk.npy", "e.npy", "junk.npy:"),
    ("none.npy", "e.npy", "No such file"),
])
def test_bad_input_is_one_line_and_nothing_is_written(tmp_path, scene, grid,
                                                      source, output, words):
    obj = obj_of(tmp_path, scene)
    (tmp_path / "in.txt").write_text("x")
    np.save(tmp_path / "wide.npy", np.zeros((3, 7)))
    np.savez(tmp_path / "empty.npz")
    (tmp_path / "in.csv").write_text(table_of(grid, UP))
    (tmp_path / "half.csv").write_text("x,y,z,nx,ny\n0,0,0,0,0\n")
    (tmp_path / "word.csv").write_text(
        "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n0,a,0,0,0,1\n")
    (tmp_path / "junk.npy").write_bytes(b"junk")
    before = sorted(p.name for p in tmp_path.iterdir())
    done = command("eval", obj, tmp_path / source, "-o", tmp_path / output)
    assert done.returncode == 2
    assert words in done.stderr and "Traceback" not in done.stderr
    assert sorted(p.name for p in tmp_path.iterdir()) == before
