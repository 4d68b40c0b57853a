// Receivers from comma-separated values, one at a time.

#ifndef TRUELUX_REPORT_RECEIVERS_H_
#define TRUELUX_REPORT_RECEIVERS_H_

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/receiver.h"

#include "report/byte_source.h"
#include "report/csv.h"

namespace truelux {

/// Names of the columns that a receivers table must have, in the order in
/// which this program writes them.
inline constexpr std::array<std::string_view, 6> kReceiverColumns = {
    "x", "y", "z", "nx", "ny", "nz"};

/// Name of the column for Receiver::on_face.
inline constexpr std::string_view kOnFaceColumn = "on_face";

/// Number of the face that a text names: 1 .. face_count, or 0 if it is empty.
/// Nothing if it is no such number; `defect` then says why.
std::optional<int> ParseOnFace(std::string_view text, int face_count,
                               std::string& defect);

/// A receiver from the texts of x, y, z, nx, ny, nz. For each text that is no
/// number, or for a normal that is zero, `defects` gets an entry: which of the
/// six texts it is about and what is wrong.
struct FieldDefect {
  std::size_t index = 0;
  std::string message;
};

Receiver ParseReceiver(const std::array<std::string, 6>& texts,
                       std::vector<FieldDefect>& defects);

/// One row of a receivers table.
struct ReceiverRow {
  std::string text;  ///< the input's bytes without the line end
  Receiver receiver;
};

/// Reads a receivers table: a header with at least x, y, z, nx, ny, nz in any
/// order, perhaps on_face, perhaps further columns; then one receiver a row.
class ReceiverReader {
 public:
  enum class Status {
    kRow,     ///< a row was read
    kDefect,  ///< a row is defective; `defects` says why
    kEnd,     ///< there are no more rows
  };

  /// face_count: number of faces of the scene, the largest on_face.
  ReceiverReader(ByteSource& source, const std::string& file_name,
                 int face_count);

  /// Reads the header; must be called once, first. False, and entries in
  /// `defects`, if it cannot be used: a column is missing or stands twice, or
  /// has the name of a result (E_*, bound_*).
  bool ReadHeader(std::vector<Diagnostic>& defects);

  /// The header as it stands in the input.
  [[nodiscard]] const std::string& header() const { return header_; }

  /// Reads the next row. May be called again after a defect.
  Status Next(ReceiverRow& row, std::vector<Diagnostic>& defects);

  /// False if Next would have to ask the source for more bytes.
  [[nodiscard]] bool HasBufferedBytes() const {
    return csv_.HasBufferedBytes();
  }

 private:
  bool FindColumns(std::vector<Diagnostic>& defects);
  std::optional<Receiver> ParseRow(std::vector<Diagnostic>& defects);

  CsvReader csv_;
  CsvRecord record_;
  int face_count_;
  std::string header_;
  std::size_t column_count_ = 0;
  std::array<std::size_t, kReceiverColumns.size()> columns_{};
  std::optional<std::size_t> on_face_column_;
};

}  // namespace truelux

#endif  // TRUELUX_REPORT_RECEIVERS_H_
