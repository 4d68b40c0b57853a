// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/regime_shadows.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "baselines/case_chart.h"

namespace truelux {
namespace {

constexpr double kPi = std::numbers::pi;

ChartPoint operator+(const ChartPoint& a, const ChartPoint& b) {
  return {a.x + b.x, a.y + b.y};
}

ChartPoint operator-(const ChartPoint& a, const ChartPoint& b) {
  return {a.x - b.x, a.y - b.y};
}

ChartPoint operator*(double s, const ChartPoint& a) {
  return {s * a.x, s * a.y};
}

ChartPoint Direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

using ChartTriangle = std::array<ChartPoint, 3>;

/// A line of the chart with a point on it; `along` and `across` are unit
/// vectors, `across` to the left of `along`.
struct ChartLine {
  ChartPoint point;
  ChartPoint along;
  ChartPoint across;

  static ChartLine At(const ChartPoint& point, double angle) {
    const ChartPoint d = Direction(angle);
    return {point, d, {-d.y, d.x}};
  }

  [[nodiscard]] ChartPoint To(double t, double offset) const {
    return point + (t * along + offset * across);
  }
};

/// A source in a chart, and the blockers before it.
class Shadows {
 public:
  /// The source's corners are 0.35 to 0.5 from the middle, clockwise; the disk
  /// of radius 0.1 about the middle is inside.
  explicit Shadows(CaseRandom& random)
      : random_(random),
        chart_(AnyChart(random)),
        distance_(random.Uniform(0.5, 5)) {
    const double turn = random.Uniform(0, 2 * kPi);
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle = turn - 2 * kPi / 3 * static_cast<double>(i);
      const double radius = random.Uniform(0.35, 0.5);
      source_[i] = radius * Direction(angle + random.Uniform(-0.2, 0.2));
    }
    Add(source_, distance_, 0.4, {1, 1, 1});
  }

  [[nodiscard]] const ChartTriangle& source() const { return source_; }

  /// The source's first edge from its first corner on, with the inside on the
  /// right, and its length.
  [[nodiscard]] std::pair<ChartLine, double> FirstEdge() const {
    const ChartPoint d = source_[1] - source_[0];
    return {ChartLine::At(source_[0], std::atan2(d.y, d.x)),
            std::hypot(d.x, d.y)};
  }

  /// A point at most 0.07 from the middle.
  ChartPoint NearTheMiddle() {
    return {random_.Uniform(-0.05, 0.05), random_.Uniform(-0.05, 0.05)};
  }

  /// In front of the source, the i-th of at most three from the receiver, and
  /// tilted a little.
  void AddBlocker(const ChartTriangle& corners, int i) {
    const double depth = 0.2 + 0.12 * i + random_.Uniform(0, 0.1);
    Add(corners, depth * distance_, 0.2, {});
  }

  /// A blocker of 6 x 4 with its first edge on the line at that offset, on its
  /// left (1) or right (-1): nothing of the source on that side is seen.
  void AddHalfPlane(const ChartLine& line, double offset, double side, int i) {
    const double depth = 0.2 + 0.12 * i + random_.Uniform(0, 0.1);
    Add({line.To(-3, offset), line.To(3, offset), line.To(0, side * 4)},
        depth * distance_, 0.02, {});
  }

  RegimeCase Finish() {
    Result<Scene> scene = builder_.Build();
    if (!scene.ok()) throw std::logic_error(scene.diagnostics[0].Text());
    return {*std::move(scene.value), {{}, {0, 0, 1}, 0}, {}};
  }

 private:
  static CaseChart AnyChart(CaseRandom& random) {
    const double azimuth = random.Uniform(-kPi, kPi);
    return CaseChart::Looking(azimuth, random.Uniform(0.8, 1.5));
  }

  /// On a plane that meets the axis at that distance.
  void Add(const ChartTriangle& corners, double distance, double most_tilt,
           const Rgb& emission) {
    const double a = random_.Uniform(-most_tilt, most_tilt);
    const double b = random_.Uniform(-most_tilt, most_tilt);
    std::vector<Point3> ring;
    for (const ChartPoint& q : corners)
      ring.push_back(chart_.At(q, distance / (1 - a * q.x - b * q.y)));
    builder_.AddFace(std::move(ring), emission);
  }

