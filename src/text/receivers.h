// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers from comma-separated values, one at a time.

#ifndef TRUELUX_TEXT_RECEIVERS_H_
#define TRUELUX_TEXT_RECEIVERS_H_

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/receiver.h"

#include "text/byte_source.h"
#include "text/csv.h"
#include "text/receiver_columns.h"

namespace truelux {

/// One row of a receivers table.
struct ReceiverRow {
  std::string text;             ///< the input's bytes without the line end
  Receiver receiver;            ///< without a face that has to be searched for
  FaceChoice face;              ///< for SetFace
  std::vector<double> numbers;  ///< of the columns that were asked for
};

/// Reads a receivers table: a header with at least x, y, z, nx, ny, nz in any
/// order and any case, perhaps on_face, perhaps further columns; then one
/// receiver a row. Without a header, if the first row is six numbers.
class ReceiverReader {
 public:
  using Status = RowStatus;

  /// source, faces: must outlive the reader.
  ReceiverReader(ByteSource& source, const std::string& file_name,
                 FaceWords& faces);

  /// Columns of numbers that the table must have, besides those of receivers.
  /// Before the header; a table without one has none.
  void AskFor(std::vector<std::string> columns) {
    columns_.AskFor(std::move(columns));
  }

  /// Further names of results, which a column must not have. Before the header.
  void Refuse(std::vector<std::string> names) { refused_ = std::move(names); }

  /// Reads the header; must be called once, first. False, and entries in
  /// `defects`, if it cannot be used: a column is missing or stands twice, or
  /// has the name of a result (E_*, bound_*, on_face_found, those refused).
  bool ReadHeader(std::vector<Diagnostic>& defects);

  /// The header as it stands in the input; "" if it has none.
  [[nodiscard]] const std::string& header() const { return header_; }

  /// Whether there is a header; known after ReadHeader.
  [[nodiscard]] bool has_header() const { return has_header_; }

  /// What stands between fields; known after ReadHeader.
  [[nodiscard]] char separator() const { return csv_.separator(); }

  /// Reads the next row. May be called again after a defect.
  Status Next(ReceiverRow& row, std::vector<Diagnostic>& defects);

  /// Reads the next row without a look at what its fields say. May be called
  /// again after a defect.
  Status NextRecord(CsvRecord& record, std::vector<Diagnostic>& defects);

  /// What the fields of a row say; nothing, and a defect for each thing that is
  /// wrong, if they are defective. May be called from several threads, also
  /// while another one reads.
  [[nodiscard]] std::optional<ReceiverFields> Parse(
      const CsvRecord& record, std::vector<Diagnostic>& defects) const {
    return columns_.Parse(csv_, record, defects);
  }

  /// False if Next would have to ask the source for more bytes.
  [[nodiscard]] bool HasBufferedBytes() const {
    return csv_.HasBufferedBytes();
  }

 private:
  CsvReader csv_;
  CsvRecord record_;
  ReceiverColumns columns_;
  std::vector<std::string> refused_;
  std::string header_;
  bool has_header_ = true;
  bool is_row_read_ = false;  ///< record_ is a row that Next has yet to give
};

}  // namespace truelux

#endif  // TRUELUX_TEXT_RECEIVERS_H_
