// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cmd_compare.h"

#include <cstddef>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

#include "truelux/irradiance.h"
#include "truelux/version.h"

#include "cli/loading.h"
#include "cli/option_values.h"
#include "cli/oracle_arguments.h"
#include "cli/output_paths.h"
#include "compare/candidate_report.h"
#include "compare/candidates.h"
#include "compare/compare_run.h"
#include "compare/load_candidate.h"
#include "run/input_file.h"
#include "run/interrupt.h"
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
  CompareOptions options;
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
  if (arguments.quantity == Name(Quantity::kFormFactor)) {
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

/// The scene is read first, so that its defects are told first.
CandidateReport Compare(const CompareRequest& request,
                        const OutputPaths& outputs) {
  const Scene scene = LoadScene(request.scene, outputs);
  CheckInput(outputs, request.candidate);
  InputFile file(request.candidate);
  const CandidateRules rules = {request.options.truth.quantity, request.channel,
                                IsGrey(scene)};
  FaceWords faces(scene);
  faces.SetUsual(OnFaceOf(request.on_face, faces));
  CandidateData data = LoadCandidate(file, file.name(), rules, faces);
  NoteFoundFaces(data.found);
  NoteBehindFaces(Oracle(scene), data.receivers);
  CandidateReport report =
      CompareCandidate(scene, std::move(data), request.options);
  report.scene_name =
      std::filesystem::path(request.scene.path).filename().string();
  report.candidate_name =
      request.candidate == "-"
          ? file.name()
          : std::filesystem::path(request.candidate).filename().string();
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
  try {
    text.Write(CandidateText(report));
  } catch (const ReaderGone&) {
    // The exit status still tells how the comparison went.
  }
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
