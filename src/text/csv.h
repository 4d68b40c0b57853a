// SPDX-License-Identifier: GPL-3.0-or-later
// Records of values with commas between (RFC 4180), or semicolons, tabs or
// blanks, read one at a time.

#ifndef TRUELUX_TEXT_CSV_H_
#define TRUELUX_TEXT_CSV_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/diagnostics.h"

#include "text/byte_source.h"

namespace truelux {

/// The text without blanks (spaces and tabs) at its ends.
std::string_view TrimBlanks(std::string_view text);

/// One record: the bytes of the input, without the line end, and where its
/// fields are.
class CsvRecord {
 public:
  /// The record as it stands in the input: quotes, blanks and all.
  [[nodiscard]] const std::string& text() const { return text_; }

  [[nodiscard]] std::size_t size() const { return fields_.size(); }

  /// What field i says: without blanks around it and without its quotes.
  [[nodiscard]] std::string Value(std::size_t i) const;

  /// Line on which field i starts, from 1.
  [[nodiscard]] int line(std::size_t i) const { return fields_[i].line; }

 private:
  friend class CsvReader;

  struct Field {
    std::size_t begin = 0;  ///< [begin, end) in text_
    std::size_t end = 0;
    int line = 0;
  };

  std::string text_;
  std::vector<Field> fields_;
};

/// How the reading of one row of a table went.
enum class RowStatus {
  kRow,     ///< a row was read
  kDefect,  ///< a row is defective; the list of defects says why
  kEnd,     ///< there are no more rows
};

/// Splits a byte stream into records.
///
/// The first line says what stands between fields: `sep=;` if it is that, else
/// the separator that finds most of the names of receivers' columns in it, or
/// numbers only. Between blanks (spaces and tabs) several count as one. Lines
/// that begin with # are skipped.
///
/// Lines end with LF or CRLF, the last one perhaps without; blank lines are
/// skipped, and so is a byte order mark at the start. A field whose first
/// character other than a blank is a quote ends with a quote; in between,
/// commas and line ends are plain text and a quote is written twice.
/// Only one record is held in memory.
class CsvReader {
 public:
  enum class Status {
    kRecord,  ///< a record was read
    kDefect,  ///< a line was no record and has been passed over
    kEnd,     ///< there is nothing more
  };

  /// A longer record is a defect and ends the input: what makes records grow
  /// without limit is a quote that is never closed.
  static constexpr std::size_t kMaxRecordBytes = std::size_t{1} << 24;

  /// `source` must outlive the reader; `file_name` prefixes diagnostics.
  CsvReader(ByteSource& source, std::string file_name);

  /// Reads the next record; on kDefect `defect` says what is wrong. Errors of
  /// the source are passed on as they are thrown.
  Status Next(CsvRecord& record, Diagnostic& defect);

  /// What stands between fields; known from the first Next on. ' ' stands for
  /// any blanks.
  [[nodiscard]] char separator() const { return separator_; }

  /// False if Next would have to ask the source for more bytes.
  [[nodiscard]] bool HasBufferedBytes() const { return next_ < end_; }

  /// An error of this file.
  [[nodiscard]] Diagnostic Error(int line, std::string message) const;

 private:
  enum class Place;

  int Get();
  int Peek();
  bool Fill();
  void SkipLine();
  void Start();
  void FillLine();
  [[nodiscard]] std::string_view FirstLine() const;
  Status ReadRecord(CsvRecord& record, Diagnostic& defect);
  void EndRecord(CsvRecord& record, Place place) const;
  [[nodiscard]] bool EndsField(char c, Place place) const;
  const char* Step(char c, CsvRecord& record, Place& place);

  ByteSource& source_;
  std::string file_name_;
  std::vector<char> buffer_;
  std::size_t next_ = 0;  ///< unread bytes are [next_, end_) of buffer_
  std::size_t end_ = 0;
  int line_ = 1;        ///< of the next byte
  int quote_line_ = 0;  ///< of the last opening quote
  char separator_ = ',';
  bool started_ = false;   ///< what comes before records has been dealt with
  bool is_utf16_ = false;  ///< the input is in an encoding that is not read
  bool ended_ = false;
};

/// Reads the next record of a table. Of a line that is no record, what is wrong
/// goes to `defects`.
RowStatus NextRecord(CsvReader& csv, CsvRecord& record,
                     std::vector<Diagnostic>& defects);

}  // namespace truelux

#endif  // TRUELUX_TEXT_CSV_H_
