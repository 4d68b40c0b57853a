#include "radiometry/hand_contour.h"

#include <cstddef>
#include <utility>

#include "exact/recipe_evaluator.h"

namespace truelux::testing {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

Vec3<Exact> Plus(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  return a - -b;
}

}  // namespace

int HandContour::AddVertex(const Point3& p) {
  vertices_.push_back(p);
  return static_cast<int>(vertices_.size()) - 1;
}

int HandContour::AddPlane(const PlaneRecipe& plane) {
  contour_.planes.push_back(plane);
  return static_cast<int>(contour_.planes.size()) - 1;
}

int HandContour::AddDirection(const DirectionRecipe& direction) {
  contour_.directions.push_back(direction);
  return static_cast<int>(contour_.directions.size()) - 1;
}

Vec3<Exact> HandContour::DirectionOf(int i) const {
  return RecipeEvaluator<Exact>(View()).Direction(
      contour_.directions[Index(i)], contour_.planes,
      contour_.explicit_vectors.All());
}

Vec3<Exact> HandContour::PlaneOf(int i) const {
  return RecipeEvaluator<Exact>(View()).Plane(contour_.planes[Index(i)],
                                              contour_.explicit_vectors.All());
}

Exact HandContour::SideOf(int plane, const Vec3<Exact>& d) const {
  return Dot(PlaneOf(plane), d);
}

void HandContour::AddConvexPolygon(const std::vector<Point3>& ring,
                                   const Rgb& emission, Ends ends) {
  const int count = static_cast<int>(ring.size());
  const int first = static_cast<int>(vertices_.size());
  for (const Point3& p : ring)
    AddVertex(p);
  const RecipeEvaluator<Exact> exact(View());
  std::vector<int> height;
  for (int i = 0; i < count; ++i) {
    height.push_back(exact.AboveHorizon(first + i).sign());
  }
  std::vector<Side> sides;
  int down = -1;  // where the outline leaves the visible half-space
  int up = -1;    // where it comes back
  for (int i = 0; i < count; ++i) {
    const int j = (i + 1) % count;
    const int a = first + i;
    const int b = first + j;
    const int h_a = height[Index(i)];
    const int h_b = height[Index(j)];
    if (h_a <= 0 && h_b <= 0 && (h_a < 0 || h_b < 0)) continue;
    Side side;
    side.plane = AddPlane({PlaneRecipe::Kind::kEdge, false, a, b});
    if (h_a < 0) {
      side.from = up = AddDirection(
          {DirectionRecipe::Kind::kEdgeAtHorizon, false, b, a, -1});
    } else {
      side.from = AddDirection({DirectionRecipe::Kind::kVertex, false, a});
      const int h_before = height[Index((i + count - 1) % count)];
      if (h_a == 0 && h_before < 0) up = side.from;
    }
    if (h_b < 0) {
      side.to = down = AddDirection(
          {DirectionRecipe::Kind::kEdgeAtHorizon, false, a, b, -1});
    } else {
      side.to = AddDirection({DirectionRecipe::Kind::kVertex, false, b});
      if (h_b == 0 && height[Index((j + 1) % count)] < 0) down = side.to;
    }
    sides.push_back(side);
  }
  if (down >= 0 && up >= 0) {
    const Side horizon{AddPlane({.kind = PlaneRecipe::Kind::kHorizon}), down,
                       up};
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
  const int first = static_cast<int>(vertices_.size());
  const int count = static_cast<int>(ring.size());
  for (const Point3& p : ring)
    AddVertex(p);
  const int cut =
      AddPlane({PlaneRecipe::Kind::kEdge, false, AddVertex(a), AddVertex(b)});
  const RecipeEvaluator<Exact> exact(View());
  const auto inside = [&](int v) {
    return SideOf(cut, exact.FromReceiver(v)).sign() == CGAL::POSITIVE;
  };
  std::vector<Side> sides;
  int leaving = -1;
  int entering = -1;
  for (int i = 0; i < count; ++i) {
    const int v = first + i;
    const int w = first + (i + 1) % count;
    if (!inside(v) && !inside(w)) continue;
    Side side;
    side.plane = AddPlane({PlaneRecipe::Kind::kEdge, false, v, w});
    side.from = AddDirection({DirectionRecipe::Kind::kVertex, false, v});
    side.to = AddDirection({DirectionRecipe::Kind::kVertex, false, w});
    if (inside(v) != inside(w)) {
      // +-(N x cut), taken to the side of the edge's middle.
      const int crossing = AddDirection(
          {DirectionRecipe::Kind::kCrossing, false, side.plane, cut});
      const Vec3<Exact> middle =
          Plus(exact.FromReceiver(v), exact.FromReceiver(w));
      if (Dot(DirectionOf(crossing), middle).sign() == CGAL::NEGATIVE) {
        contour_.directions[Index(crossing)].negated = true;
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
    std::vector<int> corners;
    for (std::size_t i = 0; i < count; ++i) {
      const int previous = sides[(i + count - 1) % count].plane;
      const Vec3<Exact> truth = DirectionOf(sides[i].from);
      const int corner = AddDirection(
          {DirectionRecipe::Kind::kCrossing, false, previous, sides[i].plane});
      if (Dot(DirectionOf(corner), truth).sign() == CGAL::NEGATIVE) {
        contour_.directions[Index(corner)].negated = true;
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
    PlaneRecipe plane;
    plane.kind = PlaneRecipe::Kind::kExplicit;
    plane.a = explicit_of(PlaneOf(side.plane));
    side.plane = AddPlane(plane);
    for (int* end : {&side.from, &side.to}) {
      DirectionRecipe direction;
      direction.kind = DirectionRecipe::Kind::kExplicit;
      direction.a = explicit_of(DirectionOf(*end));
      *end = AddDirection(direction);
    }
  }
}

void HandContour::AddSource(const std::vector<Side>& sides,
                            const Rgb& emission) {
  SourceArcs source;
  source.facet = static_cast<int>(contour_.sources.size());
  source.first_arc = static_cast<int>(contour_.arcs.size());
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
