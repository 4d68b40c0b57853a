// SPDX-License-Identifier: GPL-3.0-or-later
// A scene made in code: the irradiance at one point below a square light that
// is half hidden.

#include <cstdio>

#include "truelux/truelux.h"

int main() {
  truelux::SceneBuilder builder;
  // The light: a square of side 2 at height 2. Its front, from where its
  // corners run counter-clockwise, looks down. It emits 100 W/m^2, in red
  // half as much.
  builder.AddFace({{-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}},
                  {50, 100, 100});
  // A black sheet at height 1 hides the half with x > 0 from the origin.
  builder.AddFace({{0, -3, 1}, {3, -3, 1}, {3, 3, 1}, {0, 3, 1}});

  const truelux::Result<truelux::Scene> scene = builder.Build();
  for (const truelux::Diagnostic& diagnostic : scene.diagnostics) {
    std::fprintf(stderr, "%s\n", diagnostic.Text().c_str());
  }
  if (!scene.ok()) return 1;

  const truelux::Oracle oracle(*scene.value);
  const truelux::Receiver receiver{{0, 0, 0}, {0, 0, 1}};
  const truelux::Irradiance e = oracle.Evaluate(receiver);
  // 17 digits tell which binary64 it is: the one nearest to the true value.
  std::printf("E = %.17g %.17g %.17g W/m^2\n", e.value[0], e.value[1],
              e.value[2]);
  return 0;
}
