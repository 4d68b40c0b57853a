// SPDX-License-Identifier: GPL-3.0-or-later
// Reading scenes from files.

#ifndef TRUELUX_IO_H_
#define TRUELUX_IO_H_

#include <filesystem>
#include <optional>
#include <string_view>

#include "truelux/diagnostics.h"
#include "truelux/export.h"
#include "truelux/scene.h"
#include "truelux/stop.h"

namespace truelux {

/// How a scene file is read.
struct ReadOptions {
  /// Faces that are errors are left out, and faces whose material no file
  /// defines only block; notes count both. Else these are errors.
  bool lenient = false;
  /// Faces that do not emit and whose material has an opacity d (or 1 - Tr)
  /// below this are left out, with a note. Else all faces are opaque.
  std::optional<double> opaque_from{};
  /// Faces that emit do so to both sides.
  bool two_sided = false;
  /// Looked at while files are read; if it is set, ReadScene throws Stopped.
  const StopFlag* stop = nullptr;
};

/// Reads a Wavefront OBJ and the MTL files that it names
/// (docs/scene_format.md). Faces keep the order of their f lines. A file that
/// is missing or malformed is an error among the diagnostics, not an exception.
/// What truelux does not use never is. All defects are reported together, up to
/// 100.
[[nodiscard]] TRUELUX_EXPORT Result<Scene> ReadScene(
    const std::filesystem::path& obj, const ReadOptions& options = {});

/// The binary64 nearest to a decimal number, ties to even; nothing if the text
/// is not a number. ReadScene reads every number this way.
///
/// text  [sign] digits [. digits] [e|E [sign] digits], the whole text. The
///       digits may be missing on one side of the point. "inf", "nan" and
///       hexadecimal numbers are not accepted.
/// A number that is too large for binary64 is not accepted; one that is too
/// small gives the nearest subnormal or zero.
[[nodiscard]] TRUELUX_EXPORT std::optional<double> ParseNumber(
    std::string_view text);

}  // namespace truelux

#endif  // TRUELUX_IO_H_
