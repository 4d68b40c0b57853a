// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/projection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <numbers>

#include "base/vector_math.h"

namespace truelux {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A cubic follows an arc of a circle of this size to 4.3e-6 of its radius.
constexpr double kCubicAngle = 45 * kDegree;

/// An arc that leaves its chord by less is drawn as a line [px].
constexpr double kFlat = 0.003;

/// s a + t b.
Vector3 Mix(double s, const Vector3& a, double t, const Vector3& b) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
}

void AppendPoint(std::string& path, const PicturePoint& p) {
  // Two digits behind the point, without the zeros that say nothing.
  const auto append = [&path](double value) {
    std::string text = fmt::format("{:.2f}", value);
    while (text.back() == '0')
      text.pop_back();
    if (text.back() == '.') text.pop_back();
    path += text == "-0" ? "0" : text;
  };
  append(p.x);
  path += ' ';
  append(p.y);
}

/// The part of a closed polygon of directions with wall . d >= 0.
std::vector<Vector3> ClipToWall(const std::vector<Vector3>& polygon,
                                const Vector3& wall) {
  std::vector<Vector3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3& a = polygon[i];
    const Vector3& b = polygon[(i + 1) % polygon.size()];
    const double at_a = Dot(wall, a);
    const double at_b = Dot(wall, b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) {
      const double s = at_a / (at_a - at_b);
      kept.push_back(Mix(1 - s, a, s, b));
    }
  }
  return kept;
}

/// Appends points of an arc, near enough to each other to be joined straight.
/// Those of an arc that is nowhere in the gnomonic disc, as on the horizon,
/// are lifted to where they have a place on the plane, still out of the disc.
void AppendCorners(const CircleArc& arc, std::vector<Vector3>& corners) {
  constexpr double kLow = 9 * kDegree;
  constexpr double kLifted = 5 * kDegree;
  static_assert(kGnomonicLimit < 81);
  const bool is_low = std::hypot(arc.start.z, arc.side.z) < std::sin(kLow);
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(arc.angle / kCubicAngle)));
  // The end is the start of the next arc.
  if (is_low) corners.push_back(arc.start);
  for (int i = 0; i < pieces + (is_low ? 1 : 0); ++i) {
    Vector3 corner = arc.At(i * arc.angle / pieces);
    if (is_low) corner.z = std::hypot(corner.x, corner.y) * std::tan(kLifted);
    corners.push_back(corner);
  }
}

}  // namespace

std::string_view Name(ViewProjection projection) {
  return projection == ViewProjection::kNusselt ? "nusselt" : "gnomonic";
}

ViewFrame FrameOf(const Vector3& normal) {
  constexpr double kTooNear = 0.9;
  ViewFrame frame;
  frame.ahead = UnitOf(normal);
  for (const Vector3& axis :
       {Vector3{0, 1, 0}, Vector3{0, 0, 1}, Vector3{1, 0, 0}}) {
    const double along = Dot(axis, frame.ahead);
    if (std::abs(along) > kTooNear) continue;
    frame.up = UnitOf(Mix(1, axis, -along, frame.ahead));
    break;
  }
  frame.right = Cross(frame.ahead, frame.up);
  return frame;
}

Vector3 CircleArc::At(double t) const {
  return Mix(std::cos(t), start, std::sin(t), side);
}

PicturePoint ProjectedDisc::Place(const Vector3& v) const {
  double scale = radius_;
  if (kind_ == ViewProjection::kGnomonic)
    scale = radius_ / (v.z * std::tan(kGnomonicLimit * kDegree));
  return {centre_.x + scale * v.x, centre_.y - scale * v.y};
}

std::optional<PicturePoint> ProjectedDisc::PointOf(
    const Vector3& direction) const {
  const bool outside = kind_ == ViewProjection::kGnomonic &&
                       direction.z < std::cos(kGnomonicLimit * kDegree);
  if (outside) return std::nullopt;
  return Place(direction);
}

double ProjectedDisc::RadiusAt(double degrees) const {
  if (kind_ == ViewProjection::kNusselt)
    return radius_ * std::sin(degrees * kDegree);
  return radius_ * std::tan(degrees * kDegree) /
         std::tan(kGnomonicLimit * kDegree);
}

/// Appends the way from an arc's start, where the path is, to its end, in the
/// Nusselt disc. Being cubics of the circle seen from the side, they stay as
/// exact however flat the ellipse is.
void ProjectedDisc::AppendCurve(const CircleArc& arc, std::string& path) const {
  const double sagitta = radius_ * (1 - std::cos(arc.angle / 2));
  if (arc.angle < 1 && sagitta < kFlat) {
    path += 'L';
    AppendPoint(path, Place(arc.At(arc.angle)));
    return;
  }
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(arc.angle / kCubicAngle)));
  const double step = arc.angle / pieces;
  const double handle = 4.0 / 3 * std::tan(step / 4);
  for (int i = 0; i < pieces; ++i) {
    const Vector3 a = arc.At(i * step);
    const Vector3 b = arc.At((i + 1) * step);
    const Vector3 along_a = arc.At(i * step + std::numbers::pi / 2);
    const Vector3 along_b = arc.At((i + 1) * step + std::numbers::pi / 2);
    path += 'C';
    AppendPoint(path, Place(Mix(1, a, handle, along_a)));
    path += ' ';
    AppendPoint(path, Place(Mix(1, b, -handle, along_b)));
    path += ' ';
    AppendPoint(path, Place(b));
  }
}

std::string ProjectedDisc::ArcPath(const CircleArc& arc) const {
  double begin = 0;
  double end = arc.angle;
  if (kind_ == ViewProjection::kGnomonic) {
    // The height above the receiver plane is top cos(t - middle).
    const double top = std::hypot(arc.start.z, arc.side.z);
    const double limit = std::cos(kGnomonicLimit * kDegree);
    if (top <= limit) return "";
    const double middle = std::atan2(arc.side.z, arc.start.z);
    const double half = std::acos(limit / top);
    begin = std::max(begin, middle - half);
    end = std::min(end, middle + half);
    if (begin >= end) return "";
  }
  std::string path = "M";
  AppendPoint(path, Place(arc.At(begin)));
  if (kind_ == ViewProjection::kGnomonic) {
    path += 'L';
    AppendPoint(path, Place(arc.At(end)));
  } else {
    AppendCurve(arc, path);
  }
  return path;
}

std::string ProjectedDisc::LoopPath(const std::vector<CircleArc>& arcs) const {
  std::string path = "M";
  if (kind_ == ViewProjection::kNusselt) {
    AppendPoint(path, Place(arcs.front().start));
    for (const CircleArc& arc : arcs)
      AppendCurve(arc, path);
    return path + 'Z';
  }
  std::vector<Vector3> polygon;
  for (const CircleArc& arc : arcs)
    AppendCorners(arc, polygon);
  // A square pyramid around the disc.
  const double slope = 1.02 * std::tan(kGnomonicLimit * kDegree);
  for (const Vector3& wall : {Vector3{1, 0, slope}, Vector3{-1, 0, slope},
                              Vector3{0, 1, slope}, Vector3{0, -1, slope}}) {
    polygon = ClipToWall(polygon, wall);
  }
  if (polygon.size() < 3) return "";
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (i > 0) path += 'L';
    AppendPoint(path, Place(polygon[i]));
  }
  return path + 'Z';
}

}  // namespace truelux
