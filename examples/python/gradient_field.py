# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours and the gradient of the light on a floor.

    PYTHONPATH=build/release/python /usr/bin/python3 examples/python/gradient_field.py [PLOT.png]

The gradient is at right angles to the contours and points to more light; where
the irradiance falls steeply it is long. Both are certified, each by itself;
with PLOT.png and matplotlib they are drawn together over the shaded floor.
"""

import sys
from pathlib import Path

import numpy as np

import truelux

SCENE = Path(__file__).resolve().parents[1] / "scenes" / "cornell_box.obj"
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
UP = np.array([0.0, 1.0, 0.0])


def grid(side):
    """Points on the floor, shape (side, side, 3)."""
    steps = (np.arange(side) + 0.5) / side
    u, v = np.meshgrid(steps, steps)
    return np.stack([u * (552.8 - 3.2 * v), 0 * u, 559.2 * v], axis=-1)


def worst_angle(oracle, isolux):
    """How far gradients at vertices are from what contours are across [deg]."""
    vertices = np.concatenate([c.vertices[c.certified & (c.on == "inside")]
                               for c in isolux.contours])[::50]
    across = np.concatenate([c.across[c.certified & (c.on == "inside")]
                             for c in isolux.contours])[::50]
    found = oracle.derivatives(vertices, UP, on_face="floor")
    gradient = found.gradient.swapaxes(-1, -2) @ LUMINANCE
    gradient -= np.outer(gradient @ UP, UP)
    length = np.linalg.norm(gradient, axis=-1)
    cosine = np.sum(gradient * across, axis=-1)[length > 0] / length[length > 0]
    return np.degrees(np.arccos(np.clip(cosine, -1, 1))), len(cosine)


def draw(path, oracle, isolux):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt
    figure, axes = plt.subplots(figsize=(9, 8), constrained_layout=True)
    fine = grid(240)
    shade = oracle.irradiance(fine, UP, on_face="floor") @ LUMINANCE
    shown = axes.pcolormesh(-fine[..., 0], fine[..., 2], shade, cmap="gray",
                            shading="gouraud", rasterized=True)
    for contour in isolux.contours:
        line = contour.vertices
        if contour.closed:
            line = np.concatenate([line, line[:1]])
        axes.plot(-line[:, 0], line[:, 2], color="tab:orange", linewidth=1)
    points = grid(28)
    found = oracle.derivatives(points, UP, on_face="floor")
    gradient = found.gradient.swapaxes(-1, -2) @ LUMINANCE
    axes.quiver(-points[..., 0], points[..., 2], -gradient[..., 0],
                gradient[..., 2], color="deepskyblue", width=0.002,
                scale=0.03)
    axes.set_aspect("equal")
    axes.set_axis_off()
    figure.colorbar(shown, ax=axes, label="E [W/m$^2$]", shrink=0.8)
    figure.savefig(path, dpi=90)


def main(arguments):
    oracle = truelux.Oracle(truelux.Scene.read(SCENE))
    isolux = oracle.isolux("floor", count=8)
    angles, count = worst_angle(oracle, isolux)
    print(f"{len(isolux.contours)} contours; at {count} of their vertices the "
          f"gradient is at right angles within {np.max(angles):.1g} degrees")
    if arguments:
        draw(arguments[0], oracle, isolux)


if __name__ == "__main__":
    main(sys.argv[1:])
