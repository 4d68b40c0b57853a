// SPDX-License-Identifier: GPL-3.0-or-later
// The form factors of all lights at some points, and two oracles over one
// prepared scene.

#include <cstddef>
#include <cstdio>
#include <vector>

#include "truelux/truelux.h"

int main() {
  truelux::SceneBuilder builder;
  // Two square lights side by side, and a black sheet below the second.
  builder.AddFace({{-2, -1, 2}, {-2, 1, 2}, {0, 1, 2}, {0, -1, 2}}, {9, 9, 9});
  builder.AddFace({{0, -1, 2}, {0, 1, 2}, {2, 1, 2}, {2, -1, 2}}, {5, 5, 5});
  builder.AddFace({{0, -1, 1}, {2, -1, 1}, {2, 1, 1}, {0, 1, 1}});
  const truelux::Result<truelux::Scene> scene = builder.Build();
  if (!scene.ok()) return 1;

  // What is prepared serves both oracles.
  const truelux::PreparedScene prepared(*scene.value);
  const truelux::Oracle oracle(prepared);
  const truelux::Oracle fast(prepared, {.method = truelux::Method::kDouble});

  const std::vector<truelux::Receiver> receivers = {
      {{-1, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 0, 1}}};
  for (const truelux::Receiver& receiver : receivers) {
    std::printf("at (%g, %g, %g):", receiver.position.x, receiver.position.y,
                receiver.position.z);
    for (const auto& factor : oracle.FormFactors(receiver).faces)
      std::printf(" face %d F = %.17g", factor.face, factor.value);
    const truelux::Irradiance e = fast.Evaluate(receiver);
    std::printf(", E = %.6g +- %.1g W/m^2\n", e.value[0], e.bound[0]);
  }

  // Of many receivers, one that cannot be used is named by its index from 0.
  std::vector<truelux::Receiver> wrong = receivers;
  wrong[2].normal = {0, 0, 0};
  try {
    (void)oracle.Evaluate(wrong);
  } catch (const truelux::ReceiverError& error) {
    std::printf("%s (index %zu)\n", error.what(), error.index());
  }
  return 0;
}
