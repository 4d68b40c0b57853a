#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_sphere.py N FOLDER: a bumpy sphere of 2 N (N - 1) triangles under a
square lamp (sphere.obj, sphere.mtl) and 25 receivers below it (sphere.csv),
for measuring what large meshes cost."""

import math
import pathlib
import random
import sys


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    n, folder = int(sys.argv[1]), pathlib.Path(sys.argv[2])
    rng = random.Random(2)
    lines = ["mtllib sphere.mtl", "v 0 0 1", "v 0 0 -1"]
    for i in range(1, n):
        for j in range(n):
            u, v = 2 * math.pi * j / n, math.pi * i / n
            r = 1 + 0.1 * math.sin(7 * u) * math.sin(5 * v) + 0.01 * rng.random()
            lines.append(f"v {r * math.sin(v) * math.cos(u)!r} "
                         f"{r * math.sin(v) * math.sin(u)!r} {r * math.cos(v)!r}")

    def vertex(i, j):
        return 1 if i == 0 else 2 if i == n else 3 + (i - 1) * n + j % n

    for i in range(n):
        for j in range(n):
            a, b = vertex(i, j), vertex(i + 1, j)
            c, d = vertex(i + 1, j + 1), vertex(i, j + 1)
            if i < n - 1:
                lines.append(f"f {a} {b} {c}")
            if i > 0:
                lines.append(f"f {a} {c} {d}")
    lines += ["usemtl lamp", "v -1.5 -1.5 2.5", "v -1.5 1.5 2.5",
              "v 1.5 1.5 2.5", "v 1.5 -1.5 2.5", "f -4 -3 -2 -1"]
    (folder / "sphere.obj").write_text("\n".join(lines) + "\n")
    (folder / "sphere.mtl").write_text("newmtl lamp\nKe 17 12 4\n")
    rows = [f"{rng.uniform(-2, 2)!r},{rng.uniform(-2, 2)!r},-1.2,0,0,1"
            for _ in range(25)]
    (folder / "sphere.csv").write_text("\n".join(["x,y,z,nx,ny,nz"] + rows) + "\n")


main()
