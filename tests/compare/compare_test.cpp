// SPDX-License-Identifier: GPL-3.0-or-later
// The public functions, which compare arrays.
#include "truelux/compare.h"

#include <atomic>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"
#include "truelux/irradiance.h"
#include "truelux/stop.h"

#include "compare/stages.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// What truelux finds on a stage, each value times `factor`.
Candidate TruthOf(const Stage& stage, double factor = 1) {
  Candidate candidate;
  candidate.receivers = stage.receivers;
  for (const Irradiance& e : Oracle(stage.scene).Evaluate(stage.receivers)) {
    candidate.values.push_back(
        {factor * e.value[0], factor * e.value[1], factor * e.value[2]});
  }
  return candidate;
}

TEST(Compare, TheTruthPasses) {
  const Stage stage = AcrossTheHorizon();
  const Candidate candidate = TruthOf(stage);
  const CandidateComparison found = Compare(stage.scene, candidate, {});
  EXPECT_TRUE(found.passes());
  EXPECT_EQ(found.truth, candidate.values);
  EXPECT_EQ(found.errors.size(), stage.receivers.size());
  EXPECT_TRUE(found.worst.empty());
}

TEST(Compare, SaysWhatTheReportsSay) {
  const Stage stage = AcrossTheHorizon();
  const CandidateComparison found =
      Compare(stage.scene, TruthOf(stage, 2),
              {.tolerance = 1e-6, .threads = 2, .candidate_name = "mine"});
  EXPECT_FALSE(found.passes());
  EXPECT_EQ(found.diagnosis.factor, 2);
  ASSERT_EQ(found.worst.size(), 10U);
  EXPECT_NE(found.worst[0].reason, "");
  for (const std::string* report : {&found.text, &found.json}) {
    EXPECT_NE(report->find("mine"), report->npos);
    EXPECT_NE(report->find(found.worst[0].reason), report->npos);
    EXPECT_EQ(report->find("line"), report->npos) << *report;
  }
}

TEST(Compare, TakesSomeChannelsInAnyOrder) {
  const Stage stage = AcrossTheHorizon();
  Candidate candidate = TruthOf(stage);
  const std::vector<Rgb> truth = candidate.values;
  candidate.channels = {2, 0};
  for (Rgb& value : candidate.values)
    value[1] = std::numeric_limits<double>::quiet_NaN();
  const CandidateComparison found = Compare(stage.scene, candidate, {});
  EXPECT_TRUE(found.passes()) << found.text;
  for (std::size_t i = 0; i < truth.size(); ++i)
    EXPECT_EQ(found.truth[i], (Rgb{truth[i][0], 0, truth[i][2]}));
}

TEST(Compare, TakesFormFactorsFromTheFirstChannel) {
  const Stage stage = AcrossTheHorizon();
  const Oracle oracle(stage.scene);
  Candidate candidate;
  candidate.has_form_factors = true;
  for (const Receiver& receiver : stage.receivers) {
    double sum = 0;
    for (const auto& face : oracle.FormFactors(receiver).faces)
      sum += face.value;
    candidate.receivers.push_back(receiver);
    candidate.values.push_back({sum, -1, -1});
  }
  const CandidateComparison found =
      Compare(stage.scene, candidate, {.tolerance = 1e-14});
  EXPECT_TRUE(found.passes()) << found.text;
  EXPECT_GT(found.summary.lit, 0U);
}

TEST(CompareGradients, FindsASign) {
  const Stage stage = AcrossTheHorizon();
  const Oracle oracle(stage.scene);
  GradientCandidate candidate;
  for (const Receiver& receiver : stage.receivers) {
    const Derivatives derivatives = oracle.Derivatives(receiver);
    GradientRow row;
    for (std::size_t c = 0; c < 3; ++c)
      row[c] = derivatives.channels[c].gradient;
    candidate.receivers.push_back(receiver);
    candidate.values.push_back(row);
  }
  const GradientComparison right = CompareGradients(stage.scene, candidate, {});
  EXPECT_TRUE(right.passes()) << right.text;
  EXPECT_EQ(right.truth.size(), candidate.values.size());
  EXPECT_EQ(right.truth[0].gradient, candidate.values[0]);
  for (GradientRow& row : candidate.values) {
    for (Vector3& g : row)
      g = {-g.x, -g.y, -g.z};
  }
  const GradientComparison wrong =
      CompareGradients(stage.scene, candidate, {.tolerance = 1e-6});
  EXPECT_FALSE(wrong.passes());
  EXPECT_EQ(wrong.diagnosis.factor, -1);
  EXPECT_FALSE(wrong.worst.empty());
}

TEST(Compare, RefusesWhatDoesNotFit) {
  const Stage stage = AcrossTheHorizon();
  const Candidate good = TruthOf(stage);
  const auto defect = [&](const Candidate& candidate,
                          const CompareOptions& options) -> std::string {
    try {
      (void)Compare(stage.scene, candidate, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(defect(good, {}), "");
  EXPECT_EQ(defect({}, {}), "receivers: there is none");
  Candidate bad = good;
  bad.values.pop_back();
  EXPECT_EQ(defect(bad, {}), "values: expected one per receiver");
  for (const ChannelNumbers& channels :
       {ChannelNumbers{}, ChannelNumbers{3}, ChannelNumbers{1, 1}}) {
    bad = good;
    bad.channels = channels;
    EXPECT_EQ(defect(bad, {}).substr(0, 9), "channels:");
  }
  EXPECT_EQ(defect(good, {.tolerance = -1}), "tolerance: expected 0 or more");
  EXPECT_EQ(defect(good, {.threads = 0}), "threads: expected 1 to 1024");
  bad = good;
  bad.receivers[1].normal = {0, 0, 0};
  EXPECT_THROW((void)Compare(stage.scene, bad, {}), ReceiverError);
}

TEST(Compare, TellsHowFarItIsAndStops) {
  const Stage stage = AcrossTheHorizon();
  const Candidate candidate = TruthOf(stage, 2);
  StopFlag stop = false;
  CompareOptions options;
  options.threads = 2;
  options.stop = &stop;
  std::uint64_t most = 0;
  options.progress = [&](const ProgressState& state) {
    EXPECT_LE(state.done, state.total);
    EXPECT_EQ(state.things, "receivers");
    most = std::max(most, state.done);
  };
  (void)Compare(stage.scene, candidate, options);
  EXPECT_EQ(most, candidate.receivers.size());
  stop = true;
  EXPECT_THROW((void)Compare(stage.scene, candidate, options), Stopped);
}

}  // namespace
}  // namespace truelux
