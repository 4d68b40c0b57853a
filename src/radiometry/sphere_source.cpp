// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/sphere_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "truelux/sphere.h"

#include "exact/double_double.h"
#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {
namespace {

using std::numbers::inv_pi;

/// Where the sphere counts as almost set, and where it counts as large. Over
/// 4000 random c < 0 for each of 16 sizes s, in bins of psi, the largest
/// relative errors beside these switches were
///
///   psi      two segments           one segment            integral
///            s <= 0.8   s = 0.9     s = 0.8   s >= 0.9     s <= 0.9   s = 0.99
///   1 .. 1.1   5.6e-15  7.9e-15     5.4e-15   2.8e-15      1.2e-15    1.3e-15
///   1.1 .. 1.2 2.9e-15  4.7e-15     3.7e-15   2.5e-15      1.3e-15    8e-14
///
/// and the errors of the two closed forms shrink with growing psi, that of the
/// integral with falling psi (2.1e-15 at most, for psi -> 0).
constexpr double kAlmostSet = 1.1;  ///< psi [rad]
constexpr double kLarge = 0.85;     ///< s

struct GaussNode {
  double x;       ///< in (0, 1)
  double weight;  ///< they add up to 1
};

/// Gauss-Legendre, 16 nodes: those below 1/2; the others are their mirror
/// images.
constexpr std::array<GaussNode, 8> kGauss = {{
    {0.0052995325041750337019, 0.013576229705877047426},
    {0.027712488463383711961, 0.031126761969323946431},
    {0.06718439880608412806, 0.047579255841246392405},
    {0.12229779582249848305, 0.062314485627766936026},
    {0.19106187779867812578, 0.074797994408288366041},
    {0.27099161117138630683, 0.084578259697501269095},
    {0.35919822461037054338, 0.091301707522461794433},
    {0.45249374508118127991, 0.094725305227534248143},
}};

/// x - sin x cos x for x in [0, pi], without cancellation.
double SegmentOf(double x) {
  if (x > 1) return x - std::sin(x) * std::cos(x);
  // (b - sin b) / 2 with b = 2 x <= 2; the first term left out is below
  // 2^28 * 6 / 31! = 2e-25 of the sum.
  const double square = 4 * x * x;
  double series = 1;
  for (int k = 29; k > 3; k -= 2)
    series = 1 - square / (k * (k - 1)) * series;
  return (2.0 / 3.0) * x * x * x * series;
}

/// The same by one integral of a positive function, docs/method.md (23).
double AlmostSet(const SphereView& v, double psi) {
  double sum = 0;
  const auto add = [&](double x, double rest, double weight) {
    const double sine = std::sin(psi * x);
    const double cosine = std::cos(psi * x);
    const double a = std::sqrt(cosine * cosine + v.k * sine * (v.k * sine));
    sum += weight * sine * sine * std::sin(psi * rest) *
           std::sin(psi * (1 + x)) / (a * (v.s * cosine - v.c * a));
  };
  for (const GaussNode& node : kGauss) {
    add(node.x, 1 - node.x, node.weight);
    add(1 - node.x, node.x, node.weight);
  }
  const double square = v.s * v.s;
  return 2 * square * square * (v.one_plus_c * (1 - v.c)) * psi * sum * inv_pi;
}

/// docs/method.md (24): a share of the larger segment, less the difference of
/// the two, which is small.
double LargeAndLow(const SphereView& v, double q, double psi) {
  const double a = -v.c;
  const double unit = v.s * v.one_plus_c * (1 + a);
  const double difference =
      std::atan2(v.k * q * v.one_plus_c, q * q + a * v.k * v.k);
  const double sine = q * v.k / (v.s * (1 + a));
  const double cosine_of_sum = (a * v.k * v.k - q * q) / unit;
  return ((v.k * v.k + v.s * v.s * v.one_plus_c) * SegmentOf(psi) -
          (difference - sine * cosine_of_sum)) *
         inv_pi;
}

bool IsFinite(double x, double y, double z) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
}

void Check(const Receiver& receiver, const Sphere& sphere) {
  const Point3& p = receiver.position;
  const Vector3& n = receiver.normal;
  const Point3& q = sphere.center;
  const Rgb& m = sphere.exitance;
  if (!IsFinite(p.x, p.y, p.z) || !IsFinite(n.x, n.y, n.z))
    throw std::invalid_argument("a receiver's number is not finite");
  if (n == Vector3{})
    throw std::invalid_argument("the receiver's normal is zero");
  if (!IsFinite(q.x, q.y, q.z) || !IsFinite(m[0], m[1], m[2]))
    throw std::invalid_argument("a sphere's number is not finite");
  if (!(sphere.radius > 0) || !std::isfinite(sphere.radius))
    throw std::invalid_argument("a sphere's radius is not positive");
}

