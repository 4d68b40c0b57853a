// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a table that say what its receivers are.

#ifndef TRUELUX_TEXT_RECEIVER_COLUMNS_H_
#define TRUELUX_TEXT_RECEIVER_COLUMNS_H_

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/receiver.h"

#include "text/column_names.h"
#include "text/csv.h"
#include "text/face_choice.h"

namespace truelux {

/// A receiver from the texts of x, y, z, nx, ny, nz. For each text that is no
/// number, or for a normal that is zero, `defects` gets an entry: which of the
/// six texts it is about and what is wrong.
struct FieldDefect {
  std::size_t index = 0;
  std::string message;
};

Receiver ParseReceiver(const std::array<std::string, 6>& texts,
                       std::vector<FieldDefect>& defects);

/// The columns of a header by their names.
class ColumnNames {
 public:
  /// The arguments must outlive the object.
  ColumnNames(const CsvReader& csv, const CsvRecord& header);

  /// The names, in the order of the columns.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  /// The column of a name, if there is one; else that of the name in another
  /// case. Adds a defect if the name stands twice; other names may.
  std::optional<std::size_t> Find(std::string_view name,
                                  std::vector<Diagnostic>& defects) const;

 private:
  const CsvReader& csv_;
  const CsvRecord& header_;
  std::vector<std::string> names_;
};

/// What the columns of a row say.
struct ReceiverFields {
  Receiver receiver;            ///< without a face that has to be searched for
  FaceChoice face;              ///< for SetFace
  std::vector<double> numbers;  ///< of the further columns
};

/// Where a table has its receivers: the columns x, y, z, nx, ny, nz and, if
/// there, on_face.
class ReceiverColumns {
 public:
  /// faces: must outlive the object.
  explicit ReceiverColumns(FaceWords& faces) : faces_(faces) {}

  /// Columns of numbers that the table must have, too. Before the header.
  void AskFor(std::vector<std::string> further) {
    further_ = std::move(further);
  }

  /// Reads the header's record. Adds a defect for every column that is missing
  /// or stands twice.
  void Find(const CsvReader& csv, const CsvRecord& header,
            std::vector<Diagnostic>& defects);

  /// Takes a table without header: six columns, in the usual order.
  void TakeUsual();

  /// The receiver of a row; without a column on_face, and where that is empty,
  /// with the usual choice of a face. Nothing, and a defect for each thing that is
  /// wrong, if it has not as many fields as the header or if one of these
  /// columns does not hold what it should.
  std::optional<ReceiverFields> Parse(const CsvReader& csv,
                                      const CsvRecord& row,
                                      std::vector<Diagnostic>& defects) const;

  /// Whether a row has as many fields as the header.
  [[nodiscard]] bool HasAllFields(const CsvRecord& row) const {
    return row.size() == column_count_;
  }

 private:
  FaceWords& faces_;
  std::size_t column_count_ = 0;
  std::array<std::size_t, kReceiverColumns.size()> columns_{};
  std::optional<std::size_t> on_face_column_;
  std::vector<std::string> further_;
  std::vector<std::size_t> further_columns_;
};

/// Whether a record is a row of a table without header: six numbers.
bool IsRowWithoutHeader(const CsvRecord& record);

/// Reads the first record of a table, which names its columns. False, and a
/// defect, if there is none.
bool ReadHeaderRecord(CsvReader& csv, CsvRecord& record,
                      std::vector<Diagnostic>& defects);

}  // namespace truelux

#endif  // TRUELUX_TEXT_RECEIVER_COLUMNS_H_
