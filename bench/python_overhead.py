# SPDX-License-Identifier: GPL-3.0-or-later
"""What a call from Python costs beside the library alone.

    PYTHONPATH=build/release/python /usr/bin/python3 bench/python_overhead.py \
        build/release/bench/oracle_grid

Both evaluate the same receivers on the floor of the Cornell box, in turns; the
medians of all rounds, and that of their ratios.
"""

import os
import statistics
import subprocess
import sys
import time
import warnings
from pathlib import Path

import numpy as np

import truelux

BOX = Path(__file__).parent.parent / "examples" / "scenes" / "cornell_box.obj"
ROUNDS = 15


def seconds(call):
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


class Library:
    """The program oracle_grid, which evaluates when it is asked to."""

    def __init__(self, program, side, threads):
        self._process = subprocess.Popen(
            [program, str(BOX), str(side), str(threads)],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def seconds(self):
        self._process.stdin.write("\n")
        self._process.stdin.flush()
        return float(self._process.stdout.readline())

    def close(self):
        self._process.stdin.close()
        self._process.wait()


def floor_grid(side):
    u, v = np.meshgrid(np.linspace(5, 545, side), np.linspace(5, 545, side),
                       indexing="ij")
    return np.stack([u, 0 * u, v], axis=-1)


def main(program):
    warnings.simplefilter("ignore", truelux.Note)
    scene = truelux.Scene.read(BOX)
    up = np.array([0.0, 1.0, 0.0])
    oracle = truelux.Oracle(scene, threads=1)
    point = floor_grid(1)[0, 0]
    single = [seconds(lambda: oracle.irradiance(point, up, on_face=1))
              for _ in range(20_000)]
    print(f"a call for one receiver: {1e6 * statistics.median(single):.1f} us")
    print(f"{'receivers':>10} {'threads':>8} {'package':>12} {'library':>12} "
          f"{'ratio':>7}")
    for side in (100, 316, 1000):
        for threads in sorted({1, os.cpu_count()}):
            oracle = truelux.Oracle(scene, threads=threads)
            points = floor_grid(side)
            library = Library(program, side, threads)
            library.seconds()
            rounds = [(seconds(lambda: oracle.irradiance(points, up, on_face=1)),
                       library.seconds()) for _ in range(ROUNDS)]
            library.close()
            package, alone = (statistics.median(t) for t in zip(*rounds))
            ratio = statistics.median(a / b for a, b in rounds)
            print(f"{side * side:>10} {threads:>8} {1e3 * package:>9.1f} ms "
                  f"{1e3 * alone:>9.1f} ms {ratio:>7.3f}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
