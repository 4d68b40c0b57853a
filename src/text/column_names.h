// SPDX-License-Identifier: GPL-3.0-or-later
// What the columns of a table of receivers are called.

#ifndef TRUELUX_TEXT_COLUMN_NAMES_H_
#define TRUELUX_TEXT_COLUMN_NAMES_H_

#include <array>
#include <string_view>

namespace truelux {

/// Names of the columns that a receivers table must have, in the order in
/// which this program writes them.
inline constexpr std::array<std::string_view, 6> kReceiverColumns = {
    "x", "y", "z", "nx", "ny", "nz"};

/// Name of the column that chooses Receiver::on_face.
inline constexpr std::string_view kOnFaceColumn = "on_face";

/// Name of the column for Receiver::on_face as it was found.
inline constexpr std::string_view kOnFaceFoundColumn = "on_face_found";

}  // namespace truelux

#endif  // TRUELUX_TEXT_COLUMN_NAMES_H_
