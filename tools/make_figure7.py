#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_figure7.py FOLDER: four scenes after the words that describe Figure 7
of Stark and Riesenfeld (2000), as figure7_a.obj to figure7_d.obj and their
MTL files:

  a  evenly arranged blockers (two layers of tiles, one turned against the
     other) whose shadows make interference patterns
  b  1000 thin triangles under a large crescent
  c  a source of many polygons above a plate with small holes
  d  an object that shadows itself

The same numbers come out everywhere: coordinates are rounded to a few
decimals, and random ones come from a generator written out here."""

import math
import pathlib
import sys


class Scene:
    """Collects faces; equal corners are one vertex."""

    def __init__(self, comment, materials):
        self.comment, self.materials = comment, materials
        self.vertices, self.faces = {}, []

    def add(self, name, material, *rings):
        """Adds rings of points, counter-clockwise seen from the front."""
        self.faces += [f"o {name}", f"usemtl {material}"]
        for ring in rings:
            corners = [self.vertices.setdefault(
                tuple(number(x) for x in p), len(self.vertices) + 1) for p in ring]
            self.faces.append("f " + " ".join(map(str, corners)))

    def write(self, folder, name):
        lines = ["# " + line for line in self.comment] + [f"mtllib {name}.mtl"]
        lines += ["v " + " ".join(v) for v in self.vertices]
        (folder / f"{name}.obj").write_text("\n".join(lines + self.faces) + "\n")
        (folder / f"{name}.mtl").write_text("".join(
            f"newmtl {m}\nKe {ke}\n" for m, ke in self.materials.items()))


def number(x):
    """Three decimals at most; never -0."""
    return f"{round(x, 3) + 0.0:.3f}".rstrip("0").rstrip(".")


class Random:
    """Knuth's linear congruential generator MMIX, its upper 53 bits."""

    def __init__(self, seed):
        self.state = seed

    def uniform(self, low, high):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return low + (high - low) * (self.state >> 11) / 2**53


def square(x, y, z, width, turn=(1, 0)):
    """Looks up. turn: cosine and sine of its frame."""
    c, s = turn
    h = width / 2
    return [(c * a - s * b, s * a + c * b, z)
            for a, b in ((x - h, y - h), (x + h, y - h), (x + h, y + h), (x - h, y + h))]


def down(ring):
    """The same face looking the other way."""
    return ring[::-1]


def scene_a():
    scene = Scene(["Two layers of 12 x 12 tiles, one turned by atan(0.1), under a square lamp."],
                  {"white": "0 0 0", "lamp": "40 40 40"})
    scene.add("floor", "white", square(0, 0, 0, 11))
    angle = math.atan(0.1)
    for name, z, turn in (("lower", 2.25, (1, 0)),
                          ("upper", 2.75, (math.cos(angle), math.sin(angle)))):
        scene.add(name, "white", *(square(i / 2 - 2.75, j / 2 - 2.75, z, 0.27, turn)
                                   for i in range(12) for j in range(12)))
    scene.add("lamp", "lamp", down(square(0, 0, 9, 0.5)))
    return scene


def crescent(radius, outer, inner, height):
    """A circle without another that is smaller and shifted along x, as a
    polygon of outer + inner edges; looks down."""
    shift, hollow = 0.4 * radius, 0.85 * radius
    x = (shift**2 + radius**2 - hollow**2) / (2 * shift)
    y = math.sqrt(radius**2 - x**2)
    a, b = math.atan2(y, x), math.atan2(y, x - shift)
    ring = [(radius * math.cos(t), radius * math.sin(t))
            for t in (a + (2 * math.pi - 2 * a) * i / outer for i in range(outer + 1))]
    ring += [(shift + hollow * math.cos(t), hollow * math.sin(t))
             for t in (-b - (2 * math.pi - 2 * b) * i / inner for i in range(1, inner))]
    return down([(u + radius / 2, v, height) for u, v in ring])


def thin_triangle(random):
    """0.6 to 1.3 long and 0.14 wide, nearly level, within a disc that is denser
    in the middle."""
    t = random.uniform(0, 2 * math.pi)
    along = random.uniform(0.3, 0.65)
    a, r = random.uniform(0, 2 * math.pi), 3.7 * random.uniform(0, 1) ** 0.65
    x, y, z = r * math.cos(a), r * math.sin(a), random.uniform(0.25, 0.35)
    dx, dy, dz = along * math.cos(t), along * math.sin(t), random.uniform(-0.05, 0.05)
    nx, ny = -0.07 * math.sin(t), 0.07 * math.cos(t)
    return [(x - dx + nx, y - dy + ny, z - dz), (x - dx - nx, y - dy - ny, z - dz),
            (x + dx, y + dy, z + dz)]


