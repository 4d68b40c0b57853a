# SPDX-License-Identifier: GPL-3.0-or-later
"""Is a lightmap right? And if not, is it half a texel off?

    PYTHONPATH=build/release/python /usr/bin/python3 examples/python/lightmap_check.py [PLOT.png]

A baker that puts receivers at the corners of texels instead of their middles
makes a lightmap that looks right and is shifted. Here such a baker's map of a
floor with a penumbra is held against the exact irradiance: first as it should
be, then with the receivers moved by half texels, of which one explains it. A
map of one's own comes in as arrays of positions, normals and irradiances, or by
`python3 -m truelux eval ROOM.obj POSITIONS.exr --normals NORMALS.exr`.
"""

import itertools
import sys

import numpy as np

import truelux

VERTICES = [[-0.6, -0.4, 1.5], [-0.6, 0.4, 1.5], [0.6, 0.4, 1.5],
            [0.6, -0.4, 1.5],                                     # the lamp
            [-0.5, -0.6, 0.5], [0.3, -0.5, 0.5], [0.4, 0.5, 0.6],  # a board
            [-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]       # the floor
FACES = [[0, 1, 2, 3], [4, 5, 6], [7, 8, 9, 10]]
EMISSION = [[3, 2.8, 2.4], [0, 0, 0], [0, 0, 0]]
UP = np.array([0.0, 0.0, 1.0])
SIZE = 48
TEXEL = 2 / SIZE


def middles():
    """The middles of the floor's texels, shape (SIZE, SIZE, 3)."""
    across = -1 + TEXEL * (np.arange(SIZE) + 0.5)
    x, y = np.meshgrid(across, across)
    return np.stack([x, y, 0 * x], axis=-1)


def baked(oracle):
    """What the baker writes: receivers at lower left corners, binary32."""
    corners = middles() - [TEXEL / 2, TEXEL / 2, 0]
    return oracle.irradiance(corners, UP, on_face=3).astype(np.float32)


def error(lightmap, truth):
    """The root of the mean square, relative to that of the truth."""
    return np.sqrt(((lightmap - truth)**2).mean() / (truth**2).mean())


def draw(path, lightmap, truth):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt
    difference = (lightmap - truth)[..., 1]
    limit = np.abs(difference).max()
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8))
    for axis, values, title, style in (
            (left, lightmap[..., 1], "the lightmap, green [W/m²]",
             {"cmap": "viridis"}),
            (right, difference, "less the exact values [W/m²]",
             {"cmap": "RdBu_r", "vmin": -limit, "vmax": limit})):
        shown = axis.imshow(values, origin="lower", **style)
        axis.set_title(title)
        figure.colorbar(shown, ax=axis)
    figure.tight_layout()
    figure.savefig(path, dpi=100)


def main():
    oracle = truelux.Oracle(truelux.Scene(VERTICES, FACES, EMISSION))
    lightmap = baked(oracle)
    truth = oracle.irradiance(middles(), UP, on_face=3)
    print(f"as it should be: error {error(lightmap, truth):.1e}")
    errors = {}
    for u, v in itertools.product((-0.5, 0, 0.5), repeat=2):
        moved = middles() + [u * TEXEL, v * TEXEL, 0]
        errors[u, v] = error(lightmap, oracle.irradiance(moved, UP, on_face=3))
    u, v = min(errors, key=errors.get)
    print(f"receivers moved by ({u:+}, {v:+}) texels: error {errors[u, v]:.1e}")
    if len(sys.argv) > 1:
        draw(sys.argv[1], lightmap, truth)
    return 0 if (u, v) == (-0.5, -0.5) and errors[u, v] < 1e-7 else 1


if __name__ == "__main__":
    sys.exit(main())
