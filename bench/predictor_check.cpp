// SPDX-License-Identifier: GPL-3.0-or-later
#include "predictor_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/scene.h"

#include "isolux/light_probe.h"
#include "isolux/plan_frame.h"
#include "predictor_tracer.h"
#include "surface/named_surface.h"

namespace truelux::bench {
namespace {

constexpr double kLampHeight = 2;
constexpr std::array<double, 2> kLampSide = {4, 6};  ///< in x and in y

Scene LampOverFloor() {
  SceneBuilder builder("lamp over a floor");
  builder.SetGroup("floor");
  builder.AddFace({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}});
  builder.SetGroup("lamp");
  const auto& [a, b] = kLampSide;
  builder.AddFace({{a, a, kLampHeight},
                   {a, b, kLampHeight},
                   {b, b, kLampHeight},
                   {b, a, kLampHeight}},
                  {1, 1, 1});
  return *builder.Build().value;
}

/// E from a lamp of sides a and b with a corner above the receiver, odd in both.
double CornerLight(double a, double b) {
  const double to_a = std::hypot(a, kLampHeight);
  const double to_b = std::hypot(b, kLampHeight);
  return (a / to_a * std::atan(b / to_a) + b / to_b * std::atan(a / to_b)) /
         (2 * std::numbers::pi);
}

/// E on the floor.
double LightAt(double x, double y) {
  const auto& [a, b] = kLampSide;
  return CornerLight(b - x, b - y) - CornerLight(a - x, b - y) -
         CornerLight(b - x, a - y) + CornerLight(a - x, a - y);
}

/// Where on the line y = 5, to the right of the middle, E is the level.
double PlaceOnAxis(double level) {
  double low = 5;
  double high = 10;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (LightAt(middle, 5) > level ? low : high) = middle;
  }
  return low;
}

/// Follows the contour of a level once round; throws what does not hold.
Trace CheckedTrace(const LightProbe& probe, const TraceOptions& options) {
  const double x = PlaceOnAxis(options.level);
  const Vec3<double> start = probe.plan().PlaceOf(Point3{x, 5, 0});
  Trace trace = TraceContour(probe, {start.x, start.y}, false, options);
  const auto fail = [&](const std::string& what) {
    throw std::logic_error(fmt::format("tracer with {}, level {}: {}",
                                       Name(options.predictor), options.level,
                                       what));
  };
  if (trace.end != TraceEnd::kClosed)
    fail(fmt::format("ends with {}", Name(trace.end)));
  for (const TracePoint& point : trace.points) {
    const Point3 p = probe.plan().PointAt(point.at);
    const double off = LightAt(p.x, p.y) - options.level;
    if (!(std::fabs(off) <= options.tolerance + 1e-15))
      fail(fmt::format("E is off by {:.1e}", off));
  }
  // The whole contour, which is about a circle, and not a part of it.
  const double least = 2 * std::numbers::pi * 0.9 * (x - 5) / options.step;
  if (static_cast<double>(trace.points.size()) < least)
    fail(fmt::format("{} points", trace.points.size()));
  return trace;
}

double MedianMiss(const Trace& trace) {
  std::vector<double> misses;
  for (const TracePoint& point : trace.points) {
    if (point.miss) misses.push_back(*point.miss);
  }
  std::ranges::nth_element(misses, misses.begin() + std::ssize(misses) / 2);
  return misses[misses.size() / 2];
}

/// Where E is analytic, the miss is of order h^5 with Milne's predictor, and
/// h^3 with two steps. Without this a wrong predictor would go unnoticed, since
/// the corrector makes up for it.
void CheckOrder(const LightProbe& probe, Predictor predictor) {
  const auto miss = [&](double step) {
    return MedianMiss(CheckedTrace(probe, {.predictor = predictor,
                                           .level = 0.02,
                                           .step = step,
                                           .tolerance = 1e-15,
                                           .outline = {},
                                           .most_points = 1000}));
  };
  const double fall = miss(0.2) / miss(0.1);
  const double expected = predictor == Predictor::kMilne ? 32 : 8;
  if (fall > 0.7 * expected && fall < 1.5 * expected) return;
  throw std::logic_error(
      fmt::format("tracer with {}: the miss falls by {:.1f} when the step is "
                  "halved, and not by {}",
                  Name(predictor), fall, expected));
}

}  // namespace

void CheckPredictorTracer() {
  const Scene scene = LampOverFloor();
  const Oracle oracle(scene);
  const PlanFrame plan(scene, SurfaceNamed(scene, "floor").frame, false);
  const LightProbe probe(oracle, plan, {1, 0, 0});
  for (const Predictor predictor : {Predictor::kMilne, Predictor::kTwoStep}) {
    for (const double level : {0.02, 0.1, 0.22}) {
      CheckedTrace(probe, {.predictor = predictor,
                           .level = level,
                           .step = 0.1,
                           .tolerance = 1e-9 * LightAt(5, 5),
                           .outline = {},
                           .most_points = 1000});
    }
    CheckOrder(probe, predictor);
  }
}

}  // namespace truelux::bench
