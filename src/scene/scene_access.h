// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's arrays by ids: the public arrays are subscripted by plain numbers,
// the inside by what the numbers stand for.

#ifndef TRUELUX_SCENE_SCENE_ACCESS_H_
#define TRUELUX_SCENE_SCENE_ACCESS_H_

#include <span>

#include "truelux/scene.h"

#include "base/id_vector.h"
#include "base/ids.h"

namespace truelux {

/// Scene::vertices() by ids.
inline IdSpan<VertexId, const Point3> VerticesOf(const Scene& scene) {
  return IdSpan<VertexId, const Point3>(scene.vertices());
}

/// Scene::triangles() by ids.
inline IdSpan<TriangleId, const Triangle> TrianglesOf(const Scene& scene) {
  return IdSpan<TriangleId, const Triangle>(scene.triangles());
}

/// Scene::facets() by ids.
inline IdSpan<FacetId, const Facet> FacetsOf(const Scene& scene) {
  return IdSpan<FacetId, const Facet>(scene.facets());
}

/// Scene::faces() by ids.
inline IdSpan<FaceId, const Face> FacesOf(const Scene& scene) {
  return IdSpan<FaceId, const Face>(scene.faces());
}

/// The facet that a triangle is part of.
inline FacetId FacetOf(const Triangle& triangle) {
  return FacetId(triangle.facet);
}

/// The face that a facet is part of.
inline FaceId FaceOf(const Facet& facet) {
  return FaceId(facet.face);
}

/// The face that a facet of the scene is part of.
inline FaceId FaceOf(const Scene& scene, FacetId facet) {
  return FaceOf(FacetsOf(scene)[facet]);
}

/// A triangle that lies in the plane of a facet: its first one.
inline TriangleId FirstTriangleOf(const Facet& facet) {
  return TriangleId(facet.first_triangle);
}

/// The ids of a face's facets.
inline IdRange<FacetId> FacetsOf(const Face& face) {
  return {FacetId(face.first_facet), face.facet_count};
}

/// The triangles of a facet of the scene.
inline std::span<const Triangle> TrianglesOf(const Scene& scene,
                                             const Facet& facet) {
  return TrianglesOf(scene).Part(FirstTriangleOf(facet), facet.triangle_count);
}

}  // namespace truelux

#endif  // TRUELUX_SCENE_SCENE_ACCESS_H_
