#include "report/receivers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <system_error>
#include <utility>

#include "truelux/io.h"

#include "scene/quoted.h"

namespace truelux {
namespace {

bool IsResultColumn(std::string_view name) {
  return name.starts_with("E_") || name.starts_with("bound_");
}

}  // namespace

std::optional<int> ParseOnFace(std::string_view text, int face_count,
                               std::string& defect) {
  const std::string_view trimmed = TrimBlanks(text);
  if (trimmed.empty()) return 0;
  const std::optional<double> number = ParseNumber(trimmed);
  if (!number || std::trunc(*number) != *number) {
    defect = fmt::format("{} is not the number of a face", Quoted(trimmed));
    return std::nullopt;
  }
  if (*number < 1 || *number > face_count) {
    defect =
        fmt::format("{} is out of range; the scene has {} {}", Quoted(trimmed),
                    face_count, face_count == 1 ? "face" : "faces");
    return std::nullopt;
  }
  return static_cast<int>(*number);
}

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
        {i, fmt::format("{}: {} is not a number; expected a decimal number in "
                        "the range of binary64",
                        kReceiverColumns[i], Quoted(texts[i]))});
  }
  if (normal_read && numbers[3] == 0 && numbers[4] == 0 && numbers[5] == 0) {
    defects.push_back({3, "the normal is zero"});
  }
  return {{numbers[0], numbers[1], numbers[2]},
          {numbers[3], numbers[4], numbers[5]}};
}

ReceiverReader::ReceiverReader(ByteSource& source, const std::string& file_name,
                               int face_count)
    : csv_(source, file_name), face_count_(face_count) {}

bool ReceiverReader::ReadHeader(std::vector<Diagnostic>& defects) {
  Diagnostic defect;
  switch (csv_.Next(record_, defect)) {
    case CsvReader::Status::kDefect:
      defects.push_back(std::move(defect));
      return false;
    case CsvReader::Status::kEnd:
      defects.push_back(
          csv_.Error(1, fmt::format("no header; expected the columns {}",
                                    fmt::join(kReceiverColumns, ","))));
      return false;
    case CsvReader::Status::kRecord:
      break;
  }
  header_ = record_.text();
  column_count_ = record_.size();
  return FindColumns(defects);
}

bool ReceiverReader::FindColumns(std::vector<Diagnostic>& defects) {
  const std::size_t defects_before = defects.size();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < record_.size(); ++i) {
    names.push_back(record_.Value(i));
    if (!IsResultColumn(names.back())) continue;
    defects.push_back(
        csv_.Error(record_.line(i),
                   fmt::format("column {} has the name of a result; rename it",
                               Quoted(names.back()))));
  }
  // Columns that this program does not read may share a name.
  const auto find = [&](std::string_view name) {
    const auto first = std::find(names.begin(), names.end(), name);
    std::optional<std::size_t> column;
    if (first == names.end()) return column;
    column = static_cast<std::size_t>(first - names.begin());
    if (std::find(first + 1, names.end(), name) != names.end()) {
      defects.push_back(
          csv_.Error(record_.line(*column),
                     fmt::format("column '{}' stands twice", name)));
    }
    return column;
  };
  std::vector<std::string_view> missing;
  for (std::size_t i = 0; i < kReceiverColumns.size(); ++i) {
    const std::optional<std::size_t> column = find(kReceiverColumns[i]);
    if (!column) missing.push_back(kReceiverColumns[i]);
    columns_[i] = column.value_or(0);
  }
  on_face_column_ = find(kOnFaceColumn);
  if (!missing.empty()) {
    defects.push_back(csv_.Error(
        record_.line(0),
        fmt::format("the header lacks the column{} {}; expected names like "
                    "x,y,z,nx,ny,nz with commas between, found {}",
                    missing.size() == 1 ? "" : "s", fmt::join(missing, ", "),
                    Quoted(record_.text()))));
  }
  return defects.size() == defects_before;
}

ReceiverReader::Status ReceiverReader::Next(ReceiverRow& row,
                                            std::vector<Diagnostic>& defects) {
  Diagnostic defect;
  switch (csv_.Next(record_, defect)) {
    case CsvReader::Status::kDefect:
      defects.push_back(std::move(defect));
      return Status::kDefect;
    case CsvReader::Status::kEnd:
      return Status::kEnd;
    case CsvReader::Status::kRecord:
      break;
  }
  const std::optional<Receiver> receiver = ParseRow(defects);
  if (!receiver) return Status::kDefect;
  row.text = record_.text();
  row.receiver = *receiver;
  return Status::kRow;
}

std::optional<Receiver> ReceiverReader::ParseRow(
    std::vector<Diagnostic>& defects) {
  const std::size_t defects_before = defects.size();
  if (record_.size() != column_count_) {
    defects.push_back(csv_.Error(
        record_.line(0),
        fmt::format("{} field{}, but the header has {}", record_.size(),
                    record_.size() == 1 ? "" : "s", column_count_)));
    return std::nullopt;
  }
  std::array<std::string, 6> texts;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    texts[i] = record_.Value(columns_[i]);
  }
  std::vector<FieldDefect> field_defects;
  Receiver receiver = ParseReceiver(texts, field_defects);
  for (FieldDefect& defect : field_defects) {
    defects.push_back(csv_.Error(record_.line(columns_[defect.index]),
                                 std::move(defect.message)));
  }
  if (on_face_column_) {
    std::string message;
    const std::optional<int> face =
        ParseOnFace(record_.Value(*on_face_column_), face_count_, message);
    if (!face) {
      defects.push_back(
          csv_.Error(record_.line(*on_face_column_),
                     fmt::format("{}: {}", kOnFaceColumn, message)));
    }
    receiver.on_face = face.value_or(0);
  }
  if (defects.size() != defects_before) return std::nullopt;
  return receiver;
}

}  // namespace truelux
