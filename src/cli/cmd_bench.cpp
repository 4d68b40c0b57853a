// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cmd_bench.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "cli/loading.h"
#include "cli/option_values.h"
#include "cli/output_paths.h"
#include "run/interrupt.h"
#include "run/output_file.h"
#include "run/user_error.h"
#include "study/bench_methods.h"
#include "study/bench_run.h"
#include "study/comparison_csv.h"
#include "study/html_report.h"
#include "text/evenly_picked.h"

namespace truelux {
namespace {

/// What is to be done.
struct BenchRequest {
  SceneRequest scene;
  std::string receivers;  ///< path or "-"
  std::optional<std::string> on_face;
  std::string report;
  std::size_t count = 0;  ///< of receivers at most
  MethodChoice choice;
  BenchLimits limits;
};

/// No larger number of receivers would fit into a report.
constexpr std::int64_t kMaxReceivers = 1000000;
constexpr std::int64_t kMaxSeed = std::int64_t{1} << 53;

BenchRequest ParseBenchRequest(const BenchArguments& arguments) {
  BenchRequest request;
  request.scene = SceneRequestOf(arguments.scene);
  request.receivers = PathValue("RECEIVERS.csv", arguments.receivers);
  request.on_face = arguments.on_face;
  request.report = PathValue("--output", arguments.output);
  if (request.report == "-") {
    throw UsageError("--output: '-' cannot name a report and its tables");
  }
  request.count = static_cast<std::size_t>(
      WholeNumberValue("--receivers", arguments.count, 1, kMaxReceivers));
  request.choice.quick = arguments.quick;
  request.choice.arrangement = arguments.arrangement;
  request.choice.seed = static_cast<std::uint64_t>(
      WholeNumberValue("--seed", arguments.seed, 0, kMaxSeed));
  if (arguments.quick) request.limits = {.seconds = 1, .rounds = 3};
  if (arguments.seconds)
    request.limits.seconds = SizeValue("--seconds", *arguments.seconds);
  return request;
}

/// The report and its tables, in the order in which they are written.
OutputPaths OutputsOf(const std::string& report) {
  std::filesystem::path base = report;
  const std::string extension = base.extension().string();
  if (extension == ".html" || extension == ".htm") base.replace_extension();
  return {{"the report", report},
          {"the table of methods", base.string() + ".csv"},
          {"the table of receivers", base.string() + "_receivers.csv"}};
}

/// An evenly picked part of a table, or all of it.
std::vector<Receiver> SomeReceivers(const BenchRequest& request,
                                    const OutputPaths& outputs,
                                    const Scene& scene) {
  FaceWords faces(scene);
  faces.SetUsual(OnFaceOf(request.on_face, faces));
  const std::vector<Receiver> all =
      LoadReceivers(request.receivers, outputs, faces);
  if (all.empty()) {
    throw UserError({Diagnostic{Severity::kError, request.receivers, 0,
                                "no receivers: the table has only a header"}});
  }
  std::vector<Receiver> some;
  for (const std::size_t i : EvenlyPicked(all.size(), request.count))
    some.push_back(all[i]);
  return some;
}

}  // namespace

ExitStatus RunBench(const BenchArguments& arguments) {
  const BenchRequest request = ParseBenchRequest(arguments);
  const OutputPaths outputs = OutputsOf(request.report);
  CheckOutputs(outputs);
  // Opened before the long work, so that a bad path is known at once.
  OutputFile report(outputs[0].path);
  OutputFile methods(outputs[1].path);
  OutputFile receivers(outputs[2].path);

  const Scene scene = LoadScene(request.scene, outputs);
  std::vector<Receiver> chosen = SomeReceivers(request, outputs, scene);
  NoteBehindFaces(Oracle(scene), chosen);
  Comparison comparison = [&] {
    // Embree may want a thread to give back what it has: not after the files
    // have their names.
    const MethodList list = PrepareMethods(scene, request.choice);
    StopIfInterrupted();
    return RunMethods(scene, std::move(chosen), list, request.limits);
  }();
  comparison.scene =
      std::filesystem::path(request.scene.path).filename().string();

  report.Write(HtmlReport(comparison));
  methods.Write(MethodsCsv(comparison));
  receivers.Write(ReceiversCsv(comparison));
  // Names are given at the very end, when nothing can fail but the naming.
  const std::array files = {&report, &methods, &receivers};
  for (OutputFile* file : files)
    file->Finish();
  StopIfInterrupted();
  for (OutputFile* file : files)
    file->Commit();
  return ExitStatus::kDone;
}

}  // namespace truelux
