// SPDX-License-Identifier: GPL-3.0-or-later
// Only + - * and comparisons: distances are compared by their squares, and
// quotients across.
#include "scene/near_triangle.h"

#include <optional>

#include "exact/decide.h"
#include "exact/exact_conversion.h"
#include "exact/multiprecision.h"
#include "exact/vec3.h"
#include "scene/newell.h"

namespace truelux {
namespace {

template <class NT>
NT Square(const NT& x) {
  return x * x;
}

template <class NT>
NT SquaredLength(const Vec3<NT>& v) {
  return Dot(v, v);
}

std::size_t After(std::size_t corner) {
  return (corner + 1) % 3;
}

}  // namespace

template <class NT>
struct NearTriangle::Plane {
  Vec3<NT> normal;  ///< m
  NT height;        ///< w
  NT square;        ///< |m|^2
};

/// An edge with direction e from the corner p.
template <class NT>
struct NearTriangle::Edge {
  NT side;    ///< (e x (r - p)) . m: negative if the foot lies outside
  NT along;   ///< (r - p) . e
  NT square;  ///< |e|^2
  NT from;    ///< |r - p|^2
};

/// The root of a quotient, within an ulp; the square need not be in binary64's
/// range.
double NearTriangle::RootOf(const Quotient<Exact>& square) {
  constexpr mpfr_prec_t kPrecision = 64;
  return Sqrt(MultiprecisionOf(kPrecision, square.above) /
              MultiprecisionOf(kPrecision, square.below))
      .ToDouble();
}

const NearTriangle::Nearest& NearTriangle::NearestPart() const {
  if (!nearest_) nearest_ = FindNearest();
  return *nearest_;
}

template <class NT>
NearTriangle::Plane<NT> NearTriangle::PlaneIn() const {
  const Vec3<NT> normal = Cross(Displacement<NT>(corners_[0], corners_[1]),
                                Displacement<NT>(corners_[0], corners_[2]));
  return {normal, HeightOver(normal, corners_[0], receiver_.position),
          SquaredLength(normal)};
}

template <class NT>
NearTriangle::Edge<NT> NearTriangle::EdgeIn(std::size_t start) const {
  const Vec3<NT> edge =
      Displacement<NT>(corners_[start], corners_[After(start)]);
  const Vec3<NT> to = Displacement<NT>(corners_[start], receiver_.position);
  return {Dot(Cross(edge, to), PlaneIn<NT>().normal), Dot(to, edge),
          SquaredLength(edge), SquaredLength(to)};
}

/// The foot of the perpendicular is inside unless it is outside some edge. If
/// the perpendicular from it to such an edge ends within the edge, that end is
/// the nearest point, since the triangle is convex; else it is a corner, that
/// which lies behind one of its edges and before the other.
NearTriangle::Nearest NearTriangle::FindNearest() const {
  std::array<Sign, 3> before{};
  std::array<Sign, 3> behind{};
  bool is_inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Sign side = Decide([&]<class NT>() { return EdgeIn<NT>(k).side; });
    before[k] = Decide([&]<class NT>() { return -EdgeIn<NT>(k).along; });
    behind[k] = Decide([&]<class NT>() {
      const Edge<NT> edge = EdgeIn<NT>(k);
      return edge.along - edge.square;
    });
    if (side != Sign::kNegative) continue;
    is_inside = false;
    if (before[k] != Sign::kPositive && behind[k] != Sign::kPositive)
      return {Part::kEdge, k};
  }
  if (is_inside) return {};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t last = After(After(k));
    if (before[k] != Sign::kNegative && behind[last] != Sign::kNegative)
      return {Part::kCorner, k};
  }
  return {};  // does not happen: one of the three is nearest
}

