// SPDX-License-Identifier: GPL-3.0-or-later
// Where on a surface the gradient jumps: known answers, and the oracle's kinks
// at points of the traces.

#include "surface/kink_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
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

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr Rgb kUnit = {1, 1, 1};
const TestFace kGround = {Floor(-8, 8, -8, 8, 0)};

RationalVector PointOf(const mpq_class& x, const mpq_class& y) {
  return {x, y, 0};
}

/// A scene whose first face lies in z = 0 and looks up, with what it has.
class Ground {
 public:
  explicit Ground(const std::vector<TestFace>& above,
                  const TestFace& ground = kGround)
      : scene_(MakeScene(WithGround(above, ground))) {
    const std::array<int, 1> faces = {0};
    std::string defect;
    frame_ = SurfaceFrameOf(scene_, faces, defect).value();
    planes_ = EdgePlanesOf(scene_, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  }

  [[nodiscard]] const Scene& scene() const { return scene_; }

  [[nodiscard]] const EdgePlanes& planes() const { return planes_; }

  /// The plane with a normal and an offset; throws if there is none.
  [[nodiscard]] std::size_t PlaneOf(const std::array<int, 3>& normal,
                                    const mpq_class& offset) const {
    const auto found =
        std::ranges::find_if(planes_.planes, [&](const EdgePlane& plane) {
          return plane.normal.x == normal[0] && plane.normal.y == normal[1] &&
                 plane.normal.z == normal[2] && plane.offset == offset;
        });
    if (found == planes_.planes.end()) throw std::out_of_range("no plane");
    return static_cast<std::size_t>(found - planes_.planes.begin());
  }

  [[nodiscard]] std::vector<KinkPiece> Pieces(
      std::size_t plane, const RationalVector& from, const RationalVector& to,
      bool reversed_side = false) const {
    return KinkPiecesOf(scene_, frame_, planes_, plane, from, to,
                        reversed_side);
  }

  /// Of the plane x = 0, from y = -8 to 8.
  [[nodiscard]] std::vector<KinkPiece> PiecesAtX0(
      bool reversed_side = false) const {
    return Pieces(PlaneOf({1, 0, 0}, 0), PointOf(0, -8), PointOf(0, 8),
                  reversed_side);
  }

 private:
  static std::vector<TestFace> WithGround(std::vector<TestFace> faces,
                                          const TestFace& ground) {
    faces.insert(faces.begin(), ground);
    return faces;
  }

  Scene scene_;
  SurfaceFrame frame_;
  EdgePlanes planes_;
};

/// The kink across x = 0 at (0, y) by the oracle; 0 without one.
Rgb KinkAcrossX(const Scene& scene, double y) {
  const Derivatives derivatives =
      Oracle(scene).Derivatives(Receiver{{0, y, 0}, {0, 0, 1}, 1});
  for (const Kink& kink : derivatives.kinks) {
    if (kink.normal == Vector3{1, 0, 0}) return kink.size;
  }
  return {};
}

void ExpectNear(const Rgb& found, const Rgb& expected) {
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(found[k], expected[k], 1e-12 * std::fabs(expected[k]));
}

void ExpectPieceAtX0(const KinkPiece& piece, const mpq_class& from,
                     const mpq_class& to) {
  EXPECT_EQ(piece.from.y, from);
  EXPECT_EQ(piece.to.y, to);
  EXPECT_EQ(piece.from.x, 0);
  EXPECT_EQ(piece.from.z, 0);
}

const TestFace kLampAbove = {Ceiling(-2, 2, -1, 1, 4), kUnit};

// Edges over x = 0 from y = -1 to 1 at the heights 1 and 2, as in case K02.
TEST(KinkPieces, TwoParallelEdgesBeforeALamp) {
  const Ground ground(
      {kLampAbove, {Ceiling(0, 1, -1, 1, 1)}, {Ceiling(0, 1, -1, 1, 2)}});
  const auto pieces = ground.PiecesAtX0();
  // Both appear before the lamp where (-1 - y) / 4 < 1 - y, y < 5 / 3.
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.front().from.y, mpq_class(-5, 3));
  EXPECT_EQ(pieces.back().to.y, mpq_class(5, 3));
  EXPECT_EQ(pieces.size(), 1U);
  ExpectNear(pieces[0].size, KinkAcrossX(ground.scene(), 0));
  EXPECT_GT(std::fabs(pieces[0].size[0]), 1e-3);
  EXPECT_TRUE(pieces[0].faces.empty());
  ASSERT_EQ(pieces[0].edges.size(), 2U);
  EXPECT_NE(pieces[0].edges[0], pieces[0].edges[1]);
  EXPECT_TRUE(ground.PiecesAtX0(true).empty());
}

