// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/statement.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "scene/io/number_defect.h"
#include "scene/io/quoted.h"

namespace truelux {
namespace {

/// "line keyword|rest" for each statement.
std::vector<std::string> StatementsOf(std::string_view text) {
  std::vector<std::string> found;
  StatementReader reader(text);
  while (const auto statement = reader.Next()) {
    found.push_back(std::to_string(statement->line) + " " +
                    std::string(statement->keyword) + "|" +
                    std::string(statement->rest));
  }
  return found;
}

using Lines = std::vector<std::string>;

TEST(StatementReader, TrimsBlanksAndSkipsEmptyLines) {
  EXPECT_EQ(StatementsOf("\n \t\n  v\t1  2\t \n\nf 1"),
            (Lines{"3 v|1  2", "5 f|1"}));
}

TEST(StatementReader, EveryLineEndCountsOnce) {
  EXPECT_EQ(StatementsOf("a\r\nb\rc\nd"),
            (Lines{"1 a|", "2 b|", "3 c|", "4 d|"}));
}

TEST(StatementReader, SkipsAByteOrderMark) {
  EXPECT_EQ(StatementsOf("\xEF\xBB\xBFv 1"), (Lines{"1 v|1"}));
}

TEST(StatementReader, CommentsEndALine) {
  EXPECT_EQ(StatementsOf("# all\nv 1 # some\nv 2#glued\n#"),
            (Lines{"2 v|1", "3 v|2"}));
}

TEST(StatementReader, ANameMayContainAHashWithinAWord) {
  EXPECT_EQ(StatementsOf("usemtl a#1 # one\nnewmtl a#2\ng#x y"),
            (Lines{"1 usemtl|a#1", "2 newmtl|a#2", "3 g|"}));
}

TEST(StatementReader, ABackslashContinuesALine) {
  EXPECT_EQ(StatementsOf("f 1\\\n2 \\\r\n 3\nv"),
            (Lines{"1 f|1 2   3", "4 v|"}));
  EXPECT_EQ(StatementsOf("f 1 \\"), (Lines{"1 f|1"}));
}

TEST(StatementReader, ABackslashInACommentContinuesNothing) {
  EXPECT_EQ(StatementsOf("# c:\\\nv 1\nv 2 # d:\\\nv 3"),
            (Lines{"2 v|1", "3 v|2", "4 v|3"}));
}

TEST(TakeWord, SplitsAtBlanksAndTabs) {
  std::string_view text = "  a\t\tb c ";
  EXPECT_EQ(TakeWord(text), "a");
  EXPECT_EQ(TakeWord(text), "b");
  EXPECT_EQ(TakeWord(text), "c");
  EXPECT_TRUE(text.empty());
  EXPECT_EQ(TakeWord(text), "");
}

TEST(Quoted, ShortensLongWordsBetweenCharacters) {
  EXPECT_EQ(Quoted("abc"), "'abc'");
  EXPECT_EQ(Quoted(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
  EXPECT_EQ(Quoted(std::string(39, 'x') + "\xC3\xA9y"),
            "'" + std::string(39, 'x') + "...'");
}

TEST(ReadNumbers, CountsSurplusNumbersAndStoresTheFirst) {
  const Numbers numbers = ReadNumbers("1 2\t3 4 5 6 7");
  EXPECT_EQ(numbers.count, 7U);
  EXPECT_EQ(numbers.values[5], 6);
  EXPECT_TRUE(numbers.defect.empty());
}

TEST(ReadNumbers, EndAtAWordThatIsNoNumber) {
  const Numbers numbers = ReadNumbers("1 two 3");
  EXPECT_EQ(numbers.count, 1U);
  EXPECT_EQ(numbers.defect, "two");
}

TEST(NumberDefect, SaysWhatWasMeant) {
  const auto habit = [](const char* word) {
    const NumberDefect defect = DefectOfNumber(word);
    EXPECT_EQ(defect.is_habit, IsHabit(defect.text)) << word;
    return defect.text.substr(0, 12);
  };
  EXPECT_EQ(habit("1,5"), "decimal comm");
  EXPECT_EQ(habit("-1,5e3"), "decimal comm");
  EXPECT_EQ(habit("1.5,"), "commas betwe");
  EXPECT_EQ(habit("1,234.5"), "thousands se");
  EXPECT_EQ(habit("1,234,567"), "thousands se");
  EXPECT_EQ(habit("1e999"), "'1e999' is t");
  EXPECT_EQ(habit("a,b"), "'a,b' is no ");
  EXPECT_EQ(habit("e5"), "'e5' is no n");
  EXPECT_EQ(habit("nan"), "'nan' is no ");
  EXPECT_EQ(DefectOfNumber(std::string(400, '7')).text.find("is too large"),
            46U);
  EXPECT_TRUE(DefectOfCorner("1,001/2").is_habit);
  EXPECT_FALSE(DefectOfCorner("x").is_habit);
}

}  // namespace
}  // namespace truelux
