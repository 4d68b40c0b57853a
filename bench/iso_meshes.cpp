// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes along contours beside uniform ones with as many vertices: error of
// linear interpolation, and what they cost.

#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <string>

#include "truelux/irradiance.h"
#include "truelux/isolux.h"
#include "truelux/isomesh.h"

#include "isolux_floors.h"

namespace truelux::bench {
namespace {

double SecondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
      .count();
}

void PrintErrors(const char* name, const InterpolationError& error,
                 double range) {
  fmt::print("|   {} | {:.1e} | {:.1e} | {:.1e} |\n", name, error.most / range,
             error.at_99 / range, error.mean / range);
}

void Measure(const IsoluxFloor& floor) {
  const Oracle oracle(floor.scene);
  IsoMeshOptions options;
  options.contours.channel = ScalarChannel::kRed;
  auto begin = std::chrono::steady_clock::now();
  const Isolux isolux = IsoluxOf(oracle, "floor", options.contours);
  const double of_contours = SecondsSince(begin);
  begin = std::chrono::steady_clock::now();
  const IsoMesh mesh = IsoMeshOf(oracle, "floor", options);
  fmt::print("| {} | {} | {} | {} | {:.3f} | {} | {:.1f} | {:.1f} |\n",
             floor.name, mesh.vertices.size(), mesh.triangles.size(),
             mesh.unfinished, mesh.least_angle, mesh.evaluations, of_contours,
             SecondsSince(begin) - of_contours);
  const double range = isolux.most - isolux.least;
  PrintErrors("along the light", mesh.interpolation, range);
  PrintErrors("uniform", mesh.uniform, range);
  std::fflush(stdout);
}

}  // namespace
}  // namespace truelux::bench

int main(int argc, char** argv) {
  using namespace truelux::bench;  // NOLINT(google-build-using-namespace)
  const std::string only = argc > 1 ? argv[1] : "";
  fmt::print(
      "| floor | vertices | triangles | unfinished | least angle | evaluations "
      "| s of contours | s of the mesh |\n"
      "|   errors by the range of E: | largest | 99 % | mean |\n");
  for (const IsoluxFloor& floor : IsoluxFloors()) {
    if (floor.name.find(only) != std::string::npos) Measure(floor);
  }
  return 0;
}
