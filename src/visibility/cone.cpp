#include "visibility/cone.h"

#include <algorithm>

namespace truelux {
namespace {

constexpr signed char kUnknown = 2;

EdgeKey KeyOf(int a, int b) {
  const auto lo = static_cast<EdgeKey>(std::min(a, b));
  const auto hi = static_cast<EdgeKey>(std::max(a, b));
  return hi << 32 | lo;
}

/// The part of a triangle's cone where a linear function is >= 0. sides: the
/// function's signs at the corners, at least one positive and one negative.
/// cut: id of the plane where the function is 0, normal to the positive side.
/// crossing(p, q): id of the direction where the edge between corner p
/// (positive) and corner q (negative) meets the cut.
template <class MakeCrossing>
Cone Clip(const Cone& whole, const std::array<Sign, 3>& sides, int cut,
          const MakeCrossing& crossing) {
  Cone part;
  part.triangle = whole.triangle;
  const auto add = [&part](int direction, int plane, EdgeKey key) {
    part.directions[part.size] = direction;
    part.planes[part.size] = plane;
    part.keys[part.size] = key;
    ++part.size;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = k < 2 ? k + 1 : 0;
    const Sign here = sides[k];
    const Sign there = sides[next];
    if (here == Sign::kPositive ||
        (here == Sign::kZero && there != Sign::kNegative)) {
      add(whole.directions[k], whole.planes[k], whole.keys[k]);
      if (there == Sign::kNegative) add(crossing(k, next), cut, kNoEdgeKey);
    } else if (here == Sign::kZero) {
      add(whole.directions[k], cut, kNoEdgeKey);
    } else if (there == Sign::kPositive) {
      add(crossing(next, k), whole.planes[k], whole.keys[k]);
    }
  }
  return part;
}

}  // namespace

ConeMaker::ConeMaker(ViewGeometry& geometry,
                     std::span<const Triangle> triangles)
    : geometry_(geometry),
      triangles_(triangles),
      horizon_(geometry.AddPlane({.kind = PlaneRecipe::Kind::kHorizon})),
      receiver_side_(triangles.size(), kUnknown),
      whole_index_(triangles.size(), -1) {}

Sign ConeMaker::ReceiverSide(int triangle) {
  signed char& side = receiver_side_[static_cast<std::size_t>(triangle)];
  if (side == kUnknown) {
    side = static_cast<signed char>(geometry_.ReceiverSide(triangle));
  }
  return static_cast<Sign>(side);
}

Sign ConeMaker::HorizonSide(int vertex) {
  const int direction = geometry_.VertexDirection(vertex);
  const auto index = static_cast<std::size_t>(direction);
  if (index >= horizon_side_.size()) horizon_side_.resize(index + 1, kUnknown);
  signed char& side = horizon_side_[index];
  if (side == kUnknown) {
    side =
        static_cast<signed char>(geometry_.PlaneSide(horizon_, direction).sign);
  }
  return static_cast<Sign>(side);
}

std::array<int, 3> ConeMaker::Corners(int triangle) {
  std::array<int, 3> corners =
      triangles_[static_cast<std::size_t>(triangle)].vertices;
  // h > 0: the normal points away from r, so that the corners already run
  // counter-clockwise seen from r; else they run clockwise.
  if (ReceiverSide(triangle) != Sign::kPositive) {
    std::swap(corners[1], corners[2]);
  }
  return corners;
}

const Cone& ConeMaker::Whole(int triangle) {
  int& index = whole_index_[static_cast<std::size_t>(triangle)];
  if (index < 0) {
    index = static_cast<int>(whole_.size());
    Cone cone;
    cone.triangle = triangle;
    cone.size = 3;
    const std::array<int, 3> corners = Corners(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = corners[k];
      const int to = corners[k < 2 ? k + 1 : 0];
      cone.directions[k] = geometry_.VertexDirection(from);
      cone.planes[k] = geometry_.AddPlane(
          {.kind = PlaneRecipe::Kind::kEdge, .a = from, .b = to});
      cone.keys[k] = KeyOf(from, to);
    }
    whole_.push_back(cone);
  }
  return whole_[static_cast<std::size_t>(index)];
}

std::optional<Cone> ConeMaker::AboveHorizon(int triangle) {
  const std::array<int, 3> corners = Corners(triangle);
  std::array<Sign, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k)
    sides[k] = HorizonSide(corners[k]);
  if (std::ranges::count(sides, Sign::kPositive) == 0) return std::nullopt;
  const Cone& whole = Whole(triangle);
  if (std::ranges::count(sides, Sign::kNegative) == 0) return whole;
  return Clip(whole, sides, horizon_, [&](std::size_t p, std::size_t q) {
    return geometry_.AddDirection(
        {.kind = DirectionRecipe::Kind::kEdgeAtHorizon,
         .a = corners[p],
         .b = corners[q]});
  });
}

std::optional<Cone> ConeMaker::InFrontOf(int source, int triangle,
                                         bool earlier) {
  const std::array<int, 3> corners = Corners(triangle);
  std::array<Sign, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = geometry_.VertexSide(source, corners[k]);
  }
  const auto positive = std::ranges::count(sides, Sign::kPositive);
  const auto negative = std::ranges::count(sides, Sign::kNegative);
  if (positive == 0 && (negative > 0 || !earlier)) return std::nullopt;
  const Cone& whole = Whole(triangle);
  if (negative == 0) return whole;
  // c = sign(h_T) (h_T N_S - h_S N_T), method.md eq. (5): c . d > 0 where the
  // ray along d meets T in front of the plane of S.
  const int cut =
      geometry_.AddPlane({.kind = PlaneRecipe::Kind::kCut,
                          .negated = ReceiverSide(triangle) == Sign::kNegative,
                          .a = source,
                          .b = triangle});
  return Clip(whole, sides, cut, [&](std::size_t p, std::size_t q) {
    return geometry_.AddDirection({.kind = DirectionRecipe::Kind::kEdgeAtPlane,
                                   .a = corners[p],
                                   .b = corners[q],
                                   .c = source});
  });
}

namespace {

/// Whether some plane of a has all directions of b on its outer side.
bool Separates(ViewGeometry& geometry, const Cone& a, const Cone& b) {
  for (std::size_t k = 0; k < a.size; ++k) {
    std::size_t outside = 0;
    while (outside < b.size &&
           geometry.PlaneSide(a.planes[k], b.directions[outside]).sign !=
               Sign::kPositive) {
      ++outside;
    }
    if (outside == b.size) return true;
  }
  return false;
}

}  // namespace

bool Apart(ViewGeometry& geometry, const Cone& a, const Cone& b) {
  return Separates(geometry, a, b) || Separates(geometry, b, a);
}

bool Contains(ViewGeometry& geometry, const Cone& outer, const Cone& inner) {
  for (std::size_t k = 0; k < outer.size; ++k) {
    for (std::size_t d = 0; d < inner.size; ++d) {
      if (geometry.PlaneSide(outer.planes[k], inner.directions[d]).sign ==
          Sign::kNegative) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace truelux
