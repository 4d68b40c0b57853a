// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cmd_compare.h"

#include <cstddef>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "truelux/irradiance.h"
#include "truelux/version.h"

#include "cli/loading.h"
#include "cli/option_values.h"
#include "cli/oracle_arguments.h"
#include "cli/output_paths.h"
#include "compare/candidate_report.h"
#include "compare/candidates.h"
#include "compare/compare_run.h"
#include "compare/gradients/compare_gradients.h"
#include "compare/gradients/gradient_report.h"
#include "compare/load_candidate.h"
#include "run/input_file.h"
#include "run/interrupt.h"
#include "run/messages.h"
#include "run/output_file.h"
#include "run/user_error.h"
#include "scene/emitters.h"

namespace truelux {
namespace {

/// What is to be done.
struct CompareRequest {
  SceneRequest scene;
  std::string candidate;  ///< path or "-"
  std::optional<std::string> on_face;
  std::string output;               ///< path; "": standard output
  std::optional<std::string> json;  ///< path; "": standard output
  std::optional<std::size_t> channel;
  std::optional<Quantity> quantity;  ///< nothing: what the columns say
  CompareSettings options;
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
  request.scene = SceneRequestOf(arguments.scene);
  request.candidate = PathValue("CANDIDATE.csv", arguments.candidate);
  request.on_face = arguments.on_face;
  request.output = PathValue("--output", arguments.output);
  if (request.output == "-") request.output.clear();
  if (arguments.json) {
    const std::string path = PathValue("--json", arguments.json);
    request.json = path == "-" ? "" : path;
  }
  request.channel = ChannelOf(arguments.channel);
  request.options.tolerance = SizeValue("--tolerance", arguments.tolerance);
  request.options.truth.emission = EmissionOf(arguments.emission);
  request.options.threads = ThreadsOf(arguments.threads);
  request.options.watch = UserAtTerminal();
  for (const Quantity quantity :
       {Quantity::kIrradiance, Quantity::kFormFactor, Quantity::kGradient}) {
    if (arguments.quantity == Name(quantity)) request.quantity = quantity;
  }
  if (request.quantity == Quantity::kFormFactor) {
    request.options.truth.quantity = Quantity::kFormFactor;
    if (request.options.truth.emission != Emission::kExitance) {
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

/// What is written.
struct Texts {
  std::string report;
  std::string json;
  bool passes = false;
};

/// A report with its names.
template <class Report>
Report Named(Report report, const CompareRequest& request,
             const InputFile& file) {
  report.scene_name =
      std::filesystem::path(request.scene.path).filename().string();
  report.candidate_name =
      request.candidate == "-"
          ? file.name()
          : std::filesystem::path(request.candidate).filename().string();
  return report;
}

/// The scene is read first, so that its defects are told first.
Texts Compare(const CompareRequest& request, const OutputPaths& outputs) {
  const Scene scene = LoadScene(request.scene, outputs);
  CheckInput(outputs, request.candidate);
  InputFile file(request.candidate);
  FaceWords faces(scene);
  faces.SetUsual(OnFaceOf(request.on_face, faces));
  LoadedCandidate candidate =
      LoadCandidate(file, file.name(),
                    {request.quantity, request.channel, IsGrey(scene)}, faces);
  if (candidate.ignores_irradiance) {
    PrintNote(
        "the gradients are compared; --quantity irradiance compares the "
        "table's irradiances");
  }
  const auto tell_faces = [&](const CandidateReceivers& receivers) {
    NoteFoundFaces(receivers.found);
    NoteBehindFaces(Oracle(scene), receivers.receivers);
  };
  if (auto* data = std::get_if<GradientData>(&candidate.data)) {
    tell_faces(*data);
    const GradientReport report =
        Named(CompareGradientData(scene, std::move(*data), request.options),
              request, file);
    return {GradientText(report), GradientJson(report, VersionText()),
            report.passes()};
  }
  auto& data = std::get<CandidateData>(candidate.data);
  tell_faces(data);
  const CandidateReport report = Named(
      CompareCandidate(scene, std::move(data), request.options), request, file);
  return {CandidateText(report), CandidateJson(report, VersionText()),
          report.passes()};
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

  const Texts texts = Compare(request, outputs);
  try {
    text.Write(texts.report);
  } catch (const ReaderGone&) {
    // The exit status still tells how the comparison went.
  }
  if (json) json->Write(texts.json);
  // Names are given at the very end, when nothing can fail but the naming.
  text.Finish();
  if (json) json->Finish();
  StopIfInterrupted();
  text.Commit();
  if (json) json->Commit();
  return texts.passes ? ExitStatus::kDone : ExitStatus::kComparisonFailed;
}

}  // namespace truelux
