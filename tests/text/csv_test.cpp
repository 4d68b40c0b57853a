// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/csv.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "text/byte_source.h"

namespace truelux {
namespace {

/// Gives a text in pieces of n bytes, as a slow pipe may.
class PiecewiseSource : public ByteSource {
 public:
  PiecewiseSource(std::string_view text, std::size_t n) : rest_(text), n_(n) {}

  std::size_t Read(std::span<char> buffer) override {
    const std::size_t n =
        rest_.copy(buffer.data(), std::min(n_, buffer.size()));
    rest_.remove_prefix(n);
    return n;
  }

 private:
  std::string_view rest_;
  std::size_t n_;
};

/// All that a reader says about a text: for each record its fields' values,
/// for each defect its text.
std::vector<std::vector<std::string>> ReadFrom(ByteSource& source) {
  CsvReader reader(source, "t.csv");
  std::vector<std::vector<std::string>> all;
  CsvRecord record;
  Diagnostic defect;
  for (;;) {
    switch (reader.Next(record, defect)) {
      case CsvReader::Status::kEnd:
        return all;
      case CsvReader::Status::kDefect:
        all.push_back({defect.Text()});
        break;
      case CsvReader::Status::kRecord:
        all.emplace_back();
        for (std::size_t i = 0; i < record.size(); ++i) {
          all.back().push_back(record.Value(i));
        }
        break;
    }
  }
}

std::vector<std::vector<std::string>> Read(std::string_view text) {
  TextSource source(text);
  return ReadFrom(source);
}

using Records = std::vector<std::vector<std::string>>;

TEST(Csv, SplitsAtCommasAndLineEnds) {
  const Records expected = {{"a", "b"}, {"1", "2"}};
  EXPECT_EQ(Read("a,b\n1,2\n"), expected);
  EXPECT_EQ(Read("a,b\r\n1,2\r\n"), expected);
  EXPECT_EQ(Read("a,b\n1,2"), expected);
  EXPECT_EQ(Read("a,b\r\n1,2\r"), expected);
}

TEST(Csv, EmptyFieldsAreFields) {
  EXPECT_EQ(Read(",\n"), (Records{{"", ""}}));
  EXPECT_EQ(Read("a,,\n"), (Records{{"a", "", ""}}));
  EXPECT_EQ(Read("\"\"\n"), (Records{{""}}));
}

TEST(Csv, BlankLinesAndByteOrderMarkAreSkipped) {
  EXPECT_EQ(Read("\n \t\na\n\r\n\nb\n\n"), (Records{{"a"}, {"b"}}));
  EXPECT_EQ(Read("\xEF\xBB\xBFx,y\n"), (Records{{"x", "y"}}));
  EXPECT_EQ(Read("\xEF\xBB\xBF"), Records{});
  EXPECT_EQ(Read(""), Records{});
}

TEST(Csv, ByteOrderMarkElsewhereIsText) {
  EXPECT_EQ(Read("x\n\xEF\xBB\xBFy\n"), (Records{{"x"}, {"\xEF\xBB\xBFy"}}));
}

TEST(Csv, QuotedFieldsHoldCommasQuotesAndLineEnds) {
  EXPECT_EQ(Read("\"a,b\",\"say \"\"hi\"\"\",\"1\r\n2\"\nnext\n"),
            (Records{{"a,b", "say \"hi\"", "1\r\n2"}, {"next"}}));
}

TEST(Csv, BlanksAroundValuesDoNotCount) {
  EXPECT_EQ(Read(" a ,\t\"b\" \n"), (Records{{"a", "b"}}));
}

TEST(Csv, TextIsKeptByteForByte) {
  const std::string text = " 1 ,\"a \"\"b\"\", c\",\xC3\xA9";
  TextSource source(text);
  CsvReader reader(source, "t.csv");
  CsvRecord record;
  Diagnostic defect;
  ASSERT_EQ(reader.Next(record, defect), CsvReader::Status::kRecord);
  EXPECT_EQ(record.text(), text);
}

TEST(Csv, LinesAreCountedThroughQuotedLineEnds) {
  TextSource source("a\n\"1\n2\",b\n\nc\n");
  CsvReader reader(source, "t.csv");
  CsvRecord record;
  Diagnostic defect;
  ASSERT_EQ(reader.Next(record, defect), CsvReader::Status::kRecord);
  EXPECT_EQ(record.line(0), 1);
  ASSERT_EQ(reader.Next(record, defect), CsvReader::Status::kRecord);
  EXPECT_EQ(record.line(0), 2);
  EXPECT_EQ(record.line(1), 3);
  ASSERT_EQ(reader.Next(record, defect), CsvReader::Status::kRecord);
  EXPECT_EQ(record.line(0), 5);
}

TEST(Csv, DefectsAreLocatedAndPassedOver) {
  const auto defect = [](const char* text) {
    return Records{{"1"}, {text}, {"3"}};
  };
  EXPECT_EQ(Read("1\na\"b\n3\n"),
            defect("t.csv:2: error: quote inside a field that does not start "
                   "with one"));
  EXPECT_EQ(Read("1\n\"a\"b\n3\n"),
            defect("t.csv:2: error: text after a closing quote"));
  EXPECT_EQ(Read("1\n\"a\" \"\n3\n"),
            defect("t.csv:2: error: text after a closing quote"));
  EXPECT_EQ(Read("1\na\rb\n3\n"),
            defect("t.csv:2: error: carriage return without line feed"));
  EXPECT_EQ(Read(std::string_view("1\na\0b\n3\n", 8)),
            defect("t.csv:2: error: NUL byte; the input is no text"));
}

TEST(Csv, QuoteThatIsNeverClosedIsReportedWhereItOpens) {
  EXPECT_EQ(Read("1\n2,\"a\nb\nc"),
            (Records{{"1"}, {"t.csv:2: error: this quote is never closed"}}));
}

TEST(Csv, RecordsDoNotGrowWithoutLimit) {
  const std::string endless =
      "1\n\"" + std::string(2 * CsvReader::kMaxRecordBytes, 'a');
  EXPECT_EQ(Read(endless),
            (Records{{"1"},
                     {"t.csv:2: error: record longer than 16 MiB; is a quote "
                      "never closed?"}}));
}

TEST(Csv, PiecesDoNotMatter) {
  const std::string text =
      "\xEF\xBB\xBF"
      "a,\"b\r\n\"\"c\"\r\n\r\n \"x\" ,y\n1\"\n\"last\"";
  const Records whole = Read(text);
  ASSERT_EQ(whole.size(), 4U);
  for (std::size_t n = 1; n < 8; ++n) {
    PiecewiseSource source(text, n);
    EXPECT_EQ(ReadFrom(source), whole) << "in pieces of " << n;
  }
}

}  // namespace
}  // namespace truelux
