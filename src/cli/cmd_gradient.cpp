// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cmd_gradient.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "truelux/version.h"

#include "cli/loading.h"
#include "cli/option_values.h"
#include "cli/oracle_arguments.h"
#include "cli/output_paths.h"
#include "gradient/derivative_columns.h"
#include "gradient/gradient_run.h"
#include "run/interrupt.h"
#include "run/messages.h"
#include "run/output_file.h"
#include "run/progress.h"
#include "run/user_error.h"
#include "text/results.h"

namespace truelux {
namespace {

/// What is to be done.
struct GradientRequest {
  SceneRequest scene;
  std::string receivers;  ///< path or "-"
  std::optional<std::string> on_face;
  std::string output;           ///< path; "": standard output
  std::string kinks;            ///< path; "": none
  std::string vertices;         ///< path; "": none
  std::string vertex_gradient;  ///< path; "": none
  std::string stats;            ///< path; "": none
  ColumnChoice columns;
  OracleOptions options;
  int threads = 1;
};

ColumnChoice ParseColumns(std::string_view words) {
  ColumnChoice columns;
  for (std::size_t at = 0; at <= words.size();) {
    const std::size_t comma = std::min(words.find(',', at), words.size());
    const std::string_view word = words.substr(at, comma - at);
    const auto* const group = std::ranges::find(
        kColumnGroups, word, [](ColumnGroup g) { return Name(g); });
    if (group == kColumnGroups.end()) {
      std::string names;
      for (const ColumnGroup known : kColumnGroups)
        names += (names.empty() ? "" : ", ") + std::string(Name(known));
      throw UsageError(fmt::format("--of: '{}' is none of {}", word, names));
    }
    columns.Add(*group);
    at = comma + 1;
  }
  return columns;
}

GradientRequest ParseGradientRequest(const GradientArguments& arguments) {
  GradientRequest request;
  request.scene = SceneRequestOf(arguments.scene);
  request.receivers = PathValue("RECEIVERS.csv", arguments.receivers);
  request.on_face = arguments.on_face;
  request.output = PathValue("--output", arguments.output);
  if (request.output == "-") request.output.clear();
  request.kinks = PathValue("--kinks", arguments.kinks);
  request.vertices = PathValue("--vertices", arguments.vertices);
  request.vertex_gradient =
      PathValue("--vertex-gradient", arguments.vertex_gradient);
  if (request.vertex_gradient == "-")
    throw UsageError("--vertex-gradient: '-' is no file");
  if (request.kinks == "-") throw UsageError("--kinks: '-' is no file");
  if (request.vertices == "-") throw UsageError("--vertices: '-' is no file");
  request.columns = ParseColumns(arguments.of);
  request.options.method = MethodOf(arguments.method);
  request.stats = PathValue("--stats", arguments.stats);
  request.options.emission = EmissionOf(arguments.emission);
  request.options.stop = InterruptFlag();
  request.threads = ThreadsOf(arguments.threads);
  return request;
}

OutputPaths Outputs(const GradientRequest& request) {
  OutputPaths outputs = {{"--output", request.output}};
  if (!request.kinks.empty()) outputs.push_back({"--kinks", request.kinks});
  if (!request.vertices.empty())
    outputs.push_back({"--vertices", request.vertices});
  if (!request.vertex_gradient.empty())
    outputs.push_back({"--vertex-gradient", request.vertex_gradient});
  if (!request.stats.empty()) outputs.push_back({"--stats", request.stats});
  return outputs;
}

void NoteCounts(const GradientSummary& summary) {
  if (summary.kinks > 0) {
    PrintNote(fmt::format(
        "{} of {} receivers {} at a kink: the gradient is the mean of those on "
        "all sides, and --kinks has what one-sided derivatives need",
        summary.kinks, summary.receivers, summary.kinks == 1 ? "is" : "are"));
  }
  if (summary.discontinuous > 0) {
    PrintNote(fmt::format(
        "{} of {} receivers {} on a face that is not theirs, where irradiance "
        "is discontinuous (--on-face names it)",
        summary.discontinuous, summary.receivers,
        summary.discontinuous == 1 ? "lies" : "lie"));
  }
  if (summary.one_sided > 0) {
    PrintNote(fmt::format(
        "{} slope{} of the vertex gradient differ{} on both sides or jump{}, "
        "and count with the mean (--vertices has the sides)",
        summary.one_sided, summary.one_sided == 1 ? "" : "s",
        summary.one_sided == 1 ? "s" : "", summary.one_sided == 1 ? "s" : ""));
  }
  if (summary.undecided > 0) {
    PrintNote(fmt::format(
        "{} number{} too near to zero for 4096 bits to tell, given as 0",
        summary.undecided, summary.undecided == 1 ? " is" : "s are"));
  }
}

}  // namespace

ExitStatus RunGradient(const GradientArguments& arguments) {
  const GradientRequest request = ParseGradientRequest(arguments);
  CheckOutputs(Outputs(request));
  OutputFile table(request.output);
  std::optional<OutputFile> kinks;
  if (!request.kinks.empty()) kinks.emplace(request.kinks);
  std::optional<OutputFile> vertices;
  if (!request.vertices.empty()) vertices.emplace(request.vertices);
  std::optional<OutputFile> sum;
  if (!request.vertex_gradient.empty()) sum.emplace(request.vertex_gradient);

  std::optional<OutputFile> stats;
  if (!request.stats.empty()) stats.emplace(request.stats);

  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                         begin)
        .count();
  };
  RunReport report;
  report.version = VersionText();
  report.options = request.options;
  report.threads = request.threads;
  const Oracle oracle(LoadScene(request.scene, Outputs(request)),
                      request.options);
  FaceWords faces(oracle.scene());
  faces.SetUsual(OnFaceOf(request.on_face, faces));
  ReceiverInput input =
      OpenReceivers(request.receivers, Outputs(request), faces);
  ReceiverReader reader(*input.source, input.name, faces);
  if (sum) reader.AskFor({kWeightColumns.begin(), kWeightColumns.end()});
  reader.Refuse(DerivativeNames(request.columns, request.options.method));
  std::vector<Diagnostic> defects;
  if (!reader.ReadHeader(defects)) throw UserError(std::move(defects));
  if (sum && !reader.has_header()) {
    throw UserError({Diagnostic{
        Severity::kError, input.name, 1,
        "--vertex-gradient needs a header with the columns weight_r, weight_g "
        "and weight_b"}});
  }
  report.load_seconds = seconds();
  GradientSummary summary = [&] {
    Progress progress(input.total);
    GradientTask task;
    task.threads = request.threads;
    task.shows_faces = request.on_face.has_value();
    task.columns = request.columns;
    task.table = &table;
    task.kinks = kinks ? &*kinks : nullptr;
    task.vertices = vertices ? &*vertices : nullptr;
    task.vertex_gradient = sum ? &*sum : nullptr;
    return RunGradientTask(oracle, reader, task, progress);
  }();
  if (!summary.defects.empty()) throw UserError(std::move(summary.defects));
  report.evaluate_seconds = seconds() - report.load_seconds;
  report.receivers = summary.receivers;
  report.statistics = summary.statistics;
  const auto left_out = oracle.scene().left_out();
  report.left_out.assign(left_out.begin(), left_out.end());
  NoteCounts(summary);
  NoteFoundFaces(summary.faces);
  if (summary.receivers > 0 && summary.lit == 0)
    NoteDarkness(oracle.scene(), summary.sample.kept());

  // Names are given at the very end, when nothing can fail but the naming.
  if (kinks) kinks->Finish();
  if (vertices) vertices->Finish();
  if (sum) sum->Finish();
  if (stats) {
    stats->Write(JsonText(report));
    stats->Finish();
  }
  table.Finish();
  StopIfInterrupted();
  table.Commit();
  if (kinks) kinks->Commit();
  if (vertices) vertices->Commit();
  if (sum) sum->Commit();
  if (stats) stats->Commit();
  return ExitStatus::kDone;
}

}  // namespace truelux
