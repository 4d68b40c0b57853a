// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/on_horizon.h"

#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"

namespace truelux {

bool IsOnHorizon(const Scene& scene, const Receiver& receiver,
                 const ContourVertex& vertex) {
  if (vertex.vertex < 0) return vertex.kind == VertexKind::kHorizon;
  const RecipeEvaluator<Exact> exact({VerticesOf(scene), TrianglesOf(scene),
                                      receiver.position, receiver.normal});
  return exact.AboveHorizon(VertexId(vertex.vertex)).is_zero();
}

}  // namespace truelux
