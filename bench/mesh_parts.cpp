// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_parts.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>

#include "exact/vec3.h"

namespace truelux::bench {
namespace {

using Vec = Vec3<double>;

/// A point of a grid on an octahedron: |i| + |j| + |k| is the same everywhere.
using GridPoint = std::array<int, 3>;

Vec UnitOf(const Vec& v) {
  return 1 / std::sqrt(Dot(v, v)) * v;
}

/// Where the corners of a blob lie.
class BlobShape {
 public:
  explicit BlobShape(PortableRandom& random) {
    for (double& phase : phases_)
      phase = random.Uniform(0, 2 * std::numbers::pi);
    for (Bump& bump : bumps_) {
      bump.axis = RandomUnit(random);
      bump.height = random.Uniform(0.1, 0.3);
      bump.width = random.Uniform(0.03, 0.3);
    }
  }

  /// The grid is drawn together in some places, so that areas differ.
  [[nodiscard]] Vec Direction(const GridPoint& p) const {
    const Vec d = UnitOf({1.0 * p[0], 1.0 * p[1], 1.0 * p[2]});
    return UnitOf({d.x + 0.25 * std::sin(2 * d.y + phases_[0]),
                   d.y + 0.25 * std::sin(2 * d.z + phases_[1]),
                   d.z + 0.25 * std::sin(2 * d.x + phases_[2])});
  }

  [[nodiscard]] double Radius(const Vec& d) const {
    double radius =
        0.6 + 0.06 * std::sin(3 * d.x + phases_[1]) * std::sin(4 * d.z);
    for (const Bump& bump : bumps_)
      radius += bump.height * std::exp((Dot(d, bump.axis) - 1) / bump.width);
    return radius;
  }

 private:
  struct Bump {
    Vec axis{0, 0, 1};
    double height = 0;
    double width = 0;  ///< 1 - cosine of the angle where it is 1 / e as high
  };

  std::array<double, 3> phases_{};
  std::array<Bump, 5> bumps_;
};

/// Calls add(p, q, r) for the triangles of an octahedron's grid, fronts
/// outwards; each edge of the octahedron is cut in n.
template <class Add>
void VisitOctahedron(int n, Add add) {
  for (int octant = 0; octant < 8; ++octant) {
    const GridPoint sign = {(octant & 1) == 0 ? 1 : -1,
                            (octant & 2) == 0 ? 1 : -1,
                            (octant & 4) == 0 ? 1 : -1};
    const bool is_mirrored = sign[0] * sign[1] * sign[2] < 0;
    const auto add_signed = [&](GridPoint p, GridPoint q, GridPoint r) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        p[axis] *= sign[axis];
        q[axis] *= sign[axis];
        r[axis] *= sign[axis];
      }
      if (is_mirrored) {
        add(p, r, q);
      } else {
        add(p, q, r);
      }
    };
    for (int a = 0; a < n; ++a) {
      for (int b = 0; a + b < n; ++b) {
        const int c = n - 1 - a - b;
        add_signed({a + 1, b, c}, {a, b + 1, c}, {a, b, c + 1});
        if (c > 0)
          add_signed({a + 1, b, c}, {a + 1, b + 1, c - 1}, {a, b + 1, c});
      }
    }
  }
}

/// Two triangles for each cell of a grid; at(i, j): its corners.
template <class At>
void AppendCells(std::vector<Ring>& mesh, int rows, int columns, At at) {
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      mesh.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

}  // namespace

std::vector<Ring> BlobMesh(PortableRandom& random, int n, const Point3& centre,
                           double size, double noise) {
  const BlobShape shape(random);
  std::map<GridPoint, Point3> corners;
  const auto at = [&](const GridPoint& p) {
    const auto found = corners.find(p);
    if (found != corners.end()) return found->second;
    const Vec d = shape.Direction(p);
    const double radius =
        size * (shape.Radius(d) + noise * random.Uniform(-1, 1));
    const Point3 corner{centre.x + radius * d.x, centre.y + radius * d.y,
                        centre.z + radius * d.z};
    corners.emplace(p, corner);
    return corner;
  };
  std::vector<Ring> mesh;
  VisitOctahedron(
      n, [&](const GridPoint& p, const GridPoint& q, const GridPoint& r) {
        mesh.push_back({at(p), at(q), at(r)});
      });
  return mesh;
}

std::vector<Ring> TorusMesh(int around, int across, const Point3& centre,
                            double radius, double tube) {
  const auto at = [&](int i, int j) -> Point3 {
    const double u = 2 * std::numbers::pi * (i % around) / around;
    const double v = 2 * std::numbers::pi * (j % across) / across;
    const double r = radius + tube * std::cos(v);
    return {centre.x + r * std::cos(u), centre.y + r * std::sin(u),
            centre.z + tube * std::sin(v)};
  };
  std::vector<Ring> mesh;
  AppendCells(mesh, around, across, at);
  return mesh;
}

std::vector<Ring> BoxMesh(int n, const Point3& a, const Point3& b) {
  // Ends are taken as they are, so that sides share their corners.
  const auto between = [n](double from, double to, int i) {
    return i == n ? to : from + (to - from) * i / n;
  };
  const auto x = [&](int i) { return between(a.x, b.x, i); };
  const auto y = [&](int i) { return between(a.y, b.y, i); };
  const auto z = [&](int i) { return between(a.z, b.z, i); };
  std::vector<Ring> mesh;
  AppendCells(mesh, n, n, [&](int i, int j) {
    return Point3{x(j), y(i), a.z};
  });
  AppendCells(mesh, n, n, [&](int i, int j) {
    return Point3{x(i), y(j), b.z};
  });
  AppendCells(mesh, n, n, [&](int i, int j) {
    return Point3{x(i), a.y, z(j)};
  });
  AppendCells(mesh, n, n, [&](int i, int j) {
    return Point3{x(j), b.y, z(i)};
  });
  AppendCells(mesh, n, n, [&](int i, int j) {
    return Point3{a.x, y(j), z(i)};
  });
  AppendCells(mesh, n, n, [&](int i, int j) {
    return Point3{b.x, y(i), z(j)};
  });
  return mesh;
}

std::vector<Ring> Turned(std::vector<Ring> mesh, const Point3& around,
                         double angle) {
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  for (Ring& ring : mesh) {
    for (Point3& p : ring) {
      const double x = p.x - around.x;
      const double y = p.y - around.y;
      p.x = around.x + cosine * x - sine * y;
      p.y = around.y + sine * x + cosine * y;
    }
  }
  return mesh;
}

void AppendMesh(std::vector<TestFace>& faces, const std::vector<Ring>& mesh) {
  for (const Ring& ring : mesh)
    faces.push_back({ring, testing::kBlack});
}

}  // namespace truelux::bench
