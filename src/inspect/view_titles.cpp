// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/view_titles.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <vector>

#include "explain/edge_text.h"

namespace truelux {
namespace {

std::string TextOfRegion(const InspectedView& inspected, int region) {
  return region < 0
             ? "below the horizon"
             : TitleOfRegion(inspected, static_cast<std::size_t>(region));
}

constexpr std::array kChannels = {"r", "g", "b"};

/// "34.5 %", or why there is none.
std::string ShareTextOf(const ArcGradients& gradients, std::size_t arc,
                        std::size_t channel) {
  switch (gradients.shares[channel]) {
    case GradientShares::kNoGradient:
      return "no share (the arcs cancel)";
    case GradientShares::kDoNotAddUp:
      return "no share (the arcs do not add up to it)";
    case GradientShares::kKink:
    case GradientShares::kDiscontinuous:
    case GradientShares::kGiven:
      break;
  }
  return fmt::format("{:.3g} %", 100 * gradients.arcs[arc].share[channel]);
}

/// A line on what an arc carries of the gradient: its share in each channel,
/// once if they look the same, and its length.
std::string GradientTextOf(const InspectedView& inspected, std::size_t arc) {
  const ArcGradients& gradients = inspected.arc_gradients;
  if (inspected.view.arcs[arc].kind == ViewArcKind::kHorizon)
    return "carries no gradient: the horizon moves with the receiver";
  if (gradients.arcs.empty()) {
    return gradients.shares[0] == GradientShares::kKink
               ? "no share of the gradient: E has a kink here"
               : "no share of the gradient: E is discontinuous here";
  }
  std::vector<std::string> shares;
  std::vector<std::string> lengths;
  std::vector<std::string> both;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double length = gradients.LengthOf(arc, channel);
    if (length == 0) continue;
    const char* name = kChannels[channel];
    shares.push_back(ShareTextOf(gradients, arc, channel));
    lengths.push_back(fmt::format("{} {:.3g}", name, length));
    both.push_back(
        fmt::format("{} {}, {:.3g} W/m^3", name, shares.back(), length));
  }
  if (shares.empty()) return "carries no gradient";
  if (std::ranges::count(shares, shares.front()) == std::ssize(shares)) {
    return fmt::format("{} of dE/dr: {} W/m^3", shares.front(),
                       fmt::join(lengths, ", "));
  }
  return fmt::format("of dE/dr: {}", fmt::join(both, "; "));
}

}  // namespace

std::string DigitsOf(const Vector3& v) {
  return fmt::format("({:.17g}, {:.17g}, {:.17g})", v.x, v.y, v.z);
}

std::string TitleOfRegion(const InspectedView& inspected, std::size_t region) {
  const ViewRegion& r = inspected.view.regions[region];
  const RegionKind kind = KindOf(inspected.scene, r);
  if (kind == RegionKind::kNothing) return Name(kind);
  return fmt::format(
      "{} {}", kind == RegionKind::kBack ? "back of emitting" : Name(kind),
      TextOfFace(inspected.scene, r.face));
}

std::string TitleOfArc(const InspectedView& inspected, std::size_t arc) {
  const WholeViewArc& a = inspected.view.arcs[arc];
  std::string text = Name(a.kind);
  if (a.edge.face > 0) text += ": " + TextOf(inspected.scene, a.edge);
  text += "\nbetween " + TextOfRegion(inspected, a.left);
  text += "\nand " + TextOfRegion(inspected, a.right);
  text += "\nin the plane " + DigitsOf(a.plane_normal);
  return text + "\n" + GradientTextOf(inspected, arc);
}

std::string TitleOfVectorIrradiance(const InspectedView& inspected) {
  std::string text = "vector irradiance V [W/m^2]";
  for (std::size_t channel = 0; channel < 3; ++channel) {
    text +=
        fmt::format("\n{} {}", kChannels[channel],
                    DigitsOf(inspected.derivatives.channels[channel].vector));
  }
  return text;
}

std::string TitleOfVertex(const InspectedView& inspected, std::size_t vertex) {
  constexpr std::size_t kMostEdges = 10;
  const WholeViewVertex& v = inspected.view.vertices[vertex];
  std::string text = fmt::format("{}{} vertex, {} {}",
                                 v.vertex.conjunctive ? "conjunctive, " : "",
                                 Name(v.vertex.kind), v.vertex.planes,
                                 v.vertex.planes == 1 ? "edge" : "edges");
  if (v.planes_with_hidden > v.vertex.planes) {
    text += fmt::format(" ({} with those hidden behind)", v.planes_with_hidden);
  }
  text += "\ndirection " + DigitsOf(v.vertex.direction);
  if (v.vertex.vertex >= 0) {
    const Point3& p =
        inspected.scene.vertices()[static_cast<std::size_t>(v.vertex.vertex)];
    text += "\nat " + DigitsOf({p.x, p.y, p.z});
  }
  for (std::size_t e = 0; e < v.edges.size(); ++e) {
    if (e == kMostEdges) {
      return text + fmt::format("\nand {} more", v.edges.size() - e);
    }
    text += "\n" + TextOf(inspected.scene, v.edges[e]);
  }
  return text;
}

}  // namespace truelux