Turn NearTriangle::TurnOf() const {
  const auto cosine = [&]<class NT>() {
    const Vector3& n = receiver_.normal;
    return Dot(Vec3<NT>{NT(n.x), NT(n.y), NT(n.z)}, PlaneIn<NT>().normal);
  };
  const Sign sign = Decide(cosine);
  if (sign == Sign::kZero) return Turn::kAcross;
  if (sign == Sign::kNegative) return Turn::kOpposite;
  const Sign steep = Decide([&]<class NT>() {
    const Vector3& n = receiver_.normal;
    const NT square = SquaredLength(Vec3<NT>{NT(n.x), NT(n.y), NT(n.z)});
    return NT(4) * Square(cosine.template operator()<NT>()) -
           square * PlaneIn<NT>().square;
  });
  return steep == Sign::kNegative ? Turn::kSameSide : Turn::kAlike;
}

bool NearTriangle::IsPlaneWithin(const NearLimit& limit) const {
  return Decide([&]<class NT>() {
           const Plane<NT> plane = PlaneIn<NT>();
           return Square(limit.In<NT>()) * plane.square - Square(plane.height);
         }) != Sign::kNegative;
}

bool NearTriangle::IsFootWithin(const NearLimit& limit) const {
  const std::size_t k = NearestPart().index;
  switch (NearestPart().part) {
    case Part::kInside:
      return true;
    case Part::kEdge:
      return Decide([&]<class NT>() {
               const Edge<NT> edge = EdgeIn<NT>(k);
               return Square(limit.In<NT>()) * PlaneIn<NT>().square *
                          edge.square -
                      Square(edge.side);
             }) != Sign::kNegative;
    case Part::kCorner:
      break;
  }
  // The foot's distance to a corner, by Pythagoras.
  return Decide([&]<class NT>() {
           const Plane<NT> plane = PlaneIn<NT>();
           return Square(plane.height) +
                  (Square(limit.In<NT>()) - EdgeIn<NT>(k).from) * plane.square;
         }) != Sign::kNegative;
}

bool NearTriangle::HasReceiverBehind() const {
  const Turn turn = TurnOf();
  if (turn == Turn::kAcross) return false;
  const Sign side = Decide([&]<class NT>() { return PlaneIn<NT>().height; });
  return side == (turn == Turn::kOpposite ? Sign::kPositive : Sign::kNegative);
}

template <class NT>
NearTriangle::Quotient<NT> NearTriangle::SquaredPlaneDistance() const {
  const Plane<NT> plane = PlaneIn<NT>();
  return {Square(plane.height), plane.square};
}

template <class NT>
NearTriangle::Quotient<NT> NearTriangle::SquaredDistance() const {
  const auto [part, k] = NearestPart();
  if (part == Part::kInside) return SquaredPlaneDistance<NT>();
  const Edge<NT> edge = EdgeIn<NT>(k);
  if (part == Part::kCorner) return {edge.from, NT(1)};
  return {edge.from * edge.square - Square(edge.along), edge.square};
}

Sign NearTriangle::ComparePlanes(const NearTriangle& other) const {
  return Decide([&]<class NT>() {
    const Quotient<NT> a = SquaredPlaneDistance<NT>();
    const Quotient<NT> b = other.SquaredPlaneDistance<NT>();
    return a.above * b.below - b.above * a.below;
  });
}

Sign NearTriangle::CompareDistances(const NearTriangle& other) const {
  return Decide([&]<class NT>() {
    const Quotient<NT> a = SquaredDistance<NT>();
    const Quotient<NT> b = other.SquaredDistance<NT>();
    return a.above * b.below - b.above * a.below;
  });
}

bool NearTriangle::IsWithin(double distance) const {
  return Decide([&]<class NT>() {
           const Quotient<NT> square = SquaredDistance<NT>();
           return Square(NT(distance)) * square.below - square.above;
         }) != Sign::kNegative;
}

double NearTriangle::PlaneDistance() const {
  return RootOf(SquaredPlaneDistance<Exact>());
}

double NearTriangle::Distance() const {
  return RootOf(SquaredDistance<Exact>());
}

}  // namespace truelux
