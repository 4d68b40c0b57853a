// SPDX-License-Identifier: GPL-3.0-or-later
// Small programs of their own that compute irradiance, rightly or wrongly.

#ifndef TRUELUX_TESTS_COMPARE_WRONG_PROGRAMS_H_
#define TRUELUX_TESTS_COMPARE_WRONG_PROGRAMS_H_

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/receiver.h"
#include "truelux/scene.h"

namespace truelux::testing {

/// A program that is asked receiver by receiver.
using Program = std::function<Rgb(const Receiver&)>;

struct Vec {
  double x = 0;
  double y = 0;
  double z = 0;
};

inline Vec Minus(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vec Times(double s, const Vec& a) {
  return {s * a.x, s * a.y, s * a.z};
}

inline Vec Plus(const Vec& a, const Vec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline double Inner(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec Outer(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double Norm(const Vec& a) {
  return std::sqrt(Inner(a, a));
}

inline Vec UnitVec(const Vec& a) {
  return Times(1 / Norm(a), a);
}

/// A face as these programs keep it.
struct PlainPolygon {
  std::vector<Vec> ring;
  Rgb emission{};
  std::string group;
};

inline std::vector<PlainPolygon> PolygonsOf(const Scene& scene) {
  std::vector<PlainPolygon> polygons;
  for (const Face& face : scene.faces()) {
    PlainPolygon polygon{
        {},
        face.emission,
        scene.group_names()[static_cast<std::size_t>(face.group)]};
    for (const int v :
         scene.corners().subspan(static_cast<std::size_t>(face.first_corner),
                                 static_cast<std::size_t>(face.corner_count))) {
      const Point3& p = scene.vertices()[static_cast<std::size_t>(v)];
      polygon.ring.push_back({p.x, p.y, p.z});
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

/// Lambert's sum over whole polygons: no horizon, no shadows.
inline Program LambertWithoutClipping(const Scene& scene) {
  return [polygons = PolygonsOf(scene)](const Receiver& receiver) {
    const Vec r{receiver.position.x, receiver.position.y, receiver.position.z};
    const Vec n =
        UnitVec({receiver.normal.x, receiver.normal.y, receiver.normal.z});
    Rgb sum{};
    for (const PlainPolygon& polygon : polygons) {
      double f = 0;
      for (std::size_t i = 0; i < polygon.ring.size(); ++i) {
        const Vec a = UnitVec(Minus(polygon.ring[i], r));
        const Vec b =
            UnitVec(Minus(polygon.ring[(i + 1) % polygon.ring.size()], r));
        const Vec normal = Outer(b, a);
        const double angle = std::atan2(Norm(normal), Inner(a, b));
        f += angle * Inner(n, UnitVec(normal)) / (2 * std::numbers::pi);
      }
      for (std::size_t c = 0; c < sum.size(); ++c)
        sum[c] += f * polygon.emission[c];
    }
    return sum;
  };
}

/// What a Monte Carlo program gets wrong; by default nothing.
struct Wrong {
  double factor = 1;
  bool flips_normal = false;
  bool emits_twice = false;  ///< from both sides
  bool has_no_shadows = false;
  std::string_view left_out = {};  ///< a group that is not there
};

/// Samples the areas of the emitters at random, the same number each, and
/// tests every polygon against every ray.
class MonteCarlo {
 public:
  MonteCarlo(const Scene& scene, int samples, const Wrong& wrong = {},
             std::uint32_t seed = 1)
      : samples_(samples), wrong_(wrong), random_(seed) {
    for (PlainPolygon& polygon : PolygonsOf(scene)) {
      if (wrong.left_out.empty() || polygon.group != wrong.left_out)
        polygons_.push_back(std::move(polygon));
    }
  }

  Rgb operator()(const Receiver& receiver) {
    const Vec r{receiver.position.x, receiver.position.y, receiver.position.z};
    Vec n = UnitVec({receiver.normal.x, receiver.normal.y, receiver.normal.z});
    if (wrong_.flips_normal) n = Times(-1, n);
    Rgb sum{};
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      const PlainPolygon& polygon = polygons_[p];
      if (polygon.emission == Rgb{}) continue;
      for (std::size_t k = 1; k + 1 < polygon.ring.size(); ++k) {
        const double f = Sample(r, n, p, k) * wrong_.factor;
        for (std::size_t c = 0; c < sum.size(); ++c)
          sum[c] += f * polygon.emission[c];
      }
    }
    return sum;
  }

 private:
  /// The form factor of triangle (0, k, k + 1) of a polygon.
  double Sample(const Vec& r, const Vec& n, std::size_t p, std::size_t k) {
    const std::vector<Vec>& ring = polygons_[p].ring;
    const Vec u = Minus(ring[k], ring[0]);
    const Vec v = Minus(ring[k + 1], ring[0]);
    const Vec twice = Outer(u, v);
    std::uniform_real_distribution<double> uniform(0, 1);
    double sum = 0;
    for (int s = 0; s < samples_; ++s) {
      double a = uniform(random_);
      double b = uniform(random_);
      if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
      }
      const Vec to = Minus(Plus(ring[0], Plus(Times(a, u), Times(b, v))), r);
      const double height = Inner(n, to);
      double facing = -Inner(twice, to) / 2;
      if (wrong_.emits_twice) facing = std::abs(facing);
      if (height <= 0 || facing <= 0 || Blocked(r, to, p)) continue;
      const double square = Inner(to, to);
      sum += height * facing / (square * square * std::numbers::pi);
    }
    return sum / samples_;
  }

  [[nodiscard]] bool Blocked(const Vec& r, const Vec& to,
                             std::size_t target) const {
    if (wrong_.has_no_shadows) return false;
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      if (p != target && Hits(r, to, polygons_[p].ring)) return true;
    }
    return false;
  }

  /// Whether a polygon is hit strictly between r and r + to.
  static bool Hits(const Vec& r, const Vec& to, const std::vector<Vec>& ring) {
    Vec normal{};
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      normal = Plus(
          normal, Outer(Minus(ring[i], ring[0]), Minus(ring[i + 1], ring[0])));
    }
    const double speed = Inner(normal, to);
    const double t = Inner(normal, Minus(ring[0], r)) / speed;
    if (!(t > 1e-9) || !(t < 1 - 1e-9)) return false;
    const Vec hit = Plus(r, Times(t, to));
    // Around a point inside the ring turns once.
    double angle = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec a = Minus(ring[i], hit);
      const Vec b = Minus(ring[(i + 1) % ring.size()], hit);
      angle += std::atan2(Inner(Outer(a, b), UnitVec(normal)), Inner(a, b));
    }
    return std::abs(angle) > std::numbers::pi;
  }

  int samples_;
  Wrong wrong_;
  std::vector<PlainPolygon> polygons_;
  std::mt19937 random_;
};

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_COMPARE_WRONG_PROGRAMS_H_
