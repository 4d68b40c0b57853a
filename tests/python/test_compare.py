# SPDX-License-Identifier: GPL-3.0-or-later
"""Other programs' values, held against the truth from Python."""

import json
import os
import subprocess

import numpy as np
import pytest

import truelux
from conftest import UP, obj_of, run, table_of

RGB = ("E_r", "E_g", "E_b")


@pytest.fixture
def truth(oracle, grid):
    return oracle.irradiance(grid, UP)


def run_failing(*words):
    """Standard output of the program where the comparison fails."""
    done = subprocess.run([os.environ["TRUELUX"], *map(str, words)],
                          capture_output=True, text=True)
    assert done.returncode == 1, done.stderr
    return done.stdout


def test_the_truth_passes(scene, grid, truth):
    report = truelux.compare(scene, grid, UP, truth)
    assert report.passes and report.verdict == "nothing fails"
    np.testing.assert_array_equal(report.truth, truth)
    assert report.error.shape == (6, 5) and (report.error == 0).all()
    assert report.within.all() and report.mistake == ""
    assert repr(report) == ("<truelux.Comparison: PASS, 0 of 30 receivers fail; "
                            "nothing fails>")


def test_a_factor_has_a_name(scene, grid, truth):
    report = truelux.compare(scene, grid, UP, truth / np.pi, tolerance=1e-6,
                             name="mine")
    assert not report.passes and not report.within.any()
    assert report.verdict == "mistake"
    assert report.factor == pytest.approx(1 / np.pi, rel=1e-9)
    assert "FAIL, 30 of 30 receivers fail" in repr(report)
    assert report.error == pytest.approx(1 - 1 / np.pi, rel=1e-9)
    assert len(report.worst) == 10
    index, reason = report.worst[0]
    assert report.error[index] == report.error.max()
    assert "penumbra" in reason or "lit" in reason
    assert "mine" in str(report) and report.mistake in str(report)


def test_a_program_without_shadows_is_known(scene, grid):
    alone = truelux.Scene(scene.vertices, scene.faces[:1], scene.emission[:1])
    report = truelux.compare(scene, grid, UP,
                             truelux.Oracle(alone).irradiance(grid, UP),
                             tolerance=1e-6)
    assert report.mistake == "left-out object" and "plate" in report.diagnosis
    assert 0 < np.count_nonzero(report.within) < 30


def test_the_report_is_that_of_the_program(tmp_path, scene, grid, truth):
    obj = obj_of(tmp_path, scene)
    wrong = truth.reshape(-1, 3) * 2
    (tmp_path / "c.csv").write_text(
        table_of(grid, UP, **dict(zip(RGB, wrong.T))))
    report = truelux.compare(truelux.Scene.read(obj), grid, UP, truth * 2)
    found = report.to_dict()
    assert json.loads(report.to_json()) == found
    done = json.loads(
        run_failing("compare", obj, tmp_path / "c.csv", "--json", "-", "-o",
                    tmp_path / "r.txt"))
    for entry in found["worst"]:
        del entry["receiver"]
    for entry in done["worst"]:
        del entry["line"]
    for key in ("scene", "candidate"):
        del found[key], done[key]
    assert found == done
    # The same lines but for names and places.
    lines = (tmp_path / "r.txt").read_text().splitlines()
    same = [a == b for a, b in zip(lines, str(report).splitlines())]
    assert len(same) == len(lines) and same.count(False) == 2 + 10


def test_one_channel_and_form_factors(scene, oracle, grid, truth):
    report = truelux.compare(scene, grid, UP, truth[..., 1], channel="g")
    assert report.passes
    np.testing.assert_array_equal(report.truth, truth[..., 1])
    factors = oracle.form_factors(grid, UP).values.sum(axis=-1)
    report = truelux.compare(scene, grid, UP, factors, quantity="form-factor")
    assert report.passes
    assert not truelux.compare(scene, grid, UP, factors * 2,
                               quantity="form-factor").passes


def test_gradients(scene, oracle, grid):
    gradients = oracle.derivatives(grid, UP).gradient
    report = truelux.compare(scene, grid, UP, gradients, quantity="gradient")
    assert report.passes
    np.testing.assert_array_equal(report.truth, gradients)
    report = truelux.compare(scene, grid, UP, -gradients, quantity="gradient",
                             tolerance=1e-6)
    assert report.factor == pytest.approx(-1)
    report = truelux.compare(scene, grid, UP, gradients[..., 2, :],
                             quantity="gradient", channel="b")
    assert report.passes and report.truth.shape == (6, 5, 3)


def test_where_there_is_no_gradient_the_truth_is_nan(scene):
    report = truelux.compare(scene, [[0, 0, 1.0]], [1, 0, 0],
                             np.zeros((1, 3, 3)),
                             quantity="gradient")
    assert np.isnan(report.truth).all() and not report.passes


def test_nan_and_inf_fail(scene, grid, truth):
    truth[0, 0, 0] = np.nan
    truth[1, 2] = np.inf
    report = truelux.compare(scene, grid, UP, truth, tolerance=0.5)
    assert not report.within[0, 0] and not report.within[1, 2]
    assert np.count_nonzero(~report.within) == 2
    assert np.isinf(report.error[0, 0])


def test_one_receiver(scene, oracle):
    e = oracle.irradiance([0, 0, 0], UP)
    report = truelux.compare(scene, [0, 0, 0], UP, e * 3)
    assert report.error.shape == () and report.worst[0][0] == ()


@pytest.mark.parametrize("words, match", [
    ({"values": np.zeros((6, 5))}, r"expected the shape \(6, 5, 3\)"),
    ({"values": np.zeros((6, 5, 3), complex)}, "real numbers"),
    ({"quantity": "radiance"}, "'radiance' is none of"),
    ({"channel": "x"}, "channel"),
    ({"channel": "r", "quantity": "form-factor"}, "channel"),
    ({"tolerance": -1}, "tolerance"),
    ({"tolerance": float("nan")}, "tolerance"),
    ({"normals": [0, 0, 0]}, "receiver 0: the normal is zero"),
    ({"points": np.zeros((0, 3)), "values": np.zeros((0, 3))}, "no receiver"),
    ({"scene": None}, "expected a truelux.Scene"),
    ({"on_face": "roof"}, "no face"),
])
def test_what_cannot_be_compared(scene, grid, truth, words, match):
    words = {"scene": scene, "points": grid, "normals": UP, "values": truth,
             **words}
    with pytest.raises(truelux.Error, match=match):
        truelux.compare(words.pop("scene"), words.pop("points"),
                        words.pop("normals"), words.pop("values"), **words)