TEST(KinkPieces, PartsOfATraceAreCutThere) {
  const Ground ground(
      {kLampAbove, {Ceiling(0, 1, -1, 1, 1)}, {Ceiling(0, 1, -1, 1, 2)}});
  const std::size_t plane = ground.PlaneOf({1, 0, 0}, 0);
  const auto part = ground.Pieces(plane, PointOf(0, 1), PointOf(0, -1));
  ASSERT_EQ(part.size(), 1U);
  ExpectPieceAtX0(part[0], 1, -1);
  ExpectNear(part[0].size, KinkAcrossX(ground.scene(), 0));
  EXPECT_TRUE(
      ground.Pieces(plane, PointOf(0, mpq_class(5, 3)), PointOf(0, 7)).empty());
  EXPECT_THROW(
      static_cast<void>(ground.Pieces(plane, PointOf(0, 1), PointOf(1, 1))),
      std::invalid_argument);
  EXPECT_THROW(
      static_cast<void>(ground.Pieces(plane, PointOf(0, 1), PointOf(0, 1))),
      std::invalid_argument);
}

// Edges that are one behind the other from other places only.
TEST(KinkPieces, CausesCutAPiece) {
  const Ground ground({kLampAbove,
                       {Ceiling(0, 1, -1, 1, 1)},
                       {Ceiling(0, 1, -1, 0, 2)},
                       {Ceiling(-1, 0, 0, 1, 2)}});
  const auto pieces = ground.PiecesAtX0();
  ASSERT_EQ(pieces.size(), 3U);
  // The near edge hides the end at y = 0 of both far ones for |y| < 2, and the
  // lamp ends at y = -1 and 1, at the height 4.
  ExpectPieceAtX0(pieces[0], mpq_class(-5, 3), -1);
  ExpectPieceAtX0(pieces[1], -1, 1);
  ExpectPieceAtX0(pieces[2], 1, mpq_class(5, 3));
  EXPECT_EQ(pieces[0].edges.size(), 2U);
  EXPECT_EQ(pieces[1].edges.size(), 3U);
  EXPECT_EQ(pieces[2].edges.size(), 2U);
}

// A wall in x = 0 that stays above the ground.
TestFace WallAbove(const Rgb& front) {
  return {{{0, -0.5, 1}, {0, 0.5, 1}, {0, 0.5, 1.5}, {0, -0.5, 1.5}}, front};
}

TEST(KinkPieces, AFaceSeenEdgeOn) {
  const Ground ground({kLampAbove, WallAbove({})});
  const auto pieces = ground.PiecesAtX0();
  // The lamp's end (1, 4) is over the wall's ends (-1/2, 3/2) and (-1/2, 1), its
  // other end likewise: sides of the wall are before the lamp, or not.
  const std::vector<mpq_class> ends = {mpq_class(-7, 5), -1, mpq_class(-1, 5),
                                       mpq_class(1, 5),  1,  mpq_class(7, 5)};
  ASSERT_EQ(pieces.size() + 1, ends.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ExpectPieceAtX0(pieces[i], ends[i], ends[i + 1]);
    EXPECT_EQ(pieces[i].faces, std::vector<int>{3});
  }
  ExpectNear(pieces[2].size, KinkAcrossX(ground.scene(), 0));
}

