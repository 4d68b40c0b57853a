# SPDX-License-Identifier: GPL-3.0-or-later
"""Where is the board? Its pose out of an image of irradiances.

    PYTHONPATH=build/release/python /usr/bin/python3 examples/python/find_blocker.py [PLOT.png]

A lamp lights a floor through a board whose position and rotation are not known.
From 64 irradiances on the floor, Gauss-Newton with the exact derivatives by the
board's vertices (scipy.optimize) finds all six numbers; with PLOT.png and
matplotlib it draws the shadow and how the search goes.
"""

import sys

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

import truelux

LAMP = np.array([[-0.5, -0.5, 2], [-0.5, 0.5, 2], [0.5, 0.5, 2], [0.5, -0.5, 2]])
BOARD = np.array([[-0.4, -0.3, 0], [0.5, -0.2, 0], [0.1, 0.4, 0]])
FACES = [[0, 1, 2, 3], [4, 5, 6]]
UP = np.array([0.0, 0.0, 1.0])
SIDE = 8
GRID = np.stack(np.meshgrid(np.linspace(-0.9, 0.9, SIDE),
                            np.linspace(-0.9, 0.9, SIDE), [0.0]),
                axis=-1).reshape(-1, 3)


def board(pose):
    """The board's vertices: moved by pose[:3], turned by pose[3:] [rad]."""
    return Rotation.from_rotvec(pose[3:]).apply(BOARD) + pose[:3]


def oracle(pose):
    return truelux.Oracle(truelux.Scene(np.concatenate([LAMP, board(pose)]),
                                        FACES, [1.0, 0.0]))


def image(pose, points=GRID):
    return oracle(pose).irradiance(points, UP)[..., 0]


def by_pose(pose):
    """dE/dpose of every receiver, shape (64, 6): exact by the vertices, and
    those by the pose, which are smooth, by differences."""
    h = 1e-6
    vertices = np.array([(board(pose + h * axis) - board(pose - h * axis)) /
                         (2 * h) for axis in np.eye(6)])
    here = oracle(pose)
    gradients = [here.vertex_gradient(point, UP, [1, 0, 0]).values[4:]
                 for point in GRID]
    return np.einsum("nvk,pvk->np", np.array(gradients), vertices)


def draw(path, found, truth, course):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt
    fine = np.stack(np.meshgrid(np.linspace(-1, 1, 160),
                                np.linspace(-1, 1, 160), [0.0]), axis=-1)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2))
    shown = left.imshow(image(found, fine)[..., 0], origin="lower",
                        extent=(-1, 1, -1, 1), cmap="viridis")
    left.plot(*GRID[:, :2].T, "w.", markersize=3)
    left.set_title("the shadow of the board that was found")
    figure.colorbar(shown, ax=left, label="E [W/m²]")
    right.semilogy([np.abs(pose - truth).max() for pose in course], "o-")
    right.set_title("largest error of the pose")
    right.set_xlabel("step")
    right.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    truth = np.array([0.05, -0.1, 1.0, 0.2, -0.15, 0.4])
    measured = image(truth)
    start = np.array([0.0, 0.0, 0.9, 0.0, 0.0, 0.2])
    course = [start]

    def jacobian(pose):
        course.append(pose.copy())
        return by_pose(pose)

    found = least_squares(lambda pose: image(pose) - measured, start, jacobian,
                          method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15)
    course.append(found.x)
    for name, value, true in zip(("x", "y", "z", "turn x", "turn y", "turn z"),
                                 found.x, truth):
        print(f"{name:>7}: {value:.12f}   off by {abs(value - true):.1e}")
    error = np.abs(found.x - truth).max()
    print(f"{len(course) - 1} steps, largest error {error:.1e}")
    if len(sys.argv) > 1:
        draw(sys.argv[1], found.x, truth, course)
    return 0 if error < 1e-9 else 1


if __name__ == "__main__":
    sys.exit(main())
