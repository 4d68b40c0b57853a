// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/view_json.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "inspect/view_measure.h"
#include "text/results.h"

namespace truelux {
namespace {

using Json = nlohmann::ordered_json;

Json JsonOf(const Vector3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json JsonOf(const Point3& p) {
  return Json::array({p.x, p.y, p.z});
}

/// Null for what is not there.
Json IndexOrNull(int index) {
  return index < 0 ? Json(nullptr) : Json(index);
}

Json JsonOf(const SeenEdge& edge) {
  if (edge.face == 0) return nullptr;
  Json json;
  json["face"] = edge.face;
  if (edge.a >= 0) {
    json["vertices"] = {edge.a, edge.b};
  } else {
    json["meets"] = edge.other_face;
  }
  return json;
}

Json JsonOf(const InspectedView& inspected, const SeenSource& source) {
  const Face& face =
      inspected.scene.faces()[static_cast<std::size_t>(source.face - 1)];
  Json json;
  json["face"] = source.face;
  json["line"] = face.line;
  json["group"] =
      inspected.scene.group_names()[static_cast<std::size_t>(face.group)];
  json["Ke"] = face.emission;
  json["form_factor"] = source.form_factor;
  json["solid_angle"] = source.solid_angle;
  json["regions"] = source.regions;
  return json;
}

/// The vertices along a loop, each before the arc of the same index.
Json VerticesAlong(const WholeView& view, int region, const ViewLoop& loop) {
  Json vertices = Json::array();
  for (const int a : loop.arcs) {
    const WholeViewArc& arc = view.arcs[static_cast<std::size_t>(a)];
    const int start = arc.left == region ? arc.from : arc.to;
    if (start >= 0) vertices.push_back(start);
  }
  return vertices;
}

Json JsonOf(const InspectedView& inspected, int region) {
  const ViewRegion& r =
      inspected.view.regions[static_cast<std::size_t>(region)];
  Json json;
  json["kind"] = Name(KindOf(inspected.scene, r));
  json["face"] = r.face == 0 ? Json(nullptr) : Json(r.face);
  json["group"] = nullptr;
  if (r.face > 0) {
    const Face& face =
        inspected.scene.faces()[static_cast<std::size_t>(r.face - 1)];
    json["group"] =
        inspected.scene.group_names()[static_cast<std::size_t>(face.group)];
  }
  json["colour"] = ColourOf(inspected, region);
  json["solid_angle"] =
      SolidAngleOf(BorderOf(inspected.view, region, inspected.frame));
  json["loops"] = Json::array();
  for (const ViewLoop& loop : r.loops) {
    Json own;
    own["vertices"] = VerticesAlong(inspected.view, region, loop);
    own["arcs"] = loop.arcs;
    json["loops"].push_back(std::move(own));
  }
  return json;
}

/// Per channel; null where no share is given.
Json SharesOf(const ArcGradients& gradients, std::size_t arc) {
  Json shares = Json::array();
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const bool is_given = gradients.shares[channel] == GradientShares::kGiven;
    shares.push_back(is_given ? Json(gradients.arcs[arc].share[channel])
                              : Json(nullptr));
  }
  return shares;
}

Json JsonOfArc(const InspectedView& inspected, std::size_t index) {
  const WholeViewArc& arc = inspected.view.arcs[index];
  const ArcGradients& gradients = inspected.arc_gradients;
  Json json;
  json["kind"] = Name(arc.kind);
  json["from"] = IndexOrNull(arc.from);
  json["to"] = IndexOrNull(arc.to);
  json["plane"] = JsonOf(arc.plane_normal);
  json["at_least_pi"] = arc.at_least_pi;
  json["left"] = arc.left;
  json["right"] = IndexOrNull(arc.right);
  json["edge"] = JsonOf(arc.edge);
  json["gradient"] = nullptr;
  json["gradient_share"] = nullptr;
  if (gradients.arcs.empty()) return json;
  json["gradient"] = Json::array();
  for (const Vector3& vector : gradients.arcs[index].vector)
    json["gradient"].push_back(JsonOf(vector));
  json["gradient_share"] = SharesOf(gradients, index);
  return json;
}

Json JsonOf(const InspectedView& inspected, const WholeViewVertex& vertex) {
  const ContourVertex& v = vertex.vertex;
  Json json;
  json["kind"] = Name(v.kind);
  json["conjunctive"] = v.conjunctive;
  json["coinciding_edges"] = v.planes;
  json["with_hidden_edges"] = vertex.planes_with_hidden;
  json["direction"] = JsonOf(v.direction);
  json["scene_vertex"] = IndexOrNull(v.vertex);
  json["position"] = nullptr;
  if (v.vertex >= 0) {
    json["position"] =
        JsonOf(inspected.scene.vertices()[static_cast<std::size_t>(v.vertex)]);
  }
  json["bounds_source"] = vertex.bounds_source;
  json["edges"] = Json::array();
  for (const SeenEdge& edge : vertex.edges)
    json["edges"].push_back(JsonOf(edge));
  return json;
}

/// An array with one element a line: files of this kind are looked at.
void AppendArray(std::string& text, const char* key,
                 const std::vector<Json>& elements, const char* end) {
  text += std::string("  \"") + key + "\": [";
  for (std::size_t i = 0; i < elements.size(); ++i) {
    text += i == 0 ? "\n    " : ",\n    ";
    // Names of groups need not be UTF-8.
    text += elements[i].dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  text += elements.empty() ? "]" : "\n  ]";
  text += end;
}

/// Per channel.
Json ChannelsOf(const Derivatives& derivatives,
                Vector3 ChannelDerivatives::*vector) {
  // There are none where E is discontinuous.
  if (derivatives.smoothness == Smoothness::kDiscontinuous) return nullptr;
  Json channels = Json::array();
  for (const ChannelDerivatives& d : derivatives.channels)
    channels.push_back(JsonOf(d.*vector));
  return channels;
}

Json JsonOf(const Derivatives& derivatives) {
  Json json;
  json["status"] = std::string(Name(derivatives.smoothness));
  json["vector_irradiance"] =
      ChannelsOf(derivatives, &ChannelDerivatives::vector);
  json["gradient"] = ChannelsOf(derivatives, &ChannelDerivatives::gradient);
  json["by_normal"] = ChannelsOf(derivatives, &ChannelDerivatives::normal);
  json["kinks"] = Json::array();
  for (const Kink& kink : derivatives.kinks) {
    Json own;
    own["normal"] = JsonOf(kink.normal);
    own["b"] = kink.size;
    own["faces"] = kink.faces;
    json["kinks"].push_back(std::move(own));
  }
  return json;
}

}  // namespace

std::string ViewJson(const InspectedView& inspected) {
  const auto dump = [](const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  std::string text = "{\n";
  text += "  \"scene\": " + dump(inspected.scene_name) + ",\n";
  Json receiver;
  receiver["position"] = JsonOf(inspected.receiver.position);
  receiver["normal"] = JsonOf(inspected.receiver.normal);
  receiver["on_face"] = inspected.receiver.on_face == 0
                            ? Json(nullptr)
                            : Json(inspected.receiver.on_face);
  text += "  \"receiver\": " + dump(receiver) + ",\n";
  text +=
      "  \"emission\": " + dump(std::string(Name(inspected.emission))) + ",\n";
  text += "  \"irradiance\": " + dump(Json(inspected.irradiance)) + ",\n";
  text += "  \"derivatives\": " + dump(JsonOf(inspected.derivatives)) + ",\n";
  std::vector<Json> elements;
  for (const SeenSource& source : inspected.sources)
    elements.push_back(JsonOf(inspected, source));
  AppendArray(text, "sources", elements, ",\n");
  elements.clear();
  for (std::size_t r = 0; r < inspected.view.regions.size(); ++r)
    elements.push_back(JsonOf(inspected, static_cast<int>(r)));
  AppendArray(text, "regions", elements, ",\n");
  elements.clear();
  for (std::size_t a = 0; a < inspected.view.arcs.size(); ++a)
    elements.push_back(JsonOfArc(inspected, a));
  AppendArray(text, "arcs", elements, ",\n");
  elements.clear();
  for (const WholeViewVertex& vertex : inspected.view.vertices)
    elements.push_back(JsonOf(inspected, vertex));
  AppendArray(text, "vertices", elements, "\n");
  return text + "}\n";
}

}  // namespace truelux
