# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that truelux isolux writes, read by meshio."""

import os
import subprocess

import numpy as np
import pytest

meshio = pytest.importorskip("meshio", reason="meshio is not installed")

from conftest import EXAMPLES, table_of


@pytest.fixture(scope="module")
def meshes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("meshes")
    endings = ("obj", "ply", "vtu")
    files = [folder / f"floor.{ending}" for ending in endings]
    outputs = [word for file in files for word in ("-o", str(file))]
    subprocess.run([os.environ["TRUELUX"], "isolux",
                    str(EXAMPLES / "cornell_box.obj"), "--surface", "floor",
                    "--channel", "g", "--count", "3", "--mesh-error", "0.01",
                    *outputs], check=True, capture_output=True)
    return dict(zip(endings, map(meshio.read, files)))


def test_all_have_the_same_triangles(meshes):
    first = meshes["vtu"]
    for mesh in meshes.values():
        assert [block.type for block in mesh.cells] == ["triangle"]
        np.testing.assert_array_equal(mesh.points, first.points)
        np.testing.assert_array_equal(mesh.cells[0].data, first.cells[0].data)
    corners = first.points[first.cells[0].data]
    normals = np.cross(corners[:, 1] - corners[:, 0],
                       corners[:, 2] - corners[:, 0])
    assert np.all(normals[:, 1] > 0)  # the floor looks up along y
    x, z = first.points[:, 0], first.points[:, 2]
    assert x.min() == 0 and z.min() == 0 and z.max() == 559.2


def test_all_have_the_same_light(meshes):
    e = meshes["vtu"].point_data["E"]
    colours = meshes["vtu"].point_data["E_rgb"]
    assert e.shape == (len(colours),) and colours.shape[1] == 3
    np.testing.assert_array_equal(colours[:, 1], e)
    np.testing.assert_array_equal(meshes["ply"].point_data["E"], e)
    for k, name in enumerate(("E_r", "E_g", "E_b")):
        np.testing.assert_array_equal(meshes["ply"].point_data[name],
                                      colours[:, k])
    np.testing.assert_array_equal(meshes["obj"].point_data["obj:vt"][:, 0], e)
    assert e.min() == 0 and e.max() > 0.1


def test_eval_agrees_inside(meshes, tmp_path):
    mesh = meshes["vtu"]
    triangles = mesh.cells[0].data
    sides = mesh.cell_data["sides"][0]
    assert sides.shape == triangles.shape and set(np.unique(sides)) == set(
        range(5))
    lines = np.zeros(len(mesh.points), bool)
    for k in range(3):
        on_line = sides[:, k] >= 3  # jump or outline
        lines[triangles[on_line, (k + 1) % 3]] = True
        lines[triangles[on_line, (k + 2) % 3]] = True
    places = {tuple(p) for p in mesh.points[lines]}
    inside = np.array([tuple(p) not in places for p in mesh.points])
    assert inside.sum() > 500
    table = tmp_path / "in.csv"
    table.write_text(table_of(mesh.points[inside], [0.0, 1.0, 0.0]))
    done = subprocess.run([os.environ["TRUELUX"], "eval",
                           str(EXAMPLES / "cornell_box.obj"), str(table),
                           "--on-face", "floor"], check=True,
                          capture_output=True, text=True)
    rows = [line.split(",") for line in done.stdout.splitlines()]
    column = rows[0].index("E_g")
    values = [float(row[column]) for row in rows[1:]]
    np.testing.assert_array_equal(values, mesh.point_data["E"][inside])
