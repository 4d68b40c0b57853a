// SPDX-License-Identifier: GPL-3.0-or-later
// What contours cost and how far they are from the truth, beside two other ways:
// marching squares on a grid of certified values that costs as many evaluations,
// and contours followed with a multistep predictor, as published.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/isolux.h"

#include "contour_distances.h"
#include "isolux_floors.h"
#include "predictor_check.h"
#include "predictor_tracer.h"
#include "traced_contours.h"

namespace truelux::bench {
namespace {

struct Options {
  std::string only;
  std::string predictor = "both";
  std::vector<double> steps = {1};  ///< by the mean chord of truelux
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

void MeasureTracer(const Oracle& oracle, const Isolux& isolux,
                   const ContourDistances& distances,
                   const TraceOptions& options) {
  const TracedContours traced = TraceContours(oracle, isolux, options);
  std::string ends;
  for (std::size_t i = 0; i < traced.failed_ends.size(); ++i) {
    if (traced.failed_ends[i] == 0) continue;
    ends += fmt::format("{}{} {}", ends.empty() ? "" : ", ",
                        Name(static_cast<TraceEnd>(i)), traced.failed_ends[i]);
  }
  PrintDistances(fmt::format("{}{}, h {:.2e}", Name(options.predictor),
                             options.is_restarting ? ", restarting" : "",
                             options.step / isolux.size),
                 distances.OfContours(traced.contours), isolux.size);
  fmt::print(
      "|     completed {}, failed {} ({}) | {} points, {:.2f} evaluations a "
      "point | miss by h: median {:.1e}, 99 % {:.1e}, largest {:.1e}; {} above "
      "0.1 | {} kinks, {} of them with such a miss |\n",
      traced.completed, isolux.contours.size() - traced.completed, ends,
      traced.points,
      static_cast<double>(traced.evaluations) /
          static_cast<double>(traced.points),
      traced.misses.At(0.5), traced.misses.At(0.99), traced.misses.At(1),
      traced.large_misses, traced.kinks, traced.missed_kinks);
  std::fflush(stdout);
}

void Measure(const IsoluxFloor& floor, const Options& options) {
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
  for (const Predictor predictor : {Predictor::kMilne, Predictor::kTwoStep}) {
    if (options.predictor != "both" && options.predictor != Name(predictor))
      continue;
    for (const double step : options.steps) {
      for (const bool is_restarting : {false, true})
        MeasureTracer(oracle, isolux, distances,
                      {.predictor = predictor,
                       .step = step * MeanChord(isolux),
                       .is_restarting = is_restarting,
                       .outline = {}});
    }
  }
}

int Run(int argc, char** argv) {
  Options options;
  CLI::App app("Contours beside other ways to draw them.", "isolux_lines");
  app.add_option("--only", options.only, "only floors whose names contain this")
      ->type_name("TEXT");
  app.add_option("--predictor", options.predictor,
                 "of the published tracer: Milne, two-step, both or none")
      ->check(CLI::IsMember({"Milne", "two-step", "both", "none"}))
      ->capture_default_str()
      ->type_name("NAME");
  app.add_option("--step", options.steps,
                 "of the published tracer, by the mean chord of truelux's "
                 "contours; with 1 it has as many points; several are run one "
                 "after the other")
      ->check(CLI::Range(1e-3, 1e3))
      ->delimiter(',')
      ->capture_default_str()
      ->type_name("X");
  CLI11_PARSE(app, argc, argv);
  CheckPredictorTracer();
  fmt::print(
      "| scene | contours | vertices | not certified | evaluations a vertex | "
      "chords of unknown width | open share | evaluations of the search | s "
      "|\n");
  for (const IsoluxFloor& floor : IsoluxFloors()) {
    if (floor.name.find(options.only) != std::string::npos)
      Measure(floor, options);
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
