// SPDX-License-Identifier: GPL-3.0-or-later
// The kinks of a surface are those of the oracle at points of traces, on
// lattices where everything coincides.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"
#include "truelux/irradiance.h"

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/sweep.h"
#include "surface/ground.h"
#include "surface/kink_pieces.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// What has been compared at points of traces.
struct Counts {
  int scenes = 0;
  int kinks = 0;
  int zeros = 0;     ///< points without a kink
  int lit = 0;       ///< of these those with a kink elsewhere on the trace
  int faces = 0;     ///< kinks of faces in their plane
  int partial = 0;   ///< kinks of some channels
  int cuts = 0;      ///< kinks at lines where faces pierce each other
  int pierced = 0;   ///< of all those that the oracle finds at points, those
                     ///< that a cut makes
  int ends = 0;      ///< points at ends of pieces
  int touching = 0;  ///< points on another face
};

/// Rectangles across the axes, some of which stand on z = 0 or go through it.
TestFace RandomShelf(PortableRandom& random) {
  for (;;) {
    const int axis = random.Integer(0, 2);
    const auto point = [&random] {
      return Point3{1.0 * random.Integer(-3, 3), 1.0 * random.Integer(-3, 3),
                    1.0 * random.Integer(random.OneIn(3) ? -1 : 1, 4)};
    };
    const Point3 a = point();
    const Point3 b = point();
    Ring ring = {a, a, b, b};
    for (Point3& p : ring) {
      if (axis == 0) p.x = a.x;
      if (axis == 1) p.y = a.y;
      if (axis == 2) p.z = a.z;
    }
    (axis == 0 ? ring[1].y : ring[1].x) = axis == 0 ? b.y : b.x;
    (axis == 0 ? ring[3].y : ring[3].x) = axis == 0 ? a.y : a.x;
    if (OnOneLine(ring[0], ring[1], ring[2])) continue;
    const double m = random.OneIn(2) ? random.Integer(1, 4) : 0;
    return {ring, {m, random.OneIn(2) ? 0.5 * m : 0, m > 0 ? 2.0 : 0}};
  }
}

/// A wall that pierces the lamp z = 4 at x = 2k, and a shelf with an edge in
/// x = k, z = 2: seen from x = 0, z = 0, the edge covers the cut.
void AddPiercedLamp(PortableRandom& random, std::vector<TestFace>& faces) {
  const double k = random.Integer(-2, 2);
  const double up = random.Integer(-2, 2);
  const double y0 = random.Integer(-3, 0);
  const double y1 = random.Integer(1, 3);
  const Ring wall = {{2 * k - 1, y0, 4 - up},
                     {2 * k - 1, y1, 4 - up},
                     {2 * k + 1, y1, 4 + up},
                     {2 * k + 1, y0, 4 + up}};
  const double width = random.OneIn(2) ? 1 : -1;
  const Ring shelf = Ceiling(k, k + width, y0, random.Integer(1, 3), 2);
  faces.push_back({Ceiling(-6, 6, -2, 3, 4), {2, 1, 1}});
  faces.push_back({random.OneIn(2) ? Reversed(wall) : wall,
                   {random.OneIn(2) ? 3.0 : 0, 0, 1}});
  faces.push_back({random.OneIn(2) ? Reversed(shelf) : shelf});
}

std::vector<TestFace> RandomFaces(PortableRandom& random) {
  std::vector<TestFace> faces;
  if (random.OneIn(3)) {
    AddPiercedLamp(random, faces);
    if (random.OneIn(2)) return faces;
  }
  const int shelves = random.Integer(2, 7);
  while (static_cast<int>(faces.size()) < shelves)
    faces.push_back(RandomShelf(random));
  for (TestFace face : RandomScene(random, true, random.Integer(0, 4), 3)) {
    for (Point3& p : face.ring)
      p.z += 2;
    faces.push_back(face);
  }
  const double x = random.Integer(-3, 0);
  const double y = random.Integer(-3, 0);
  faces.push_back({Ceiling(x, x + random.Integer(2, 6), y,
                           y + random.Integer(2, 6), random.Integer(3, 5)),
                   kLamp});
  return faces;
}

/// The double that a rational number is, if it is one.
std::optional<double> DoubleOf(const mpq_class& q) {
  const double x = q.get_d();
  if (mpq_class(x) != q) return std::nullopt;
  return x;
}

/// The kink across a plane; null if there is none.
const Kink* KinkAcross(const std::vector<Kink>& kinks, const EdgePlane& plane) {
  const Vector3 n = ToDouble(plane.normal);
  const double length = std::hypot(n.x, n.y, n.z);
  for (const Kink& kink : kinks) {
    const Vector3& m = kink.normal;
    if (std::hypot(m.x - n.x / length, m.y - n.y / length, m.z - n.z / length) <
            1e-14 ||
        std::hypot(m.x + n.x / length, m.y + n.y / length, m.z + n.z / length) <
            1e-14) {
      return &kink;
    }
  }
  return nullptr;
}

class Comparison {
 public:
  Comparison(const Ground& ground, Counts& counts)
      : ground_(ground), oracle_(ground.scene()), counts_(counts) {}

