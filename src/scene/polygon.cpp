// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/polygon.h"

#include <optional>
#include <span>

#include "exact/number.h"

namespace truelux {

PolygonKind PolygonReader::Read(std::span<const Point3> ring) {
  const RoundUpward rounding;
  triangles_.clear();
  const RingShape shape = projection_.Project(ring);
  if (shape == RingShape::kNoArea) return PolygonKind::kNoArea;
  if (shape == RingShape::kZeroNormal) return PolygonKind::kZeroNormal;
  if (ring.size() == 3) {
    triangles_.push_back({0, 1, 2});
    return PolygonKind::kPlanar;
  }
  if (const std::optional<BoundaryContact> contact = FindContact(projection_)) {
    contact_ = *contact;
    return PolygonKind::kNotSimple;
  }
  Triangulate(projection_, triangles_);
  return shape == RingShape::kPlanar ? PolygonKind::kPlanar
                                     : PolygonKind::kNotPlanar;
}

}  // namespace truelux
