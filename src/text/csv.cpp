// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/csv.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "truelux/io.h"

#include "base/ascii_case.h"
#include "base/utf16.h"
#include "text/column_names.h"

namespace truelux {
namespace {

constexpr int kEndOfInput = -1;
constexpr std::size_t kBufferBytes = std::size_t{1} << 16;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool IsBlank(char c) {
  return c == ' ' || c == '\t';
}

std::string_view WithoutReturn(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// The separator that a line "sep=;" is about, as spreadsheets write it.
std::optional<char> GivenSeparator(std::string_view line) {
  constexpr std::string_view kStart = "sep=";
  if (line.size() != kStart.size() + 1 || !line.starts_with(kStart)) {
    return std::nullopt;
  }
  return line.back();
}

/// The fields of a line, roughly: quotes are taken off, not looked at.
std::vector<std::string_view> RoughFields(std::string_view line,
                                          char separator) {
  std::vector<std::string_view> fields;
  const std::string_view ends = separator == ' '
                                    ? std::string_view(" \t")
                                    : std::string_view(&separator, 1);
  while (!line.empty()) {
    const std::size_t size = std::min(line.find_first_of(ends), line.size());
    std::string_view field = TrimBlanks(line.substr(0, size));
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
      field = TrimBlanks(field.substr(1, field.size() - 2));
    }
    if (separator != ' ' || !field.empty()) fields.push_back(field);
    line.remove_prefix(std::min(size + 1, line.size()));
  }
  return fields;
}

/// How many fields name a column that receivers must have, in any case.
std::size_t NamesIn(const std::vector<std::string_view>& fields) {
  return static_cast<std::size_t>(
      std::ranges::count_if(fields, [](std::string_view field) {
        return std::ranges::find(kReceiverColumns, LowerAscii(field)) !=
               kReceiverColumns.end();
      }));
}

char GuessedSeparator(std::string_view line) {
  constexpr std::array<char, 4> kSeparators{',', ';', '\t', ' '};
  char best = ',';
  std::size_t most = 0;
  for (const char separator : kSeparators) {
    const auto fields = RoughFields(line, separator);
    const bool is_row = fields.size() == kReceiverColumns.size() &&
                        std::ranges::all_of(fields, [](std::string_view field) {
                          return ParseNumber(field).has_value();
                        });
    const std::size_t score = std::max(NamesIn(fields), std::size_t{is_row});
    if (score > most) {
      most = score;
      best = separator;
    }
  }
  return best;
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
  if (!started_) Start();
  if (is_utf16_) {
    is_utf16_ = false;
    defect = Error(1, "looks like UTF-16, expected UTF-8: save it as UTF-8");
    next_ = end_;
    ended_ = true;
    return Status::kDefect;
  }
  for (;;) {
    while (Peek() == '#')
      SkipLine();
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
  EndRecord(record, place);
  return Status::kRecord;
}

/// Ends the last field; blanks at the end of a line separate nothing.
void CsvReader::EndRecord(CsvRecord& record, Place place) const {
  record.fields_.back().end = record.text_.size();
  const bool is_behind_blanks = separator_ == ' ' && place == Place::kStart;
  if (is_behind_blanks && record.fields_.size() > 1) record.fields_.pop_back();
}

/// Whether a byte outside quotes separates two fields. Blanks before a field
/// belong to it.
bool CsvReader::EndsField(char c, Place place) const {
  if (separator_ != ' ') return c == separator_;
  return IsBlank(c) && place != Place::kStart;
}

/// Takes one byte into the record; returns what is wrong with it, if anything.
const char* CsvReader::Step(char c, CsvRecord& record, Place& place) {
  if (c == '\0') return "NUL byte; the input is no text";
  if (place != Place::kQuoted && EndsField(c, place)) {
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

/// Makes the buffer hold a whole line, or as much as it can.
void CsvReader::FillLine() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(next_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_),
            buffer_.begin());
  end_ -= next_;
  next_ = 0;
  const auto has_line = [this] {
    return std::memchr(buffer_.data(), '\n', end_) != nullptr;
  };
  while (!ended_ && end_ < buffer_.size() && !has_line()) {
    const std::size_t n = source_.Read(std::span(buffer_).subspan(end_));
    ended_ = n == 0;
    end_ += n;
  }
}

std::string_view CsvReader::FirstLine() const {
  const std::string_view all(buffer_.data() + next_, end_ - next_);
  return all.substr(0, all.find('\n'));
}

void CsvReader::Start() {
  started_ = true;
  FillLine();
  // Of the first line alone: what is behind it may come later, or not.
  is_utf16_ = LooksLikeUtf16(FirstLine());
  if (FirstLine().starts_with(kByteOrderMark)) next_ = kByteOrderMark.size();
  for (;;) {
    const std::string_view whole = WithoutReturn(FirstLine());
    const std::string_view line = TrimBlanks(whole);
    if (const auto given = GivenSeparator(whole)) {
      separator_ = *given;
      SkipLine();
      return;
    }
    const bool is_skipped = line.empty() || line.starts_with('#');
    if (!is_skipped || end_ == next_) {
      separator_ = GuessedSeparator(line);
      return;
    }
    SkipLine();
    FillLine();
  }
}

RowStatus NextRecord(CsvReader& csv, CsvRecord& record,
                     std::vector<Diagnostic>& defects) {
  Diagnostic defect;
  switch (csv.Next(record, defect)) {
    case CsvReader::Status::kDefect:
      defects.push_back(std::move(defect));
      return RowStatus::kDefect;
    case CsvReader::Status::kEnd:
      return RowStatus::kEnd;
    case CsvReader::Status::kRecord:
      break;
  }
  return RowStatus::kRow;
}

}  // namespace truelux
