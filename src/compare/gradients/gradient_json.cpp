// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>

#include "base/vector_math.h"
#include "compare/gradients/gradient_report.h"
#include "compare/report_json.h"

namespace truelux {
namespace {

/// The components of all compared channels, one after the other.
Json RowJson(const GradientRow& row, std::size_t channels) {
  Json json = Json::array();
  for (std::size_t c = 0; c < channels; ++c) {
    for (const double component : {row[c].x, row[c].y, row[c].z})
      json.push_back(NumberJson(component));
  }
  return json;
}

Json QuantilesJson(
    const std::optional<GradientErrorSummary::Quantiles>& quantiles) {
  if (!quantiles) return nullptr;
  return {{"p50", NumberJson(quantiles->median)},
          {"p95", NumberJson(quantiles->percentile_95)},
          {"p99", NumberJson(quantiles->percentile_99)},
          {"p100", NumberJson(quantiles->max)}};
}

Json SummaryJson(const GradientErrorSummary& s) {
  Json json;
  json["receivers"] = s.receivers;
  json["failing"] = s.failing();
  json["sloping"] = {{"receivers", s.sloping},
                     {"exact", s.sloping_exact},
                     {"failing", s.sloping_failing}};
  json["flat"] = {{"receivers", s.flat},
                  {"exact", s.flat_exact},
                  {"failing", s.flat_failing},
                  {"max_absolute", NumberJson(s.max_flat_absolute)}};
  json["kinks"] = s.kinks;
  json["discontinuous"] = s.discontinuous;
  json["not_a_number"] = s.no_number;
  json["relative_error"] = QuantilesJson(s.relative);
  json["angle"] = QuantilesJson(s.angle);
  json["lengthening"] = QuantilesJson(s.lengthening);
  json["mean_lengthening"] = NumberJson(s.mean_lengthening);
  json["max_absolute_error"] = NumberJson(s.max_absolute);
  return json;
}

Json KinkJson(const Kink& kink) {
  const Vector3& m = kink.normal;
  return {
      {"normal", TripleJson(m.x, m.y, m.z)},
      {"size", Json::array({NumberJson(kink.size[0]), NumberJson(kink.size[1]),
                            NumberJson(kink.size[2])})},
      {"faces", kink.faces}};
}

Json WorstJson(const GradientReport& report, const WorstGradient& worst) {
  const std::size_t i = worst.receiver;
  const GradientError& e = report.errors[i];
  const std::size_t channels = report.data.channels.size();
  Json json = PlaceJson(report.data, i);
  json["candidate"] = RowJson(report.data.values[i], channels);
  json["truelux"] = RowJson(report.data.truth[i].gradient, channels);
  json["error"] = NumberJson(e.excess);
  json["absolute_error"] = NumberJson(e.absolute);
  json["angle"] = NumberJson(e.angle);
  json["lengthening"] = NumberJson(e.lengthening);
  json["passes"] = e.passes;
  json["kinks"] = Json::array();
  for (const Kink& kink : worst.kinks)
    json["kinks"].push_back(KinkJson(kink));
  json["reason"] = ReasonJson(report.scene, worst.detail);
  return json;
}

}  // namespace

std::string GradientJson(const GradientReport& report,
                         std::string_view version) {
  Json json;
  json["version"] = version;
  json["scene"] = report.scene_name;
  json["candidate"] = report.candidate_name;
  json["quantity"] = "gradient";
  json["emission"] = Name(report.emission);
  json["columns"] = report.data.value_names;
  json["tolerance"] = report.tolerance;
  json["passes"] = report.passes();
  json["summary"] = SummaryJson(report.summary);
  json["worst"] = Json::array();
  for (const WorstGradient& worst : report.worst)
    json["worst"].push_back(WorstJson(report, worst));
  json["diagnosis"] = DiagnosisJson(report.diagnosis);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace truelux
