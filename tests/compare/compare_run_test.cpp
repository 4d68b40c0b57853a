// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/compare_run.h"

#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "compare/stages.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// What truelux finds on a stage, each value times `factor`.
CandidateData Candidate(const Stage& stage, double factor = 1) {
  CandidateData data;
  data.value_names = {"E_r", "E_g", "E_b"};
  data.channels = {0, 1, 2};
  data.receivers = stage.receivers;
  data.lines.resize(stage.receivers.size());
  for (const Irradiance& e : Oracle(stage.scene).Evaluate(stage.receivers)) {
    Rgb value = e.value;
    for (double& channel : value)
      channel *= factor;
    data.values.push_back(value);
  }
  return data;
}

TEST(CompareRun, OfARightCandidateEverythingIsExactAndNothingIsLookedInto) {
  const Stage stage = AcrossTheHorizon();
  const CandidateReport report =
      CompareCandidate(stage.scene, Candidate(stage), {});
  EXPECT_TRUE(report.passes());
  EXPECT_EQ(report.data.truth, report.data.values);
  EXPECT_EQ(report.summary.lit_exact, report.summary.lit);
  EXPECT_GT(report.summary.lit, 0U);
  EXPECT_TRUE(report.worst.empty());
  EXPECT_EQ(report.diagnosis.verdict, Verdict::kNothingFails);
  EXPECT_TRUE(report.diagnosis.tried.empty());
}

TEST(CompareRun, NamesTheWorstReceiversAndTheMistakeOnAnyNumberOfThreads) {
  const Stage stage = AcrossTheHorizon();
  for (const int threads : {1, 3}) {
    const CandidateReport report =
        CompareCandidate(stage.scene, Candidate(stage, 2),
                         {.tolerance = 1e-6, .threads = threads});
    EXPECT_FALSE(report.passes());
    EXPECT_EQ(report.worst.size(), kMostWorstCandidates);
    for (const WorstCandidate& worst : report.worst)
      EXPECT_FALSE(report.errors[worst.receiver].passes);
    EXPECT_EQ(report.diagnosis.verdict, Verdict::kMistake);
    EXPECT_EQ(report.diagnosis.factor, 2);
    EXPECT_TRUE(report.classified.empty());
  }
}

TEST(CompareRun, ClassifiesReceiversWhereNothingExplainsTheFailures) {
  const Stage stage = AcrossTheHorizon();
  CandidateData data = Candidate(stage);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < data.values.size(); i += 3, ++wrong)
    data.values[i] = {7, 8, 9};
  const CandidateReport report =
      CompareCandidate(stage.scene, std::move(data), {.tolerance = 1e-6});
  EXPECT_EQ(report.summary.failing(), wrong);
  EXPECT_EQ(report.diagnosis.verdict, Verdict::kUnexplained);
  EXPECT_FALSE(report.classified.empty());
}

TEST(CompareRun, FormFactorsAreThoseOfUnitExitances) {
  // Exitances differ between the lamps, so that E is no multiple of F.
  const Stage stage = AcrossTheHorizon();
  CandidateData data = Candidate(stage);
  data.value_names = {"F"};
  data.channels = {0};
  const CandidateReport report = CompareCandidate(
      stage.scene, std::move(data),
      {.truth = {.quantity = Quantity::kFormFactor}, .tolerance = 1e-6});
  EXPECT_FALSE(report.passes());
  for (const Face& face : report.scene.faces())
    EXPECT_EQ(face.emission, (Rgb{1, 1, 1}));
}

}  // namespace
}  // namespace truelux
