# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh that follows the light, beside a uniform one with as many vertices.

    PYTHONPATH=build/release/python /usr/bin/python3 examples/python/iso_mesh.py [PLOT.png]

The edges of the first mesh are the outline of the floor, the feet of the
blocks, the lines where the gradient jumps, and contours. Values between its
vertices are interpolated, as a game engine does with light in vertices; with
PLOT.png and matplotlib both meshes are drawn with what they show.
"""

import sys
from pathlib import Path

import numpy as np

import truelux

SCENE = Path(__file__).resolve().parents[1] / "scenes" / "cornell_box.obj"


def uniform_mesh(oracle, count):
    """About count points of the floor on a grid, their values and triangles."""
    side = int(round(np.sqrt(count)))
    # The floor is not quite a rectangle: its left wall leans a little.
    u, v = np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side))
    points = np.stack([u * (552.8 - 3.2 * v), 0 * u, 559.2 * v],
                      axis=-1).reshape(-1, 3)
    values = oracle.irradiance(points, [0, 1, 0], on_face="floor")
    luminance = values @ [0.2126, 0.7152, 0.0722]
    corner = np.arange(side * (side - 1)).reshape(side - 1, side)[:, :-1]
    corner = corner.reshape(-1)
    return points, luminance, np.concatenate(
        [np.stack([corner, corner + side, corner + 1], axis=-1),
         np.stack([corner + 1, corner + side, corner + side + 1], axis=-1)])


def draw(path, meshes):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt
    figure, rows = plt.subplots(2, 2, figsize=(11, 10.6),
                                constrained_layout=True)
    for column, (title, points, values, triangles) in enumerate(meshes):
        x, y = -points[:, 0], points[:, 2]
        for axes in rows[:, column]:
            axes.set_aspect("equal")
            axes.set_axis_off()
        rows[0, column].set_title(title)
        rows[0, column].triplot(x, y, triangles, color="0.35", linewidth=0.25)
        shown = rows[1, column].tripcolor(x, y, triangles, values, vmin=0,
                                          vmax=0.2146, shading="gouraud",
                                          rasterized=True)
    figure.colorbar(shown, ax=rows[1, :], label="E [W/m$^2$]", shrink=0.8)
    figure.savefig(path, dpi=90)


def main(arguments):
    oracle = truelux.Oracle(truelux.Scene.read(SCENE))
    mesh = oracle.iso_mesh("floor", count=8)
    points, values, triangles = uniform_mesh(oracle, len(mesh.points))
    print(f"{len(mesh.points)} vertices, {len(mesh.triangles)} triangles; "
          f"a grid of {len(points)}")
    print(f"interpolation is wrong by {mesh.interpolation.most:.2g} at most, "
          f"{mesh.interpolation.mean:.2g} on the average")
    print(f"in a uniform mesh by {mesh.uniform.most:.2g} and "
          f"{mesh.uniform.mean:.2g}")
    if arguments:
        draw(arguments[0],
             [("a uniform mesh", points, values, triangles),
              ("a mesh that follows the light", mesh.points, mesh.values,
               mesh.triangles)])


if __name__ == "__main__":
    main(sys.argv[1:])
