// SPDX-License-Identifier: GPL-3.0-or-later
// Compares truelux with other ways to the same number, in one run: time per
// receiver on one thread, and error against the certified value.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

#include "bar.h"
#include "chart.h"
#include "image.h"
#include "options.h"
#include "run/exit_status.h"
#include "run/interrupt.h"
#include "run/messages.h"
#include "run/output_file.h"
#include "run/user_error.h"
#include "suites.h"
#include "tables.h"

namespace truelux::bench {
namespace {

constexpr const char* kPreamble =
    "Microseconds are processor time of one thread per receiver, the median "
    "of\n"
    "rounds in which the methods take turns. What a method prepares once per\n"
    "scene is not counted: indices, hierarchies, and the points on the "
    "sources\n"
    "to which shadow rays go. The error is relative to the certified value,\n"
    "root of the mean square over the receivers that see anything; that of "
    "the\n"
    "certified value itself is a bound, what rounding to the nearest costs.\n";

void AddOptions(CLI::App& app, Options& options) {
  app.add_flag("--quick", options.quick,
               "few receivers and a small grid; about a minute");
  app.add_option("--only", options.only,
                 "only scenes whose names contain this; those whose names "
                 "begin with meshes are left out without it")
      ->type_name("TEXT");
  app.add_option("--seed", options.seed, "of scenes, receivers and samples")
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--meshes", options.meshes,
                 "for --only meshes: measure teapot.obj, torus3.obj and "
                 "bunny_lowres.obj of this folder, too")
      ->type_name("FOLDER");
  app.add_option("--csv", options.csv, "write all measurements as a table")
      ->type_name("FILE");
  app.add_option("--svg", options.svg,
                 "draw error against time for slab_100 and slab_1000")
      ->type_name("FILE");
}

void WriteWhole(std::optional<OutputFile>& file, const std::string& text) {
  if (!file) return;
  file->Write(text);
  file->Finish();
  file->Commit();
}

void Append(std::vector<BarRow>& rows, const std::vector<BarRow>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

void Measure(const Options& options) {
  const std::vector<std::string> drawn = {"slab_100", "slab_1000"};
  const auto wanted = [&](const std::string& name) {
    return options.Wants(name);
  };
  if (!options.svg.empty() && std::ranges::none_of(drawn, wanted))
    throw UserError("--svg draws slab_100 and slab_1000, and --only has none");
  // Opened before the long work, so that a bad path is known at once.
  std::optional<OutputFile> csv;
  std::optional<OutputFile> svg;
  if (!options.csv.empty()) csv.emplace(options.csv);
  if (!options.svg.empty()) svg.emplace(options.svg);
  fmt::print("{}", kPreamble);
  const std::vector<Measurement> measurements = RunSuites(options);
  std::vector<BarRow> rows = RatioRows(measurements);
  Append(rows, MeasureGrid(options));
  Append(rows, MeasureLoading(options));
  // A run of a few scenes says nothing about the others.
  if (!options.only.empty())
    std::erase_if(rows, [](const BarRow& row) { return !row.measured; });
  PrintBar(rows);
  WriteWhole(csv, CsvText(measurements));
  WriteWhole(svg, ErrorChart(measurements, drawn));
}

ExitStatus Run(int argc, char** argv) {
  Options options;
  CLI::App app("truelux beside other ways to the same irradiance.",
               "side_by_side");
  AddOptions(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ExitStatus::kDone : ExitStatus::kBadInput;
  }
  try {
    Measure(options);
    return ExitStatus::kDone;
  } catch (const UserError& error) {
    Print(error.diagnostics());
    return ExitStatus::kBadInput;
  } catch (const Stopped&) {
    PrintLine("interrupted");
    return ExitStatus::kInterrupted;
  }
}

}  // namespace
}  // namespace truelux::bench

int main(int argc, char** argv) {
  truelux::CatchSignals();
  try {
    return static_cast<int>(truelux::bench::Run(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error: %s\n", error.what());
  } catch (...) {
    std::fputs("internal error\n", stderr);
  }
  return static_cast<int>(truelux::ExitStatus::kInternalError);
}
