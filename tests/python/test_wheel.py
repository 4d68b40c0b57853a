# SPDX-License-Identifier: GPL-3.0-or-later
"""A wheel out of the module at hand, installed elsewhere."""

import os
import shutil
import subprocess
import sys
import venv
from pathlib import Path

import pytest

ROOT = Path(os.environ["TRUELUX_EXAMPLES"]).parent
BUILT = Path(os.environ["PYTHONPATH"]).parent

pytest.importorskip("setuptools", reason="setuptools is not installed")
pytest.importorskip("wheel", reason="wheel is not installed")
pytest.importorskip("pip", reason="pip is not installed")


def run(*words, **environment):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True,
                          env=os.environ | environment)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_a_wheel_works_in_an_environment_of_its_own(tmp_path):
    # A copy, so that the source tree stays as it is.
    source = tmp_path / "source"
    for name in ("setup.py", "pyproject.toml", "include/truelux/version.h"):
        (source / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, source / name)
    shutil.copytree(ROOT / "bindings/python/truelux",
                    source / "bindings/python/truelux")
    run(sys.executable, "-m", "pip", "wheel", source, "--no-build-isolation",
        "--no-deps", "--quiet", "-w", tmp_path / "wheels", TRUELUX_BUILD=str(BUILT))
    wheel, = (tmp_path / "wheels").iterdir()
    assert wheel.name.startswith("truelux-") and "none-any" not in wheel.name
    venv.create(tmp_path / "venv", with_pip=False, system_site_packages=True)
    python = tmp_path / "venv/bin/python"
    run(python, "-m", "pip", "install", "--no-deps", "--quiet", wheel)
    out = run(python, "-c", "import truelux; print(truelux.__file__); "
              "print(truelux.__version__)", PYTHONPATH="")
    place, version = out.split()
    assert place.startswith(str(tmp_path / "venv"))
    assert wheel.name.startswith(f"truelux-{version}-")
    first = ROOT / "examples/python/first.py"
    assert "E = 0.0 W/m^2" in run(python, first, PYTHONPATH="")
