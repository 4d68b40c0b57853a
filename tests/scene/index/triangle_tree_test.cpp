// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "scene/index/hull_twin.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using testing::HullTwin;
using testing::PortableRandom;

/// The triangles of a scene; the first one or two are its source.
struct Soup {
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;
  std::size_t source_size = 1;

  void Add(const Point3& a, const Point3& b, const Point3& c) {
    const int first = static_cast<int>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c});
    triangles.push_back({{first, first + 1, first + 2}, 0});
  }

  void AddQuadSource(const Point3& a, const Point3& b, const Point3& c,
                     const Point3& d) {
    vertices = {a, b, c, d};
    triangles = {{{0, 1, 2}, 0}, {{0, 2, 3}, 0}};
    source_size = 2;
  }

  [[nodiscard]] std::span<const Triangle> source() const {
    return std::span(triangles).first(source_size);
  }

  [[nodiscard]] Box BoxOf(const Triangle& triangle) const {
    Box box;
    for (const int v : triangle.vertices)
      box.Include(vertices[static_cast<std::size_t>(v)]);
    return box;
  }
};

/// A kind of scene, in the unit cube or so, with a scale.
struct Kind {
  std::string name;
  int exponent = 0;
  bool lattice = false;
  bool flat = false;       ///< everything in planes of equal z
  double triangle = 2.0;   ///< size of a triangle
  double receivers = 0.1;  ///< size of the block of receivers
};

const std::vector<Kind> kKinds = {
    {.name = "soup"},
    {.name = "small triangles", .triangle = 0.1},
    {.name = "lattice", .lattice = true},
    {.name = "flat", .flat = true, .triangle = 0.3},
    {.name = "flat lattice", .lattice = true, .flat = true},
    {.name = "one receiver", .triangle = 0.3, .receivers = 0},
    {.name = "huge", .exponent = 1000, .triangle = 0.3},
    {.name = "huge lattice", .exponent = 1000, .lattice = true},
    {.name = "tiny", .exponent = -1000, .triangle = 0.3},
    {.name = "denormal", .exponent = -1060, .triangle = 0.3},
    {.name = "denormal lattice", .exponent = -1072, .lattice = true},
};

class RandomSoup {
 public:
  RandomSoup(const Kind& kind, PortableRandom& random)
      : kind_(kind), random_(random) {}

  Point3 Around(const Point3& centre, double size) {
    return {Coordinate(centre.x, size), Coordinate(centre.y, size),
            kind_.flat ? centre.z : Coordinate(centre.z, size)};
  }

  Soup Make(int count) {
    Soup soup;
    const double s = std::ldexp(1, kind_.exponent);
    if (random_.OneIn(2)) {
      soup.AddQuadSource({-s, -s, 3 * s}, {-s, s, 3 * s}, {s, s, 3 * s},
                         {s, -s, 3 * s});
    } else {
      soup.Add(Around({-s, 0, 3 * s}, 1), Around({s, s, 3 * s}, 1),
               Around({s, -s, 3 * s}, 1));
    }
    while (static_cast<int>(soup.triangles.size()) < count) {
      const Point3 centre{Coordinate(0, 3), Coordinate(0, 3), Coordinate(s, 3)};
      soup.Add(Around(centre, kind_.triangle), Around(centre, kind_.triangle),
               Around(centre, kind_.triangle));
    }
    return soup;
  }

 private:
  double Coordinate(double centre, double size) {
    const double offset =
        kind_.lattice ? random_.Integer(-2, 2) : random_.Uniform(-size, size);
    return centre + std::ldexp(offset, kind_.exponent);
  }

  const Kind& kind_;
  PortableRandom& random_;
};

std::vector<int> Visited(const TriangleTree& tree, const Shaft& shaft) {
  std::vector<int> visited;
  tree.Visit(shaft, [&](int t) { visited.push_back(t); });
  return visited;
}

