// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/facet_normal.h"

#include <cstddef>

#include "exact/number.h"
#include "exact/primitive.h"
#include "exact/vec3.h"
#include "scene/newell.h"

namespace truelux {

Vector3 FacetNormal(const Scene& scene, int facet) {
  const Facet& f = scene.facets()[static_cast<std::size_t>(facet)];
  const Triangle& triangle =
      scene.triangles()[static_cast<std::size_t>(f.first_triangle)];
  const auto corner = [&](std::size_t k) {
    return scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])];
  };
  const PrimitiveVector normal =
      MakePrimitive(Cross(Displacement<Exact>(corner(0), corner(1)),
                          Displacement<Exact>(corner(0), corner(2))));
  const mpz_class most = mpz_class(1) << 53;
  if (abs(normal.x) <= most && abs(normal.y) <= most && abs(normal.z) <= most) {
    return {normal.x.get_d(), normal.y.get_d(), normal.z.get_d()};
  }
  return ToDouble(normal);
}

}  // namespace truelux
