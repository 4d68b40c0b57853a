// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/compare.h"

#include <fmt/format.h>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

#include "truelux/version.h"

#include "base/visible_text.h"
#include "compare/candidate_errors.h"
#include "compare/candidate_report.h"
#include "compare/candidates.h"
#include "compare/compare_run.h"
#include "compare/gradients/compare_gradients.h"
#include "compare/gradients/gradient_data.h"
#include "compare/gradients/gradient_report.h"
#include "explain/receiver_detail.h"
#include "run/parallel.h"

namespace truelux {
namespace {

void Check(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(message);
}

CompareSettings SettingsOf(const CompareOptions& options, Quantity quantity) {
  Check(options.tolerance >= 0, "tolerance: expected 0 or more");
  CheckThreads(options.threads);
  return {.truth = {.quantity = quantity, .emission = options.emission},
          .tolerance = options.tolerance,
          .threads = options.threads,
          .watch = {.stop = options.stop, .hook = options.progress}};
}

/// Checks what does not depend on the scene. prefix: of the values' names.
CandidateReceivers ReceiversOf(const std::vector<Receiver>& receivers,
                               std::size_t values, ChannelNumbers channels,
                               const char* prefix) {
  Check(!receivers.empty(), "receivers: there is none");
  Check(receivers.size() == values, "values: expected one per receiver");
  Check(!channels.empty(), "channels: there is none");
  unsigned int seen = 0;
  CandidateReceivers candidate;
  for (const std::size_t channel : channels) {
    Check(channel < 3 && (seen & 1U << channel) == 0,
          "channels: expected some of 0, 1 and 2, each once");
    seen |= 1U << channel;
    candidate.value_names.push_back(
        fmt::format("{}_{}", prefix, ChannelName(channel)));
  }
  candidate.channels = std::move(channels);
  candidate.receivers = receivers;
  candidate.place = "receiver";
  candidate.lines.resize(receivers.size());
  std::iota(candidate.lines.begin(), candidate.lines.end(), 0);
  return candidate;
}

/// Names the report, and fills in all but truth and texts.
template <class Report, class Result>
void FillIn(Report& report, const CompareOptions& options, Result& result) {
  report.scene_name = Visible(options.scene_name);
  report.candidate_name = Visible(options.candidate_name);
  for (const auto& worst : report.worst)
    result.worst.push_back({worst.receiver, SummaryOf(worst.detail)});
  result.errors = report.errors;
  result.summary = report.summary;
  result.diagnosis = report.diagnosis;
}

}  // namespace

CandidateComparison Compare(const Scene& scene, const Candidate& candidate,
                            const CompareOptions& options) {
  const bool factors = candidate.has_form_factors;
  CandidateData data;
  static_cast<CandidateReceivers&>(data) =
      ReceiversOf(candidate.receivers, candidate.values.size(),
                  factors ? ChannelNumbers{0} : candidate.channels, "E");
  if (factors) data.value_names = {"F"};
  for (const Rgb& value : candidate.values)
    data.values.push_back(data.Compared(value));
  CandidateReport report =
      CompareCandidate(scene, std::move(data),
                       SettingsOf(options, factors ? Quantity::kFormFactor
                                                   : Quantity::kIrradiance));
  CandidateComparison result;
  FillIn(report, options, result);
  result.text = CandidateText(report);
  result.json = CandidateJson(report, VersionText());
  for (const Rgb& compared : report.data.truth) {
    result.truth.push_back(
        SpreadChannels<double>(report.data.channels, compared));
  }
  return result;
}

GradientComparison CompareGradients(const Scene& scene,
                                    const GradientCandidate& candidate,
                                    const CompareOptions& options) {
  GradientData data;
  static_cast<CandidateReceivers&>(data) = ReceiversOf(
      candidate.receivers, candidate.values.size(), candidate.channels, "grad");
  for (const GradientRow& value : candidate.values)
    data.values.push_back(PickChannels<Vector3>(data.channels, value));
  GradientReport report = CompareGradientData(
      scene, std::move(data), SettingsOf(options, Quantity::kGradient));
  GradientComparison result;
  FillIn(report, options, result);
  result.text = GradientText(report);
  result.json = GradientJson(report, VersionText());
  for (const GradientTruth& compared : report.data.truth) {
    result.truth.push_back(
        {compared.smoothness,
         SpreadChannels<Vector3>(report.data.channels, compared.gradient)});
  }
  return result;
}

}  // namespace truelux
