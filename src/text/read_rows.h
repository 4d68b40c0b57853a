// SPDX-License-Identifier: GPL-3.0-or-later
// A whole table, row by row, with all its defects.

#ifndef TRUELUX_TEXT_READ_ROWS_H_
#define TRUELUX_TEXT_READ_ROWS_H_

#include <string>
#include <utility>
#include <vector>

#include "truelux/diagnostics.h"

#include "scene/diagnostic_list.h"
#include "scene/io/number_defect.h"

namespace truelux {

/// Reads the header and all rows of a table that messages call `name`, and
/// calls take(row) for each row without defects. Returns the defects of the
/// others; rows are not looked at if the header cannot be used. Reader: as
/// ReceiverReader, new; Row: what its Next fills.
template <class Row, class Reader, class Take>
DiagnosticList ReadRows(Reader& reader, const std::string& name,
                        const Take& take) {
  using Status = typename Reader::Status;
  DiagnosticList all_defects(name);
  std::vector<Diagnostic> defects;
  Row row;
  Status status = reader.ReadHeader(defects) ? Status::kRow : Status::kEnd;
  for (;;) {
    for (Diagnostic& defect : defects) {
      if (IsHabit(defect.message)) {
        all_defects.CountError(defect.line, defect.message);
      } else {
        all_defects.Add(std::move(defect));
      }
    }
    defects.clear();
    if (status == Status::kEnd) return all_defects;
    status = reader.Next(row, defects);
    if (status == Status::kRow) take(row);
  }
}

}  // namespace truelux

#endif  // TRUELUX_TEXT_READ_ROWS_H_
