// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/receiver_columns.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "truelux/io.h"

#include "base/ascii_case.h"
#include "scene/io/number_defect.h"
#include "scene/io/quoted.h"

namespace truelux {
namespace {

/// What is wrong with the text of a column that should be a number.
std::string MessageOf(std::string_view column, std::string_view word,
                      std::string_view text) {
  const NumberDefect defect = DefectOfNumber(word);
  if (defect.is_habit) return defect.text;
  return fmt::format(
      "{}: {} is not a number; expected a decimal number in the range of "
      "binary64",
      column, Quoted(text));
}

}  // namespace

Receiver ParseReceiver(const std::array<std::string, 6>& texts,
                       std::vector<FieldDefect>& defects) {
  std::array<double, 6> numbers{};
  bool normal_read = true;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::optional<double> number = ParseNumber(TrimBlanks(texts[i]));
    if (number) {
      numbers[i] = *number;
      continue;
    }
    normal_read = normal_read && i < 3;
    defects.push_back(
        {i, MessageOf(kReceiverColumns[i], TrimBlanks(texts[i]), texts[i])});
  }
  if (normal_read && numbers[3] == 0 && numbers[4] == 0 && numbers[5] == 0) {
    defects.push_back({3, "the normal is zero"});
  }
  return {{numbers[0], numbers[1], numbers[2]},
          {numbers[3], numbers[4], numbers[5]}};
}

ColumnNames::ColumnNames(const CsvReader& csv, const CsvRecord& header)
    : csv_(csv), header_(header) {
  for (std::size_t i = 0; i < header.size(); ++i)
    names_.push_back(header.Value(i));
}

std::optional<std::size_t> ColumnNames::Find(
    std::string_view name, std::vector<Diagnostic>& defects) const {
  const auto is_name = [&](const std::string& other) { return other == name; };
  const auto is_like = [&](const std::string& other) {
    return LowerAscii(other) == name;
  };
  const bool is_exact = std::ranges::any_of(names_, is_name);
  const auto find = [&](auto from) {
    return is_exact ? std::find_if(from, names_.end(), is_name)
                    : std::find_if(from, names_.end(), is_like);
  };
  const auto first = find(names_.begin());
  if (first == names_.end()) return std::nullopt;
  const auto column = static_cast<std::size_t>(first - names_.begin());
  if (find(first + 1) != names_.end()) {
    defects.push_back(csv_.Error(
        header_.line(column), fmt::format("column '{}' stands twice", name)));
  }
  return column;
}

void ReceiverColumns::Find(const CsvReader& csv, const CsvRecord& header,
                           std::vector<Diagnostic>& defects) {
  const ColumnNames names(csv, header);
  column_count_ = header.size();
  std::vector<std::string_view> missing;
  for (std::size_t i = 0; i < kReceiverColumns.size(); ++i) {
    const auto column = names.Find(kReceiverColumns[i], defects);
    if (!column) missing.push_back(kReceiverColumns[i]);
    columns_[i] = column.value_or(0);
  }
  on_face_column_ = names.Find(kOnFaceColumn, defects);
  for (const std::string& name : further_) {
    const auto column = names.Find(name, defects);
    if (!column) missing.push_back(name);
    further_columns_.push_back(column.value_or(0));
  }
  if (missing.empty()) return;
  defects.push_back(csv.Error(
      header.line(0),
      fmt::format("the header lacks the column{} {}; expected names like "
                  "x,y,z,nx,ny,nz with commas between (or semicolons, tabs, "
                  "blanks), found {}",
                  missing.size() == 1 ? "" : "s", fmt::join(missing, ", "),
                  Quoted(header.text()))));
}

std::optional<ReceiverFields> ReceiverColumns::Parse(
    const CsvReader& csv, const CsvRecord& row,
    std::vector<Diagnostic>& defects) const {
  const std::size_t defects_before = defects.size();
  if (!HasAllFields(row)) {
    defects.push_back(
        csv.Error(row.line(0),
                  fmt::format("{} field{}, but the header has {}", row.size(),
                              row.size() == 1 ? "" : "s", column_count_)));
    return std::nullopt;
  }
  std::array<std::string, 6> texts;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    texts[i] = row.Value(columns_[i]);
  }
  std::vector<FieldDefect> field_defects;
  ReceiverFields fields;
  fields.receiver = ParseReceiver(texts, field_defects);
  for (FieldDefect& defect : field_defects) {
    defects.push_back(
        csv.Error(row.line(columns_[defect.index]), std::move(defect.message)));
  }
  std::optional<FaceChoice> face = faces_.usual();
  if (on_face_column_) {
    std::string message;
    face = faces_.Parse(row.Value(*on_face_column_), message);
    if (!face) {
      defects.push_back(
          csv.Error(row.line(*on_face_column_),
                    fmt::format("{}: {}", kOnFaceColumn, message)));
    }
  }
  for (std::size_t i = 0; i < further_columns_.size(); ++i) {
    const std::size_t column = further_columns_[i];
    const std::string text = row.Value(column);
    const std::optional<double> number = ParseNumber(TrimBlanks(text));
    if (!number) {
      defects.push_back(csv.Error(
          row.line(column), MessageOf(further_[i], TrimBlanks(text), text)));
    }
    fields.numbers.push_back(number.value_or(0));
  }
  if (defects.size() != defects_before) return std::nullopt;
  fields.face = *face;
  fields.receiver.on_face = face->number;
  return fields;
}

void ReceiverColumns::TakeUsual() {
  column_count_ = kReceiverColumns.size();
  for (std::size_t i = 0; i < columns_.size(); ++i)
    columns_[i] = i;
  on_face_column_.reset();
}

bool IsRowWithoutHeader(const CsvRecord& record) {
  if (record.size() != kReceiverColumns.size()) return false;
  for (std::size_t i = 0; i < record.size(); ++i) {
    if (!ParseNumber(record.Value(i))) return false;
  }
  return true;
}

bool ReadHeaderRecord(CsvReader& csv, CsvRecord& record,
                      std::vector<Diagnostic>& defects) {
  const RowStatus status = NextRecord(csv, record, defects);
  if (status == RowStatus::kEnd) {
    defects.push_back(
        csv.Error(1, fmt::format("no header; expected the columns {}",
                                 fmt::join(kReceiverColumns, ","))));
  }
  return status == RowStatus::kRow;
}

}  // namespace truelux
