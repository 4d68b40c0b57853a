# SPDX-License-Identifier: GPL-3.0-or-later
"""The polygons that stability_reference.py measures on: the unoccluded regimes
of src/baselines/regimes.h, with the same names and distributions and random
numbers of their own."""

import fractions
import math

TWO_PI = 2 * math.pi


# --- vectors ---------------------------------------------------------------

def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def scaled(s, a):
    return (s * a[0], s * a[1], s * a[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return scaled(1 / length(a), a)


def edges(ring):
    return zip(ring, ring[1:] + ring[:1])


# --- a case ----------------------------------------------------------------

class Case:
    """A loop, counter-clockwise seen from a receiver; both exact."""

    def __init__(self, loop, position=(0.0, 0.0, 0.0), normal=(0.0, 0.0, 1.0)):
        self.loop, self.position, self.n = loop, position, normal
        self.seen = [sub(v, position) for v in loop]  # fl(v - r)
        self.n_length = length(normal)

    def in_frame(self):
        """The loop with the normal along z; rounded unless it is there."""
        if self.n == (0.0, 0.0, 1.0):
            return self.seen
        u, v = across(self.n)
        return [(dot(u, w), dot(v, w), dot(self.n, w)) for w in self.seen]

    def exact(self):
        r = [fractions.Fraction(x) for x in self.position]
        return [tuple(fractions.Fraction(x) - y for x, y in zip(v, r))
                for v in self.loop]


def across(n):
    """Two vectors that make a right-handed frame with the unit vector n."""
    u = unit(cross((1.0, 0.0, 0.0) if abs(n[0]) < 0.6 else (0.0, 1.0, 0.0), n))
    return u, cross(n, u)


# --- regimes ---------------------------------------------------------------

def outline(rng):
    count = rng.choice((3, 3, 4, 5, 6))
    least = 0.3 if rng.random() < 0.4 else 0.8
    points = []
    for k in reversed(range(count)):
        angle = TWO_PI * (k + rng.uniform(-0.35, 0.35)) / count
        radius = rng.uniform(least, 1)
        points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return points


def looking(rng, elevation):
    """Axis, right and up at an elevation and any azimuth."""
    azimuth = rng.uniform(-math.pi, math.pi)
    ca, sa = math.cos(azimuth), math.sin(azimuth)
    ce, se = math.cos(elevation), math.sin(elevation)
    return (ca * ce, sa * ce, se), (-sa, ca, 0.0), (-ca * se, -sa * se, ce)


def turned(points, angle):
    c, s = math.cos(angle), math.sin(angle)
    return [(c * x - s * y, s * x + c * y) for x, y in points]


def place(rng, elevation, width, height, most_tilt):
    axis, right, up = looking(rng, elevation)
    distance = rng.uniform(0.5, 5)
    a, b = rng.uniform(-most_tilt, most_tilt), rng.uniform(-most_tilt, most_tilt)
    points = [(width * x, height * y) for x, y in outline(rng)]
    loop = []
    for x, y in turned(points, rng.uniform(0, TWO_PI)):
        tilt = a * x + b * y
        d = distance / (1 - tilt) if abs(tilt) < 0.7 else distance
        loop.append(scaled(d, add(axis, add(scaled(x, right), scaled(y, up)))))
    return Case(loop)


def of_size(rng, size):
    while True:
        case = place(rng, rng.uniform(0.2, 1.55), size / 2, size / 2, 1.5)
        if all(v[2] > 0.02 for v in case.loop):
            return case


def low(rng, elevation):
    return place(rng, elevation, 0.3 * elevation, 0.3 * elevation, 1.5)


def is_good_contour(loop):
    """Whether a loop above z = 0 is simple and counter-clockwise as seen from
    the origin, which multiplying all z does not change. Bending an outline
    around the horizon, or moving points down to it, now and then turns a
    triangle over: then another one is drawn."""
    total = 0.0
    sides = list(edges(loop))
    for i, (v, w) in enumerate(sides):
        normal = cross(v, w)
        for c, d in sides[i + 2:len(sides) - (i == 0)]:  # no common corner
            other = cross(c, d)
            if (dot(normal, c) * dot(normal, d) < 0 and
                    dot(other, v) * dot(other, w) < 0):
                return False
        total -= math.atan2(length(normal), dot(v, w)) * (
            normal[2] / length(normal))
    return total > 0


def wide(rng, elevation):
    while True:
        azimuth, width = rng.uniform(-math.pi, math.pi), rng.uniform(0.3, 0.6)
        d = rng.uniform(0.5, 5)
        loop = [(d * (1 + 0.3 * x) * math.cos(azimuth + width * x),
                 d * (1 + 0.3 * x) * math.sin(azimuth + width * x),
                 d * (1.5 + 0.5 * y)) for x, y in outline(rng)]
        if is_good_contour(loop):
            return Case([(x, y, elevation * z) for x, y, z in loop])


def on_horizon(rng, count):
    while True:
        azimuth, d = rng.uniform(-math.pi, math.pi), rng.uniform(0.5, 5)
        points = outline(rng)
        if min(math.hypot(x, y) for x, y in points) <= 0.75:
            continue
        limit = sorted(y for _, y in points)[count - 1]
        loop = []
        for x, y in points:
            at = azimuth + 0.5 * x
            e = 1e-12 * rng.uniform(1, 3) if y <= limit else 0.55 + 0.4 * y
            loop.append((d * math.cos(e) * math.cos(at),
                         d * math.cos(e) * math.sin(at), d * math.sin(e)))
        if is_good_contour(loop):
            return Case(loop)


def sliver(rng, long, thin):
    return place(rng, rng.uniform(0.4, 1.2), long / 2, thin / 2, 0.5)


def flat(rng, distance):
    while True:
        axis, right, up = looking(rng, rng.uniform(0.5, 1.2))
        turn = rng.uniform(-1.2, 1.2)
        along = add(scaled(math.cos(turn), right), scaled(math.sin(turn), up))
        off = scaled(distance, cross(axis, along))
        away = rng.uniform(1.5, 3)
        loop = [add(add(scaled(away + 0.6 * x, axis), scaled(0.6 * y, along)),
                    off) for x, y in outline(rng)]
        if all(v[2] > 0.05 for v in loop):
            return Case(loop)


def parallel(points, angle, scale, height):
    return Case([(scale * x, scale * y, height)
                 for x, y in turned(points, angle)])


def floor(rng, height, above):
    size, angle = rng.uniform(0.5, 3), rng.uniform(-math.pi, math.pi)
    if not above:
        beside = rng.uniform(1.5, 3)
        points = [(x + beside, y) for x, y in outline(rng)]
        return parallel(points, angle, size, size * height)
    while True:
        points = outline(rng)
        at = [math.atan2(y, x) for x, y in points]
        if all((a - b) % TWO_PI < 2.7 for a, b in edges(at)):
            return parallel(points, angle, size, size * height)


def vertical(rng, slope):
    x0, y0, y1 = rng.uniform(-2, 2), rng.uniform(-2, 0), rng.uniform(0.3, 2)
    x1, scale = x0 + rng.uniform(0.5, 1.5), rng.uniform(0.5, 3)
    return parallel([(x0, y0), (x0 + slope * rng.uniform(-1, 1), y0 + y1),
                     (x1, y0 + 1.2 * y1),
                     (x1 + slope * rng.uniform(-1, 1), y0 - 0.1)],
                    0, scale, scale)


def axis_side(rng, distance):
    scale = rng.uniform(0.5, 3)
    points = [(-rng.uniform(0.2, 1), distance),
              (rng.uniform(-0.1, 0.1), rng.uniform(0.5, 1)),
              (rng.uniform(0.2, 1), distance)]
    return parallel(points, rng.uniform(0, TWO_PI), scale, scale)


def far(rng, offset, size):
    n = unit(tuple(rng.gauss(0, 1) for _ in range(3)))
    u, v = across(n)
    azimuth, elevation = rng.uniform(-math.pi, math.pi), rng.uniform(0.95, 1.4)
    level = add(scaled(math.cos(azimuth), u), scaled(math.sin(azimuth), v))
    axis = unit(add(scaled(math.cos(elevation), level),
                    scaled(math.sin(elevation), n)))
    right, up = across(axis)
    r = tuple(offset * rng.uniform(-1, 1) + rng.uniform(-1, 1)
              for _ in range(3))
    count = rng.choice((3, 4, 5))
    a, b = rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.6)
    loop = []
    for k in reversed(range(count)):
        angle = TWO_PI * (k + rng.uniform(-0.3, 0.3)) / count
        x, y = size / 2 * math.cos(angle), size / 2 * math.sin(angle)
        p = add(scaled(1 + a * x + b * y, axis),
                add(scaled(x, right), scaled(y, up)))
        loop.append(add(r, scaled(1.5, p)))
    return Case(loop, r, n)


def regimes():
    """(name, how to draw, its parameters, formulas that do not apply)"""
    rows = []
    long_series = ("series",)  # its terms fall like the square of the size

    def row(name, draw, *parameters, without=long_series):
        rows.append((name, draw, parameters, without))
    for k in range(9):
        row(f"size 1e-{k}", of_size, 10.0 ** -k,
            without=long_series if k < 2 else ())
    for k in (2, 4, 6, 8):
        row(f"elevation 1e-{k} iso", low, 10.0 ** -k, without=())
    for k in (2, 4, 6, 8):
        row(f"elevation 1e-{k} wide", wide, 10.0 ** -k)
    row("1 vertex at 1e-12", on_horizon, 1)
    row("2 vertices at 1e-12", on_horizon, 2)
    row("sliver 0.5 x 5e-7", sliver, 0.5, 5e-7)
    row("sliver 2e-3 x 2e-9", sliver, 2e-3, 2e-9, without=())
    for k in (4, 8):
        row(f"1e-{k} off the source plane", flat, 10.0 ** -k)
    row("source plane 1e-8 up beside", floor, 1e-8, False)
    # The cubature cannot resolve a source that all but touches the receiver.
    row("source plane 1e-8 up above", floor, 1e-8, True,
        without=("series", "cubature"))
    row("vertical edges", vertical, 0.0)
    row("edges 1e-9 off vertical", vertical, 1e-9)
    row("edge 1e-9 off the axis", axis_side, 1e-9)
    for size, text in ((1.0, "1"), (1e-3, "1e-3")):
        for offset, where in ((0.0, "0"), (1e3, "1e3"), (1e6, "1e6"),
                              (1e9, "1e9")):
            row(f"far {where} size {text}", far, offset, size,
                without=long_series if size == 1 else ())
    return rows
