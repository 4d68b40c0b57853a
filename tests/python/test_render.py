# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures from Python: the program's pixels and files."""

import numpy as np
import pytest

import truelux
from conftest import EXAMPLES, LAMP, PLATE, obj_of, run

FLOOR = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]


@pytest.fixture
def room():
    return truelux.Scene(LAMP + PLATE + FLOOR,
                         [[0, 1, 2, 3], [4, 5, 6], [7, 8, 9, 10]],
                         [[2, 1, 0.5], [0, 0, 0], [0, 0, 0]],
                         groups=["lamp", "plate", "floor"])


def test_pixels_are_the_oracle_s_answers(room):
    picture = truelux.render(room, surface="floor", width=8, height=6,
                             bound=True)
    assert repr(picture) == "<truelux.Picture: 8 x 6, 48 receivers>"
    assert picture.covered.all() and (picture.on_face == 3).all()
    e, bound = truelux.Oracle(room).irradiance(
        picture.points, picture.normals, on_face=picture.on_face, bound=True)
    np.testing.assert_array_equal(picture.irradiance, e)
    np.testing.assert_array_equal(picture.bound, bound)
    assert picture.arcs is None and picture.difference is None


def test_what_else_there_is(room):
    oracle = truelux.Oracle(room)
    picture = truelux.render(oracle, surface="floor", width=12,
                             also=("error", "arcs", "class", "gradient"))
    assert picture.irradiance.shape == (12, 12, 3)
    names = np.array(truelux.SHADOW_CLASSES)[picture.shadow_class]
    assert {"lit", "penumbra"} <= set(names.ravel())
    for y, x in ((0, 0), (6, 7), (11, 3)):
        contour = oracle.contour(picture.points[y, x], picture.normals[y, x],
                                 on_face=3)
        assert picture.arcs[y, x] == len(contour.arcs)
    d = oracle.derivatives(picture.points, picture.normals, on_face=3)
    np.testing.assert_allclose(np.linalg.norm(d.tangential, axis=-1),
                               picture.gradient, rtol=1e-14)
    e = truelux.Oracle(room, method="double").irradiance(
        picture.points, picture.normals, on_face=3)
    np.testing.assert_array_equal(picture.difference,
                                  abs(e - picture.irradiance))
    assert picture.kinks.shape == (12, 12, 3) and (picture.kinks == 0).all()


def test_kinks_are_where_edges_are_parallel():
    board = [[0, -0.2, 0.5], [0.4, -0.2, 0.5], [0.4, 0.3, 0.5], [0, 0.3, 0.5]]
    room = truelux.Scene(LAMP + board + FLOOR,
                         [[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, 11]],
                         [[2, 1, 0.5], [0, 0, 0], [0, 0, 0]],
                         groups=["lamp", "board", "floor"])
    kinks = truelux.render(room, surface="floor", width=12,
                           also="gradient").kinks
    assert 0 < np.count_nonzero(kinks[..., 0]) < 144


def test_files_are_those_of_the_program(tmp_path, room):
    obj = obj_of(tmp_path, room)
    for suffix, options, words in (
            (".exr", {}, ()),
            (".png", {"white": 0.25}, ("--white", "0.25")),
            (".png", {"exposure": 1.5}, ("--exposure", "1.5")),
            (".png", {"false_colour": True, "channel": "r", "white": 1},
             ("--false-colour", "--channel", "r", "--white", "1")),
            (".png", {"false_colour": True, "white": 0.1},
             ("--false-colour", "--white", "0.1")),
            (".png", {"false_colour": True, "isolux": False, "white": 1},
             ("--false-colour", "--no-isolux", "--white", "1"))):
        mine, theirs = tmp_path / f"mine{suffix}", tmp_path / f"its{suffix}"
        truelux.render(room, surface="floor", width=24).write(mine, **options)
        run("render", obj, "--surface", "floor", "--size", "24", "-o", theirs,
            *words)
        if suffix == ".exr":  # the program's has the scene's name, too
            mine, theirs = (truelux.read_exr(path)
                            for path in (mine, theirs))
            assert mine.keys() == theirs.keys() == set("RGBA")
            for name in mine:
                np.testing.assert_array_equal(mine[name], theirs[name])
        else:
            assert mine.read_bytes() == theirs.read_bytes()
    run("render", obj, "--surface", "floor", "--size", "24", "-o",
        tmp_path / "p.png", "--also", "arcs", "--also", "gradient")
    picture = truelux.render(room, surface="floor", width=24,
                             also=["arcs", "gradient"])
    for which in ("arcs", "gradient"):
        picture.write_also(tmp_path / "a.png", which)
        assert (tmp_path / "a.png").read_bytes() == \
            (tmp_path / f"p_{which}.png").read_bytes()


