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
void ReadTable(ByteSource& source, const std::string& name, int face_count,
               const std::function<void(const Receiver&)>& take) {
  ReceiverReader reader(source, name, face_count);
  const DiagnosticList defects = ReadRows<ReceiverRow>(
      reader, name, [&take](const ReceiverRow& row) { take(row.receiver); });
  if (defects.has_errors()) throw UserError(defects.Sorted());
}

}  // namespace

Scene LoadScene(const SceneRequest& request, const OutputPaths& outputs) {
  CheckInput(outputs, request.path);
  auto [scene, files] = ReadSceneAndFiles(request.path, request.options);
  // Which MTL files are inputs is known only when the OBJ has been read.
  for (const std::filesystem::path& file : files)
    CheckInput(outputs, file.string());
  StopIfInterrupted();
  if (!scene.ok()) throw UserError(std::move(scene.diagnostics));
  Print(scene.diagnostics);
  NoteNoEmitter(*scene.value, request.path);
  return std::move(*scene.value);
}

void NoteDarkness(const Scene& scene, std::span<const Receiver> receivers) {
  const std::string text = DarknessText(DarknessOf(scene, receivers));
  if (!text.empty()) PrintNote(text);
}

ReceiverInput OpenReceivers(const std::string& path, const OutputPaths& outputs,
                            int face_count) {
  CheckInput(outputs, path);
  auto file = std::make_unique<InputFile>(path);
  const std::string name = file->name();
  std::optional<std::uint64_t> total;
  if (file->CanRewind()) {
    total = 0;
    ReadTable(*file, name, face_count,
              [&total](const Receiver& /*receiver*/) { ++*total; });
    file->Rewind();
  }
  return {std::move(file), name, total};
}

std::vector<Receiver> LoadReceivers(const std::string& path,
                                    const OutputPaths& outputs,
                                    int face_count) {
  CheckInput(outputs, path);
  InputFile file(path);
  std::vector<Receiver> receivers;
  ReadTable(file, file.name(), face_count,
            [&receivers](const Receiver& r) { receivers.push_back(r); });
  return receivers;
}

}  // namespace truelux
