// SPDX-License-Identifier: GPL-3.0-or-later
// A scene whose vertices can be moved one by one.

#ifndef TRUELUX_SCENE_LOOSE_SCENE_H_
#define TRUELUX_SCENE_LOOSE_SCENE_H_

#include <optional>
#include <vector>

#include "truelux/scene.h"

#include "base/ids.h"
#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {

/// The same faces, seen and numbered as before, for exact displacements of a
/// vertex (exact/displacement.h): every vertex of the input is one of its own,
/// also where several are in one place; every triangle is a facet of its own,
/// so that it may tilt; and no facets are known to be coplanar.
struct LooseScene {
  Scene scene;
  std::vector<int> numbers;  ///< of its vertices in the input, ascending

  /// The vertex with a number; none if no face uses it.
  [[nodiscard]] VertexId VertexOf(int number) const;
};

/// The scene with the triangles that its faces have if a vertex is displaced by
/// a step, where these differ: a step makes slivers of corners on one line.
/// Nothing if none does. Faces of more than 64 corners keep their triangles.
std::optional<Scene> WithDisplacedTriangles(const LooseScene& loose,
                                            VertexId vertex,
                                            const Vec3<Exact>& step);

/// Makes it, in time proportional to the scene.
LooseScene LooseSceneOf(const Scene& scene);

}  // namespace truelux

#endif  // TRUELUX_SCENE_LOOSE_SCENE_H_