  CaseRandom& random_;
  CaseChart chart_;
  double distance_;
  ChartTriangle source_;
  SceneBuilder builder_;
};

/// A triangle with its first edge on the line at that offset and its third
/// corner on one side.
ChartTriangle OnLine(CaseRandom& random, const ChartLine& line, double offset,
                     double side) {
  const double from = -random.Uniform(0.2, 0.4);
  const double to = random.Uniform(0.2, 0.4);
  const double apex = random.Uniform(-0.2, 0.2);
  return {line.To(from, offset), line.To(to, offset),
          line.To(apex, offset + side * random.Uniform(0.2, 0.4))};
}

}  // namespace

RegimeCase NearConjunction(CaseRandom& random, double miss) {
  Shadows shadows(random);
  const ChartPoint p = shadows.NearTheMiddle();
  const double turn = random.Uniform(0, kPi);
  const double offset = random.Sign() * miss;
  for (int i = 0; i < 3; ++i) {
    const double angle = turn + kPi / 3 * i + random.Uniform(-0.25, 0.25);
    shadows.AddBlocker(OnLine(random, ChartLine::At(p, angle),
                              i == 2 ? offset : 0, random.Sign()),
                       i);
  }
  return shadows.Finish();
}

RegimeCase VertexNearEdge(CaseRandom& random, double miss) {
  Shadows shadows(random);
  const bool of_source = random.Below(2) == 0;
  const ChartPoint p = shadows.NearTheMiddle();
  const ChartLine open = ChartLine::At(p, random.Uniform(0, 2 * kPi));
  const auto [edge, length] = shadows.FirstEdge();
  const double from =
      of_source ? random.Uniform(0.3, 0.7) * length : random.Uniform(-0.1, 0.1);
  const double offset = random.Sign() * miss;
  const ChartLine& line = of_source ? edge : open;
  const double back = -random.Uniform(0.05, 0.15);
  const double ahead = random.Uniform(0.05, 0.15);
  shadows.AddBlocker(
      {line.To(from, offset), line.To(from + back, -random.Uniform(0.1, 0.3)),
       line.To(from + ahead, -random.Uniform(0.1, 0.3))},
      0);
  shadows.AddBlocker(OnLine(random, open, 0, 1), 1);
  return shadows.Finish();
}

RegimeCase NearlyEqualEdges(CaseRandom& random, double miss) {
  Shadows shadows(random);
  const auto [edge, length] = shadows.FirstEdge();
  const double offset = random.Sign() * miss;
  const double apex = random.Uniform(0.3, 0.7) * length;
  shadows.AddBlocker({edge.To(random.Uniform(-0.3, 0.4) * length, offset),
                      edge.To(random.Uniform(0.6, 1.3) * length, offset),
                      edge.To(apex, -random.Uniform(0.1, 0.25))},
                     0);
  return shadows.Finish();
}

RegimeCase Slit(CaseRandom& random, double width) {
  Shadows shadows(random);
  const auto [edge, length] = shadows.FirstEdge();
  const ChartLine middle{edge.To(length / 2, 0), edge.along, edge.across};
  shadows.AddHalfPlane(middle, -width, -1, 0);
  return shadows.Finish();
}

RegimeCase ThinBlockers(CaseRandom& random, double width) {
  Shadows shadows(random);
  const ChartPoint p = shadows.NearTheMiddle();
  const double turn = random.Uniform(0, kPi);
  for (int i = 0; i < 3; ++i) {
    const double angle = turn + kPi / 3 * i + random.Uniform(-0.25, 0.25);
    const ChartLine line = ChartLine::At(p + shadows.NearTheMiddle(), angle);
    const double from = -random.Uniform(0.6, 0.9);
    shadows.AddBlocker({line.To(from, -width / 2), line.To(from, width / 2),
                        line.To(random.Uniform(0.6, 0.9), 0)},
                       i);
  }
  return shadows.Finish();
}

RegimeCase Pinhole(CaseRandom& random, double size) {
  Shadows shadows(random);
  const ChartPoint p = shadows.NearTheMiddle();
  const double turn = random.Uniform(0, 2 * kPi);
  for (int i = 0; i < 3; ++i) {
    const double angle = turn + 2 * kPi / 3 * i + random.Uniform(-0.2, 0.2);
    shadows.AddHalfPlane(ChartLine::At(p, angle),
                         random.Uniform(0.3, 0.6) * size, 1, i);
  }
  return shadows.Finish();
}

}  // namespace truelux
