// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/square_clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "exact/ball_recipe.h"
#include "exact/recipe_evaluator.h"

namespace truelux {
namespace {

/// A side of the square: inside is normal . d >= 0.
struct SquareSide {
  Vec3<Exact> normal;
  Vec3<Exact> reference;  ///< on the side, above the horizon
};

Vec3<Exact> Plus(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  return a - -b;
}

Vec3<Exact> ExactOf(const Vec3<double>& v, const Exact& factor) {
  return {Exact(v.x) * factor, Exact(v.y) * factor, Exact(v.z) * factor};
}

/// Both axes of the image plane, of about the length of the normal.
std::array<Vec3<Exact>, 2> ImageAxes(const Vector3& normal) {
  const int exponent = std::ilogb(std::max(
      {std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)}));
  const Vec3<double> n = {std::ldexp(normal.x, -exponent),
                          std::ldexp(normal.y, -exponent),
                          std::ldexp(normal.z, -exponent)};
  const double length = std::sqrt(Dot(n, n));
  // An axis that is not along n.
  const Vec3<double> other = std::fabs(n.x) < 0.6 * length
                                 ? Vec3<double>{1, 0, 0}
                                 : Vec3<double>{0, 1, 0};
  const Vec3<double> across = Cross(n, other);
  const double across_length = std::sqrt(Dot(across, across));
  const Vec3<double> u = (length / across_length) * across;
  const Vec3<double> v = (1 / length) * Cross(n, u);
  // Two factors, as one need not be a double.
  const Exact half_scale(std::ldexp(1.0, exponent / 2));
  const Exact scale =
      half_scale * Exact(std::ldexp(1.0, exponent - exponent / 2));
  return {ExactOf(u, scale), ExactOf(v, scale)};
}

std::array<SquareSide, 4> SidesOf(const ReceiverView& view, double half_side) {
  const Vec3<Exact> n = RecipeEvaluator<Exact>(view).ReceiverNormal();
  const auto axes = ImageAxes(view.normal);
  const Vec3<Exact> up = Exact(half_side) * n;
  std::array<SquareSide, 4> sides;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3<Exact>& across = axes[k / 2];
    const Vec3<Exact>& along = axes[1 - k / 2];
    sides[k].normal = k % 2 == 0 ? Plus(up, across) : up - across;
    Vec3<Exact> reference = Cross(sides[k].normal, along);
    if (Dot(reference, n).sign() == CGAL::NEGATIVE) reference = -reference;
    sides[k].reference = std::move(reference);
  }
  return sides;
}

/// Cuts a contour by one side after the other.
class Cutter {
 public:
  explicit Cutter(const WeightedContour& contour)
      : view_(contour.view),
        contour_(contour.contour),
        is_cut_(contour.contour.sources.size()) {}

  void Cut(const SquareSide& side) {
    FindSides(side.normal);
    if (!any_outside_) return;
    const PlaneId plane = AddPlane(side.normal);
    const DirectionId reference = AddDirection(side.reference);
    IdVector<ArcId, Arc> arcs;
    for (const SourceId id : contour_.sources.ids()) {
      SourceArcs& source = contour_.sources[id];
      const ArcId first = arcs.end_id();
      for (const Arc& arc : contour_.ArcsOf(source)) {
        if (!CutArc(arc, side, plane, reference, arcs)) is_cut_[id] = true;
      }
      source.first_arc = first;
      source.arc_count = arcs.end_id().value() - first.value();
    }
    contour_.arcs = std::move(arcs);
  }

  BoundedContour Finish() { return {std::move(contour_), std::move(is_cut_)}; }

 private:
  /// Finds on which side of a plane each direction is: -1, 0 or 1.
  void FindSides(const Vec3<Exact>& normal) {
    using B = Ball<double>;
    const RecipeEvaluator<B> rounded(view_);
    const Vec3<B> n = {FromExact<B>::Of(normal.x), FromExact<B>::Of(normal.y),
                       FromExact<B>::Of(normal.z)};
    side_.clear();
    any_outside_ = false;
    for (const DirectionId id : contour_.directions.ids()) {
      const B height =
          Dot(n, rounded.Direction(contour_.directions[id], contour_.planes,
                                   contour_.explicit_vectors.All()));
      int side = std::fabs(height.value) > height.error
                     ? (height.value > 0 ? 1 : -1)
                     : 0;
      if (side == 0) {
        side = static_cast<int>(SignOf(Dot(normal, Direction(id))));
      }
      side_.push_back(side);
      any_outside_ = any_outside_ || side < 0;
    }
  }

  /// Appends what is inside of an arc, and what closes it. False if some of it
  /// is outside.
  bool CutArc(Arc arc, const SquareSide& side, PlaneId plane,
              DirectionId reference, IdVector<ArcId, Arc>& arcs) {
    const bool from_inside = side_[arc.from] >= 0;
    const bool to_inside = side_[arc.to] >= 0;
    if (from_inside && to_inside) {
      arcs.push_back(arc);
      return true;
    }
    if (!from_inside && !to_inside) return false;
    const Vec3<Exact> d1 = Direction(arc.from);
    const Vec3<Exact> d2 = Direction(arc.to);
    const Exact h1 = Dot(side.normal, d1);
    const Exact h2 = Dot(side.normal, d2);
    Vec3<Exact> crossing = from_inside ? h1 * d2 - h2 * d1 : h2 * d1 - h1 * d2;
    const Sign turn =
        SignOf(Determinant(crossing, side.reference, side.normal));
    const DirectionId point = AddDirection(std::move(crossing));
    const bool is_point = side_[from_inside ? arc.from : arc.to] == 0;
    if (from_inside) {
      arc.to = point;
    } else {
      arc.from = point;
    }
    if (!is_point) arcs.push_back(arc);
    if (turn != Sign::kZero) {
      const bool positive = (turn == Sign::kPositive) == from_inside;
      arcs.push_back({plane, positive, from_inside ? point : reference,
                      from_inside ? reference : point, FaceNumber()});
    }
    return false;
  }

  [[nodiscard]] Vec3<Exact> Direction(DirectionId id) const {
    return RecipeEvaluator<Exact>(view_).Direction(
        contour_.directions[id], contour_.planes,
        contour_.explicit_vectors.All());
  }

  PlaneId AddPlane(const Vec3<Exact>& normal) {
    return contour_.planes.push_back(
        PlaneRecipe::Explicit(contour_.explicit_vectors.Add(normal)));
  }

  DirectionId AddDirection(Vec3<Exact> direction) {
    return contour_.directions.push_back(DirectionRecipe::Explicit(
        contour_.explicit_vectors.Add(std::move(direction))));
  }

  ReceiverView view_;
  Contour contour_;
  IdVector<SourceId, bool> is_cut_;
  /// Of each direction that was there before a cut.
  IdVector<DirectionId, int> side_;
  bool any_outside_ = false;
};

}  // namespace

double FormFactorBeyond(double half_side) {
  // The rounded square holds the disc of this radius; the rest is rounding.
  const double radius = half_side * (1 - 0x1p-40);
  // Its square may overflow, and something is beyond.
  if (radius > 0x1p500) return 0x1p-999;
  return (1 + 0x1p-40) / (1 + radius * radius);
}

BoundedContour CutToSquare(const WeightedContour& contour, double half_side) {
  Cutter cutter(contour);
  for (const SquareSide& side : SidesOf(contour.view, half_side)) {
    cutter.Cut(side);
  }
  return cutter.Finish();
}

}  // namespace truelux
