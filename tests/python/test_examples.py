# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples end well, and say what they should."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

FOLDER = Path(os.environ["TRUELUX_EXAMPLES"]) / "python"


def run(name, *words):
    return subprocess.run([sys.executable, "-W", "ignore", FOLDER / name,
                           *map(str, words)], capture_output=True, text=True)


def test_first():
    done = run("first.py")
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert len(lines) == 5 and lines[-1].endswith("E = 0.0 W/m^2 in red")


def plot(tmp_path):
    """Where to draw; nowhere without matplotlib."""
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        return []
    return [tmp_path / "plot.png"]


def checked(name, words):
    done = run(name, *words)
    assert done.returncode == 0, done.stdout + done.stderr
    for path in words:
        assert path.stat().st_size > 10_000
    return done.stdout


def test_find_blocker(tmp_path):
    pytest.importorskip("scipy", reason="SciPy is not installed")
    out = checked("find_blocker.py", plot(tmp_path))
    assert float(re.search(r"largest error (\S+)", out)[1]) < 1e-9


def test_shader_check(tmp_path):
    out = checked("shader_check.py", plot(tmp_path))
    biased, points = map(int, re.match(r"(\d+) of (\d+) points", out).groups())
    # In the penumbra, which is most of the floor, but not in it all.
    assert points / 2 < biased < points
    assert float(re.search(r"error there is (\S+)", out)[1]) < 1e-4


def test_iso_mesh(tmp_path):
    out = checked("iso_mesh.py", plot(tmp_path))
    mine, theirs = (float(re.search(rf"{words} by (\S+)", out)[1])
                    for words in ("is wrong", "uniform mesh"))
    assert mine < theirs / 2


def test_gradient_field(tmp_path):
    out = checked("gradient_field.py", plot(tmp_path))
    assert float(re.search(r"within (\S+) degrees", out)[1]) < 0.1


def test_lightmap_check(tmp_path):
    out = checked("lightmap_check.py", plot(tmp_path))
    assert "moved by (-0.5, -0.5) texels" in out
