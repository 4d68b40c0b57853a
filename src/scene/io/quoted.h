// SPDX-License-Identifier: GPL-3.0-or-later
// Words of an input in messages about it.

#ifndef TRUELUX_SCENE_IO_QUOTED_H_
#define TRUELUX_SCENE_IO_QUOTED_H_

#include <string>
#include <string_view>

namespace truelux {

/// A word between quotes, on one line and not longer than a reader can use:
/// cut behind 40 bytes or less (never inside a UTF-8 character), control
/// characters as \xHH.
std::string Quoted(std::string_view word);

/// A name as it is if it can be read so: printable and not longer than Quoted
/// shows; else as Quoted shows it.
std::string Shown(std::string_view name);

/// The shortest decimal that reads back to the same number, for messages.
std::string NumberInText(double value);

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_QUOTED_H_