TEST(KinkPieces, AFaceThatEmitsTwiceWhatIsBehindItIsNone) {
  // The lamp fills all that the wall is before.
  const TestFace lamp = {Ceiling(-9, 9, -90, 90, 4), kUnit};
  EXPECT_TRUE(Ground({lamp, WallAbove({2, 2, 2})}).PiecesAtX0().empty());
  EXPECT_FALSE(Ground({lamp, WallAbove({1, 1, 1})}).PiecesAtX0().empty());
  const Ground some({lamp, WallAbove({1, 2, 3})});
  const auto pieces = some.PiecesAtX0();
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size[1], 0);
  ExpectNear(pieces[0].size, KinkAcrossX(some.scene(), 0));
}

TEST(KinkPieces, AFarLineThatBoundsNoLightIsNone) {
  // The blocker far away has nothing behind it, or ends where its like begins.
  EXPECT_TRUE(Ground({{Ceiling(2, 3, -1, 1, 4), kUnit},
                      {Ceiling(0, 1, -1, 1, 1)},
                      {Ceiling(0, 1, -1, 1, 2)}})
                  .PiecesAtX0()
                  .empty());
  EXPECT_TRUE(Ground({{Ceiling(0, 2, -1, 1, 4), kUnit},
                      {Ceiling(-2, 0, -1, 1, 4), kUnit},
                      {Ceiling(0, 1, -1, 1, 1)}})
                  .PiecesAtX0()
                  .empty());
  EXPECT_FALSE(Ground({{Ceiling(0, 2, -1, 1, 4), kUnit},
                       {Ceiling(-2, 0, -1, 1, 4), {2, 1, 1}},
                       {Ceiling(0, 1, -1, 1, 1)}})
                   .PiecesAtX0()
                   .empty());
}

TEST(KinkPieces, AThirdFaceHides) {
  std::vector<TestFace> faces = {kLampAbove,
                                 {Ceiling(0, 1, -1, 1, 1)},
                                 {Ceiling(0, 1, -1, 1, 2)},
                                 {Ceiling(-1, 1, -9, 9, 0.5)}};
  EXPECT_TRUE(Ground(faces).PiecesAtX0().empty());
  // A half of it: from y = 0 it hides what lies at y > 0.
  faces[3] = {Ceiling(-1, 1, 0, 9, 0.5)};
  const auto pieces = Ground(faces).PiecesAtX0();
  ASSERT_EQ(pieces.size(), 1U);
  ExpectPieceAtX0(pieces[0], mpq_class(-5, 3), mpq_class(1, 7));
}

TEST(KinkPieces, AnInnerDiagonalIsNone) {
  // A non-planar lamp would bend there; a planar one is one facet.
  const Ground ground(
      {{{{-1, -1, 4}, {0, 1, 4}, {1, -1, 4}, {0, -2, 4}}, kUnit},
       {Ceiling(0, 1, -1, 1, 1)}});
  EXPECT_THROW(static_cast<void>(ground.PiecesAtX0()), std::out_of_range);
  const Ground cut({{{{0, -2, 4}, {-1, -1, 4}, {0, 1, 4}, {1, -1, 4}}, kUnit},
                    {Ceiling(0, 1, -1, 1, 1)},
                    {Ceiling(5, 6, -1, 1, 1)}});
  EXPECT_THROW(static_cast<void>(cut.PiecesAtX0()), std::out_of_range);
}

TEST(KinkPieces, WhereAFaceStandsOnTheSurfaceThereIsNone) {
  const TestFace wall = {{{0, -1, 0}, {0, 1, 0}, {0, 1, 2}, {0, -1, 2}}};
  const Ground ground({kLampAbove, wall});
  const auto pieces = ground.PiecesAtX0();
  ASSERT_EQ(pieces.size(), 2U);
  // The lamp's end at (-1, 4) over the wall's top at (1, 2): y = 3.
  ExpectPieceAtX0(pieces[0], -3, -1);
  ExpectPieceAtX0(pieces[1], 1, 3);
  ExpectNear(pieces[1].size, KinkAcrossX(ground.scene(), 2));
}

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
      if (t < 0 || t > 1) continue;
      if (t == 0 || t == 1) {
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

TEST(KinkPieces, AreTheOraclesKinksOnLattices) {
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
