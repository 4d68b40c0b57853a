// SPDX-License-Identifier: GPL-3.0-or-later
// What contours cost and how far they are from the truth, beside marching
// squares on a grid of certified values that costs as many evaluations.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <string>

#include "truelux/irradiance.h"
#include "truelux/isolux.h"

#include "contour_distances.h"
#include "isolux_floors.h"

namespace truelux::bench {
namespace {

struct Options {
  std::string only;
};

/// Ours, with what is certified of them, and the seconds they took.
void PrintContours(const IsoluxFloor& floor, const Isolux& isolux,
                   double seconds) {
  std::size_t vertices = 0;
  std::size_t certified = 0;
  std::size_t chords = 0;
  std::size_t unknown = 0;
  for (const IsoluxContour& contour : isolux.contours) {
    vertices += contour.vertices.size();
    chords += contour.widths.size();
    for (const IsoluxVertex& v : contour.vertices)
      certified += v.is_certified && v.half_width <= 1e-9 * isolux.size ? 1 : 0;
    unknown += static_cast<std::size_t>(std::ranges::count_if(
        contour.widths, [](double width) { return !std::isfinite(width); }));
  }
  fmt::print(
      "| {} | {} | {} | {} | {:.2f} | {} of {} | {:.1g} | {} | {:.1f} |\n",
      floor.name, isolux.contours.size(), vertices, vertices - certified,
      static_cast<double>(isolux.line_evaluations) /
          static_cast<double>(vertices),
      unknown, chords, isolux.open_area / isolux.area,
      isolux.search_evaluations, seconds);
}

void PrintDistances(const std::string& name, const SortedNumbers& distances,
                    double size) {
  fmt::print("|   {} | {:.1e} | {:.1e} | {:.1e} |\n", name,
             distances.At(0.5) / size, distances.At(0.99) / size,
             distances.At(1) / size);
  std::fflush(stdout);
}

void Measure(const IsoluxFloor& floor) {
  const Oracle oracle(floor.scene);
  IsoluxOptions wanted;
  wanted.channel = ScalarChannel::kRed;
  wanted.threads = 1;
  const auto begin = std::chrono::steady_clock::now();
  const Isolux isolux = IsoluxOf(oracle, "floor", wanted);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  PrintContours(floor, isolux, seconds);
  const ContourDistances distances(floor, oracle, isolux);
  PrintDistances("contours", distances.OfContours(DrawnContoursOf(isolux)),
                 isolux.size);
  const double evaluations =
      static_cast<double>(isolux.line_evaluations + isolux.search_evaluations);
  PrintDistances("marching squares", distances.OfMarchingSquares(evaluations),
                 isolux.size);
}

int Run(int argc, char** argv) {
  Options options;
  CLI::App app("Contours beside other ways to draw them.", "isolux_lines");
  app.add_option("--only", options.only, "only floors whose names contain this")
      ->type_name("TEXT");
  CLI11_PARSE(app, argc, argv);
  fmt::print(
      "| scene | contours | vertices | not certified | evaluations a vertex | "
      "chords of unknown width | open share | evaluations of the search | s "
      "|\n");
  for (const IsoluxFloor& floor : IsoluxFloors()) {
    if (floor.name.find(options.only) != std::string::npos) Measure(floor);
  }
  return 0;
}

}  // namespace
}  // namespace truelux::bench

int main(int argc, char** argv) {
  try {
    return truelux::bench::Run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error: %s\n", error.what());
  }
  return 3;
}
