// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/receivers.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <string_view>
#include <utility>

#include "base/ascii_case.h"
#include "scene/io/quoted.h"

namespace truelux {
namespace {

bool IsResultColumn(std::string_view name) {
  return name.starts_with("E_") || name.starts_with("bound_") ||
         LowerAscii(name) == kOnFaceFoundColumn;
}

}  // namespace

ReceiverReader::ReceiverReader(ByteSource& source, const std::string& file_name,
                               FaceWords& faces)
    : csv_(source, file_name), columns_(faces) {}

bool ReceiverReader::ReadHeader(std::vector<Diagnostic>& defects) {
  if (!ReadHeaderRecord(csv_, record_, defects)) return false;
  has_header_ = !IsRowWithoutHeader(record_);
  if (!has_header_) {
    columns_.TakeUsual();
    is_row_read_ = true;
    return true;
  }
  header_ = record_.text();
  const std::size_t defects_before = defects.size();
  for (std::size_t i = 0; i < record_.size(); ++i) {
    const std::string name = record_.Value(i);
    if (!IsResultColumn(name) &&
        std::ranges::find(refused_, name) == refused_.end()) {
      continue;
    }
    defects.push_back(
        csv_.Error(record_.line(i),
                   fmt::format("column {} has the name of a result; rename it",
                               Quoted(name))));
  }
  columns_.Find(csv_, record_, defects);
  return defects.size() == defects_before;
}

ReceiverReader::Status ReceiverReader::NextRecord(
    CsvRecord& record, std::vector<Diagnostic>& defects) {
  if (std::exchange(is_row_read_, false)) {
    record = record_;
    return Status::kRow;
  }
  return truelux::NextRecord(csv_, record, defects);
}

ReceiverReader::Status ReceiverReader::Next(ReceiverRow& row,
                                            std::vector<Diagnostic>& defects) {
  const Status status = NextRecord(record_, defects);
  if (status != Status::kRow) return status;
  const std::optional<ReceiverFields> fields = Parse(record_, defects);
  if (!fields) return Status::kDefect;
  row.text = record_.text();
  row.receiver = fields->receiver;
  row.face = fields->face;
  row.numbers = fields->numbers;
  return Status::kRow;
}

}  // namespace truelux
