// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/polygon.h"

#include <cstddef>
#include <optional>
#include <span>

#include "exact/number.h"
#include "scene/ring_mesh.h"

namespace truelux {
namespace {

/// Up to so many points comparing all edges is as fast as anything.
constexpr std::size_t kFew = 64;

}  // namespace

PolygonKind PolygonReader::Read(std::span<const Point3> ring) {
  const RoundUpward rounding;
  triangles_.clear();
  const RingShape shape = projection_.Project(ring);
  if (shape == RingShape::kNoArea) return PolygonKind::kNoArea;
  const bool is_planar =
      shape == RingShape::kPlanar || shape == RingShape::kFlat;
  if (!is_planar && ring.size() > kMostNotPlanar) return PolygonKind::kTooLarge;
  if (shape == RingShape::kZeroNormal) {
    TakeFan(ring);
    return PolygonKind::kNotPlanar;
  }
  if (ring.size() == 3) {
    triangles_.push_back({0, 1, 2});
    return PolygonKind::kPlanar;
  }
  if (shape == RingShape::kPlanar && ring.size() > kFew) {
    const PolygonKind kind = ReadByMesh();
    if (kind == PolygonKind::kNoPolygon)
      contact_ = FindContact(projection_).value_or(BoundaryContact{});
    return kind;
  }
  if (const std::optional<BoundaryContact> contact = FindContact(projection_)) {
    contact_ = *contact;
    const PolygonKind kind = ReadMeetingItself(shape);
    if (kind == PolygonKind::kNotPlanar && triangles_.empty()) TakeFan(ring);
    return kind;
  }
  Triangulate(projection_, triangles_);
  return shape == RingShape::kPlanar ? PolygonKind::kPlanar
                                     : PolygonKind::kNotPlanar;
}

bool PolygonReader::ReadDisplaced(std::span<const Point3> ring,
                                  const RingDisplacement& displacement) {
  const RoundUpward rounding;
  triangles_.clear();
  if (ring.size() > kFew) return false;
  const RingShape shape = projection_.Project(ring, displacement);
  if (shape != RingShape::kPlanar && shape != RingShape::kNotPlanar)
    return false;
  if (FindContact(projection_)) return false;
  Triangulate(projection_, triangles_);
  return true;
}

/// A planar ring that has many points or meets itself.
PolygonKind PolygonReader::ReadByMesh() {
  switch (MeshInside(projection_, triangles_)) {
    case RingInside::kOnce:
      return PolygonKind::kPlanar;
    case RingInside::kNothing:
      return PolygonKind::kNoArea;
    default:
      return PolygonKind::kNoPolygon;
  }
}

/// A ring of four points or more whose image meets itself. Without triangles
/// if it is not planar and the fan stands for it.
PolygonKind PolygonReader::ReadMeetingItself(RingShape shape) {
  if (shape == RingShape::kPlanar) return ReadByMesh();
  const RingInside inside = FindInside(projection_);
  if (shape == RingShape::kFlat) {
    return inside == RingInside::kNothing ? PolygonKind::kNoArea
                                          : PolygonKind::kNoPolygon;
  }
  if (inside == RingInside::kOnce)
    TriangulateMeetingItself(projection_, triangles_);
  return PolygonKind::kNotPlanar;
}

/// The fan from the first point, without the triangles whose corners are on one
/// line.
void PolygonReader::TakeFan(std::span<const Point3> ring) {
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    if (AreOnOneLine(ring[0], ring[i], ring[i + 1])) continue;
    triangles_.push_back({0, static_cast<int>(i), static_cast<int>(i) + 1});
  }
}

}  // namespace truelux
