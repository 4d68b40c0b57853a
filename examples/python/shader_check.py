# SPDX-License-Identifier: GPL-3.0-or-later
"""Where is a shader biased, and where is it only noisy?

    PYTHONPATH=build/release/python /usr/bin/python3 examples/python/shader_check.py [PLOT.png]

The shader is of the kind that games use: the closed form of the unshadowed lamp
(here Lambert's, as linearly transformed cosines give it for diffuse surfaces)
times the share of 64 shadow rays to the lamp that arrive. Its mean over many
random numbers is held against the exact irradiance: what is left then is bias,
what the single picture has besides is noise. With PLOT.png and matplotlib it
draws both.
"""

import sys

import numpy as np

import truelux

LAMP = np.array([[-0.6, -0.4, 1.5], [-0.6, 0.4, 1.5], [0.6, 0.4, 1.5],
                 [0.6, -0.4, 1.5]])
BOARD = np.array([[-0.5, -0.6, 0.5], [0.3, -0.5, 0.5], [0.4, 0.5, 0.6],
                  [-0.4, 0.4, 0.6]])
UP = np.array([0.0, 0.0, 1.0])
SIDE, RAYS, PICTURES = 32, 64, 100


def unshadowed(points):
    """Lambert's formula for M = 1; the lamp is above all horizons here."""
    to = LAMP - points[:, None, :]
    unit = to / np.linalg.norm(to, axis=-1, keepdims=True)
    following = np.roll(unit, -1, axis=1)
    normal = np.cross(following, unit)
    sine = np.linalg.norm(normal, axis=-1)
    angle = np.arctan2(sine, (unit * following).sum(axis=-1))
    return (angle * normal[..., 2] / sine).sum(axis=-1) / (2 * np.pi)


def arrives(points, samples):
    """Whether rays from points to samples on the lamp miss the board."""
    clear = np.ones(samples.shape[:-1], dtype=bool)
    for a, b, c in (BOARD[[0, 1, 2]], BOARD[[0, 2, 3]]):
        ray = samples - points[:, None, :]
        across = np.cross(ray, c - a)
        volume = across @ (b - a)
        from_a = (points - a)[:, None, :]
        u = (from_a * across).sum(axis=-1) / volume
        turned = np.cross(from_a, b - a)
        v = (ray * turned).sum(axis=-1) / volume
        t = (turned @ (c - a)) / volume
        clear &= ~((u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0) & (t < 1))
    return clear


def picture(points, random):
    """The shader's irradiance, with a jittered 8 x 8 grid of shadow rays."""
    cells = np.stack(np.meshgrid(np.arange(8), np.arange(8)), -1).reshape(-1, 2)
    st = (cells + random.random((len(points), RAYS, 2))) / 8
    samples = (LAMP[0] + st[..., :1] * (LAMP[3] - LAMP[0]) +
               st[..., 1:] * (LAMP[1] - LAMP[0]))
    return unshadowed(points) * arrives(points, samples).mean(axis=1)


def draw(path, truth, bias, noise):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.8))
    limit = np.abs(bias).max()
    for axis, values, title, style in (
            (axes[0], truth, "exact E [W/m²]", {"cmap": "viridis"}),
            (axes[1], bias, "bias of the shader [W/m²]",
             {"cmap": "RdBu_r", "vmin": -limit, "vmax": limit}),
            (axes[2], noise, "noise of one picture [W/m²]",
             {"cmap": "magma"})):
        shown = axis.imshow(values.reshape(SIDE, SIDE), origin="lower",
                            extent=(-1, 1, -1, 1), **style)
        axis.set_title(title)
        figure.colorbar(shown, ax=axis)
    figure.tight_layout()
    figure.savefig(path, dpi=100)


def main():
    x, y = np.meshgrid(np.linspace(-1, 1, SIDE), np.linspace(-1, 1, SIDE))
    points = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    scene = truelux.Scene(np.concatenate([LAMP, BOARD]),
                          [[0, 1, 2, 3], [4, 5, 6], [4, 6, 7]],
                          [[1, 1, 1], [0, 0, 0], [0, 0, 0]])
    truth = truelux.Oracle(scene).irradiance(points, UP)[:, 0]
    random = np.random.default_rng(7)
    pictures = np.array([picture(points, random) for _ in range(PICTURES)])
    bias = pictures.mean(axis=0) - truth
    noise = pictures.std(axis=0)
    # What the mean of so many pictures can be off by chance.
    chance = noise / np.sqrt(PICTURES)
    biased = np.abs(bias) > 5 * chance + 1e-12
    lit = truth > 0
    relative = np.abs(bias[lit]) / truth[lit]
    print(f"{biased.sum()} of {len(points)} points are biased, by up to "
          f"{np.abs(bias).max():.2e} W/m^2 ({100 * relative.max():.0f} % of E)")
    print(f"noise of one picture: up to {noise.max():.2e} W/m^2")
    clear = noise == 0
    print(f"no noise at {clear.sum()} points; the largest error there is "
          f"{np.abs(bias[clear]).max():.1e} W/m^2")
    if len(sys.argv) > 1:
        draw(sys.argv[1], truth, bias, noise)
    return 0


if __name__ == "__main__":
    sys.exit(main())
