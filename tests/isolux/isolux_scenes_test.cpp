// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of whole scenes: none is missing, and none crosses another or a
// jump.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/isolux.h"

#include "isolux/named_floor.h"
#include "support/portable_random.h"
#include "support/sweep.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// A chord of a contour, or a jump.
struct Piece {
  std::array<Flat, 2> ends;
  std::size_t contour = 0;  ///< index; or beyond, of a jump
  double level = 0;         ///< 0: of a jump
  double width = 0;
};

/// Pieces by the cells of a grid.
class PieceGrid {
 public:
  explicit PieceGrid(double cell) : cell_(cell) {}

  void Add(const Piece& piece) {
    const auto index = static_cast<int>(pieces_.size());
    pieces_.push_back(piece);
    ForCells(piece.ends, 0,
             [&](std::pair<int, int> cell) { cells_[cell].push_back(index); });
  }

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

  /// Calls f once or more for each piece within a distance of a segment.
  template <class F>
  void Near(const std::array<Flat, 2>& segment, double distance,
            const F& f) const {
    ForCells(segment, distance, [&](std::pair<int, int> cell) {
      const auto found = cells_.find(cell);
      if (found == cells_.end()) return;
      for (const int index : found->second)
        f(pieces_[static_cast<std::size_t>(index)]);
    });
  }

 private:
  template <class F>
  void ForCells(const std::array<Flat, 2>& s, double more, const F& f) const {
    const auto cell = [this](double x) {
      return static_cast<int>(std::floor(x / cell_));
    };
    for (int i = cell(std::min(s[0].x, s[1].x) - more);
         i <= cell(std::max(s[0].x, s[1].x) + more); ++i) {
      for (int k = cell(std::min(s[0].y, s[1].y) - more);
           k <= cell(std::max(s[0].y, s[1].y) + more); ++k) {
        f(std::pair<int, int>(i, k));
      }
    }
  }

  double cell_;
  std::vector<Piece> pieces_;
  std::map<std::pair<int, int>, std::vector<int>> cells_;
};

template <class FlatOf>
PieceGrid GridOf(const Isolux& isolux, const FlatOf& flat) {
  PieceGrid grid(isolux.size / 128);
  for (std::size_t i = 0; i < isolux.contours.size(); ++i) {
    const IsoluxContour& contour = isolux.contours[i];
    const auto chords = ChordsOf(contour, flat);
    for (std::size_t k = 0; k < chords.size(); ++k)
      grid.Add({chords[k], i, contour.level, contour.widths[k]});
  }
  for (const SurfaceLine& line : isolux.lines.lines) {
    if (line.kind != SurfaceLineKind::kJump) continue;
    grid.Add({{flat(line.ends[0]), flat(line.ends[1])},
              isolux.contours.size(),
              0,
              0});
  }
  return grid;
}

void ExpectNoCrossings(const PieceGrid& grid) {
  std::size_t compared = 0;
  for (const Piece& piece : grid.pieces()) {
    grid.Near(piece.ends, 0, [&](const Piece& other) {
      if (other.level <= piece.level) return;
      ++compared;
      EXPECT_FALSE(Cross(piece.ends, other.ends))
          << "levels " << piece.level << " and " << other.level << " at "
          << piece.ends[0].x << ", " << piece.ends[0].y;
    });
  }
  EXPECT_GT(compared, 100U);
}

/// Between two points with E on both sides of a level there is a contour of it,
/// a jump, or an open triangle.
template <class FlatOf, class At>
void ExpectNoneIsMissing(const Oracle& oracle, const Isolux& isolux,
                         const PieceGrid& grid, const FlatOf& flat,
                         const At& at, std::uint64_t seed) {
  PortableRandom random(seed);
  std::size_t passed = 0;
  std::size_t tried = 0;
  const int count = SweepSize(4000, 40000);
  for (int i = 0; i < count; ++i) {
    const Receiver p = at(random.Unit(), random.Unit());
    const double turn = random.Uniform(0, 6.2831);
    const double way = random.Uniform(0, 0.05) * isolux.size;
    Receiver q = p;
    const Flat from = flat(p.position);
    const Flat to = {from.x + way * std::cos(turn),
                     from.y + way * std::sin(turn)};
    if (FlatXY(q.position).y == from.y) {
      q.position.x = to.x;
      q.position.y = to.y;
    } else {
      q.position.x = to.x;
      q.position.z = to.y;
    }
    const std::array<Flat, 2> segment = {from, to};
    const double e_p = oracle.Evaluate(p).value[0];
    const double e_q = oracle.Evaluate(q).value[0];
    ++tried;
    for (const double level : isolux.levels) {
      if ((e_p > level) == (e_q > level)) continue;
      bool is_crossed = false;
      grid.Near(segment, isolux.size / 128, [&](const Piece& piece) {
        if (piece.level != level && piece.level != 0) return;
        // A chord may be off by its width.
        const double width =
            std::isfinite(piece.width) ? piece.width : isolux.size / 500;
        is_crossed = is_crossed || Cross(segment, piece.ends) ||
                     DistanceTo(from, piece.ends) <= width ||
                     DistanceTo(to, piece.ends) <= width;
      });
      EXPECT_TRUE(is_crossed)
          << level << " between " << e_p << " at " << from.x << ", " << from.y
          << " and " << e_q << " at " << to.x << ", " << to.y;
      passed += is_crossed ? 1 : 0;
    }
  }
  EXPECT_GT(passed, tried / 10);
}

