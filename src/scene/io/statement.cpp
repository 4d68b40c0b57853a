// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/statement.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "truelux/io.h"

namespace truelux {
namespace {

bool IsBlank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool IsLineEnd(char c) {
  return c == '\n' || c == '\r';
}

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && IsBlank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && IsBlank(text.back()))
    text.remove_suffix(1);
  return text;
}

bool TakesName(std::string_view keyword) {
  constexpr std::array<std::string_view, 5> kKeywords{"usemtl", "newmtl",
                                                      "mtllib", "o", "g"};
  return std::ranges::find(kKeywords, keyword) != kKeywords.end();
}

/// Where the comment begins, or npos. in_name: a '#' within a word is none.
std::size_t CommentStart(std::string_view line, bool in_name) {
  std::size_t at = line.find('#');
  while (in_name && at != std::string_view::npos && at > 0 &&
         !IsBlank(line[at - 1])) {
    at = line.find('#', at + 1);
  }
  return at;
}

}  // namespace

StatementReader::StatementReader(std::string_view text) : text_(text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text_.starts_with(kByteOrderMark)) {
    text_.remove_prefix(kByteOrderMark.size());
  }
}

std::string_view StatementReader::TakeLine() {
  const auto end = std::ranges::find_if(text_, IsLineEnd);
  const auto size = static_cast<std::size_t>(end - text_.begin());
  const std::string_view line = text_.substr(0, size);
  text_.remove_prefix(size);
  text_.remove_prefix(text_.starts_with("\r\n") ? 2 : text_.empty() ? 0 : 1);
  ++line_;
  return line;
}

std::optional<Statement> StatementReader::Next() {
  while (!text_.empty()) {
    std::string_view line = TakeLine();
    const int first_line = line_;
    std::string_view start = line;
    const bool in_name = TakesName(TakeWord(start));
    line = line.substr(0, CommentStart(line, in_name));
    if (line.ends_with('\\')) {
      joined_.clear();
      while (line.ends_with('\\')) {
        joined_.append(line.substr(0, line.size() - 1)).append(" ");
        line = TakeLine();
        line = line.substr(0, CommentStart(line, in_name));
      }
      line = joined_.append(line);
    }
    line = Trimmed(line);
    if (line.empty()) continue;
    const std::string_view keyword = TakeWord(line);
    return Statement{keyword, line, first_line};
  }
  return std::nullopt;
}

std::string_view TakeWord(std::string_view& text) {
  const auto begin = std::ranges::find_if_not(text, IsBlank);
  const auto end = std::find_if(begin, text.end(), IsBlank);
  const auto next = std::find_if_not(end, text.end(), IsBlank);
  const std::string_view word(begin, end);
  text = std::string_view(next, text.end());
  return word;
}

Numbers ReadNumbers(std::string_view text) {
  Numbers numbers;
  while (!text.empty()) {
    const std::string_view word = TakeWord(text);
    const std::optional<double> value = ParseNumber(word);
    if (!value) {
      numbers.defect = word;
      break;
    }
    if (numbers.count < numbers.values.size()) {
      numbers.values[numbers.count] = *value;
    }
    ++numbers.count;
  }
  return numbers;
}

}  // namespace truelux
