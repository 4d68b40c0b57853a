// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cmd_eval.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "truelux/formulas.h"
#include "truelux/irradiance.h"
#include "truelux/stop.h"
#include "truelux/version.h"

#include "cli/loading.h"
#include "cli/output_paths.h"
#include "cli/part_key.h"
#include "run/evaluation.h"
#include "run/interrupt.h"
#include "run/messages.h"
#include "run/output_file.h"
#include "run/part_rows.h"
#include "run/progress.h"
#include "run/user_error.h"
#include "text/receivers.h"
#include "text/results.h"

namespace truelux {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] double Seconds() const {
    const std::chrono::duration<double> elapsed = Clock::now() - start_;
    return elapsed.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// What is written: the table and, if asked for, the file of --stats.
OutputPaths Outputs(const EvalRequest& request) {
  OutputPaths outputs = {{"--output", request.output}};
  if (!request.stats.empty()) outputs.push_back({"--stats", request.stats});
  if (!request.part.empty()) outputs.push_back({"--resume", request.part});
  return outputs;
}

ReceiverInput OpenReceivers(const EvalRequest& request, FaceWords& faces) {
  if (!request.receivers.empty())
    return OpenReceivers(request.receivers, Outputs(request), faces);
  return {std::make_unique<TextSource>(request.table), "", 1};
}

/// How the table is evaluated. The table of --at has a column on_face, which
/// says as much as on_face_found unless the face is searched for.
EvaluationTask TaskOf(const EvalRequest& request, FaceWords& faces) {
  const FaceChoice choice = OnFaceOf(request.on_face, faces);
  const bool is_table = request.table.empty();
  if (is_table) faces.SetUsual(choice);
  return {request.threads, request.on_face.has_value() &&
                               (is_table || choice.search != nullptr)};
}

/// Streams the table through the oracle.
EvaluationSummary EvaluateTable(const Oracle& oracle, ReceiverInput& input,
                                FaceWords& faces, RowSink& sink,
                                const EvaluationTask& task) {
  ReceiverReader reader(*input.source, input.name, faces);
  std::vector<Diagnostic> defects;
  if (!reader.ReadHeader(defects)) throw UserError(std::move(defects));
  if (!reader.has_header()) {
    PrintNote(
        "the receivers have no header: their columns are taken as x, y, z, nx, "
        "ny, nz, and the output has no header");
  }
  Progress progress(input.total);
  EvaluationSummary summary = Evaluate(oracle, reader, sink, task, progress);
  if (!summary.defects.empty()) throw UserError(std::move(summary.defects));
  return summary;
}

void NoteOverflows(const EvaluationSummary& summary) {
  if (summary.overflowing == 0) return;
  PrintNote(
      fmt::format("{} of {} receivers {} an irradiance too large for "
                  "binary64, written as inf",
                  summary.overflowing, summary.receivers,
                  summary.overflowing == 1 ? "has" : "have"));
}

void NoteUnanswered(const EvaluationSummary& summary, Formula formula) {
  if (summary.unanswered == 0) return;
  PrintNote(
      fmt::format("{} of {} receivers {} a source to which the formula {} does "
                  "not apply, written as nan",
                  summary.unanswered, summary.receivers,
                  summary.unanswered == 1 ? "has" : "have", Name(formula)));
}

/// No zero without a word.
void NoteDarkness(const Scene& scene, const EvaluationSummary& summary) {
  if (summary.receivers == 0 || summary.lit > 0) return;
  NoteDarkness(scene, summary.sample.kept());
}

/// Says where a run goes on.
void NoteDone(const PartRows& part, std::optional<std::uint64_t> total) {
  if (const auto done = part.done()) {
    PrintNote(fmt::format("{} has {} of {} receivers already", part.path(),
                          done->receivers, total.value_or(0)));
  }
}

/// What is left of an interrupted run.
void NoteKept(const EvalRequest& request, const std::optional<PartRows>& part) {
  if (part) {
    const auto done = part->done();
    PrintNote(fmt::format("{} keeps {} receivers; the same command goes on",
                          part->path(), done ? done->receivers : 0));
  } else if (!request.output.empty()) {
    PrintNote("nothing was kept; --resume keeps what is done");
  }
}

void NoteFaces(const EvaluationSummary& summary) {
  NoteFoundFaces(summary.faces);
  const std::string text =
      BehindFacesText(summary.behind_faces, summary.receivers);
  if (!text.empty()) PrintNote(text);
}

}  // namespace

ExitStatus RunEval(const EvalArguments& arguments) {
  const EvalRequest request = ParseEvalRequest(arguments);
  CheckOutputs(Outputs(request));
  OutputFile output(request.output);
  std::optional<OutputFile> stats;
  if (!request.stats.empty()) stats.emplace(request.stats);

  RunReport report;
  report.version = VersionText();
  report.options = request.options;
  report.threads = request.threads;
  const Stopwatch loading;
  std::vector<std::filesystem::path> files;
  const Oracle oracle(LoadScene(request.scene, Outputs(request), &files),
                      request.options);
  FaceWords faces(oracle.scene());
  EvaluationTask task = TaskOf(request, faces);
  ReceiverInput input = OpenReceivers(request, faces);
  const auto left_out = oracle.scene().left_out();
  report.left_out.assign(left_out.begin(), left_out.end());
  report.load_seconds = loading.Seconds();

  const Stopwatch evaluating;
  std::optional<PartRows> part;
  if (!request.part.empty()) {
    part.emplace(request.part, PartKey(request, files));
    task.done = part->done();
    NoteDone(*part, input.total);
  }
  const EvaluationSummary summary = [&] {
    OutputRows rows(output);
    RowSink& sink = part ? static_cast<RowSink&>(*part) : rows;
    try {
      return EvaluateTable(oracle, input, faces, sink, task);
    } catch (const Stopped&) {
      NoteKept(request, part);
      throw;
    }
  }();
  if (part) part->CopyTo(output);
  report.evaluate_seconds = evaluating.Seconds();
  report.receivers = summary.receivers;
  report.statistics = summary.statistics;
  NoteOverflows(summary);
  NoteUnanswered(summary, request.options.formula);
  NoteDarkness(oracle.scene(), summary);
  NoteFaces(summary);

  // Names are given at the very end, when nothing can fail but the naming.
  if (stats) {
    stats->Write(JsonText(report));
    stats->Finish();
  }
  output.Finish();
  StopIfInterrupted();
  output.Commit();
  if (stats) stats->Commit();
  if (part) part->Remove();
  return ExitStatus::kDone;
}

}  // namespace truelux
