// Uses each public header's part that has to be linked; exits with 0 if the
// answer is right.

#include <cmath>
#include <cstdio>

#include "truelux/truelux.h"

#ifdef CGAL_VERSION
#error "the public headers must not include CGAL"
#endif

int main() {
  truelux::SceneBuilder builder;
  builder.AddFace({{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}}, {1, 1, 1});
  truelux::Result<truelux::Scene> scene = builder.Build();
  if (!scene.ok()) return 1;
  const truelux::Oracle oracle(*scene.value);
  const truelux::Irradiance e = oracle.Evaluate({{0, 0, 0}, {0, 0, 1}});
  std::printf("%.17g\n", e.value[0]);
  const bool right = std::abs(e.value[0] - 0.5541) < 1e-4;
  const bool refuses = !truelux::ReadScene("no such file").ok();
  return right && refuses ? 0 : 1;
}
