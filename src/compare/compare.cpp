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
  Check(options.threads >= 1 && options.threads <= kMaxThreads,
        "threads: expected 1 to 1024");
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

/// The names, the worst receivers, and the texts: what reports of both kinds
/// bring along.
template <class Report, class Result>
void FillIn(Report& report, const CompareOptions& options, Result& result) {
  report.scene_name = Visible(options.scene_name);
  report.candidate_name = Visible(options.candidate_name);
  for (const auto& worst : report.worst)
    result.worst.push_back({worst.receiver, SummaryOf(worst.detail)});
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
  result.truth.resize(report.data.truth.size());
  for (std::size_t i = 0; i < result.truth.size(); ++i) {
    for (std::size_t c = 0; c < report.data.channels.size(); ++c)
      result.truth[i][report.data.channels[c]] = report.data.truth[i][c];
  }
  result.errors = std::move(report.errors);
  result.summary = report.summary;
  result.diagnosis = std::move(report.diagnosis);
  return result;
}

GradientComparison CompareGradients(const Scene& scene,
                                    const GradientCandidate& candidate,
                                    const CompareOptions& options) {
  GradientData data;
  static_cast<CandidateReceivers&>(data) = ReceiversOf(
      candidate.receivers, candidate.values.size(), candidate.channels, "grad");
  for (const GradientRow& value : candidate.values) {
    GradientRow compared{};
    for (std::size_t c = 0; c < data.channels.size(); ++c)
      compared[c] = value[data.channels[c]];
    data.values.push_back(compared);
  }
  GradientReport report = CompareGradientData(
      scene, std::move(data), SettingsOf(options, Quantity::kGradient));
  GradientComparison result;
  FillIn(report, options, result);
  result.text = GradientText(report);
  result.json = GradientJson(report, VersionText());
  result.truth.resize(report.data.truth.size());
  for (std::size_t i = 0; i < result.truth.size(); ++i) {
    const GradientTruth& compared = report.data.truth[i];
    result.truth[i].smoothness = compared.smoothness;
    for (std::size_t c = 0; c < report.data.channels.size(); ++c)
      result.truth[i].gradient[report.data.channels[c]] = compared.gradient[c];
  }
  result.errors = std::move(report.errors);
  result.summary = report.summary;
  result.diagnosis = std::move(report.diagnosis);
  return result;
}

}  // namespace truelux
