# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the package share. TRUELUX is the program, EXAMPLES the
folder of examples/scenes."""

import os
import subprocess
import sys
import textwrap
from pathlib import Path

import numpy as np
import pytest

import truelux

EXAMPLES = Path(os.environ["TRUELUX_EXAMPLES"]) / "scenes"

LAMP = [[-0.5, -0.5, 1], [-0.5, 0.5, 1], [0.5, 0.5, 1], [0.5, -0.5, 1]]
PLATE = [[0, -0.2, 0.5], [0.4, -0.2, 0.6], [0.3, 0.3, 0.4]]
FLOOR = [[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]]
WALL = [[-1, 1, 0], [1, 1, 0], [1, 1, 0.5], [-1, 1, 0.5]]


@pytest.fixture
def scene():
    """A lamp of three colours, and a triangle that hides part of it."""
    return truelux.Scene(LAMP + PLATE, [[0, 1, 2, 3], [4, 5, 6]],
                         [[2, 1, 0.5], [0, 0, 0]], groups=["lamp", "plate"])


@pytest.fixture
def oracle(scene):
    return truelux.Oracle(scene)


@pytest.fixture
def grid():
    """Points below the lamp, shape (6, 5, 3)."""
    x, y = np.meshgrid(np.linspace(-0.71, 0.63, 6), np.linspace(-0.47, 0.53, 5),
                       indexing="ij")
    return np.stack([x, y, 0 * x], axis=-1)


@pytest.fixture
def progress_units(monkeypatch):
    """What progress counts, by a bar in tqdm's place."""
    units = set()

    class Bar:
        def __init__(self, total, unit):
            self.total, self.unit, self.n = total, unit, 0

        def update(self, count):
            units.add(self.unit)

        def close(self):
            pass

    monkeypatch.setattr("truelux.progress._tqdm", lambda: Bar)
    return units


UP = np.array([0.0, 0.0, 1.0])


def run(*words, text=None):
    """Standard output of the program."""
    return subprocess.run([os.environ["TRUELUX"], *map(str, words)],
                          input=text, capture_output=True, text=True,
                          check=True).stdout


def obj_of(folder, scene):
    """The scene as a file that the program reads."""
    lines = ["mtllib s.mtl"]
    materials = []
    lines += ["v " + " ".join(map(repr, map(float, v)))
              for v in scene.vertices]
    for k, (ring, ke, group) in enumerate(
            zip(scene.faces, scene.emission, scene.groups)):
        lines += [f"g {group}"] if group else []
        lines += [f"usemtl m{k}", "f " + " ".join(str(v + 1) for v in ring)]
        materials += [f"newmtl m{k}", "Ke " + " ".join(map(repr, map(float, ke)))]
    (folder / "s.obj").write_text("\n".join(lines) + "\n")
    (folder / "s.mtl").write_text("\n".join(materials) + "\n")
    return folder / "s.obj"


def table_of(points, normals, **columns):
    """A receivers table, all digits."""
    points = np.asarray(points, float).reshape(-1, 3)
    normals = np.broadcast_to(normals, points.shape)
    names = ["x", "y", "z", "nx", "ny", "nz", *columns]
    rows = [",".join(names)]
    for i, (p, n) in enumerate(zip(points, normals)):
        cells = [*p, *n, *(column[i] for column in columns.values())]
        rows.append(",".join(repr(c.item() if hasattr(c, "item") else c)
                             for c in cells))
    return "\n".join(rows) + "\n"


def columns_of(text, *names):
    """Columns of the program's table, one after the other."""
    header, *rows = [line.split(",") for line in text.splitlines()]
    at = [header.index(name) for name in names]
    return np.array([[float(row[i] or "nan") for i in at] for row in rows])


def room(*others, emission=(1, 1, 1), **words):
    """A lamp over a floor, face 1, and whatever else there is."""
    rings = [FLOOR, LAMP, *others]
    faces = np.arange(4 * len(rings)).reshape(-1, 4)
    ke = np.zeros((len(rings), 3))
    ke[1] = emission
    return truelux.Oracle(
        truelux.Scene([v for ring in rings for v in ring], faces, ke,
                      groups=["floor", "lamp"] + ["other"] * len(others)),
        **words)


def interrupt(call, scene="truelux.Scene.read(sys.argv[1])"):
    """Ctrl-C ends a call, of `oracle`, and the oracle goes on."""
    script = textwrap.dedent(f"""
        import os, signal, sys, threading, time, truelux
        oracle = truelux.Oracle({scene})
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        try:
            while True:
                {call}
        except KeyboardInterrupt:
            print("interrupted", flush=True)
        print(oracle.irradiance([0, 0, 0], [0, 0, 1]).shape)
        """)
    done = subprocess.run(
        [sys.executable, "-c", script, str(EXAMPLES / "figure7_b.obj")],
        capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout) == (0, "interrupted\n(3,)\n"), \
        done.stderr
