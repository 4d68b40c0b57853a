// Compares truelux with other ways to the same number, in one run: time per
// receiver on one thread, and error against the certified value.

#include <CLI/CLI.hpp>
#include <exception>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

#include "announce.h"
#include "bar.h"
#include "baselines/sampled.h"
#include "chart.h"
#include "cli/exit_status.h"
#include "cli/interrupt.h"
#include "cli/messages.h"
#include "cli/output_file.h"
#include "image.h"
#include "options.h"
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
  app.add_option("--only", options.only, "only scenes whose names contain this")
      ->type_name("TEXT");
  app.add_option("--seed", options.seed, "of scenes, receivers and samples")
      ->capture_default_str()
      ->type_name("N");
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

void Run(const Options& options) {
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
  const std::string chart = ErrorChart(measurements, {"slab_100", "slab_1000"});
  if (!options.svg.empty() && chart.empty())
    throw UserError("nothing to draw: slab_100 and slab_1000 not measured");
  WriteWhole(svg, chart);
}

}  // namespace
}  // namespace truelux::bench

int main(int argc, char** argv) {
  using truelux::ExitStatus;
  truelux::CatchSignals();
  truelux::bench::Options options;
  CLI::App app("truelux beside other ways to the same irradiance.",
               "side_by_side");
  truelux::bench::AddOptions(app, options);
  try {
    app.parse(argc, argv);
    truelux::bench::Run(options);
    return static_cast<int>(ExitStatus::kDone);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? static_cast<int>(ExitStatus::kDone)
                                : static_cast<int>(ExitStatus::kBadInput);
  } catch (const truelux::UserError& error) {
    truelux::Print(error.diagnostics());
    return static_cast<int>(ExitStatus::kBadInput);
  } catch (const truelux::Interruption&) {
    truelux::PrintLine("interrupted");
    return static_cast<int>(ExitStatus::kInterrupted);
  } catch (const std::exception& error) {
    truelux::PrintLine(std::string("internal error: ") + error.what());
    return static_cast<int>(ExitStatus::kInternalError);
  }
}