def test_a_camera(tmp_path):
    scene = truelux.Scene.read(EXAMPLES / "cornell_box.obj")
    camera = truelux.Camera(eye=(2.78, 2.73, -8), target=(2.78, 2.73, 0),
                            up=(0, 1, 0), fov=39)
    picture = truelux.render(scene, camera=camera, width=16)
    assert picture.irradiance.shape == (16, 16, 3)
    run("render", EXAMPLES / "cornell_box.obj", "--eye", "2.78,2.73,-8",
        "--target", "2.78,2.73,0", "--up", "0,1,0", "--fov", "39", "--size",
        "16", "-o", tmp_path / "its.exr")
    theirs = truelux.read_exr(tmp_path / "its.exr")
    np.testing.assert_array_equal(picture.irradiance[..., 0].astype(np.float32),
                                  theirs["R"])
    np.testing.assert_array_equal(picture.covered, theirs["A"] == 1)


def test_a_picture_is_a_candidate(room):
    picture = truelux.render(room, surface="floor", width=6)
    assert truelux.compare(room, picture.points, picture.normals,
                           picture.irradiance, on_face=picture.on_face).passes


def test_what_white_is_is_said(tmp_path, room):
    picture = truelux.render(room, surface="floor", width=4)
    with pytest.warns(truelux.Note, match="white is"):
        picture.write(tmp_path / "p.png")


def test_progress_tells(room, monkeypatch):
    class Bar:
        bars = []

        def __init__(self, total, unit):
            self.total, self.unit, self.n, self.open = total, unit, 0, True
            Bar.bars.append(self)

        def update(self, count):
            assert count >= 0
            self.n += count

        def close(self):
            self.open = False

    monkeypatch.setattr("truelux.progress._tqdm", lambda: Bar)
    truelux.render(room, surface="floor", width=40, also="gradient",
                   progress=True)
    assert [(bar.unit, bar.n == bar.total) for bar in Bar.bars][0] == \
        ("pixels", True)
    assert "kink candidates" in {bar.unit for bar in Bar.bars}
    assert not any(bar.open for bar in Bar.bars)


@pytest.mark.parametrize("words, match", [
    ({}, "surface, camera: expected one"),
    ({"surface": "roof"}, "surface: no object or group"),
    ({"surface": "floor", "also": "arc"}, "also: 'arc' is none of"),
    ({"surface": "floor", "width": 0}, "width, height"),
    ({"surface": "floor", "width": 2.5}, "width, height"),
    ({"surface": "floor", "width": 65536, "height": 65536}, "size: 65536"),
    ({"surface": "floor", "on_face": "roof"}, "on_face"),
    ({"camera": ((0, 0, 0), (0, 0, 0), (0, 1, 0), 40)}, "camera: "),
    ({"camera": ((0, 0, 0), (0, 0), (0, 1, 0), 40)}, "camera.target"),
    ({"camera": ((0, 0, np.nan), (0, 0, 1), (0, 1, 0), 40)}, "finite"),
])
def test_what_cannot_be_rendered(room, words, match):
    with pytest.raises(truelux.Error, match=match):
        truelux.render(room, **words)


def test_what_cannot_be_written(tmp_path, room):
    picture = truelux.render(room, surface="floor", width=4)
    for name, options, match in (
            ("p.jpg", {}, ".exr or .png"),
            ("p.exr", {"white": 1}, "belong to a PNG"),
            ("p.png", {"white": 0}, "finite number above 0"),
            ("p.png", {"exposure": 1e9}, "exposure: expected -1000"),
            ("p.png", {"white": "x"}, "white: expected a number"),
            ("p.png", {"channel": "r"}, "belong to false_colour"),
            ("p.exr", {"channel": "r"}, "belong to a PNG"),
            ("none/p.png", {"white": 1}, "there is no folder"),
            ("p.png", {"white": 1, "exposure": 0}, "say the same"),
            ("p.png", {"false_colour": True, "white": 1, "channel": "x"},
             "'x' is none of")):
        with pytest.raises(truelux.Error, match=match):
            picture.write(tmp_path / name, **options)
        assert not (tmp_path / name).exists()
    with pytest.raises(truelux.Error, match="not asked for"):
        picture.write_also(tmp_path / "p.png", "arcs")
