// SPDX-License-Identifier: GPL-3.0-or-later
// A lightmap of another program, held against the truth: what is wrong with it?
// Links to truelux::tools, which has compare.h and render.h.

#include <cstddef>
#include <cstdio>
#include <numbers>
#include <vector>

#include "truelux/compare.h"
#include "truelux/io.h"
#include "truelux/render.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: 06_compare cornell_box.obj\n", stderr);
    return 2;
  }
  const auto scene = truelux::ReadScene(argv[1]);
  if (!scene.ok()) return 2;

  // The floor as 16 x 16 texels, each with its receiver and the exact value.
  const truelux::Oracle oracle(*scene.value);
  const truelux::Rendering truth =
      truelux::Render(oracle, "floor", {16, 16}, {});

  // The other program takes Ke for a radiance, and computes in binary32.
  truelux::Candidate lightmap;
  lightmap.receivers = truth.receivers.pixels();
  for (const truelux::Rgb& e : truth.pixels.image.values.pixels()) {
    truelux::Rgb value{};
    for (std::size_t c = 0; c < 3; ++c)
      value[c] = static_cast<float>(std::numbers::pi * e[c]);
    lightmap.values.push_back(value);
  }

  const truelux::CandidateComparison found =
      truelux::Compare(*scene.value, lightmap, {.tolerance = 1e-3});
  std::printf("%zu of %zu texels are wrong\n", found.summary.failing(),
              found.summary.receivers);
  std::printf("%s\n", found.diagnosis.text.c_str());
  return 0;
}