double LargestOf(const Vec3<DoubleDouble>& v) {
  return std::max({std::abs(v.x.high), std::abs(v.y.high), std::abs(v.z.high)});
}

DoubleDouble Scaled(const DoubleDouble& x, int exponent) {
  return {std::ldexp(x.high, exponent), std::ldexp(x.low, exponent)};
}

Vec3<DoubleDouble> Scaled(const Vec3<DoubleDouble>& v, int exponent) {
  return {Scaled(v.x, exponent), Scaled(v.y, exponent), Scaled(v.z, exponent)};
}

DoubleDouble DotOf(const Vec3<DoubleDouble>& a, const Vec3<DoubleDouble>& b) {
  return SumOfProducts(a.x, b.x, a.y, b.y, a.z, b.z);
}

/// The sign of d - R, exactly.
CGAL::Sign ExactGap(const Receiver& receiver, const Sphere& sphere) {
  const Point3& p = receiver.position;
  const Point3& q = sphere.center;
  const Vec3<Exact> w = Vec3<Exact>{Exact(q.x), Exact(q.y), Exact(q.z)} -
                        Vec3<Exact>{Exact(p.x), Exact(p.y), Exact(p.z)};
  const Exact radius(sphere.radius);
  return CGAL::sign(Dot(w, w) - radius * radius);
}

/// From exact differences, in double-double and with lengths near 1, rounded
/// once at the end. std::invalid_argument if the receiver is inside.
SphereView ViewOf(const Receiver& receiver, const Sphere& sphere) {
  // A difference that overflows is so long that what a quarter loses of tiny
  // numbers is nothing beside it.
  const auto from_receiver = [&](double unit) {
    const Point3& p = receiver.position;
    const Point3& q = sphere.center;
    return Vec3<DoubleDouble>{TwoSum(unit * q.x, unit * -p.x),
                              TwoSum(unit * q.y, unit * -p.y),
                              TwoSum(unit * q.z, unit * -p.z)};
  };
  double radius = sphere.radius;
  Vec3<DoubleDouble> w = from_receiver(1);
  if (!(LargestOf(w) < 0x1p1022)) {
    w = from_receiver(0.25);
    radius *= 0.25;
  }
  if (LargestOf(w) == 0)
    throw std::invalid_argument("the receiver is inside the sphere");
  const int exponent = -std::ilogb(LargestOf(w));
  w = Scaled(w, exponent);
  // Larger than any distance: inside, whatever it is.
  const DoubleDouble r{std::min(std::ldexp(radius, exponent), 0x1p10), 0};
  const Vector3& normal = receiver.normal;
  Vec3<DoubleDouble> n{{normal.x, 0}, {normal.y, 0}, {normal.z, 0}};
  n = Scaled(n, -std::ilogb(LargestOf(n)));

  const DoubleDouble square = DotOf(w, w);
  const DoubleDouble gap = square - r * r;  // d^2 - R^2, error < 2^-98
  if (gap.high < 0x1p-96 &&
      (gap.high < -0x1p-96 || ExactGap(receiver, sphere) == CGAL::NEGATIVE))
    throw std::invalid_argument("the receiver is inside the sphere");
  const DoubleDouble distance = Sqrt(square);
  const DoubleDouble length = Sqrt(DotOf(n, n));
  const DoubleDouble height = DotOf(n, w) / length;
  const auto over_distance = [&distance](const DoubleDouble& x) {
    return (x / distance).high;
  };
  return {over_distance(r),
          over_distance(height),
          std::sqrt(std::max((gap / square).high, 0.0)),
          over_distance(r + height),
          over_distance(r - height),
          over_distance(distance + height)};
}

}  // namespace

double SphereFormFactor(const SphereView& view) {
  if (view.s_plus_c <= 0 || view.one_plus_c <= 0) return 0;
  if (view.s_minus_c <= 0) return view.s * view.s * view.c;
  const double q = std::sqrt(view.s_minus_c * view.s_plus_c);
  const double psi = std::atan2(q, -view.c * view.k);
  if (view.c < 0) {
    if (psi < kAlmostSet) return AlmostSet(view, psi);
    if (view.s > kLarge) return LargeAndLow(view, q, psi);
  }
  const double omega = std::atan2(q, view.k);
  return (SegmentOf(omega) + view.s * view.s * view.c * SegmentOf(psi)) *
         inv_pi;
}

Rgb IrradianceFromSphere(const Receiver& receiver, const Sphere& sphere) {
  Check(receiver, sphere);
  const double factor = SphereFormFactor(ViewOf(receiver, sphere));
  const Rgb& m = sphere.exitance;
  return {factor * m[0], factor * m[1], factor * m[2]};
}

}  // namespace truelux
