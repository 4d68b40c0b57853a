# SPDX-License-Identifier: GPL-3.0-or-later
"""What a call from Python costs beside the library alone.

    PYTHONPATH=build/release/python /usr/bin/python3 bench/python_overhead.py

Beside a call of the package stands one of the module that it is made of, which
gets rows and face numbers ready: what is left are the receivers, the threads,
and the array of results.
"""

import statistics
import time
import warnings
from pathlib import Path

import numpy as np

import truelux
from truelux import _truelux, arrays

SCENES = Path(__file__).parent.parent / "examples" / "scenes"


def median(times):
    return statistics.median(times)


def seconds(call, rounds=7):
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return median(times)


def main():
    warnings.simplefilter("ignore", truelux.Note)
    scene = truelux.Scene.read(SCENES / "cornell_box.obj")
    oracle = truelux.Oracle(scene)
    up = np.array([0.0, 1.0, 0.0])
    print(f"{'receivers':>10} {'package':>12} {'module':>12} {'per receiver':>13}")
    for side in (1, 10, 100, 1000):
        u, v = np.meshgrid(np.linspace(5, 545, side), np.linspace(5, 545, side),
                           indexing="ij")
        points = np.stack([u, 0 * u, v], axis=-1)
        repeat = max(1, 2000 // (side * side))
        rows, normals, _ = arrays.receivers(points, up)
        faces = np.ones(1, dtype=np.int64)

        def package():
            for _ in range(repeat):
                oracle.irradiance(points, up, on_face=1)

        def module():
            for _ in range(repeat):
                _truelux.irradiances(scene._shared, oracle._choice, rows, normals,
                                     faces, False)

        whole = seconds(package) / repeat
        inner = seconds(module) / repeat
        print(f"{side * side:>10} {1e6 * whole:>9.1f} us {1e6 * inner:>9.1f} us "
              f"{1e6 * whole / side**2:>10.2f} us")


if __name__ == "__main__":
    main()
