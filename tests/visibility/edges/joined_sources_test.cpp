// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs between emitting faces that share an edge and emit the same are left
// out, and nothing else: values stay those of the slow twin.

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/evaluate.h"
#include "support/plain_contour.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// A lamp of n x n quads over |x|, |y| <= 2 whose heights come from height(i,
/// k) at the grid's points; all emit downwards, emission(i, k) each.
template <class Height, class EmissionOf>
std::vector<TestFace> LampMesh(int n, const Height& height,
                               const EmissionOf& emission) {
  const auto point = [&](int i, int k) {
    return Point3{-2 + 4.0 * i / n, -2 + 4.0 * k / n, height(i, k)};
  };
  std::vector<TestFace> faces;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      // Two triangles: a quad of a curved lamp is not planar.
      faces.push_back({{point(i, k), point(i, k + 1), point(i + 1, k + 1)},
                       emission(i, k)});
      faces.push_back({{point(i, k), point(i + 1, k + 1), point(i + 1, k)},
                       emission(i, k)});
    }
  }
  return faces;
}

struct Counts {
  std::size_t all = 0;
  std::size_t joined = 0;
};

/// The arcs with and without joining; the values must be the same.
Counts Compare(const Scene& scene, const Receiver& receiver) {
  const ContourEngine engine(scene);
  ContourQuery query{scene, receiver, {}, false};
  const Contour whole = engine.Build(query);
  query.join_sources = true;
  const Contour joined = engine.Build(query);
  const Rgb expected = EvaluateContour(query, PlainContour(query), {}).value;
  EXPECT_EQ(EvaluateContour(query, whole, {}).value, expected);
  EXPECT_EQ(EvaluateContour(query, joined, {}).value, expected);
  EXPECT_EQ(Oracle(scene).Evaluate(receiver).value, expected);
  return {whole.arcs.size(), joined.arcs.size()};
}

constexpr Rgb kWhite{1, 1, 1};

TEST(JoinedSources, APlanarMeshKeepsItsOutline) {
  const Scene scene = MakeScene(LampMesh(
      4, [](int, int) { return 3.0; }, [](int, int) { return kWhite; }));
  const Counts counts = Compare(scene, {{0.1, 0.2, 0}, {0.1, 0, 1}, 0});
  EXPECT_EQ(counts.all, 32U * 3);
  EXPECT_EQ(counts.joined, 16U);
}

TEST(JoinedSources, OnlyEqualEmissionsAreJoined) {
  const Scene scene = MakeScene(LampMesh(
      4, [](int, int) { return 3.0; },
      [](int i, int) {
        return i < 2 ? kWhite : Rgb{1, 1, 0.5};
      }));
  const Counts counts = Compare(scene, {{0, 0, 0}, {0, 0, 1}, 0});
  // The outline, and four edges along the middle, from both sides.
  EXPECT_EQ(counts.joined, 16U + 8U);
}

TEST(JoinedSources, BlockersOverTheEdgesChangeNothing) {
  PortableRandom random(1);
  std::size_t joined = 0;
  std::size_t all = 0;
  for (int i = 0; i < 60; ++i) {
    const bool lattice = i % 2 == 0;
    std::vector<double> heights;
    for (int k = 0; k < 16; ++k) {
      heights.push_back(lattice ? random.Integer(8, 10) * 0.5
                                : random.Uniform(4, 5));
    }
    std::vector<TestFace> faces = LampMesh(
        3,
        [&](int a, int b) {
          return heights[4 * static_cast<std::size_t>(a) +
                         static_cast<std::size_t>(b)];
        },
        [&](int a, int b) {
          return i % 3 == 0 && (a + b) % 2 == 0 ? Rgb{2, 1, 1} : kWhite;
        });
    for (TestFace& face : RandomScene(random, lattice, 6, 3)) {
      for (Point3& p : face.ring)
        p.z = p.z * 0.5 + 2;
      if (random.OneIn(2)) face.emission = kWhite;
      faces.insert(random.OneIn(2) ? faces.begin() : faces.end(), face);
    }
    const Scene scene = MakeScene(faces);
    const Receiver receiver{
        {random.Integer(-2, 2) * 0.5, random.Integer(-2, 2) * 0.5, 0},
        {0, random.Integer(-1, 1) * 1.0, 1},
        0};
    const Counts counts = Compare(scene, receiver);
    joined += counts.joined;
    all += counts.all;
  }
  EXPECT_LT(joined, all * 3 / 4);
}

TEST(JoinedSources, ThreeFacesOnOneEdge) {
  // Two coplanar halves of a lamp, and a third face of equal emission that
  // hangs from the edge between them.
  const Scene scene =
      MakeScene({{{{-1, -1, 2}, {-1, 1, 2}, {0, 1, 2}, {0, -1, 2}}, kWhite},
                 {{{0, -1, 2}, {0, 1, 2}, {1, 1, 2}, {1, -1, 2}}, kWhite},
                 {{{0, -1, 2}, {0, 1, 2}, {0, 1, 1.5}, {0, -1, 1.5}}, kWhite}});
  for (const double x : {-0.5, 0.0, 0.5})
    Compare(scene, {{x, 0.25, 0}, {0, 0, 1}, 0});
}

TEST(JoinedSources, ARoomThatEmitsEverywhereIsFull) {
  // Nothing but the horizon is left of the contour: E = M, exactly.
  std::vector<TestFace> faces;
  for (const Ring& ring : BoxAround(2))
    faces.push_back({ring, kWhite});
  const Scene scene = MakeScene(faces);
  const Counts counts = Compare(scene, {{0.3, -0.7, 0.2}, {1, 2, 3}, 0});
  EXPECT_LT(counts.joined, counts.all);
  const Rgb value =
      Oracle(scene).Evaluate({{0.3, -0.7, 0.2}, {1, 2, 3}, 0}).value;
  EXPECT_EQ(value, kWhite);
}

}  // namespace
}  // namespace truelux