  void Compare(std::size_t index, PortableRandom& random) {
    const EdgePlane& plane = ground_.planes().planes[index];
    const mpz_class& a = plane.normal.x;
    const mpz_class& b = plane.normal.y;
    if (a == 0 && b == 0) return;
    const bool by_x = abs(b) >= abs(a);
    const auto at = [&](const mpq_class& s) {
      if (by_x) return PointOf(s, (plane.offset - a * s) / b);
      return PointOf((plane.offset - b * s) / a, s);
    };
    const mpq_class reach = 5;
    const auto pieces = ground_.Pieces(index, at(mpq_class(-reach)), at(reach));
    for (const KinkPiece& piece : pieces)
      CompareSize(index, piece);
    for (int i = 0; i < 2; ++i) {
      const mpq_class s = mpq_class(random.Integer(-40, 40)) / 8;
      ComparePoint(index, at(s), pieces);
    }
  }

 private:
  static mpq_class AlongOf(const RationalVector& from, const RationalVector& to,
                           const RationalVector& p) {
    return Dot(to - from, p - from) / Dot(to - from, to - from);
  }

  /// The oracle's kinks at a point; nothing if it lies on a face or is no
  /// double.
  std::optional<std::vector<Kink>> KinksAt(const RationalVector& p) {
    const auto x = DoubleOf(p.x);
    const auto y = DoubleOf(p.y);
    if (!x || !y) return std::nullopt;
    const Derivatives derivatives =
        oracle_.Derivatives(Receiver{{*x, *y, 0}, {0, 0, 1}, 1},
                            {.sphere = false, .jacobian = false});
    if (derivatives.smoothness == Smoothness::kDiscontinuous) {
      ++counts_.touching;
      return std::nullopt;
    }
    return derivatives.kinks;
  }

  /// A piece's middle, where its size is known, if that is a double.
  void CompareSize(std::size_t index, const KinkPiece& piece) {
    const mpq_class half(1, 2);
    CompareKink(index, half * (piece.from + piece.to), piece);
  }

  void CompareKink(std::size_t index, const RationalVector& p,
                   const KinkPiece& piece) {
    const auto kinks = KinksAt(p);
    if (!kinks) return;
    const Kink* kink = KinkAcross(*kinks, ground_.planes().planes[index]);
    // The size may pass through 0.
    if (kink == nullptr && piece.size == Rgb{}) return;
    ASSERT_NE(kink, nullptr) << p.x << ' ' << p.y << " size " << piece.size[0];
    ++counts_.kinks;
    for (const Kink& other : *kinks)
      ExpectPlane(other, p);
    ExpectNear(piece.size, kink->size);
    if (std::ranges::count(kink->size, 0) > 0) ++counts_.partial;
    if (!piece.faces.empty()) ++counts_.faces;
    std::vector<int> faces = kink->faces;
    std::ranges::sort(faces);
    EXPECT_TRUE(std::ranges::includes(faces, piece.faces));
    if (piece.faces.empty() && piece.edges.size() < 2) ++counts_.cuts;
  }

  /// A kink at a point must lie in a plane that is known.
  void ExpectPlane(const Kink& kink, const RationalVector& p) {
    if (kink.faces.empty() && (kink.edges[0][0] < 0 || kink.edges[1][0] < 0))
      ++counts_.pierced;
    EXPECT_TRUE(std::ranges::any_of(
        ground_.planes().planes, [&](const EdgePlane& plane) {
          return plane.normal.x * p.x + plane.normal.y * p.y == plane.offset &&
                 KinkAcross({kink}, plane) != nullptr;
        }));
  }

  void ComparePoint(std::size_t index, const RationalVector& p,
                    const std::vector<KinkPiece>& pieces) {
    for (const KinkPiece& piece : pieces) {
      const mpq_class t = AlongOf(piece.from, piece.to, p);
      if (sgn(t) < 0 || cmp(t, 1) > 0) continue;
      if (sgn(t) == 0 || cmp(t, 1) == 0) {
        ++counts_.ends;
        return;
      }
      // With the point in the middle.
      const mpq_class reach = t < mpq_class(1, 2) ? t : mpq_class(1 - t);
      const RationalVector arm = reach * (piece.to - piece.from);
      const auto middle = ground_.Pieces(index, p - arm, p + arm);
      ASSERT_EQ(middle.size(), 1U);
      EXPECT_EQ(middle[0].edges, piece.edges);
      EXPECT_EQ(middle[0].faces, piece.faces);
      CompareKink(index, p, middle[0]);
      return;
    }
    const auto kinks = KinksAt(p);
    if (!kinks) return;
    for (const Kink& kink : *kinks)
      ExpectPlane(kink, p);
    EXPECT_EQ(KinkAcross(*kinks, ground_.planes().planes[index]), nullptr)
        << p.x << ' ' << p.y;
    ++counts_.zeros;
    if (!pieces.empty()) ++counts_.lit;
  }

  const Ground& ground_;
  Oracle oracle_;
  Counts& counts_;
};

TEST(KinkLattice, AreTheOraclesKinksOnLattices) {
  Counts counts;
  for (int seed = 0; seed < SweepSize(8, 200); ++seed) {
    PortableRandom random(static_cast<std::uint64_t>(seed) + 77000);
    const Ground ground(RandomFaces(random));
    Comparison comparison(ground, counts);
    ++counts.scenes;
    for (std::size_t i = 0; i < ground.planes().planes.size(); ++i)
      comparison.Compare(i, random);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  for (const auto& [name, count] : std::vector<std::pair<std::string, int>>{
           {"scenes", counts.scenes},
           {"kinks", counts.kinks},
           {"zeros", counts.zeros},
           {"lit", counts.lit},
           {"faces", counts.faces},
           {"partial", counts.partial},
           {"cuts", counts.cuts},
           {"pierced", counts.pierced},
           {"ends", counts.ends},
           {"touching", counts.touching}}) {
    EXPECT_GT(count, 2) << name;
    RecordProperty(name, count);
  }
}

}  // namespace
}  // namespace truelux
