// SPDX-License-Identifier: GPL-3.0-or-later
// A scene from a file: the irradiance at one point, and how it was found.
//
//   02_read_scene SCENE.obj

#include <cinttypes>
#include <cstdio>

#include "truelux/truelux.h"

namespace {

/// Which stage of exact arithmetic answered how often.
void Print(const char* predicate, const truelux::StageCounts& counts) {
  std::printf("%-14s symbolic %" PRIu64 ", filter %" PRIu64
              ", interval %" PRIu64 ", double-double %" PRIu64
              ", exact %" PRIu64 "\n",
              predicate, counts.symbolic, counts.filter, counts.interval,
              counts.double_double, counts.exact);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: 02_read_scene SCENE.obj\n");
    return 2;
  }
  truelux::Result<truelux::Scene> scene = truelux::ReadScene(argv[1]);
  for (const truelux::Diagnostic& diagnostic : scene.diagnostics) {
    std::fprintf(stderr, "%s\n", diagnostic.Text().c_str());
  }
  if (!scene.ok()) return 2;

  const truelux::Oracle oracle(*scene.value);
  // In the middle of the Cornell box's floor, which is face 1 of that file.
  const truelux::Receiver receiver{{278, 0, 279.5}, {0, 1, 0}, 1};
  const truelux::Irradiance e = oracle.Evaluate(receiver);
  std::printf("E = %.17g %.17g %.17g W/m^2\n", e.value[0], e.value[1],
              e.value[2]);

  const truelux::Statistics& s = e.statistics;
  Print("receiver side", s.receiver_side);
  Print("vertex side", s.vertex_side);
  Print("plane side", s.plane_side);
  Print("edge order", s.edge_order);
  std::printf("%" PRIu64 " source, %" PRIu64 " blockers, %" PRIu64 " arcs\n",
              s.sources, s.blockers, s.arcs);
  return 0;
}
