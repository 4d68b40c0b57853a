// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/relevant_triangles.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "scene/scene_access.h"
#include "visibility/view/rounded_angles.h"

namespace truelux {
namespace {

/// Directions within an angle of one of them. A wide cap, of no less than 1.5,
/// stands for all directions.
struct Cap {
  Vec3<double> center;
  double radius = 0;

  [[nodiscard]] bool IsWide() const { return !(radius < 1.5); }
};

/// Holds a triangle, around the direction to its first corner. In binary64,
/// which is off by far less than kBesideSource.
Cap CapOf(const ContourQuery& query, const Triangle& triangle) {
  const std::array<VertexId, 3> corners = CornersOf(triangle);
  std::array<Vec3<double>, 3> units{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3& p = VerticesOf(query.scene)[corners[k]];
    const Point3& r = query.receiver.position;
    units[k] = UnitOf(Vec3<double>{p.x - r.x, p.y - r.y, p.z - r.z});
  }
  return {units[0], std::max(AngleBetween(units[0], units[1]),
                             AngleBetween(units[0], units[2]))};
}

std::vector<Cap> CapsOf(const ContourQuery& query, FacetId facet) {
  const Facet& f = FacetsOf(query.scene)[facet];
  std::vector<Cap> caps;
  for (const Triangle& triangle : TrianglesOf(query.scene, f))
    caps.push_back(CapOf(query, triangle));
  return caps;
}

bool IsBeside(const Cap& cap, const std::vector<Cap>& source) {
  return !cap.IsWide() && std::ranges::all_of(source, [&cap](const Cap& s) {
    return !s.IsWide() && LeastAngle(cap.center, s.center,
                                     cap.radius + s.radius) > kBesideSource;
  });
}

/// Whether triangles take part in a view.
class Participation {
 public:
  explicit Participation(const ContourQuery& query)
      : query_(query), sides_(ViewOf(query)), ignored_(IgnoredFacets(query)) {}

  [[nodiscard]] bool IsIgnored(TriangleId triangle) const {
    return !ignored_.empty() &&
           ignored_[FacetOf(TrianglesOf(query_.scene)[triangle])];
  }

  [[nodiscard]] bool IsEdgeOn(TriangleId triangle) const {
    return sides_.OfReceiver(triangle) == Sign::kZero;
  }

 private:
  const ContourQuery& query_;
  TriangleSides sides_;
  IdVector<FacetId, bool> ignored_;
};

}  // namespace

std::vector<TriangleId> RelevantTriangles(const ContourQuery& query) {
  const Participation participation(query);
  std::vector<TriangleId> relevant;
  for (const TriangleId t : TrianglesOf(query.scene).ids()) {
    if (!participation.IsIgnored(t) && !participation.IsEdgeOn(t))
      relevant.push_back(t);
  }
  return relevant;
}

std::vector<TriangleId> TrianglesOfSource(const ContourQuery& query,
                                          const FacetFront& source) {
  const Participation participation(query);
  const std::vector<Cap> caps = CapsOf(query, source.facet());
  // The cheapest question first.
  const auto can_hide_source = [&](TriangleId t, const Triangle& triangle) {
    return !IsBeside(CapOf(query, triangle), caps) && source.CanBeHiddenBy(t) &&
           !participation.IsEdgeOn(t);
  };
  std::vector<TriangleId> relevant;
  const auto triangles = TrianglesOf(query.scene);
  for (const TriangleId t : triangles.ids()) {
    const Triangle& triangle = triangles[t];
    if (participation.IsIgnored(t)) continue;
    if (FacetOf(triangle) == source.facet() || can_hide_source(t, triangle))
      relevant.push_back(t);
  }
  return relevant;
}

}  // namespace truelux
