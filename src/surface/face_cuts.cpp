// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/face_cuts.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/stop.h"
#include "scene/emitters.h"

namespace truelux {
namespace {

using Ends = std::array<int, 2>;

/// A triangle and its box.
struct Sheet {
  const Triangle* triangle = nullptr;
  std::array<Point3, 3> corners;
  std::array<double, 3> least{};
  std::array<double, 3> most{};
  bool emits = false;
};

Sheet SheetOf(const Scene& scene, const Triangle& triangle) {
  const Facet& facet = scene.facets()[static_cast<std::size_t>(triangle.facet)];
  Sheet sheet;
  sheet.triangle = &triangle;
  sheet.emits = Emits(scene.faces()[static_cast<std::size_t>(facet.face)]);
  for (std::size_t k = 0; k < 3; ++k) {
    sheet.corners[k] =
        scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])];
  }
  const auto& [a, b, c] = sheet.corners;
  sheet.least = {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}),
                 std::min({a.z, b.z, c.z})};
  sheet.most = {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}),
                std::max({a.z, b.z, c.z})};
  return sheet;
}

bool HaveCommonBox(const Sheet& a, const Sheet& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.most[axis] < b.least[axis] || b.most[axis] < a.least[axis])
      return false;
  }
  return true;
}

RationalVector NormalOf(const Sheet& sheet) {
  const RationalVector a = RationalOf(sheet.corners[0]);
  return Cross(RationalOf(sheet.corners[1]) - a,
               RationalOf(sheet.corners[2]) - a);
}

/// Where a plane cuts a triangle.
struct Chord {
  FaceCut ends;
  std::optional<Ends> edge;  ///< the edge that it is
};

/// Nothing if the plane meets the triangle in a point at most, or is its own.
std::optional<Chord> ChordOf(const Sheet& sheet, const RationalVector& normal,
                             const RationalVector& at) {
  std::array<RationalVector, 3> corners;
  std::array<mpq_class, 3> heights;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = RationalOf(sheet.corners[k]);
    heights[k] = Dot(normal, corners[k] - at);
  }
  std::vector<RationalVector> points;
  std::vector<int> vertices;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (heights[k] == 0) {
      points.push_back(corners[k]);
      vertices.push_back(sheet.triangle->vertices[k]);
    }
    if (sgn(heights[k]) * sgn(heights[next]) < 0) {
      const mpq_class share = heights[k] / (heights[k] - heights[next]);
      points.push_back(corners[k] + share * (corners[next] - corners[k]));
    }
  }
  if (points.size() != 2) return std::nullopt;
  Chord chord{{points[0], points[1]}, std::nullopt};
  if (vertices.size() == 2) {
    const auto [first, last] = std::minmax(vertices[0], vertices[1]);
    chord.edge = Ends{first, last};
  }
  return chord;
}

/// What two chords on one line have in common, if it is more than a point.
std::optional<FaceCut> CommonPart(FaceCut a, FaceCut b) {
  const RationalVector along = a[1] - a[0];
  const auto place = [&along](const RationalVector& p) {
    return Dot(along, p);
  };
  if (place(b[0]) > place(b[1])) std::swap(b[0], b[1]);
  const RationalVector& from = place(a[0]) < place(b[0]) ? b[0] : a[0];
  const RationalVector& to = place(a[1]) < place(b[1]) ? a[1] : b[1];
  if (place(from) >= place(to)) return std::nullopt;
  return FaceCut{from, to};
}

std::optional<FaceCut> CutOf(const Sheet& a, const Sheet& b,
                             const std::set<Ends>& outlines) {
  const auto is_outline = [&outlines](const std::optional<Chord>& chord) {
    return chord->edge && outlines.contains(*chord->edge);
  };
  const auto of_a = ChordOf(a, NormalOf(b), RationalOf(b.corners[0]));
  if (!of_a || is_outline(of_a)) return std::nullopt;
  const auto of_b = ChordOf(b, NormalOf(a), RationalOf(a.corners[0]));
  if (!of_b || is_outline(of_b)) return std::nullopt;
  return CommonPart(of_a->ends, of_b->ends);
}

}  // namespace

std::vector<FaceCut> FaceCutsOf(const Scene& scene,
                                const std::set<std::array<int, 2>>& outlines,
                                const StopFlag* stop) {
  std::vector<Sheet> sheets;
  for (const Triangle& triangle : scene.triangles()) {
    // The back of a facet lies where its front does.
    if (!scene.facets()[static_cast<std::size_t>(triangle.facet)].is_back)
      sheets.push_back(SheetOf(scene, triangle));
  }
  std::vector<FaceCut> cuts;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    if (!sheets[i].emits) continue;
    StopIfAsked(stop);
    for (std::size_t k = 0; k < sheets.size(); ++k) {
      // Of two that emit the second is looked at with the first.
      if (sheets[k].triangle->facet == sheets[i].triangle->facet ||
          (sheets[k].emits && k < i) || !HaveCommonBox(sheets[i], sheets[k])) {
        continue;
      }
      if (auto cut = CutOf(sheets[i], sheets[k], outlines))
        cuts.push_back(*std::move(cut));
    }
  }
  return cuts;
}

}  // namespace truelux
