// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/receiver_detail.h"

#include <algorithm>
#include <fmt/format.h>

#include "explain/edge_text.h"
#include "text/number_text.h"
#include "visibility/on_horizon.h"

namespace truelux {
namespace {

bool IsNear(const ReceiverDetail& detail) {
  return detail.nearest && detail.nearest->angle < kNearConjunction;
}

/// So many edges of one vertex are written out.
constexpr std::size_t kMostEdges = 6;

std::string MeetingText(const Scene& scene, const MeetingEdges& meeting) {
  std::vector<std::string> texts;
  for (const SeenEdge& edge : meeting.edges) {
    if (texts.size() == kMostEdges) {
      texts.push_back(
          fmt::format("{} more", meeting.edges.size() - kMostEdges));
      break;
    }
    texts.push_back(TextOf(scene, edge));
  }
  if (meeting.on_horizon) texts.emplace_back("the horizon");
  return fmt::format("meet: {}", fmt::join(texts, "; "));
}

}  // namespace

ReceiverDetail DetailOf(const Scene& scene, const Receiver& receiver,
                        const ContourInDetail& contour) {
  ReceiverDetail detail;
  detail.traits = TraitsOf(scene, receiver, contour.contour);
  for (std::size_t i = 0; i < contour.edges.size(); ++i) {
    const ContourVertex& vertex = contour.contour.vertices[i];
    const VertexEdges& edges = contour.edges[i];
    if (vertex.conjunctive) {
      detail.meetings.push_back(
          {vertex.planes, IsOnHorizon(scene, receiver, vertex), edges.through});
    }
    if (!edges.nearest) continue;
    if (detail.nearest && detail.nearest->angle <= edges.nearest_angle)
      continue;
    detail.nearest = NearConjunction{*edges.nearest, edges.nearest_angle};
  }
  return detail;
}

std::string SummaryOf(const ReceiverDetail& detail) {
  std::string text = TextOf(detail.traits);
  if (!IsNear(detail)) return text;
  text += text.find(';') == std::string::npos ? "; " : ", ";
  return text + fmt::format("near-conjunction ({} rad)",
                            ScientificText(detail.nearest->angle, 0));
}

std::vector<std::string> LinesOf(const Scene& scene,
                                 const ReceiverDetail& detail,
                                 std::size_t most) {
  std::vector<std::string> lines;
  for (const MeetingEdges& meeting : detail.meetings) {
    if (lines.size() == most) {
      lines.push_back(fmt::format("and at {} more vertices",
                                  detail.meetings.size() - most));
      break;
    }
    lines.push_back(MeetingText(scene, meeting));
  }
  if (IsNear(detail)) {
    lines.push_back(fmt::format("{} rad beside a vertex: {}",
                                ScientificText(detail.nearest->angle, 1),
                                TextOf(scene, detail.nearest->edge)));
  }
  return lines;
}

ReceiverDetail DetailFinder::Find(const Receiver& receiver,
                                  bool in_detail) const {
  const ContourQuery query{engine_.scene(), receiver};
  const Contour contour = engine_.Build(query);
  if (in_detail) {
    return DetailOf(engine_.scene(), receiver,
                    DescribeInDetail(query, contour));
  }
  return DetailOf(engine_.scene(), receiver,
                  {DescribeContour(query, contour), {}});
}

}  // namespace truelux
