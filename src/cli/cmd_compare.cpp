#include "cli/cmd_compare.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fmt/format.h>
#include <span>
#include <utility>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/version.h"

#include "cli/loading.h"
#include "cli/option_values.h"
#include "cli/oracle_arguments.h"
#include "cli/output_paths.h"
#include "compare/candidate_report.h"
#include "compare/candidates.h"
#include "run/input_file.h"
#include "run/interrupt.h"
#include "run/output_file.h"
#include "run/parallel.h"
#include "run/progress.h"
#include "run/user_error.h"
#include "scene/diagnostic_list.h"
#include "scene/emitters.h"
#include "scene/scene_variants.h"
#include "text/evenly_picked.h"

namespace truelux {
namespace {

/// What is to be done.
struct CompareRequest {
  std::string scene;
  std::string candidate;            ///< path or "-"
  std::string output;               ///< path; "": standard output
  std::optional<std::string> json;  ///< path; "": standard output
  std::optional<std::size_t> channel;
  TruthOptions options;
  double tolerance = 0;
  int threads = 1;
};

std::optional<std::size_t> ChannelOf(const std::optional<std::string>& word) {
  if (!word) return std::nullopt;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (*word == ChannelName(channel)) return channel;
  }
  throw UsageError(fmt::format("--channel: '{}' is none of r, g, b", *word));
}

CompareRequest RequestOf(const CompareArguments& arguments) {
  CompareRequest request;
  request.scene = PathValue("SCENE.obj", arguments.scene);
  request.candidate = PathValue("CANDIDATE.csv", arguments.candidate);
  request.output = PathValue("--output", arguments.output);
  if (request.output == "-") request.output.clear();
  if (arguments.json) {
    const std::string path = PathValue("--json", arguments.json);
    request.json = path == "-" ? "" : path;
  }
  request.channel = ChannelOf(arguments.channel);
  request.tolerance = SizeValue("--tolerance", arguments.tolerance);
  request.options.emission = EmissionOf(arguments.emission);
  request.threads = ThreadsOf(arguments.threads);
  if (arguments.quantity == Name(Quantity::kFormFactor)) {
    request.options.quantity = Quantity::kFormFactor;
    if (request.options.emission != Emission::kExitance) {
      throw UsageError(
          "--emission says what Ke is; a form factor does not depend on it");
    }
    if (request.channel)
      throw UsageError("--channel: a form factor has no channels");
  }
  return request;
}

OutputPaths OutputsOf(const CompareRequest& request) {
  OutputPaths outputs = {{"--output", request.output}};
  if (request.json) outputs.push_back({"--json", *request.json});
  return outputs;
}

/// Reads the whole candidate. Throws UserError with all defects.
CandidateData LoadCandidate(const CompareRequest& request,
                            const OutputPaths& outputs, const Scene& scene) {
  CheckInput(outputs, request.candidate);
  InputFile file(request.candidate);
  CandidateReader reader(
      file, file.name(),
      {request.options.quantity, request.channel, IsGrey(scene),
       static_cast<int>(scene.faces().size())});
  DiagnosticList all_defects(file.name());
  std::vector<Diagnostic> defects;
  CandidateData data;
  CandidateRow row;
  auto status = CandidateReader::Status::kRow;
  // Rows mean nothing without a header.
  if (!reader.ReadHeader(defects)) status = CandidateReader::Status::kEnd;
  for (;;) {
    for (Diagnostic& defect : defects)
      all_defects.Add(std::move(defect));
    defects.clear();
    if (status == CandidateReader::Status::kEnd) break;
    status = reader.Next(row, defects);
    if (status != CandidateReader::Status::kRow) continue;
    data.receivers.push_back(row.receiver);
    data.lines.push_back(row.line);
    data.values.push_back(row.values);
  }
  if (all_defects.has_errors()) throw UserError(all_defects.Sorted());
  if (data.receivers.empty()) {
    throw UserError({Diagnostic{Severity::kError, file.name(), 0,
                                "no receivers: the table has only a header"}});
  }
  data.channels = reader.channels();
  data.value_names = reader.value_names();
  return data;
}

std::vector<Rgb> IrradiancesOf(const Oracle& oracle,
                               std::span<const Receiver> receivers,
                               int threads) {
  std::vector<Rgb> values(receivers.size());
  Progress progress(receivers.size());
  EvaluateInParallel(oracle, receivers, threads, progress,
                     [&](std::size_t i, const Irradiance& irradiance) {
                       values[i] = irradiance.value;
                     });
  return values;
}

void FindWorst(const DetailFinder& finder, int threads,
               CandidateReport& report) {
  for (const std::size_t i : WorstOf(report.errors, kMostWorstCandidates))
    report.worst.push_back({i, {}});
  Progress progress(report.worst.size());
  ForEachInParallel(report.worst.size(), threads, progress, [&](std::size_t k) {
    WorstCandidate& worst = report.worst[k];
    worst.detail = finder.Find(report.data.receivers[worst.receiver], true);
  });
}

/// Looks at receivers as mistakes were tried on; at fewer in large scenes,
/// since what coincides exactly is found slowly.
void Classify(const DetailFinder& finder, int threads,
              CandidateReport& report) {
  constexpr std::size_t kMostWork = 1'000'000;
  constexpr std::size_t kFewest = 8;
  const std::size_t triangles =
      std::max<std::size_t>(report.scene.triangles().size(), 1);
  const std::vector<std::size_t> indices = TrialReceivers(
      report.errors,
      std::clamp(kMostWork / triangles, kFewest, kMostTrialReceivers));
  report.classified.resize(indices.size());
  Progress progress(indices.size());
  ForEachInParallel(indices.size(), threads, progress, [&](std::size_t k) {
    const std::size_t i = indices[k];
    report.classified[k] = {finder.Find(report.data.receivers[i], false).traits,
                            report.errors[i].passes};
  });
}

void FindReasons(const CompareRequest& request, CandidateReport& report) {
  if (WorstOf(report.errors, 1).empty()) {
    report.diagnosis = Diagnose(report.scene, report.data, report.errors,
                                request.tolerance, request.options, {});
    return;
  }
  const DetailFinder finder(report.scene);
  FindWorst(finder, request.threads, report);
  const SceneEvaluator evaluate = [&](const Scene& variant,
                                      std::span<const Receiver> receivers) {
    StopIfInterrupted();
    const Oracle oracle(variant, {.emission = request.options.emission});
    return IrradiancesOf(oracle, receivers, request.threads);
  };
  report.diagnosis = Diagnose(report.scene, report.data, report.errors,
                              request.tolerance, request.options, evaluate);
  if (report.diagnosis.verdict == Verdict::kUnexplained)
    Classify(finder, request.threads, report);
}

CandidateReport Compare(const CompareRequest& request,
                        const OutputPaths& outputs) {
  CandidateReport report;
  const Scene scene = LoadScene(request.scene, outputs);
  report.scene = request.options.quantity == Quantity::kFormFactor
                     ? WithUnitExitance(scene)
                     : scene;
  report.scene_name = std::filesystem::path(request.scene).filename().string();
  report.candidate_name =
      request.candidate == "-"
          ? "<stdin>"
          : std::filesystem::path(request.candidate).filename().string();
  report.options = request.options;
  report.tolerance = request.tolerance;
  report.data = LoadCandidate(request, outputs, scene);
  const Oracle oracle(report.scene, {.emission = request.options.emission});
  for (const Rgb& value :
       IrradiancesOf(oracle, report.data.receivers, request.threads))
    report.data.truth.push_back(report.data.Compared(value));
  report.errors = ErrorsOf(report.data, request.tolerance);
  report.summary = Summarize(report.errors);
  FindReasons(request, report);
  return report;
}

}  // namespace

ExitStatus RunCompare(const CompareArguments& arguments) {
  const CompareRequest request = RequestOf(arguments);
  const OutputPaths outputs = OutputsOf(request);
  CheckOutputs(outputs);
  // Opened before the long work, so that a bad path is known at once.
  OutputFile text(request.output);
  std::optional<OutputFile> json;
  if (request.json) json.emplace(*request.json);

  const CandidateReport report = Compare(request, outputs);
  text.Write(CandidateText(report));
  if (json) json->Write(CandidateJson(report, VersionText()));
  // Names are given at the very end, when nothing can fail but the naming.
  text.Finish();
  if (json) json->Finish();
  StopIfInterrupted();
  text.Commit();
  if (json) json->Commit();
  return report.passes() ? ExitStatus::kDone : ExitStatus::kComparisonFailed;
}

}  // namespace truelux
