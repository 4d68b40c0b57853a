// SPDX-License-Identifier: GPL-3.0-or-later
#include "conjunctive_scenes.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "support/scenes.h"

namespace truelux::bench {
namespace {

using testing::PortableRandom;
using testing::Ring;
using testing::TestFace;

constexpr Rgb kWhite = {1, 1, 1};

/// A point of the source's plane, z = 1.
struct P2 {
  double x = 0;
  double y = 0;
};

/// A multiple of 2^-10.
double FewBits(PortableRandom& random, double low, double high) {
  return std::floor(random.Uniform(low, high) * 0x1p10) * 0x1p-10;
}

/// A displacement with few bits whose length is between 1/16 and 1/4.
P2 FewBitsStep(PortableRandom& random) {
  P2 d;
  double size = 0;
  do {
    d = {FewBits(random, -0.25, 0.25), FewBits(random, -0.25, 0.25)};
    size = std::hypot(d.x, d.y);
  } while (size < 0.0625 || size > 0.25);
  return d;
}

P2 FewBitsPoint(PortableRandom& random, double range) {
  return {FewBits(random, -range, range), FewBits(random, -range, range)};
}

/// The image of a ring of the source's plane at another height, seen from 0.
TestFace At(double z, const std::vector<P2>& image) {
  TestFace face;
  for (const P2& p : image)
    face.ring.push_back({p.x * z, p.y * z, z});
  return face;
}

P2 Moved(const P2& p, double s, const P2& d, double t = 0) {
  return {p.x + s * d.x - t * d.y, p.y + s * d.y + t * d.x};
}

/// The height of blocker i: no two are equal, few bits.
double Height(int i) {
  return (8 + i) / 32.0;
}

Receiver Looking(PortableRandom& random) {
  Receiver r{{0, 0, 0}, {0, 0, 1}, 0};
  if (random.OneIn(2)) {
    r.normal.x = random.Uniform(-0.4, 0.4);
    r.normal.y = random.Uniform(-0.4, 0.4);
  }
  return r;
}

ConjunctiveCase Finish(PortableRandom& random, std::vector<TestFace> faces,
                       double side = 1) {
  const double h = side / 2;
  faces.push_back({testing::Ceiling(-h, h, -h, h, 1), kWhite});
  return {testing::MakeScene(faces), Looking(random), side};
}

/// A triangle with an edge along d through p, on the side of the edge that
/// does not hold p + open.
std::vector<P2> BesideEdge(const P2& p, const P2& d, const P2& open) {
  const double side = d.x * open.y - d.y * open.x > 0 ? -1 : 1;
  return {Moved(p, -1, d), Moved(p, 1, d), Moved(p, 0.25, d, side)};
}

/// side: of the source and of what hides it, in the image plane.
ConjunctiveCase GeneralPosition(PortableRandom& random, int count,
                                double side) {
  const auto uniform = [&](double range) {
    return random.Uniform(-range * side, range * side);
  };
  std::vector<TestFace> faces;
  for (int i = 0; i < count; ++i) {
    const P2 c{uniform(0.5), uniform(0.5)};
    const P2 d{uniform(0.15), uniform(0.15)};
    faces.push_back(At(0.3 + 0.5 * i / count,
                       {c, Moved(c, 1, d, 0.2), Moved(c, 0.3, d, 0.9)}));
  }
  return Finish(random, std::move(faces), side);
}

/// The last edge is moved by `miss`.
ConjunctiveCase EdgesThroughPoint(PortableRandom& random, int count,
                                  double miss) {
  const P2 p = FewBitsPoint(random, 0.3);
  const P2 open = FewBitsStep(random);
  std::vector<TestFace> faces;
  for (int i = 0; i < count; ++i) {
    const P2 d = FewBitsStep(random);
    const bool is_moved = miss != 0 && i == count - 1;
    const double t = is_moved ? miss / std::hypot(d.x, d.y) : 0;
    faces.push_back(At(Height(i), BesideEdge(Moved(p, 0, d, t), d, open)));
  }
  return Finish(random, std::move(faces));
}

std::vector<P2> WithCorner(PortableRandom& random, const P2& p) {
  const P2 d = FewBitsStep(random);
  return {p, Moved(p, 1, d, 0.25), Moved(p, 1, d, -0.5)};
}

ConjunctiveCase VertexOnEdge(PortableRandom& random, double miss) {
  const P2 p = FewBitsPoint(random, 0.3);
  const P2 d = FewBitsStep(random);
  const P2 beside = Moved(p, 0, d, miss / std::hypot(d.x, d.y));
  const int vertex_first = random.Integer(0, 1);
  return Finish(random, {At(Height(vertex_first), WithCorner(random, p)),
                         At(Height(1 - vertex_first),
                            BesideEdge(beside, d, FewBitsStep(random)))});
}

ConjunctiveCase VertexOnEdgeOfSource(PortableRandom& random) {
  const P2 p{FewBits(random, -0.4, 0.4), 0.5};
  return Finish(random, {At(Height(1), WithCorner(random, p))});
}

ConjunctiveCase VertexBeforeCornerOfSource(PortableRandom& random) {
  return Finish(random, {At(Height(1), WithCorner(random, {-0.5, 0.5}))});
}

ConjunctiveCase VerticesInLine(PortableRandom& random, int count) {
  const P2 p = FewBitsPoint(random, 0.3);
  std::vector<TestFace> faces;
  for (int i = 0; i < count; ++i)
    faces.push_back(At(Height(i), WithCorner(random, p)));
  return Finish(random, std::move(faces));
}

ConjunctiveCase EdgesInPlane(PortableRandom& random) {
  const P2 p = FewBitsPoint(random, 0.3);
  const P2 d = FewBitsStep(random);
  const P2 q = Moved(p, FewBits(random, -1, 1), d);
  const P2 side{-d.y, d.x};
  const P2 other = random.OneIn(2) ? side : P2{d.y, -d.x};
  return Finish(random, {At(Height(0), BesideEdge(p, d, side)),
                         At(Height(1), BesideEdge(q, d, other))});
}

ConjunctiveCase EdgeAlongEdgeOfSource(PortableRandom& random) {
  const P2 p{FewBits(random, -0.4, 0.4), -0.5};
  const P2 d{FewBits(random, 0.125, 0.5), 0};
  const P2 open{0, random.OneIn(2) ? 1.0 : -1.0};
  return Finish(random, {At(Height(0), BesideEdge(p, d, open))});
}

/// Squares with sides of half the spacing, around the multiples of `spacing`.
void AddLayer(double z, double spacing, int reach,
              std::vector<TestFace>& faces) {
  for (int i = -reach; i <= reach; ++i) {
    for (int k = -reach; k <= reach; ++k) {
      const double x = i * spacing;
      const double y = k * spacing;
      const double h = spacing / 4;
      faces.push_back({testing::Ceiling(x - h, x + h, y - h, y + h, z)});
    }
  }
}

/// A receiver where edges of the layers can coincide.
ConjunctiveCase OnLattice(PortableRandom& random, double step,
                          std::vector<TestFace> faces) {
  ConjunctiveCase made = Finish(random, std::move(faces));
  made.receiver.position = {step * random.Integer(-6, 6),
                            step * random.Integer(-6, 6), 0};
  return made;
}

ConjunctiveCase Grids(PortableRandom& random) {
  std::vector<TestFace> faces;
  AddLayer(0.5, 0.125, 3, faces);
  AddLayer(0.75, 0.125, 3, faces);
  return OnLattice(random, 0x1p-5, std::move(faces));
}

void AddBox(const Point3& low, const Point3& high,
            std::vector<TestFace>& faces) {
  const auto [x0, y0, z0] = low;
  const auto [x1, y1, z1] = high;
  faces.push_back({testing::Ceiling(x0, x1, y0, y1, z0)});
  faces.push_back({testing::Floor(x0, x1, y0, y1, z1)});
  for (const auto& [a, b, c, d] :
       {std::array{x0, y0, x1, y0}, std::array{x1, y0, x1, y1},
        std::array{x1, y1, x0, y1}, std::array{x0, y1, x0, y0}}) {
    faces.push_back({{{a, b, z0}, {c, d, z0}, {c, d, z1}, {a, b, z1}}});
  }
}

ConjunctiveCase Boxes(PortableRandom& random) {
  std::vector<TestFace> faces;
  for (int i = -1; i <= 1; ++i) {
    for (int k = -1; k <= 1; ++k) {
      const double x = 0.25 * i;
      const double y = 0.25 * k;
      AddBox({x - 0.0625, y - 0.0625, 0.5}, {x + 0.0625, y + 0.0625, 0.625},
             faces);
    }
  }
  return OnLattice(random, 0x1p-4, std::move(faces));
}

}  // namespace

std::vector<ConjunctiveFamily> ConjunctiveFamilies() {
  using R = PortableRandom;
  std::vector<ConjunctiveFamily> families;
  const auto add = [&families](std::string name, auto make) {
    families.push_back({std::move(name), std::move(make)});
  };
  for (const int n : {10, 40, 160}) {
    add(fmt::format("{} triangles", n),
        [n](R& r) { return GeneralPosition(r, n, 1); });
  }
  for (int k = 2; k <= 4; ++k) {
    const double side = std::pow(10.0, -k);
    add(fmt::format("10 triangles, side 1e-{}", k),
        [side](R& r) { return GeneralPosition(r, 10, side); });
  }
  for (int k = 3; k <= 12; ++k) {
    add(fmt::format("{} edges through a point", k),
        [k](R& r) { return EdgesThroughPoint(r, k, 0); });
  }
  add("vertex on an edge", [](R& r) { return VertexOnEdge(r, 0); });
  add("vertex on an edge of the source", VertexOnEdgeOfSource);
  add("vertex before a corner of the source", VertexBeforeCornerOfSource);
  for (const int n : {2, 4}) {
    add(fmt::format("{} vertices in line", n),
        [n](R& r) { return VerticesInLine(r, n); });
  }
  add("two edges in a plane", EdgesInPlane);
  add("edge along an edge of the source", EdgeAlongEdgeOfSource);
  add("two grids of squares", Grids);
  add("boxes in rows", Boxes);
  for (int k = 2; k <= 16; ++k) {
    const double miss = std::pow(10.0, -k);
    add(fmt::format("3 edges missing by 1e-{}", k),
        [miss](R& r) { return EdgesThroughPoint(r, 3, miss); });
  }
  for (int k = 2; k <= 14; k += 2) {
    const double miss = std::pow(10.0, -k);
    add(fmt::format("vertex and edge missing by 1e-{}", k),
        [miss](R& r) { return VertexOnEdge(r, miss); });
  }
  return families;
}

}  // namespace truelux::bench
