// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/hand_contour.h"

#include <cstddef>
#include <utility>

#include "exact/recipe_evaluator.h"

namespace truelux::testing {
namespace {

Vec3<Exact> Plus(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  return a - -b;
}

}  // namespace

std::vector<VertexId> HandContour::AddRing(const std::vector<Point3>& ring) {
  std::vector<VertexId> ids;
  for (const Point3& p : ring)
    ids.push_back(vertices_.push_back(p));
  return ids;
}

PlaneId HandContour::AddPlane(const PlaneRecipe& plane) {
  return contour_.planes.push_back(plane);
}

DirectionId HandContour::AddDirection(const DirectionRecipe& direction) {
  return contour_.directions.push_back(direction);
}

Vec3<Exact> HandContour::DirectionOf(DirectionId id) const {
  return RecipeEvaluator<Exact>(View()).Direction(
      contour_.directions[id], contour_.planes,
      contour_.explicit_vectors.All());
}

Vec3<Exact> HandContour::PlaneOf(PlaneId id) const {
  return RecipeEvaluator<Exact>(View()).Plane(contour_.planes[id],
                                              contour_.explicit_vectors.All());
}

Exact HandContour::SideOf(PlaneId plane, const Vec3<Exact>& d) const {
  return Dot(PlaneOf(plane), d);
}

void HandContour::AddConvexPolygon(const std::vector<Point3>& ring,
                                   const Rgb& emission, Ends ends) {
  const std::vector<VertexId> corners = AddRing(ring);
  const std::size_t count = corners.size();
  const RecipeEvaluator<Exact> exact(View());
  std::vector<int> height;
  for (const VertexId v : corners)
    height.push_back(exact.AboveHorizon(v).sign());
  std::vector<Side> sides;
  DirectionId down;  // where the outline leaves the visible half-space
  DirectionId up;    // where it comes back
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = (i + 1) % count;
    const VertexId a = corners[i];
    const VertexId b = corners[j];
    const int h_a = height[i];
    const int h_b = height[j];
    if (h_a <= 0 && h_b <= 0 && (h_a < 0 || h_b < 0)) continue;
    Side side;
    side.plane = AddPlane(PlaneRecipe::OfEdge(a, b));
    if (h_a < 0) {
      side.from = up = AddDirection(DirectionRecipe::EdgeAtHorizon(b, a));
    } else {
      side.from = AddDirection(DirectionRecipe::ToVertex(a));
      const int h_before = height[(i + count - 1) % count];
      if (h_a == 0 && h_before < 0) up = side.from;
    }
    if (h_b < 0) {
      side.to = down = AddDirection(DirectionRecipe::EdgeAtHorizon(a, b));
    } else {
      side.to = AddDirection(DirectionRecipe::ToVertex(b));
      if (h_b == 0 && height[(j + 1) % count] < 0) down = side.to;
    }
    sides.push_back(side);
  }
  if (down.valid() && up.valid()) {
    const Side horizon{AddPlane(PlaneRecipe::OfHorizon()), down, up};
    std::size_t place = 0;
    while (sides[place].to != down)
      ++place;
    sides.insert(sides.begin() + static_cast<std::ptrdiff_t>(place) + 1,
                 horizon);
  }
  Rewrite(sides, ends);
  AddSource(sides, emission);
}

