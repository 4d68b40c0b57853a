// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/loading.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>

#include "explain/darkness.h"
#include "run/input_file.h"
#include "run/interrupt.h"
#include "run/messages.h"
#include "run/user_error.h"
#include "scene/diagnostic_list.h"
#include "scene/emitters.h"
#include "scene/io/read_scene.h"
#include "text/read_rows.h"
#include "text/receivers.h"

namespace truelux {
namespace {

/// The likeliest reason for zeros everywhere deserves a word.
void NoteNoEmitter(const Scene& scene, const std::string& name) {
  if (scene.faces().empty() || !EmittersOf(scene).empty()) return;
  const bool any_missing =
      !scene.left_out().empty() || std::ranges::any_of(scene.faces(), Emits);
  Print({{Severity::kNote, name, 0,
          any_missing ? "no face emits: none that is left and has an area has "
                        "a material with Ke above 0"
                      : "no face emits: none has a material with Ke above 0"}});
}

/// Reads a whole table, row by row. Throws UserError with all defects
/// together.
void ReadTable(ByteSource& source, const std::string& name, FaceWords& faces,
               const std::function<void(const ReceiverRow&)>& take) {
  ReceiverReader reader(source, name, faces);
  const DiagnosticList defects = ReadRows<ReceiverRow>(reader, name, take);
  if (defects.has_errors()) throw UserError(defects.Sorted());
}

}  // namespace

Scene LoadScene(const SceneRequest& request, const OutputPaths& outputs,
                std::vector<std::filesystem::path>* files) {
  CheckInput(outputs, request.path);
  auto [scene, read] = ReadSceneAndFiles(request.path, request.options);
  // Which MTL files are inputs is known only when the OBJ has been read.
  for (const std::filesystem::path& file : read)
    CheckInput(outputs, file.string());
  StopIfInterrupted();
  if (!scene.ok()) throw UserError(std::move(scene.diagnostics));
  Print(scene.diagnostics);
  NoteNoEmitter(*scene.value, request.path);
  if (files != nullptr) *files = std::move(read);
  return std::move(*scene.value);
}

void NoteDarkness(const Scene& scene, std::span<const Receiver> receivers) {
  const std::string text = DarknessText(DarknessOf(scene, receivers));
  if (!text.empty()) PrintNote(text);
}

ReceiverInput OpenReceivers(const std::string& path, const OutputPaths& outputs,
                            FaceWords& faces) {
  CheckInput(outputs, path);
  auto file = std::make_unique<InputFile>(path);
  const std::string name = file->name();
  std::optional<std::uint64_t> total;
  if (file->CanRewind()) {
    total = 0;
    ReadTable(*file, name, faces,
              [&total](const ReceiverRow& /*row*/) { ++*total; });
    file->Rewind();
  }
  return {std::move(file), name, total};
}

std::vector<Receiver> LoadReceivers(const std::string& path,
                                    const OutputPaths& outputs,
                                    FaceWords& faces) {
  CheckInput(outputs, path);
  InputFile file(path);
  std::vector<Receiver> receivers;
  std::vector<FaceChoice> choices;
  ReadTable(file, file.name(), faces, [&](const ReceiverRow& row) {
    receivers.push_back(row.receiver);
    choices.push_back(row.face);
  });
  FoundFaces found;
  for (std::size_t i = 0; i < choices.size(); ++i)
    SetFace(faces.scene(), choices[i], receivers[i], found);
  NoteFoundFaces(found);
  return receivers;
}

FaceChoice OnFaceOf(const std::optional<std::string>& on_face,
                    FaceWords& faces) {
  if (!on_face) return {};
  std::string defect = "the text is empty";
  const std::optional<FaceChoice> choice = TrimBlanks(*on_face).empty()
                                               ? std::nullopt
                                               : faces.Parse(*on_face, defect);
  if (!choice) throw UserError("--on-face: " + defect);
  return *choice;
}

void NoteFoundFaces(const FoundFaces& found) {
  const std::string text = FoundFacesText(found);
  if (!text.empty()) PrintNote("--on-face: " + text);
}

void NoteBehindFaces(const Oracle& oracle,
                     std::span<const Receiver> receivers) {
  const auto is_dark = [&](const Receiver& receiver) {
    return receiver.on_face == 0 && oracle.scene().IsBehindFace(receiver) &&
           oracle.Evaluate(receiver).value == Rgb{};
  };
  const auto dark = std::ranges::count_if(receivers, is_dark);
  const std::string text =
      BehindFacesText(static_cast<std::uint64_t>(dark), receivers.size());
  if (!text.empty()) PrintNote(text);
}

}  // namespace truelux
