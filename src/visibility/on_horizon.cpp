// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/on_horizon.h"

#include <cstddef>

#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {

bool IsOnHorizon(const Scene& scene, const Receiver& receiver,
                 const ContourVertex& vertex) {
  if (vertex.vertex < 0) return vertex.kind == VertexKind::kHorizon;
  const Point3& v = scene.vertices()[static_cast<std::size_t>(vertex.vertex)];
  const Point3& r = receiver.position;
  const Vector3& n = receiver.normal;
  const Vec3<Exact> normal{Exact(n.x), Exact(n.y), Exact(n.z)};
  const Vec3<Exact> direction =
      Vec3<Exact>{Exact(v.x), Exact(v.y), Exact(v.z)} -
      Vec3<Exact>{Exact(r.x), Exact(r.y), Exact(r.z)};
  return SignOf(Dot(normal, direction)) == Sign::kZero;
}

}  // namespace truelux
