// SPDX-License-Identifier: GPL-3.0-or-later
#include "traced_contours.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "isolux/light_probe.h"
#include "isolux/plan_frame.h"
#include "surface/named_surface.h"

namespace truelux::bench {
namespace {

constexpr double kTolerance = 1e-9;  ///< by the range of E
constexpr double kNear = 2;          ///< ends that are the same, by h
/// Lengths that are the same, relative: ours has other chords.
constexpr double kSameLength = 0.05;

double Distance(const Point3& a, const Point3& b) {
  return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

double LengthOf(std::span<const Point3> points, bool is_closed) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    length += Distance(points[i], points[i + 1]);
  if (is_closed && !points.empty())
    length += Distance(points.back(), points.front());
  return length;
}

/// Follows contours one by one and adds up.
class ContourFollower {
 public:
  ContourFollower(const Oracle& oracle, const Isolux& isolux,
                  const TraceOptions& options)
      : plan_(oracle.scene(), SurfaceNamed(oracle.scene(), "floor").frame,
              false),
        probe_(oracle, plan_, {1, 0, 0}),
        options_(options) {
    options_.tolerance = kTolerance * (isolux.most - isolux.least);
    for (const auto& side : isolux.outline)
      options_.outline.push_back(SegmentOf(side));
    for (const SurfaceLine& line : isolux.lines.lines) {
      if (line.kind == SurfaceLineKind::kKink)
        kinks_.push_back(SegmentOf(line.ends));
    }
  }

  void Follow(const DrawnContour& truth) {
    const double length = LengthOf(truth.points, truth.is_closed);
    options_.level = truth.level;
    options_.most_points =
        static_cast<std::size_t>(2 * length / options_.step) + 10;
    // Contours may end at walls, where there is no gradient: the middle is away
    // from both ends.
    const PlanPoint start = PlaceOf(truth.points[truth.points.size() / 2]);
    const Trace ahead = TraceContour(probe_, start, false, options_);
    Add(ahead);
    DrawnContour drawn;
    drawn.level = truth.level;
    drawn.is_closed = ahead.end == TraceEnd::kClosed;
    std::vector<TraceEnd> ends = {ahead.end};
    if (!drawn.is_closed && !truth.is_closed) {
      const Trace behind = TraceContour(probe_, start, true, options_);
      Add(behind);
      ends.push_back(behind.end);
      // The start is a point of both.
      for (std::size_t i = behind.points.size(); i > 1; --i)
        drawn.points.push_back(plan_.PointAt(behind.points[i - 1].at));
    }
    for (const TracePoint& point : ahead.points)
      drawn.points.push_back(plan_.PointAt(point.at));
    if (IsComplete(drawn, truth, length)) {
      ++result_.completed;
    } else {
      for (const TraceEnd end : ends)
        ++result_.failed_ends[static_cast<std::size_t>(end)];
    }
    result_.points += drawn.points.size();
    result_.contours.push_back(std::move(drawn));
  }

  TracedContours Result() {
    result_.evaluations = probe_.count();
    result_.misses = SortedNumbers(std::move(misses_));
    return std::move(result_);
  }

 private:
  [[nodiscard]] PlanPoint PlaceOf(const Point3& p) const {
    const Vec3<double> place = plan_.PlaceOf(p);
    return {place.x, place.y};
  }

  [[nodiscard]] PlanSegment SegmentOf(const std::array<Point3, 2>& ends) const {
    return {PlaceOf(ends[0]), PlaceOf(ends[1])};
  }

  [[nodiscard]] bool IsComplete(const DrawnContour& drawn,
                                const DrawnContour& truth,
                                double length) const {
    if (drawn.points.empty() || drawn.is_closed != truth.is_closed)
      return false;
    const double near = kNear * options_.step;
    const double found = LengthOf(drawn.points, drawn.is_closed);
    if (!(std::fabs(found - length) <= kSameLength * length + 2 * near))
      return false;
    return drawn.is_closed ||
           (Distance(drawn.points.front(), truth.points.front()) <= near &&
            Distance(drawn.points.back(), truth.points.back()) <= near);
  }

  [[nodiscard]] bool IsLarge(const TracePoint& point) const {
    return point.miss && *point.miss > kLargeMiss * options_.step;
  }

  void Add(const Trace& trace) {
    const std::span<const TracePoint> points = trace.points;
    for (const TracePoint& point : points) {
      if (point.miss) misses_.push_back(*point.miss / options_.step);
      if (IsLarge(point)) ++result_.large_misses;
    }
    const auto history =
        static_cast<std::size_t>(HistoryOf(options_.predictor));
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const auto crossed =
          std::ranges::count_if(kinks_, [&](const PlanSegment& kink) {
            return DoSegmentsCross(kink, {points[i].at, points[i + 1].at});
          });
      if (crossed == 0) continue;
      ++result_.kinks;
      const auto guessed =
          points.subspan(i + 1).first(std::min(history, points.size() - i - 1));
      if (std::ranges::any_of(
              guessed, [&](const TracePoint& point) { return IsLarge(point); }))
        ++result_.missed_kinks;
    }
  }

  PlanFrame plan_;
  LightProbe probe_;
  TraceOptions options_;
  std::vector<PlanSegment> kinks_;
  std::vector<double> misses_;
  TracedContours result_;
};

}  // namespace

double MeanChord(const Isolux& isolux) {
  double length = 0;
  std::size_t chords = 0;
  for (const DrawnContour& contour : DrawnContoursOf(isolux)) {
    length += LengthOf(contour.points, contour.is_closed);
    chords += contour.points.size() - (contour.is_closed ? 0 : 1);
  }
  return length / static_cast<double>(chords);
}

TracedContours TraceContours(const Oracle& oracle, const Isolux& isolux,
                             const TraceOptions& options) {
  ContourFollower follower(oracle, isolux, options);
  for (const DrawnContour& contour : DrawnContoursOf(isolux))
    follower.Follow(contour);
  return follower.Result();
}

}  // namespace truelux::bench
