// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/diagnostics.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/diagnostic_list.h"

namespace truelux {
namespace {

TEST(Diagnostic, TextLeavesOutMissingParts) {
  EXPECT_EQ((Diagnostic{Severity::kError, "a.obj", 3, "bad"}.Text()),
            "a.obj:3: error: bad");
  EXPECT_EQ((Diagnostic{Severity::kNote, "a.obj", 0, "odd"}.Text()),
            "a.obj: note: odd");
  EXPECT_EQ((Diagnostic{Severity::kError, "", 0, "bad"}.Text()), "error: bad");
  EXPECT_EQ((Diagnostic{Severity::kError, "", 7, "bad"}.Text()),
            "line 7: error: bad");
}

TEST(DiagnosticList, SortsByLineWhateverTheOrderOfDiscovery) {
  DiagnosticList list("f");
  list.Error(9, "late");
  list.Note(5, "remark");
  list.Error(2, "early");
  const std::vector<Diagnostic> sorted = list.Sorted();
  ASSERT_EQ(sorted.size(), 3U);
  EXPECT_EQ(sorted[0].Text(), "f:2: error: early");
  EXPECT_EQ(sorted[1].Text(), "f:5: note: remark");
  EXPECT_EQ(sorted[2].Text(), "f:9: error: late");
  EXPECT_TRUE(list.has_errors());
}

TEST(DiagnosticList, NotesAreNoErrors) {
  DiagnosticList list("f");
  list.Note(1, "remark");
  EXPECT_FALSE(list.has_errors());
}

TEST(DiagnosticList, KeepsTheFirstHundredLinesAndCountsTheRest) {
  DiagnosticList list("f");
  for (int line = 1000; line > 0; --line)
    list.Error(line, "bad");
  const std::vector<Diagnostic> sorted = list.Sorted();
  ASSERT_EQ(sorted.size(), 101U);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(sorted[static_cast<std::size_t>(i)].line, i + 1);
  }
  EXPECT_EQ(sorted.back().Text(), "f: error: 900 more errors not shown");
}

TEST(DiagnosticList, ExactlyHundredErrorsNeedNoLastLine) {
  DiagnosticList list("f");
  for (int line = 1; line <= 100; ++line)
    list.Error(line, "bad");
  EXPECT_EQ(list.Sorted().size(), 100U);
}

}  // namespace
}  // namespace truelux