TEST(IsoluxScenes, TheCornellFloor) {
  const Scene scene = ExampleScene("cornell_box.obj");
  const Oracle oracle(scene);
  IsoluxOptions options;
  options.channel = ScalarChannel::kRed;
  options.threads = 2;
  const Isolux isolux = IsoluxOf(oracle, "floor", options);
  EXPECT_EQ(isolux.levels.size(), 10U);
  EXPECT_LT(isolux.open_area, 1e-6 * isolux.area);
  std::size_t vertices = 0;
  for (const IsoluxContour& contour : isolux.contours) {
    vertices += contour.vertices.size();
    for (const IsoluxVertex& v : contour.vertices) {
      EXPECT_TRUE(v.is_certified);
      EXPECT_LE(v.half_width, 1e-9 * isolux.size);
    }
  }
  EXPECT_GT(vertices, 5000U);
  EXPECT_LT(static_cast<double>(isolux.line_evaluations),
            6.0 * static_cast<double>(vertices));
  const PieceGrid grid = GridOf(isolux, FlatXZ);
  ExpectNoCrossings(grid);
  const auto at = [](double u, double v) {
    return Receiver{{30 + 490 * u, 0, 30 + 490 * v}, {0, 1, 0}, 1};
  };
  ExpectNoneIsMissing(oracle, isolux, grid, FlatXZ, at, 1);
}

TEST(IsoluxScenes, ThePinwheel) {
  const Scene scene = ExampleScene("figure7_c.obj");
  const Oracle oracle(scene);
  IsoluxOptions options;
  options.levels = {0.05, 0.06, 0.15};
  options.channel = ScalarChannel::kRed;
  options.threads = 2;
  const Isolux isolux = IsoluxOf(oracle, "floor", options);
  EXPECT_LT(isolux.open_area, 1e-6 * isolux.area);
  const PieceGrid grid = GridOf(isolux, FlatXY);
  ExpectNoCrossings(grid);
  const auto at = [](double u, double v) {
    return Receiver{{-5.6 + 11.2 * u, -5.6 + 11.2 * v, 0}, {0, 0, 1}, 1};
  };
  ExpectNoneIsMissing(oracle, isolux, grid, FlatXY, at, 2);
}

// Coordinates of maps have few bits left for what is small.
TEST(IsoluxScenes, FarFromTheOrigin) {
  const auto found = [](double offset) {
    const auto moved = [&](std::vector<Point3> ring) {
      for (Point3& p : ring)
        p = {p.x + offset, p.y + offset, p.z + offset};
      return ring;
    };
    SceneBuilder builder("scene");
    builder.SetGroup("floor");
    builder.AddFace(moved(Floor(-2, 2, -2, 2, 0)));
    builder.SetGroup("rest");
    builder.AddFace(
        moved({{-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}}),
        {10, 10, 10});
    builder.AddFace(
        moved({{-1, 0.125, 0}, {1, 0.5, 0}, {1, 0.5, 1}, {-1, 0.125, 1}}));
    const Result<Scene> scene = builder.Build();
    IsoluxOptions options;
    options.levels = {0.2, 0.4};
    options.smallest = 1e-3;
    return FloorIsolux(*scene.value, options);
  };
  const Isolux near = found(0);
  const Isolux far = found(1 << 20);
  EXPECT_GT(near.contours.size(), 1U);
  EXPECT_EQ(far.contours.size(), near.contours.size());
  ASSERT_EQ(far.lines.lines.size(), near.lines.lines.size());
  bool has_jump = false;
  for (std::size_t i = 0; i < near.lines.lines.size(); ++i) {
    const SurfaceLine& line = near.lines.lines[i];
    if (line.kind != SurfaceLineKind::kJump) continue;
    has_jump = true;
    EXPECT_GT(std::fabs(line.left[0] - line.right[0]), 0.1);
    EXPECT_NEAR(far.lines.lines[i].left[0], line.left[0], 1e-6);
    EXPECT_NEAR(far.lines.lines[i].right[0], line.right[0], 1e-6);
  }
  EXPECT_TRUE(has_jump);
}

}  // namespace
}  // namespace truelux