def scene_b():
    scene = Scene(["1000 thin triangles between a floor and a crescent."],
                  {"white": "0 0 0", "lamp": "10 10 10"})
    scene.add("floor", "white", square(0, 0, 0, 8))
    random = Random(7)
    scene.add("triangles", "white", *(thin_triangle(random) for _ in range(1000)))
    scene.add("lamp", "lamp", crescent(4, 16, 8, 8))
    return scene


def scene_c():
    scene = Scene(["A pinwheel of coloured triangles above a plate with nine holes."],
                  {"white": "0 0 0", "red": "60 6 6", "green": "8 44 8",
                   "blue": "8 14 70", "yellow": "52 40 4"})
    scene.add("floor", "white", square(0, 0, 0, 12))
    # The plate: strips between rows of holes, and what is left of each row.
    centres, widths, half, z = (-2, 0, 2), (0.125, 0.25, 0.5), 3, 3
    faces, y0 = [], -half

    def rectangle(xa, xb, ya, yb):
        faces.append([(xa, ya, z), (xb, ya, z), (xb, yb, z), (xa, yb, z)])

    for y, width in zip(centres, widths):
        rectangle(-half, half, y0, y - width / 2)
        x0 = -half
        for x in centres:
            rectangle(x0, x - width / 2, y - width / 2, y + width / 2)
            x0 = x + width / 2
        rectangle(x0, half, y - width / 2, y + width / 2)
        y0 = y + width / 2
    rectangle(-half, half, y0, half)
    scene.add("plate", "white", *faces)
    for k, colour in enumerate(("red", "green", "blue", "yellow")):
        blade = [(0, 0), (1.5, 0), (1.5, 1)]
        for _ in range(k):
            blade = [(-y, x) for x, y in blade]
        scene.add(f"blade_{colour}", colour, down([(x, y, 9) for x, y in blade]))
    return scene


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def middle(*face):
    """The corner of the dodecahedron in the middle of an icosahedron's face:
    at the distance where the planes of the stars' edges cross."""
    centre = [sum(c) for c in zip(*face)]
    scale = 2 * math.sqrt(3) / (1 + math.sqrt(5)) / math.hypot(*centre)
    return tuple(scale * x for x in centre)


def scene_d():
    scene = Scene(["A stellated dodecahedron under a square lamp."],
                  {"white": "0 0 0", "lamp": "40 40 40"})
    scene.add("floor", "white", square(0, 0, 0, 12))
    phi = (1 + math.sqrt(5)) / 2
    # Its twelve tips are the corners of an icosahedron with edges of length 2.
    tips = [p for s in (-1, 1) for t in (-phi, phi)
            for p in ((0, s, t), (s, t, 0), (t, 0, s))]

    def neighbours(p):
        return [q for q in tips if abs(math.dist(p, q) - 2) < 0.1]

    rings = []
    for tip in tips:
        for p in neighbours(tip):
            for q in neighbours(tip):
                # A pyramid's face is between two corners of the dodecahedron
                # inside, which are in the middles of two neighbouring faces of
                # the icosahedron. Taken once, in the order that looks out.
                for r in neighbours(tip):
                    if q in neighbours(p) and r in neighbours(p) and q != r and \
                            dot(cross(tip, p), q) > 0:
                        rings.append([tip, middle(tip, r, p), middle(tip, p, q)])
    rings = [[(1.5 * x, 1.5 * y, 1.5 * z + 2.87) for x, y, z in ring] for ring in rings]
    scene.add("star", "white", *rings)
    scene.add("lamp", "lamp", down([(x - 4, y - 3, z) for x, y, z in square(0, 0, 10, 1)]))
    return scene


def main():
    if sys.argv[1:] in (["-h"], ["--help"]):
        print(__doc__)
        return
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    for name, scene in (("a", scene_a()), ("b", scene_b()),
                        ("c", scene_c()), ("d", scene_d())):
        scene.write(folder, f"figure7_{name}")


main()