std::vector<int> Visited(const TriangleTree& tree, const Shaft& shaft,
                         const TreeCut& cut) {
  std::vector<int> visited;
  tree.Visit(shaft, cut, [&](int t) { visited.push_back(t); });
  return visited;
}

std::vector<int> Sorted(std::vector<int> numbers) {
  std::ranges::sort(numbers);
  return numbers;
}

/// The triangles whose own box the shaft keeps.
std::vector<int> Kept(const Soup& soup, const Shaft& shaft) {
  std::vector<int> kept;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (shaft.Keeps(soup.BoxOf(soup.triangles[t])))
      kept.push_back(static_cast<int>(t));
  }
  return kept;
}

/// The triangles that meet the hull of a receiver and the source; none if it
/// has no volume.
std::vector<int> Meeting(const Soup& soup, const Point3& receiver) {
  std::vector<int> meeting;
  const HullTwin twin(soup.vertices, soup.source(), receiver);
  if (!twin.has_volume()) return meeting;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (twin.Meets(soup.triangles[t])) meeting.push_back(static_cast<int>(t));
  }
  return meeting;
}

/// Whether `part` is `whole` with some numbers left out.
bool IsSubsequence(const std::vector<int>& part,
                   const std::vector<int>& whole) {
  auto next = whole.begin();
  return std::ranges::all_of(part, [&](int x) {
    next = std::find(next, whole.end(), x);
    return next != whole.end() && (++next, true);
  });
}

/// Checks what is visited for receivers of one block; returns how many
/// triangles meet their hulls.
int CheckVisits(const Soup& soup, const std::vector<Point3>& receivers) {
  Box block;
  for (const Point3& r : receivers)
    block.Include(r);
  const RoundUpward rounding;
  const TriangleTree tree(soup.vertices, soup.triangles);
  const ShaftSource source(soup.vertices, soup.source());
  TreeCut cut;
  tree.Narrow(Shaft(source, block), cut);
  int met = 0;
  for (const Point3& r : receivers) {
    const Shaft shaft(source, Box::Of(r));
    const std::vector<int> all = Visited(tree, shaft);
    EXPECT_EQ(Sorted(all), Kept(soup, shaft));
    const std::vector<int> narrowed = Visited(tree, shaft, cut);
    EXPECT_TRUE(IsSubsequence(narrowed, all));
    const std::vector<int> meeting = Meeting(soup, r);
    EXPECT_TRUE(std::ranges::includes(Sorted(narrowed), meeting));
    met += static_cast<int>(meeting.size());
  }
  return met;
}

class TriangleTreeOfKind : public ::testing::TestWithParam<Kind> {};

TEST_P(TriangleTreeOfKind, VisitsWhatMeetsTheHull) {
  const Kind& kind = GetParam();
  PortableRandom random(7);
  RandomSoup maker(kind, random);
  int met = 0;
  for (int i = 0; i < 60; ++i) {
    const Soup soup = maker.Make(i % 2 == 0 ? random.Integer(2, 20) : 100);
    const Point3 centre = maker.Around({0, 0, 0}, 1);
    std::vector<Point3> receivers(4);
    for (Point3& r : receivers)
      r = maker.Around(centre, kind.receivers);
    met += CheckVisits(soup, receivers);
    ASSERT_FALSE(HasFailure()) << i;
  }
  EXPECT_GT(met, 500);
}

