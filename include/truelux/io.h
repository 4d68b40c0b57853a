// Reading scenes from files.

#ifndef TRUELUX_IO_H_
#define TRUELUX_IO_H_

#include <filesystem>
#include <optional>
#include <string_view>

#include "truelux/diagnostics.h"
#include "truelux/scene.h"

namespace truelux {

/// Reads a Wavefront OBJ and the MTL files it names (docs/scene_format.md).
/// All defects are reported together, up to 100.
Result<Scene> ReadScene(const std::filesystem::path& obj);

/// The binary64 nearest to a decimal number, or nothing.
///
/// text  [sign] digits [. digits] [e|E [sign] digits], the whole text; digits
///       may be missing on one side of the point; "inf", "nan" and
///       hexadecimal are no numbers.
/// Overflow is no number; underflow gives the nearest subnormal or zero.
std::optional<double> ParseNumber(std::string_view text);

}  // namespace truelux

#endif  // TRUELUX_IO_H_
