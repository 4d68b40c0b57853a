// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/csv.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace truelux {
namespace {

constexpr int kEndOfInput = -1;
constexpr std::size_t kBufferBytes = std::size_t{1} << 16;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool IsBlank(char c) {
  return c == ' ' || c == '\t';
}

}  // namespace

std::string_view TrimBlanks(std::string_view text) {
  while (!text.empty() && IsBlank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && IsBlank(text.back()))
    text.remove_suffix(1);
  return text;
}

std::string CsvRecord::Value(std::size_t i) const {
  const Field& field = fields_[i];
  const std::string_view inside = TrimBlanks(
      std::string_view(text_).substr(field.begin, field.end - field.begin));
  if (inside.empty() || inside.front() != '"') return std::string(inside);
  std::string value;
  for (std::size_t k = 1; k + 1 < inside.size(); ++k) {
    value += inside[k];
    if (inside[k] == '"') ++k;  // written twice, meant once
  }
  return std::string(TrimBlanks(value));
}

/// Where in a field the reader stands.
enum class CsvReader::Place {
  kStart,      ///< nothing but blanks so far
  kPlain,      ///< in a field without quotes
  kQuoted,     ///< between quotes
  kQuoteSeen,  ///< after a quote that closes, or is the first of two
  kClosed,     ///< after the closing quote and a blank
};

CsvReader::CsvReader(ByteSource& source, std::string file_name)
    : source_(source),
      file_name_(std::move(file_name)),
      buffer_(kBufferBytes) {}

Diagnostic CsvReader::Error(int line, std::string message) const {
  return {Severity::kError, file_name_, line, std::move(message)};
}

CsvReader::Status CsvReader::Next(CsvRecord& record, Diagnostic& defect) {
  if (!started_) SkipByteOrderMark();
  for (;;) {
    const Status status = ReadRecord(record, defect);
    const bool blank_line =
        status == Status::kRecord && TrimBlanks(record.text_).empty();
    if (!blank_line) return status;
  }
}

CsvReader::Status CsvReader::ReadRecord(CsvRecord& record, Diagnostic& defect) {
  record.text_.clear();
  record.fields_.clear();
  if (Peek() == kEndOfInput) return Status::kEnd;
  const int first_line = line_;
  Place place = Place::kStart;
  record.fields_.push_back({0, 0, line_});
  for (;;) {
    const int byte = Get();
    const bool quoted = place == Place::kQuoted;
    if (byte == kEndOfInput && quoted) {
      defect = Error(quote_line_, "this quote is never closed");
      return Status::kDefect;
    }
    if (byte == kEndOfInput || (byte == '\n' && !quoted)) break;
    if (byte == '\r' && !quoted) {
      if (Peek() == '\n' || Peek() == kEndOfInput) continue;
      defect = Error(line_, "carriage return without line feed");
      SkipLine();
      return Status::kDefect;
    }
    const int at_line = line_;
    if (const char* what = Step(static_cast<char>(byte), record, place)) {
      defect = Error(at_line, what);
      SkipLine();
      return Status::kDefect;
    }
    if (record.text_.size() > kMaxRecordBytes) {
      defect = Error(quoted ? quote_line_ : first_line,
                     "record longer than 16 MiB; is a quote never closed?");
      next_ = end_;
      ended_ = true;
      return Status::kDefect;
    }
  }
  record.fields_.back().end = record.text_.size();
  return Status::kRecord;
}

/// Takes one byte into the record; returns what is wrong with it, if anything.
const char* CsvReader::Step(char c, CsvRecord& record, Place& place) {
  if (c == '\0') return "NUL byte; the input is no text";
  if (c == ',' && place != Place::kQuoted) {
    record.fields_.back().end = record.text_.size();
    record.text_ += c;
    record.fields_.push_back({record.text_.size(), 0, line_});
    place = Place::kStart;
    return nullptr;
  }
  switch (place) {
    case Place::kStart:
      if (c == '"') {
        quote_line_ = line_;
        place = Place::kQuoted;
      } else if (!IsBlank(c)) {
        place = Place::kPlain;
      }
      break;
    case Place::kPlain:
      if (c == '"') return "quote inside a field that does not start with one";
      break;
    case Place::kQuoted:
      if (c == '"') place = Place::kQuoteSeen;
      break;
    case Place::kQuoteSeen:
      if (c == '"') {
        place = Place::kQuoted;
        break;
      }
      place = Place::kClosed;
      [[fallthrough]];
    case Place::kClosed:
      if (!IsBlank(c)) return "text after a closing quote";
      break;
  }
  record.text_ += c;
  return nullptr;
}

bool CsvReader::Fill() {
  if (ended_) return false;
  next_ = 0;
  end_ = source_.Read(buffer_);
  ended_ = end_ == 0;
  return !ended_;
}

int CsvReader::Peek() {
  if (next_ == end_ && !Fill()) return kEndOfInput;
  return static_cast<unsigned char>(buffer_[next_]);
}

int CsvReader::Get() {
  const int byte = Peek();
  if (byte == kEndOfInput) return byte;
  ++next_;
  // The line numbers of an input with 2^31 lines stop at the last int.
  if (byte == '\n' && line_ < std::numeric_limits<int>::max()) ++line_;
  return byte;
}

void CsvReader::SkipLine() {
  for (int byte = Get(); byte != '\n' && byte != kEndOfInput;)
    byte = Get();
}

void CsvReader::SkipByteOrderMark() {
  started_ = true;
  // The mark may arrive in pieces.
  while (end_ < kByteOrderMark.size()) {
    const std::size_t n = source_.Read(std::span(buffer_).subspan(end_));
    ended_ = n == 0;
    if (ended_) break;
    end_ += n;
  }
  const std::string_view front(buffer_.data(), end_);
  if (front.starts_with(kByteOrderMark)) next_ = kByteOrderMark.size();
}

}  // namespace truelux
