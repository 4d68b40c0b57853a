#include "cli/cmd_eval.h"

#include <algorithm>
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

#include "cli/eval_paths.h"
#include "cli/evaluation.h"
#include "cli/input_file.h"
#include "cli/interrupt.h"
#include "cli/messages.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/version.h"
#include "report/receivers.h"
#include "report/results.h"
#include "scene/diagnostic_list.h"
#include "scene/read_scene.h"
#include "scene/text_file.h"

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

/// The receivers of a request, ready to be streamed.
struct ReceiverInput {
  std::unique_ptr<ByteSource> source;
  std::string name;                    ///< for messages; "": the command line
  std::optional<std::uint64_t> total;  ///< number of rows, if known
};

/// The likeliest reason for zeros everywhere deserves a word.
void NoteDarkness(const Scene& scene, const std::string& name) {
  const auto emits = [](const Face& face) {
    return std::ranges::any_of(face.emission, [](double m) { return m > 0; });
  };
  if (scene.faces().empty() || std::ranges::any_of(scene.faces(), emits)) {
    return;
  }
  Print({{Severity::kNote, name, 0,
          "no face emits: none has a material with Ke above 0"}});
}

Scene LoadScene(const EvalRequest& request) {
  // Which MTL files are inputs is known only when the OBJ is read.
  const FileOpener open = [&request](const std::filesystem::path& path) {
    CheckInput(request, path.string());
    return ReadTextFile(path);
  };
  Result<Scene> scene = ReadSceneWith(open, request.scene);
  StopIfInterrupted();
  if (!scene.ok()) throw UserError(std::move(scene.diagnostics));
  Print(scene.diagnostics);
  NoteDarkness(*scene.value, request.scene);
  return std::move(*scene.value);
}

/// Reads a whole table and returns its number of rows. Throws UserError with
/// all defects together.
std::uint64_t CheckTable(ByteSource& source, const std::string& name,
                         int face_count) {
  ReceiverReader reader(source, name, face_count);
  DiagnosticList all_defects(name);
  std::uint64_t rows = 0;
  std::vector<Diagnostic> defects;
  auto status = reader.ReadHeader(defects) ? ReceiverReader::Status::kRow
                                           : ReceiverReader::Status::kEnd;
  ReceiverRow row;
  for (;;) {
    for (Diagnostic& defect : defects)
      all_defects.Add(std::move(defect));
    defects.clear();
    if (status == ReceiverReader::Status::kEnd) break;
    status = reader.Next(row, defects);
    if (status == ReceiverReader::Status::kRow) ++rows;
  }
  if (all_defects.has_errors()) throw UserError(all_defects.Sorted());
  return rows;
}

ReceiverInput OpenReceivers(const EvalRequest& request, int face_count) {
  if (request.receivers.empty()) {
    std::string defect;
    if (!ParseOnFace(request.on_face, face_count, defect)) {
      throw UserError("--on-face: " + defect);
    }
    return {std::make_unique<TextSource>(request.table), "", 1};
  }
  CheckInput(request, request.receivers);
  auto file = std::make_unique<InputFile>(request.receivers);
  const std::string name = file->name();
  std::optional<std::uint64_t> total;
  if (file->CanRewind()) {
    total = CheckTable(*file, name, face_count);
    file->Rewind();
  }
  return {std::move(file), name, total};
}

/// Streams the table through the oracle.
EvaluationSummary EvaluateTable(const Oracle& oracle, ReceiverInput& input,
                                OutputFile& output, int threads) {
  const auto face_count = static_cast<int>(oracle.scene().faces().size());
  ReceiverReader reader(*input.source, input.name, face_count);
  std::vector<Diagnostic> defects;
  if (!reader.ReadHeader(defects)) throw UserError(std::move(defects));
  Progress progress(input.total);
  EvaluationSummary summary =
      Evaluate(oracle, reader, output, threads, progress);
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

}  // namespace

ExitStatus RunEval(const EvalArguments& arguments) {
  const EvalRequest request = ParseEvalRequest(arguments);
  CheckOutputs(request);
  OutputFile output(request.output);
  std::optional<OutputFile> stats;
  if (!request.stats.empty()) stats.emplace(request.stats);

  RunReport report;
  report.version = kVersion;
  report.options = request.options;
  report.threads = request.threads;
  const Stopwatch loading;
  const Oracle oracle(LoadScene(request), request.options);
  ReceiverInput input =
      OpenReceivers(request, static_cast<int>(oracle.scene().faces().size()));
  report.load_seconds = loading.Seconds();

  const Stopwatch evaluating;
  const EvaluationSummary summary =
      EvaluateTable(oracle, input, output, request.threads);
  report.evaluate_seconds = evaluating.Seconds();
  report.receivers = summary.receivers;
  report.statistics = summary.statistics;
  NoteOverflows(summary);
  NoteUnanswered(summary, request.options.formula);

  // Names are given at the very end, when nothing can fail but the naming.
  if (stats) {
    stats->Write(JsonText(report));
    stats->Finish();
  }
  output.Finish();
  StopIfInterrupted();
  output.Commit();
  if (stats) stats->Commit();
  return ExitStatus::kDone;
}

}  // namespace truelux
