// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/candidate_report.h"
#include "explain/edge_text.h"
#include "text/results.h"

namespace truelux {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no word for numbers that are not finite.
Json NumberJson(double value) {
  if (std::isfinite(value)) return value;
  std::string text;
  AppendNumber(text, value);
  return text;
}

Json ChannelsJson(const Rgb& values, std::size_t channels) {
  Json json = Json::array();
  for (std::size_t c = 0; c < channels; ++c)
    json.push_back(NumberJson(values[c]));
  return json;
}

Json TripleJson(double x, double y, double z) {
  return Json::array({x, y, z});
}

Json EdgeJson(const Scene& scene, const SeenEdge& edge) {
  Json json;
  json["face"] = edge.face;
  if (edge.a >= 0) {
    Json ends = Json::array();
    for (const int v : {edge.a, edge.b}) {
      const Point3& p = scene.vertices()[static_cast<std::size_t>(v)];
      ends.push_back(TripleJson(p.x, p.y, p.z));
    }
    json["ends"] = std::move(ends);
  } else {
    json["other_face"] = edge.other_face;
  }
  json["text"] = TextOf(scene, edge);
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
    ulps.push_back(
        {{"ulps", UlpHistogram::BinText(i)}, {"receivers", s.ulps.counts[i]}});
  }
  json["ulp_histogram"] = std::move(ulps);
  return json;
}

Json ReasonJson(const Scene& scene, const ReceiverDetail& detail) {
  const ReceiverTraits& t = detail.traits;
  Json json;
  json["text"] = SummaryOf(detail);
  json["lighting"] = Name(t.lighting);
  json["sources"] = t.sources;
  json["arcs"] = t.arcs;
  json["horizon_arcs"] = t.horizon_arcs;
  json["extent"] = t.extent;
  json["width"] = t.width;
  json["shortest_arc"] = t.shortest_arc;
  json["highest"] = t.highest;
  json["lowest"] = t.lowest ? Json(*t.lowest) : Json(nullptr);
  json["cancellation"] = t.cancellation;
  Json conjunctions = Json::array();
  for (const MeetingEdges& meeting : detail.meetings) {
    Json edges = Json::array();
    for (const SeenEdge& edge : meeting.edges)
      edges.push_back(EdgeJson(scene, edge));
    conjunctions.push_back({{"planes", meeting.planes},
                            {"on_horizon", meeting.on_horizon},
                            {"edges", std::move(edges)}});
  }
  json["conjunctions"] = std::move(conjunctions);
  json["near_conjunction"] = nullptr;
  if (detail.nearest) {
    json["near_conjunction"] = {
        {"angle", detail.nearest->angle},
        {"edge", EdgeJson(scene, detail.nearest->edge)}};
  }
  return json;
}

Json WorstJson(const CandidateReport& report, const WorstCandidate& worst) {
  const std::size_t i = worst.receiver;
  const CandidateError& e = report.errors[i];
  const Receiver& r = report.data.receivers[i];
  const std::size_t channels = report.data.channels.size();
  Json json;
  json["line"] = report.data.lines[i];
  json["position"] = TripleJson(r.position.x, r.position.y, r.position.z);
  json["normal"] = TripleJson(r.normal.x, r.normal.y, r.normal.z);
  json["on_face"] = r.on_face;
  json["candidate"] = ChannelsJson(report.data.values[i], channels);
  json["truelux"] = ChannelsJson(report.data.truth[i], channels);
  json["error"] = NumberJson(e.excess);
  json["absolute_error"] = NumberJson(e.error.absolute);
  json["passes"] = e.passes;
  json["reason"] = ReasonJson(report.scene, worst.detail);
  return json;
}

Json FitJson(const MistakeFit& fit) {
  return {{"receivers_disputed", fit.disputed},
          {"median_error_before", NumberJson(fit.median_before)},
          {"median_error_after", NumberJson(fit.median_after)},
          {"passing_before", fit.passing_before},
          {"passing_after", fit.passing_after}};
}

Json DiagnosisJson(const CandidateReport& report) {
  const Diagnosis& d = report.diagnosis;
  Json json;
  json["verdict"] = Name(d.verdict);
  json["mistake"] = d.mistake.empty() ? Json(nullptr) : Json(d.mistake);
  json["text"] = d.text;
  json["factor"] = d.factor ? Json(*d.factor) : Json(nullptr);
  json["fit"] = d.fit ? FitJson(*d.fit) : Json(nullptr);
  json["equally_explained"] = d.equally;
  json["noise"] = nullptr;
  if (d.noise) {
    json["noise"] = {{"receivers", d.noise->receivers},
                     {"size", NumberJson(d.noise->size)},
                     {"signed_mean", NumberJson(d.noise->bias)},
                     {"standard_error", NumberJson(d.noise->standard_error)},
                     {"looks_unbiased", d.noise->looks_unbiased}};
  }
  json["receivers_tried"] = d.receivers;
  json["mistakes_tried"] = d.tried;
  json["notes"] = d.notes;
  Json classes = Json::array();
  for (const FailureClass& c : FailureClasses(report.classified)) {
    classes.push_back({{"class", c.name},
                       {"receivers", c.receivers},
                       {"failing", c.failing}});
  }
  json["classes"] = std::move(classes);
  return json;
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
  json["diagnosis"] = DiagnosisJson(report);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace truelux
