# SPDX-License-Identifier: GPL-3.0-or-later
"""The irradiance below a lamp that a board half hides, exactly.

    PYTHONPATH=build/release/python python3 examples/python/first.py
"""

import truelux

scene = truelux.Scene(
    vertices=[[-1, -1, 2], [-1, 1, 2], [1, 1, 2], [1, -1, 2],
              [0, -1, 1], [0, 1, 1], [2, 1, 1], [2, -1, 1]],
    faces=[[0, 1, 2, 3], [4, 5, 6, 7]],
    emission=[[10, 9, 7], [0, 0, 0]],  # W/m^2; the board only hides
)
oracle = truelux.Oracle(scene)
points = [[x, 0, 0] for x in (-1, -0.5, 0, 0.5, 1)]
for point, e in zip(points, oracle.irradiance(points, [0, 0, 1])):
    print(f"x = {point[0]:4}: E = {e[0]!r} W/m^2 in red")
