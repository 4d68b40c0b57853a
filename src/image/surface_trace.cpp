// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/surface_trace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace truelux {
namespace {

mpq_class Half() {
  return {1, 2};
}

mpq_class AbsoluteOf(const mpq_class& q) {
  return abs(q);
}

}  // namespace

PixelPlane::PixelPlane(const Scene& scene, const SurfaceFrame& frame, int width,
                       int height)
    : width_(width), height_(height) {
  const mpq_class a_step = (frame.a_most - frame.a_least) / width;
  const mpq_class b_step = (frame.b_most - frame.b_least) / height;
  const mpq_class a_zero = frame.a_least + a_step * Half();
  const mpq_class b_zero = frame.b_most - b_step * Half();
  right_ = a_step * frame.u;
  down_ = mpq_class(-b_step) * frame.v;
  zero_ = frame.origin + a_zero * frame.u + b_zero * frame.v;
  const auto near = [](const RationalVector& v) {
    return Vec3<double>{NearestTo(v.x), NearestTo(v.y), NearestTo(v.z)};
  };
  near_ = {near(zero_), near(right_), near(down_)};
  double largest = 0;
  for (const int face : frame.faces) {
    const Face& f = scene.faces()[static_cast<std::size_t>(face)];
    const Facet& facet =
        scene.facets()[static_cast<std::size_t>(f.first_facet)];
    for (const Triangle& triangle : scene.triangles().subspan(
             static_cast<std::size_t>(facet.first_triangle),
             static_cast<std::size_t>(facet.triangle_count))) {
      std::array<Corner, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3& p =
            scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])];
        const auto [a, b] = frame.Of(p);
        corners[k] = {mpq_class((a - a_zero) / a_step).get_d(),
                      mpq_class((b_zero - b) / b_step).get_d()};
        largest =
            std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
      }
      triangles_.push_back(corners);
    }
  }
  const mpq_class narrow = std::min(Dot(right_, right_), Dot(down_, down_));
  bits_per_pixel_ =
      std::ilogb(std::sqrt(NearestTo(narrow))) - (std::ilogb(largest) - 52);
}

Point3 PixelPlane::PointAt(const mpq_class& x, const mpq_class& y) const {
  const RationalVector p = zero_ + x * right_ + y * down_;
  return {NearestTo(p.x), NearestTo(p.y), NearestTo(p.z)};
}

Point3 PixelPlane::NearPointAt(double x, double y) const {
  const Vec3<double> p = near_[0] + x * near_[1] + y * near_[2];
  return {p.x, p.y, p.z};
}

bool PixelPlane::Covers(double x, double y) const {
  constexpr double kSlack = 1e-9;
  return std::ranges::any_of(triangles_, [&](const auto& corners) {
    const auto turn = [](const Corner& p, const Corner& q, const Corner& r) {
      return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    };
    const Corner at = {x, y};
    const double side = turn(corners[0], corners[1], corners[2]) > 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner& p = corners[k];
      const Corner& q = corners[(k + 1) % 3];
      const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
      if (side * turn(p, q, at) < -kSlack * length) return false;
    }
    return true;
  });
}

std::array<mpq_class, 3> PixelPlane::HeightOver(const RationalVector& normal,
                                                const mpq_class& offset) const {
  return {mpq_class(Dot(normal, zero_) - offset), Dot(normal, right_),
          Dot(normal, down_)};
}

SurfaceTrace::SurfaceTrace(int width, int height,
                           std::array<mpq_class, 3> height_over)
    : width_(width),
      height_(height),
      is_steep_(AbsoluteOf(height_over[1]) > AbsoluteOf(height_over[2])) {
  const mpq_class& along = height_over[is_steep_ ? 2 : 1];
  const mpq_class& across = height_over[is_steep_ ? 1 : 2];
  start_ = -height_over[0] / across;
  slope_ = -along / across;
}

std::optional<SurfaceTrace> SurfaceTrace::Of(const PixelPlane& pixels,
                                             const RationalVector& normal,
                                             const mpq_class& offset) {
  std::array<mpq_class, 3> over = pixels.HeightOver(normal, offset);
  if (over[1] == 0 && over[2] == 0) return std::nullopt;
  return SurfaceTrace(pixels.width(), pixels.height(), std::move(over));
}

std::vector<SurfaceTrace::Step> SurfaceTrace::Steps() const {
  const double start = start_.get_d();
  const double slope = slope_.get_d();
  const int length = is_steep_ ? height_ : width_;
  const int breadth = is_steep_ ? width_ : height_;
  std::vector<Step> steps;
  for (int along = 0; along < length; ++along) {
    const double across = start + slope * along;
    const double middle = std::floor(across + 0.5);
    if (!(middle >= 0 && middle < breadth)) continue;
    const int pixel = static_cast<int>(middle);
    const auto place = static_cast<double>(along);
    steps.push_back(is_steep_ ? Step{pixel, along, across, place}
                              : Step{along, pixel, place, across});
  }
  return steps;
}

SurfaceTrace::Place SurfaceTrace::At(const Step& step,
                                     const mpq_class& aside) const {
  const mpq_class along = is_steep_ ? step.y : step.x;
  const mpq_class across = start_ + slope_ * along + aside;
  if (is_steep_) return {across, along};
  return {along, across};
}

}  // namespace truelux
