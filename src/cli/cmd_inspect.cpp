// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cmd_inspect.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

#include "truelux/irradiance.h"

#include "cli/loading.h"
#include "cli/option_values.h"
#include "cli/oracle_arguments.h"
#include "cli/output_paths.h"
#include "inspect/inspected_view.h"
#include "inspect/view_json.h"
#include "inspect/view_svg.h"
#include "run/announce.h"
#include "run/interrupt.h"
#include "run/output_file.h"
#include "run/user_error.h"
#include "text/receivers.h"

namespace truelux {
namespace {

/// What is to be done.
struct InspectRequest {
  SceneRequest scene;
  Receiver receiver;  ///< without its face
  std::optional<std::string> on_face;
  std::optional<std::string> output;  ///< path; "": standard output
  std::optional<std::string> json;
  ViewPicture picture;
  Emission emission = Emission::kExitance;
};

Receiver ReceiverOf(const InspectArguments& arguments) {
  std::array<std::string, kReceiverColumns.size()> texts;
  std::ranges::copy(TripleTexts("--at", arguments.at), texts.begin());
  std::ranges::copy(TripleTexts("--normal", arguments.normal),
                    texts.begin() + 3);
  std::vector<FieldDefect> defects;
  const Receiver receiver = ParseReceiver(texts, defects);
  if (!defects.empty()) {
    const FieldDefect& defect = defects.front();
    throw UsageError(fmt::format(
        "{}: {}", defect.index < 3 ? "--at" : "--normal", defect.message));
  }
  return receiver;
}

/// "" for standard output; nothing if the option is not given.
std::optional<std::string> OutputValue(const char* name,
                                       const std::optional<std::string>& word) {
  if (!word) return std::nullopt;
  const std::string path = PathValue(name, word);
  return path == "-" ? "" : path;
}

InspectRequest RequestOf(const InspectArguments& arguments) {
  constexpr int kLargestWidth = 20000;
  InspectRequest request;
  request.scene = SceneRequestOf(arguments.scene);
  request.receiver = ReceiverOf(arguments);
  request.on_face = arguments.on_face;
  request.output = OutputValue("--output", arguments.output);
  request.json = OutputValue("--json", arguments.json);
  if (!request.output && !request.json) {
    throw UsageError("nothing to write: give --output, --json or both");
  }
  if (arguments.projection == Name(ViewProjection::kGnomonic))
    request.picture.projection = ViewProjection::kGnomonic;
  request.picture.width = static_cast<int>(WholeNumberValue(
      "--size", arguments.size, kSmallestViewWidth, kLargestWidth));
  request.emission = EmissionOf(arguments.emission);
  return request;
}

OutputPaths OutputsOf(const InspectRequest& request) {
  OutputPaths outputs;
  if (request.output) outputs.push_back({"--output", *request.output});
  if (request.json) outputs.push_back({"--json", *request.json});
  return outputs;
}

InspectedView LookAround(const Oracle& oracle, const InspectRequest& request) {
  Receiver receiver = request.receiver;
  FaceWords faces(oracle.scene());
  FoundFaces found;
  SetFace(oracle.scene(), OnFaceOf(request.on_face, faces), receiver, found);
  NoteFoundFaces(found);
  NoteBehindFaces(oracle, {&receiver, 1});
  const std::string name =
      std::filesystem::path(request.scene.path).filename().string();
  InspectedView inspected = Inspect(oracle, name, receiver, Announce);
  Announce("");
  return inspected;
}

}  // namespace

ExitStatus RunInspect(const InspectArguments& arguments) {
  const InspectRequest request = RequestOf(arguments);
  const OutputPaths outputs = OutputsOf(request);
  CheckOutputs(outputs);
  // Opened before the long work, so that a bad path is known at once.
  std::optional<OutputFile> picture;
  std::optional<OutputFile> json;
  if (request.output) picture.emplace(*request.output);
  if (request.json) json.emplace(*request.json);

  const Oracle oracle(LoadScene(request.scene, outputs),
                      {.emission = request.emission, .stop = InterruptFlag()});
  const InspectedView inspected = LookAround(oracle, request);
  if (picture) picture->Write(ViewSvg(inspected, request.picture));
  if (json) json->Write(ViewJson(inspected));
  // Names are given at the very end, when nothing can fail but the naming.
  if (picture) picture->Finish();
  if (json) json->Finish();
  StopIfInterrupted();
  if (picture) picture->Commit();
  if (json) json->Commit();
  return ExitStatus::kDone;
}

}  // namespace truelux
