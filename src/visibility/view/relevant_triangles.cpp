// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/relevant_triangles.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "visibility/view/rounded_angles.h"

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

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
  std::array<Vec3<double>, 3> units{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3& p = query.scene.vertices()[Index(triangle.vertices[k])];
    const Point3& r = query.receiver.position;
    units[k] = UnitOf(Vec3<double>{p.x - r.x, p.y - r.y, p.z - r.z});
  }
  return {units[0], std::max(AngleBetween(units[0], units[1]),
                             AngleBetween(units[0], units[2]))};
}

std::vector<Cap> CapsOf(const ContourQuery& query, int facet) {
  const Facet& f = query.scene.facets()[Index(facet)];
  std::vector<Cap> caps;
  for (const Triangle& triangle : query.scene.triangles().subspan(
           Index(f.first_triangle), Index(f.triangle_count)))
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

  [[nodiscard]] bool IsIgnored(int triangle) const {
    const int facet = query_.scene.triangles()[Index(triangle)].facet;
    return !ignored_.empty() && ignored_[FacetId(facet)];
  }

  [[nodiscard]] bool IsEdgeOn(int triangle) const {
    return sides_.OfReceiver(TriangleId(triangle)) == Sign::kZero;
  }

 private:
  const ContourQuery& query_;
  TriangleSides sides_;
  IdVector<FacetId, bool> ignored_;
};

}  // namespace

std::vector<int> RelevantTriangles(const ContourQuery& query) {
  const Participation participation(query);
  std::vector<int> relevant;
  const int count = static_cast<int>(query.scene.triangles().size());
  for (int t = 0; t < count; ++t) {
    if (!participation.IsIgnored(t) && !participation.IsEdgeOn(t))
      relevant.push_back(t);
  }
  return relevant;
}

std::vector<int> TrianglesOfSource(const ContourQuery& query,
                                   const FacetFront& source) {
  const Participation participation(query);
  const std::vector<Cap> caps = CapsOf(query, source.facet());
  // The cheapest question first.
  const auto can_hide_source = [&](int t, const Triangle& triangle) {
    return !IsBeside(CapOf(query, triangle), caps) && source.CanBeHiddenBy(t) &&
           !participation.IsEdgeOn(t);
  };
  std::vector<int> relevant;
  const auto triangles = query.scene.triangles();
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    const Triangle& triangle = triangles[Index(t)];
    if (participation.IsIgnored(t)) continue;
    if (triangle.facet == source.facet() || can_hide_source(t, triangle))
      relevant.push_back(t);
  }
  return relevant;
}

}  // namespace truelux
