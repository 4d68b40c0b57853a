// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux_floors.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "truelux/io.h"

#include "support/portable_random.h"

namespace truelux::bench {
namespace {

using testing::PortableRandom;

/// A room with boxes on and above its floor, a hundred faces in all.
Scene MakeRoom() {
  PortableRandom random(17);
  SceneBuilder builder("room of 100 faces");
  builder.SetGroup("floor");
  builder.AddFace({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}});
  builder.SetGroup("room");
  builder.AddFace({{0, 0, 0}, {0, 0, 4}, {10, 0, 4}, {10, 0, 0}});
  builder.AddFace({{10, 0, 0}, {10, 0, 4}, {10, 10, 4}, {10, 10, 0}});
  builder.AddFace({{10, 10, 0}, {10, 10, 4}, {0, 10, 4}, {0, 10, 0}});
  builder.AddFace({{0, 10, 0}, {0, 10, 4}, {0, 0, 4}, {0, 0, 0}});
  for (int i = 0; i < 4; ++i) {
    const double x = i % 2 == 0 ? 2 : 7;
    const double y = i / 2 == 0 ? 2 : 7;
    builder.AddFace(
        {{x, y, 3.9}, {x, y + 1, 3.9}, {x + 1, y + 1, 3.9}, {x + 1, y, 3.9}},
        {1, 1, 1});
  }
  for (int i = 0; i < 15; ++i) {
    // Turned boxes; every third one hangs.
    const double turn = random.Uniform(0, 1.5);
    const double x = random.Uniform(1, 9);
    const double y = random.Uniform(1, 9);
    const double z = i % 3 == 2 ? random.Uniform(0.5, 2) : 0;
    const double h = random.Uniform(0.3, 1.2);
    const double a = random.Uniform(0.15, 0.5);
    std::array<std::array<double, 2>, 4> c{};
    for (std::size_t k = 0; k < 4; ++k) {
      const double angle = turn + 1.5707963 * static_cast<double>(k);
      c[k] = {x + a * std::cos(angle), y + a * std::sin(angle)};
    }
    const auto at = [&](std::size_t k, double height) {
      return Point3{c[k % 4][0], c[k % 4][1], height};
    };
    builder.AddFace({at(0, z + h), at(1, z + h), at(2, z + h), at(3, z + h)});
    for (std::size_t k = 0; k < 4; ++k) {
      builder.AddFace({at(k, z), at(k + 1, z), at(k + 1, z + h), at(k, z + h)});
    }
    if (z > 0) builder.AddFace({at(3, z), at(2, z), at(1, z), at(0, z)});
  }
  return *builder.Build().value;
}

Scene Example(const char* name) {
  auto result = ReadScene(std::string(TRUELUX_EXAMPLES "/scenes/") + name);
  if (!result.ok()) throw std::invalid_argument(result.diagnostics[0].Text());
  return *result.value;
}

}  // namespace

std::vector<IsoluxFloor> IsoluxFloors() {
  return {
      {"cornell", Example("cornell_box.obj"), {550, 0, 0}, 550, 559},
      {"room of 100", MakeRoom(), {0, 0, 0}, 10, 10},
      {"figure7_c", Example("figure7_c.obj"), {-6, -6, 0}, 12, 12},
      {"figure7_a", Example("figure7_a.obj"), {-5.5, -5.5, 0}, 11, 11},
  };
}

}  // namespace truelux::bench
