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

namespace truelux {

/// Reads a Wavefront OBJ and the MTL files that it names
/// (docs/scene_format.md). Faces keep the order of their f lines. A file that
/// is missing or malformed is an error among the diagnostics, not an exception.
/// All defects are reported together, up to 100.
[[nodiscard]] TRUELUX_EXPORT Result<Scene> ReadScene(
    const std::filesystem::path& obj);

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
