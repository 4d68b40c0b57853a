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


def test_find_blocker(tmp_path):
    pytest.importorskip("scipy", reason="SciPy is not installed")
    words = []
    try:
        import matplotlib  # noqa: F401
        words = [tmp_path / "plot.png"]
    except ImportError:
        pass
    done = run("find_blocker.py", *words)
    assert done.returncode == 0, done.stdout + done.stderr
    error = float(re.search(r"largest error (\S+)", done.stdout)[1])
    assert error < 1e-9
    for path in words:
        assert path.stat().st_size > 10_000
