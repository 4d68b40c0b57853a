// SPDX-License-Identifier: GPL-3.0-or-later
// The line structure that OBJ and MTL share, and the words in a line.

#ifndef TRUELUX_SCENE_IO_STATEMENT_H_
#define TRUELUX_SCENE_IO_STATEMENT_H_

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace truelux {

/// A keyword and what follows it, without blanks around and without comment.
struct Statement {
  std::string_view keyword;
  std::string_view rest;
  int line = 0;  ///< where it begins, 1-based
};

/// Splits a text into statements. Lines end with LF, CRLF or CR; a backslash
/// at the end of a line continues it; a byte order mark is skipped. A comment
/// runs from '#' to the end of the line; in a statement that ends in a name
/// (usemtl, newmtl, mtllib, o, g) the '#' must follow a blank.
class StatementReader {
 public:
  explicit StatementReader(std::string_view text);

  /// The next statement; its views hold until the next call.
  std::optional<Statement> Next();

 private:
  std::string_view TakeLine();

  std::string_view text_;
  int line_ = 0;
  std::string joined_;  ///< the current statement, if it has several lines
};

/// Removes the first word of a text and the blanks around it; empty if there
/// is none.
std::string_view TakeWord(std::string_view& text);

/// The numbers of a statement; `count` may exceed what is stored.
struct Numbers {
  std::array<double, 6> values{};
  std::size_t count = 0;
  std::string_view defect;  ///< the first word that is no number; ends them
};

/// The words of a text as numbers.
Numbers ReadNumbers(std::string_view text);

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_STATEMENT_H_
