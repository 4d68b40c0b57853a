// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/line_cover.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace truelux {
namespace {

double CoordinateOf(const Point3& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

bool AreSame(std::span<const FacetSide> a, std::span<const FacetSide> b) {
  return std::ranges::equal(a, b, [](const FacetSide& x, const FacetSide& y) {
    return x.facet == y.facet && x.is_forward == y.is_forward;
  });
}

}  // namespace

double LineCover::PlaceOf(int vertex) const {
  return CoordinateOf(scene_.vertices()[static_cast<std::size_t>(vertex)],
                      axis_);
}

void LineCover::Add(const std::array<int, 2>& ends,
                    std::span<const FacetSide> facets) {
  if (axis_ < 0) {
    const Point3& a = scene_.vertices()[static_cast<std::size_t>(ends[0])];
    const Point3& b = scene_.vertices()[static_cast<std::size_t>(ends[1])];
    axis_ = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (std::fabs(CoordinateOf(b, axis) - CoordinateOf(a, axis)) >
          std::fabs(CoordinateOf(b, axis_) - CoordinateOf(a, axis_))) {
        axis_ = axis;
      }
    }
  }
  Edge edge{ends, {facets.begin(), facets.end()}};
  if (PlaceOf(ends[1]) < PlaceOf(ends[0])) {
    std::swap(edge.ends[0], edge.ends[1]);
    for (FacetSide& side : edge.facets)
      side.is_forward = !side.is_forward;
  }
  edges_.push_back(std::move(edge));
}

std::vector<LinePiece> LineCover::Pieces() const {
  std::vector<int> cuts;
  for (const Edge& edge : edges_)
    cuts.insert(cuts.end(), edge.ends.begin(), edge.ends.end());
  // Equal points are one vertex.
  std::ranges::sort(cuts, {}, [this](int vertex) { return PlaceOf(vertex); });
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::vector<LinePiece> pieces;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    LinePiece piece{{cuts[i], cuts[i + 1]}, {}};
    for (const Edge& edge : edges_) {
      if (PlaceOf(edge.ends[0]) <= PlaceOf(cuts[i]) &&
          PlaceOf(cuts[i + 1]) <= PlaceOf(edge.ends[1])) {
        piece.facets.insert(piece.facets.end(), edge.facets.begin(),
                            edge.facets.end());
      }
    }
    if (piece.facets.empty()) continue;
    if (!pieces.empty() && pieces.back().ends[1] == cuts[i] &&
        AreSame(pieces.back().facets, piece.facets)) {
      pieces.back().ends[1] = cuts[i + 1];
    } else {
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

}  // namespace truelux
