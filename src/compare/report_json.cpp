// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report_json.h"

#include <cmath>
#include <string>
#include <utility>

#include "explain/edge_text.h"
#include "text/results.h"

namespace truelux {
namespace {

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

Json FitJson(const MistakeFit& fit) {
  return {{"receivers_disputed", fit.disputed},
          {"median_error_before", NumberJson(fit.median_before)},
          {"median_error_after", NumberJson(fit.median_after)},
          {"passing_before", fit.passing_before},
          {"passing_after", fit.passing_after}};
}

}  // namespace

Json NumberJson(double value) {
  if (std::isfinite(value)) return value;
  std::string text;
  AppendNumber(text, value);
  return text;
}

Json TripleJson(double x, double y, double z) {
  return Json::array({x, y, z});
}

Json PlaceJson(const CandidateReceivers& candidate, std::size_t receiver) {
  const Receiver& r = candidate.receivers[receiver];
  Json json;
  json[candidate.place] = candidate.lines[receiver];
  json["position"] = TripleJson(r.position.x, r.position.y, r.position.z);
  json["normal"] = TripleJson(r.normal.x, r.normal.y, r.normal.z);
  json["on_face"] = r.on_face;
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

Json DiagnosisJson(const Diagnosis& d) {
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
  return json;
}

}  // namespace truelux