void HandContour::AddCutPolygon(const std::vector<Point3>& ring,
                                const Point3& a, const Point3& b,
                                const Rgb& emission) {
  const std::vector<VertexId> corners = AddRing(ring);
  const std::vector<VertexId> cut_ends = AddRing({a, b});
  const PlaneId cut = AddPlane(PlaneRecipe::OfEdge(cut_ends[0], cut_ends[1]));
  const RecipeEvaluator<Exact> exact(View());
  const auto inside = [&](VertexId v) {
    return SideOf(cut, exact.FromReceiver(v)).sign() == CGAL::POSITIVE;
  };
  std::vector<Side> sides;
  DirectionId leaving;
  DirectionId entering;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const VertexId v = corners[i];
    const VertexId w = corners[(i + 1) % corners.size()];
    if (!inside(v) && !inside(w)) continue;
    Side side;
    side.plane = AddPlane(PlaneRecipe::OfEdge(v, w));
    side.from = AddDirection(DirectionRecipe::ToVertex(v));
    side.to = AddDirection(DirectionRecipe::ToVertex(w));
    if (inside(v) != inside(w)) {
      // +-(N x cut), taken to the side of the edge's middle.
      const DirectionId crossing =
          AddDirection(DirectionRecipe::Crossing(side.plane, cut));
      const Vec3<Exact> middle =
          Plus(exact.FromReceiver(v), exact.FromReceiver(w));
      if (Dot(DirectionOf(crossing), middle).sign() == CGAL::NEGATIVE) {
        DirectionRecipe& recipe = contour_.directions[crossing];
        recipe = recipe.NegatedIf(true);
      }
      if (inside(v)) {
        side.to = leaving = crossing;
      } else {
        side.from = entering = crossing;
      }
    }
    sides.push_back(side);
  }
  sides.push_back({cut, leaving, entering});
  AddSource(sides, emission);
}

void HandContour::Rewrite(std::vector<Side>& sides, Ends ends) {
  if (ends == Ends::kNatural) return;
  const std::size_t count = sides.size();
  if (ends == Ends::kCrossings) {
    // Every corner as the crossing of the two sides that meet there.
    std::vector<DirectionId> corners;
    for (std::size_t i = 0; i < count; ++i) {
      const PlaneId previous = sides[(i + count - 1) % count].plane;
      const Vec3<Exact> truth = DirectionOf(sides[i].from);
      const DirectionId corner =
          AddDirection(DirectionRecipe::Crossing(previous, sides[i].plane));
      if (Dot(DirectionOf(corner), truth).sign() == CGAL::NEGATIVE) {
        DirectionRecipe& recipe = contour_.directions[corner];
        recipe = recipe.NegatedIf(true);
      }
      corners.push_back(corner);
    }
    for (std::size_t i = 0; i < count; ++i) {
      sides[i].from = corners[i];
      sides[i].to = corners[(i + 1) % count];
    }
    return;
  }
  for (Side& side : sides) {
    const auto explicit_of = [&](const Vec3<Exact>& v) {
      return contour_.explicit_vectors.Add(v);
    };
    side.plane =
        AddPlane(PlaneRecipe::Explicit(explicit_of(PlaneOf(side.plane))));
    for (DirectionId* end : {&side.from, &side.to}) {
      *end = AddDirection(
          DirectionRecipe::Explicit(explicit_of(DirectionOf(*end))));
    }
  }
}

void HandContour::AddSource(const std::vector<Side>& sides,
                            const Rgb& emission) {
  SourceArcs source;
  source.facet = FacetId(contour_.sources.end_id().value());
  source.first_arc = contour_.arcs.end_id();
  source.arc_count = static_cast<int>(sides.size());
  // Some direction inside the convex region.
  Vec3<Exact> middle{Exact(0), Exact(0), Exact(0)};
  for (const Side& side : sides)
    middle = Plus(middle, DirectionOf(side.from));
  for (const Side& side : sides) {
    Arc arc;
    arc.plane = side.plane;
    arc.positive = SideOf(side.plane, middle).sign() == CGAL::POSITIVE;
    arc.from = side.from;
    arc.to = side.to;
    const Exact turn = Determinant(DirectionOf(arc.from), DirectionOf(arc.to),
                                   PlaneOf(side.plane));
    if ((turn.sign() == CGAL::POSITIVE) != arc.positive) {
      std::swap(arc.from, arc.to);
    }
    contour_.arcs.push_back(arc);
  }
  contour_.sources.push_back(source);
  weights_.push_back(emission);
}

}  // namespace truelux::testing
