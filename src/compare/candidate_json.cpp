// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/candidate_report.h"
#include "compare/report_json.h"

namespace truelux {
namespace {

Json ChannelsJson(const Rgb& values, std::size_t channels) {
  Json json = Json::array();
  for (std::size_t c = 0; c < channels; ++c)
    json.push_back(NumberJson(values[c]));
  return json;
}

Json SummaryJson(const CandidateSummary& s) {
  Json json;
  json["receivers"] = s.receivers;
  json["failing"] = s.failing();
  json["lit"] = {
      {"receivers", s.lit}, {"exact", s.lit_exact}, {"failing", s.lit_failing}};
  json["dark"] = {{"receivers", s.dark},
                  {"exact", s.dark_exact},
                  {"failing", s.dark_failing},
                  {"max_absolute", NumberJson(s.max_dark_absolute)}};
  json["not_a_number"] = s.no_number;
  json["relative_error"] = nullptr;
  if (s.relative) {
    const CandidateSummary::Relative& r = *s.relative;
    json["relative_error"] = {{"rms", NumberJson(r.rms)},
                              {"mean", NumberJson(r.mean)},
                              {"signed_mean", NumberJson(r.bias)},
                              {"p50", NumberJson(r.median)},
                              {"p95", NumberJson(r.percentile_95)},
                              {"p99", NumberJson(r.percentile_99)},
                              {"p100", NumberJson(r.max)}};
  }
  json["max_absolute_error"] = NumberJson(s.max_absolute);
  Json ulps = Json::array();
  for (std::size_t i = 0; i < s.ulps.counts.size(); ++i) {
    ulps.push_back({{"ulps", UlpBinText(i)}, {"receivers", s.ulps.counts[i]}});
  }
  json["ulp_histogram"] = std::move(ulps);
  return json;
}

Json WorstJson(const CandidateReport& report, const WorstCandidate& worst) {
  const std::size_t i = worst.receiver;
  const CandidateError& e = report.errors[i];
  const std::size_t channels = report.data.channels.size();
  Json json = PlaceJson(report.data, i);
  json["candidate"] = ChannelsJson(report.data.values[i], channels);
  json["truelux"] = ChannelsJson(report.data.truth[i], channels);
  json["error"] = NumberJson(e.excess);
  json["absolute_error"] = NumberJson(e.error.absolute);
  json["passes"] = e.passes;
  json["reason"] = ReasonJson(report.scene, worst.detail);
  return json;
}

Json ClassesJson(const CandidateReport& report) {
  Json classes = Json::array();
  for (const FailureClass& c : FailureClasses(report.classified)) {
    classes.push_back({{"class", c.name},
                       {"receivers", c.receivers},
                       {"failing", c.failing}});
  }
  return classes;
}

}  // namespace

std::string CandidateJson(const CandidateReport& report,
                          std::string_view version) {
  Json json;
  json["version"] = version;
  json["scene"] = report.scene_name;
  json["candidate"] = report.candidate_name;
  json["quantity"] = Name(report.options.quantity);
  json["emission"] = Name(report.options.emission);
  json["columns"] = report.data.value_names;
  json["tolerance"] = report.tolerance;
  json["passes"] = report.passes();
  json["summary"] = SummaryJson(report.summary);
  json["worst"] = Json::array();
  for (const WorstCandidate& worst : report.worst)
    json["worst"].push_back(WorstJson(report, worst));
  json["diagnosis"] = DiagnosisJson(report.diagnosis);
  json["diagnosis"]["classes"] = ClassesJson(report);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace truelux
