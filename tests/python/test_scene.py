# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes from files and arrays, and back."""

import warnings

import numpy as np
import pytest

import truelux
from conftest import EXAMPLES, LAMP, PLATE, UP, obj_of


def test_arrays_come_back(scene):
    assert scene.vertices.shape == (7, 3)
    np.testing.assert_array_equal(scene.vertices, LAMP + PLATE)
    assert [ring.tolist() for ring in scene.faces] == [[0, 1, 2, 3], [4, 5, 6]]
    np.testing.assert_array_equal(scene.emission, [[2, 1, 0.5], [0, 0, 0]])
    assert scene.groups == ["lamp", "plate"]
    assert repr(scene) == ("<truelux.Scene: 2 faces, 1 of them emit, "
                           "7 points>")


def test_faces_in_any_form():
    square = np.array([[0, 1, 2, 3]])
    for faces in (square, square.tolist(), [np.array([0, 1, 2, 3])],
                  square.astype(np.int32), square.astype(np.uint8)):
        made = truelux.Scene(LAMP, faces, 1.0)
        np.testing.assert_array_equal(made.emission, [[1, 1, 1]])
    two = truelux.Scene(LAMP + PLATE, [[0, 1, 2, 3], [4, 5, 6]], [3, 0])
    np.testing.assert_array_equal(two.emission, [[3, 3, 3], [0, 0, 0]])
    with pytest.warns(truelux.Note, match="no faces"):
        assert truelux.Scene(np.zeros((0, 3)), []).faces == []


def test_a_file_is_the_same_scene(tmp_path, scene, grid):
    read = truelux.Scene.read(obj_of(tmp_path, scene))
    assert read.groups == scene.groups
    np.testing.assert_array_equal(
        truelux.Oracle(read).irradiance(grid, UP),
        truelux.Oracle(scene).irradiance(grid, UP))


def test_defects_are_told_all_at_once(tmp_path):
    with pytest.raises(truelux.Error) as caught:
        truelux.Scene(LAMP, [[0, 1, 9], [0, -1, 2], [0, 1, 2]])
    assert caught.value.defects == [
        "face 1: vertex 9 does not exist; there are 4, counted from 0",
        "face 2: vertex -1 does not exist; there are 4, counted from 0",
    ]
    (tmp_path / "bad.obj").write_text("f 1 2 3\nv 0 0 0\nf 1 x 2\n")
    with pytest.raises(truelux.Error) as caught:
        truelux.Scene.read(tmp_path / "bad.obj")
    assert len(caught.value.defects) >= 2
    with pytest.raises(truelux.Error, match="no such file|cannot|does not"):
        truelux.Scene.read(tmp_path / "none.obj")


@pytest.mark.parametrize("vertices, faces, emission, words", [
    ([0, 0, 0], [[0, 0, 0]], None, "vertices: expected the shape"),
    (LAMP, [[0.5, 1, 2]], None, "faces: entry 0 is no sequence of indices"),
    (LAMP, [[[0, 1], [2, 3]]], None, "faces: entry 0 is no sequence"),
    (LAMP, [[0, 1, 2, 3]], [1, 2], "emission: the shape"),
    (LAMP, [[0, 1, 2, 3]], [-1, 0, 0], "emission"),
    (LAMP, [[0, 1, 2, 3]], [np.inf, 0, 0], "emission"),
    ([[np.nan, 0, 0]] + LAMP, [[0, 1, 2]], 1, "finite"),
    (LAMP, [[0, 2, 1, 3]], 1, "scene:1: error"),
])
def test_what_is_no_scene(vertices, faces, emission, words):
    with pytest.raises(truelux.Error, match=words):
        truelux.Scene(vertices, faces, emission)


def test_notes_are_warnings():
    bent = [[0, 0, 1], [0, 1, 1], [1, 1, 1.5], [1, 0, 1]]
    with pytest.warns(truelux.Note, match="not planar"):
        truelux.Scene(bent, [[0, 1, 2, 3]], 1)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        truelux.Scene(LAMP, [[0, 1, 2, 3]], 1)
    with pytest.warns(truelux.Note):
        lenient = truelux.Scene(LAMP + PLATE, [[0, 2, 1, 3], [4, 5, 6]],
                                lenient=True)
    assert len(lenient.faces) == 2


def test_groups_are_names(scene):
    with pytest.raises(truelux.Error, match="1 names, but 2 faces"):
        truelux.Scene(LAMP + PLATE, [[0, 1, 2, 3], [4, 5, 6]], groups=["a"])
    assert scene.face_near([0, 0, 0], UP, name="plate") == 2
    assert scene.face_near([0, 0, 0], UP) == 0


def test_example_scenes_are_read():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", truelux.Note)
        box = truelux.Scene.read(str(EXAMPLES / "cornell_box.obj"))
    assert len(box.faces) > 10 and "light" in "".join(box.groups)
