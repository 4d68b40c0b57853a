#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""stability_reference.py [--polygons N] [--processes N]: how many digits each
closed form of the irradiance keeps in binary64, as CSV on standard output:
regime,formula,median,max of the relative error over N random polygons (1000)
of every unoccluded regime (stability_cases.py).

The forms are written down here once more, from the papers with the corrections
of docs/method.md section 8 and from section 9, so that the C++ ones can be held
against them: tests/data/stability_reference.csv is the output without options.
Truth: Lambert's formula with 80 digits on the same binary64 numbers. Needs
mpmath."""

import argparse
import math
import multiprocessing
import random
import statistics

import mpmath

from stability_cases import (TWO_PI, add, cross, dot, edges, length, regimes,
                             scaled, sub, unit)

SEED = 2024


def truth(case):
    m = mpmath.mpf
    ring = [tuple(m(x) - m(y) for x, y in zip(v, case.position))
            for v in case.loop]
    n = tuple(m(x) for x in case.n)
    total = m(0)
    for v, w in edges(ring):
        across_both = cross(v, w)
        size = mpmath.sqrt(dot(across_both, across_both))
        total -= mpmath.atan2(size, dot(v, w)) * dot(across_both, n) / size
    return total / (2 * mpmath.pi * mpmath.sqrt(dot(n, n)))


# --- sums over edges: S (3), corrected ----------------------------------------

def lambert(case, normal_of, angle_of):
    total = 0.0
    for v, w in edges(case.seen):
        normal = normal_of(v, w)
        size = length(normal)
        if size != 0:
            total -= angle_of(v, w, size) * (dot(normal, case.n) / size)
    return total / (TWO_PI * case.n_length)


def by_atan2(v, w, size):
    return math.atan2(size, dot(v, w))


def by_acos(v, w, _):
    return math.acos(max(-1.0, min(1.0, dot(unit(v), unit(w)))))


def from_difference(v, w):
    return cross(v, sub(w, v))


def lambert_acos(case):
    return lambert(case, cross, by_acos)


def lambert_atan2(case):
    return lambert(case, cross, by_atan2)


def lambert_edge(case):
    return lambert(case, from_difference, by_atan2)


# --- sums over vertices ----------------------------------------------------

def over_edge_ends(ring, term):
    """Sum of term(vertex, its edge's difference, its edge's normal), + for the
    edge that comes in and - for the one that goes out."""
    total = 0.0
    previous = ring[-1]
    for i, v in enumerate(ring):
        after = ring[(i + 1) % len(ring)]
        e_in, e_out = sub(v, previous), sub(after, v)
        total += term(v, e_in, cross(v, e_in)) - term(v, e_out, cross(v, e_out))
        previous = v
    return total / TWO_PI


def vertex_lambert(case):
    """S (12), (13): the angle of the vertex with the edge."""
    def term(v, e, normal):
        size = length(normal)
        if size == 0:
            return 0.0
        return math.atan2(size, dot(v, e)) * (dot(normal, case.n) / size)
    return over_edge_ends(case.seen, term) / case.n_length


def unified(case):
    """H(v, N), with one N for both ends of an edge."""
    total = 0.0
    n = case.n
    for v, w in edges(case.seen):
        normal = from_difference(v, w)
        size = length(normal)
        if size == 0:
            continue
        ahead = cross(n, normal)

        def angle(p):
            return math.atan2(dot(p, ahead), size * dot(n, p))
        total += dot(n, normal) / size * (angle(w) - angle(v))
    return total / (TWO_PI * case.n_length)


def sphere(case):
    """S (27), (28) above the equator: azimuth phi and elevation alpha of the
    vertex, chi the direction of the edge there."""
    ring = case.in_frame()
    total = 0.0
    for v, w in edges(ring):
        normal = cross(v, w)
        size = length(normal)
        if size == 0:
            continue
        nx, ny, nz = scaled(1 / size, normal)

        def g(p):
            phi = math.atan2(p[1], p[0])
            alpha = math.atan2(p[2], math.hypot(p[0], p[1]))
            cp, sp = math.cos(phi), math.sin(phi)
            ca, sa = math.cos(alpha), math.sin(alpha)
            sin_chi = nz * ca - (nx * cp + ny * sp) * sa
            cos_chi = nx * sp - ny * cp
            return ca * sin_chi * math.atan2(cos_chi, math.tan(alpha))
        total += g(w) - g(v)
    return total / TWO_PI


# --- on the image plane --------------------------------------------------------

def image(case):
    return [(x / z, y / z) for x, y, z in case.in_frame()]


def image_plane(case):
    """S (8) to (10): slopes; a vertical edge adds nothing."""
    total = 0.0
    for (x, y), (x1, y1) in edges(image(case)):
        if x == x1:
            continue
        m = (y1 - y) / (x1 - x)

        def f(p, q):
            a = 1 / math.sqrt(1 + p * p)
            c = 1 / math.sqrt(1 + m * m + (q - m * p) ** 2)
            return (a * p * math.atan(a * q) +
                    c * (q - m * p) * math.atan(c * (p + m * q)))
        total += f(x1, y1) - f(x, y)
    return total / TWO_PI


def end_term(x, y, a, b):
    """S (44), (45), corrected: C (a y - b x) atan(C (a x + b y))."""
    k = a * y - b * x
    c = 1 / math.sqrt(a * a + b * b + k * k)
    return c * k * math.atan(c * (a * x + b * y))


def directions(case):
    """Over the vertices, each with the directions of its two edges."""
    ring = image(case)
    total = 0.0
    for i, (x, y) in enumerate(ring):
        (xi, yi), (xo, yo) = ring[i - 1], ring[(i + 1) % len(ring)]
        if (x, y) != (xi, yi):
            total += end_term(x, y, x - xi, y - yi)
        if (x, y) != (xo, yo):
            total -= end_term(x, y, xo - x, yo - y)
    return total / TWO_PI


def projective(case):
    """S Figure 10, over the edges with their directions of travel. Loops are
    above the horizon, so that the rows of points at infinity never occur."""
    total = 0.0
    for (x, y), (x1, y1) in edges(image(case)):
        a, b = x1 - x, y1 - y
        if a != 0 or b != 0:
            total += end_term(x1, y1, a, b) - end_term(x, y, a, b)
    return total / TWO_PI


def homogeneous(case):
    """S Figure 11, the row of finite vertices: each takes the unsigned
    difference to the other end."""
    ring = image(case)
    total = 0.0
    for i, (x, y) in enumerate(ring):
        for j, sign in ((i - 1, 1), ((i + 1) % len(ring), -1)):
            a, b = ring[j][0] - x, ring[j][1] - y
            if a != 0 or b != 0:
                total += sign * end_term(x, y, a, b)
    return total / TWO_PI


# --- stable forms ----------------------------------------------------------

def angle_less_sine(b):
    if b > 0.7:
        return b - math.sin(b)
    total = term = b ** 3 / 6
    for k in range(4, 24, 2):
        term *= -b * b / (k * (k + 1))
        total += term
    return total


def difference(case):
    """Sum of (u_i - u_0) x (u_i+1 - u_0), and of beta - sin beta."""
    ring = case.seen
    l0 = length(ring[0])
    u0 = scaled(1 / l0, ring[0])
    apart = []
    for v in ring:
        d, size = sub(v, ring[0]), length(v)
        longer = dot(d, add(v, ring[0])) / (size + l0)  # |v| - |v_0|
        apart.append(scaled(1 / size, sub(d, scaled(longer, u0))))
    total = 0.0
    for d, d1 in zip(apart[1:], apart[2:]):
        total += dot(case.n, cross(d, d1))
    for v, w in edges(ring):
        normal = from_difference(v, w)
        size = length(normal)
        if size != 0:
            total += (angle_less_sine(math.atan2(size, dot(v, w))) *
                      (dot(case.n, normal) / size))
    return -total / (TWO_PI * case.n_length)


def fan(case, triangle):
    """Sum over the fan of the first vertex of triangle(three vertices) times
    minus the exact determinant, rounded."""
    exact, ring = case.exact(), case.seen
    total = 0.0
    for k in range(1, len(ring) - 1):
        det = float(dot(exact[0], cross(exact[k], exact[k + 1])))
        total -= det * triangle(case, ring[0], ring[k], ring[k + 1])
    return total / case.n_length


def series_triangle(case, *v):
    """Positive series in D_ij = 1 - cos beta_ij, to the second order."""
    l = [length(p) for p in v]

    def d(i, j):
        sine_square = dot(*[from_difference(v[i], v[j])] * 2) / (
            l[i] * l[j]) ** 2
        return sine_square / (1 + dot(v[i], v[j]) / (l[i] * l[j]))
    total = 0.0
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        p, q, o = d(k, i), d(k, j), d(i, j)
        weight = (1 + 0.4 * (p + q) + 0.2 * o +
                  (6 * (p * p + q * q + p * q) + 2 * o * o + 4 * o * (p + q))
                  / 35)
        total += dot(case.n, v[k]) / l[k] * weight
    return total / (6 * math.pi * l[0] * l[1] * l[2])


def gauss(count):
    """Nodes and weights on [0, 1]."""
    nodes = []
    for i in range(count):
        x = mpmath.cos(mpmath.pi * (i + 0.75) / (count + 0.5))
        for _ in range(8):
            p, before = mpmath.legendre(count, x), mpmath.legendre(count - 1, x)
            slope = count * (x * p - before) / (x * x - 1)
            x -= p / slope
        nodes.append((float((1 + x) / 2), float(1 / ((1 - x * x) * slope ** 2))))
    return nodes


GAUSS = {count: gauss(count) for count in (4, 5, 6, 8)}


def cubature_triangle(case, v0, v1, v2, share=1.0):
    """1/pi of the mean of n.p / |p|^4 over the triangle: collapsed product
    Gauss rule, after subdivision to 0.3 of the distance."""
    nearest = min(dot(v, v) for v in (v0, v1, v2))
    widest = max(dot(e, e) for e in (sub(v1, v0), sub(v2, v1), sub(v0, v2)))
    if widest > 0.09 * nearest:
        m0, m1, m2 = (scaled(0.5, add(a, b))
                      for a, b in ((v1, v2), (v2, v0), (v0, v1)))
        parts = ((v0, m2, m1), (m2, v1, m0), (m1, m0, v2), (m2, m0, m1))
        return sum(cubature_triangle(case, *part, share / 4) for part in parts)
    ratio = math.sqrt(widest / nearest)
    nodes = GAUSS[4 if ratio <= 0.01 else 5 if ratio <= 0.03 else
                  6 if ratio <= 0.1 else 8]
    nx, ny, nz = case.n
    total = 0.0
    for s, ws in nodes:
        for t, wt in nodes:
            a, b, c = 1 - s, s * (1 - t), s * t
            x = a * v0[0] + b * v1[0] + c * v2[0]
            y = a * v0[1] + b * v1[1] + c * v2[1]
            z = a * v0[2] + b * v1[2] + c * v2[2]
            square = x * x + y * y + z * z
            total += ws * wt * s * (nx * x + ny * y + nz * z) / (square * square)
    return share * total / math.pi


def series(case):
    return fan(case, series_triangle)


def cubature(case):
    return fan(case, cubature_triangle)


FORMULAS = {
    "lambert-acos": lambert_acos, "lambert-atan2": lambert_atan2,
    "lambert-edge": lambert_edge, "vertex-lambert": vertex_lambert,
    "image-plane": image_plane, "directions": directions, "sphere": sphere,
    "projective": projective, "homogeneous": homogeneous, "unified": unified,
    "difference": difference, "series": series, "cubature": cubature,
}


def measure(job):
    """CSV lines of one regime."""
    (name, draw, parameters, without), polygons = job
    mpmath.mp.dps = 80
    rng = random.Random(f"{SEED} {name}")
    cases = [draw(rng, *parameters) for _ in range(polygons)]
    right = [truth(case) for case in cases]
    lines = []
    for formula, evaluate in FORMULAS.items():
        if formula in without:
            continue
        errors = []
        for case, e in zip(cases, right):
            try:
                error = float(abs(mpmath.mpf(evaluate(case)) - e) / abs(e))
            except (ArithmeticError, ValueError):
                error = math.inf
            errors.append(error if error == error else math.inf)
        lines.append(f"{name},{formula},{statistics.median(errors):.3g},"
                     f"{max(errors):.3g}")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--polygons", type=int, default=1000)
    parser.add_argument("--processes", type=int, default=2)
    options = parser.parse_args()
    jobs = [(regime, options.polygons) for regime in regimes()]
    print("regime,formula,median,max", flush=True)
    with multiprocessing.Pool(options.processes) as pool:
        for lines in pool.imap(measure, jobs):
            print("\n".join(lines), flush=True)


if __name__ == "__main__":
    main()