INSTANTIATE_TEST_SUITE_P(Kinds, TriangleTreeOfKind, ::testing::ValuesIn(kKinds),
                         [](const auto& parameter) {
                           std::string name = parameter.param.name;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

/// Keeps everything that these tests build.
Shaft WideShaft(const ShaftSource& source) {
  return {source, {{-1e308, -1e308, -1e308}, {1e308, 1e308, 1e308}}};
}

void ExpectAllOnce(const Soup& soup) {
  const RoundUpward rounding;
  const TriangleTree tree(soup.vertices, soup.triangles);
  const ShaftSource source(soup.vertices, soup.source());
  const Shaft shaft = WideShaft(source);
  const std::vector<int> visited = Visited(tree, shaft);
  std::vector<int> all(soup.triangles.size());
  for (std::size_t t = 0; t < all.size(); ++t)
    all[t] = static_cast<int>(t);
  EXPECT_EQ(Sorted(visited), all);
  TreeCut cut;
  tree.Narrow(shaft, cut);
  EXPECT_EQ(Visited(tree, shaft, cut), visited);
  EXPECT_EQ(Visited(TriangleTree(soup.vertices, soup.triangles), shaft),
            visited);
}

TEST(TriangleTree, OfNothingVisitsNothing) {
  Soup soup;
  soup.Add({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  const RoundUpward rounding;
  const Shaft shaft = WideShaft(ShaftSource(soup.vertices, soup.source()));
  for (const TriangleTree& tree :
       {TriangleTree(), TriangleTree(soup.vertices, {})}) {
    EXPECT_TRUE(Visited(tree, shaft).empty());
    TreeCut cut;
    tree.Narrow(shaft, cut);
    EXPECT_TRUE(cut.empty());
    EXPECT_TRUE(Visited(tree, shaft, cut).empty());
  }
}

TEST(TriangleTree, VisitsEachTriangleOnce) {
  PortableRandom random(8);
  const Kind kind{.name = "small triangles", .triangle = 0.1};
  for (int count = 1; count < 200; ++count) {
    Soup soup = RandomSoup(kind, random).Make(count);
    soup.triangles.resize(static_cast<std::size_t>(count));
    soup.source_size = 1;
    ExpectAllOnce(soup);
  }
}

TEST(TriangleTree, DividesWhatCannotBeDividedByPlace) {
  Soup soup;
  for (int i = 0; i < 5000; ++i)
    soup.Add({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  ExpectAllOnce(soup);
}

TEST(TriangleTree, HasFewLevelsEvenIfPlacesGrowLikePowers) {
  Soup soup;
  for (int i = -1070; i < 1020; ++i) {
    for (const double sign : {-1.0, 1.0}) {
      const double x = std::ldexp(sign, i);
      soup.Add({x, 0, 0}, {x, x / 2, 0}, {0, x, x});
      soup.Add({0, x, 0}, {x, x / 2, 0}, {0, x, x});
      soup.Add({0, 0, x}, {x, x / 2, 0}, {0, x, x});
    }
  }
  ExpectAllOnce(soup);
}

TEST(TriangleTree, LeavesOutMostOfALargeScene) {
  PortableRandom random(9);
  Soup soup;
  soup.AddQuadSource({-0.1, -0.1, 1}, {-0.1, 0.1, 1}, {0.1, 0.1, 1},
                     {0.1, -0.1, 1});
  const auto near = [&](const Point3& p) {
    return Point3{random.Uniform(p.x, p.x + 0.01),
                  random.Uniform(p.y, p.y + 0.01),
                  random.Uniform(p.z, p.z + 0.01)};
  };
  for (int i = 0; i < 50000; ++i) {
    const Point3 p{random.Uniform(-2, 2), random.Uniform(-2, 2),
                   random.Uniform(-1, 2)};
    soup.Add(near(p), near(p), near(p));
  }
  const RoundUpward rounding;
  const TriangleTree tree(soup.vertices, soup.triangles);
  const ShaftSource source(soup.vertices, soup.source());
  for (int i = 0; i < 20; ++i) {
    const Point3 r{random.Uniform(-2, 2), random.Uniform(-2, 2), -1};
    const Shaft shaft(source, Box::Of(r), Vector3{0, 0, 1});
    const std::vector<int> visited = Visited(tree, shaft);
    // The pyramid has 1/2000 of the volume; so small, the boxes add little.
    EXPECT_GT(visited.size(), 10U);
    EXPECT_LT(visited.size(), 150U);
    TreeCut cut;
    tree.Narrow(shaft, cut);
    EXPECT_EQ(Visited(tree, shaft, cut), visited);
  }
}

}  // namespace
}  // namespace truelux
