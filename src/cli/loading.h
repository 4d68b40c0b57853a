// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and receivers for a command, with everything that is wrong with them.

#ifndef TRUELUX_CLI_LOADING_H_
#define TRUELUX_CLI_LOADING_H_

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "cli/input_arguments.h"
#include "cli/output_paths.h"
#include "text/byte_source.h"
#include "text/face_choice.h"

namespace truelux {

/// Reads an OBJ and its MTL files and prints the notes about them. Throws
/// UserError with all defects, or if a file that is read is an output.
/// files: if given, gets the files that were asked for.
Scene LoadScene(const SceneRequest& request, const OutputPaths& outputs,
                std::vector<std::filesystem::path>* files = nullptr);

/// Prints why everything is 0, if something emits. receivers: a few, of which
/// none sees light.
void NoteDarkness(const Scene& scene, std::span<const Receiver> receivers);

/// A table of receivers, ready to be read from its start.
struct ReceiverInput {
  std::unique_ptr<ByteSource> source;
  std::string name;                    ///< for messages; "": the command line
  std::optional<std::uint64_t> total;  ///< number of rows, if known
};

/// Opens a table ("-" is standard input) and, if it can be read twice, checks
/// it whole. Throws UserError with all defects found, or if it is an output.
ReceiverInput OpenReceivers(const std::string& path, const OutputPaths& outputs,
                            FaceWords& faces);

/// The receivers of a whole table, with their faces found. Throws UserError
/// with all defects, or if the table is an output, and Stopped.
std::vector<Receiver> LoadReceivers(const std::string& path,
                                    const OutputPaths& outputs,
                                    FaceWords& faces);

/// What --on-face says; no face without it. Throws UserError if the scene has
/// no such face, object or group.
FaceChoice OnFaceOf(const std::optional<std::string>& on_face,
                    FaceWords& faces);

/// Prints how searches for faces went, if there were any.
void NoteFoundFaces(const FoundFaces& found);

/// Prints how many of the receivers get 0 and lie behind a face, if any do.
void NoteBehindFaces(const Oracle& oracle, std::span<const Receiver> receivers);

}  // namespace truelux

#endif  // TRUELUX_CLI_LOADING_H_
