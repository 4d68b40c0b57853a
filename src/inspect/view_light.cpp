// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/view_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "base/vector_math.h"
#include "inspect/view_measure.h"
#include "inspect/view_style.h"
#include "inspect/view_titles.h"

namespace truelux {
namespace {

constexpr std::array kChannelColours = {"#b00020", "#00701a", "#0040c0"};
constexpr const char* kCommonColour = "#000000";

/// An arrow in the picture.
struct Arrow {
  PicturePoint tip;
  const char* colour;
};

/// Nothing if V is 0 or points out of the picture.
std::optional<PicturePoint> TipOf(const InspectedView& inspected,
                                  const ProjectedDisc& disc,
                                  std::size_t channel) {
  const Vector3& v = inspected.derivatives.channels[channel].vector;
  if (v.x == 0 && v.y == 0 && v.z == 0) return std::nullopt;
  return disc.PointOf(InFrame(UnitOf(v), inspected.frame));
}

std::vector<Arrow> ArrowsOf(const InspectedView& inspected,
                            const ProjectedDisc& disc) {
  constexpr double kSame = 1;
  std::vector<Arrow> arrows;
  bool are_same = true;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto tip = TipOf(inspected, disc, channel);
    if (!tip) continue;
    arrows.push_back({*tip, kChannelColours[channel]});
    const PicturePoint& first = arrows.front().tip;
    are_same =
        are_same && std::hypot(tip->x - first.x, tip->y - first.y) < kSame;
  }
  if (!arrows.empty() && are_same) arrows = {{arrows[0].tip, kCommonColour}};
  return arrows;
}

/// A line with a head; of a short one only a dot at the tip.
std::string SvgArrow(const PicturePoint& from, const Arrow& arrow) {
  constexpr double kHead = 13;
  constexpr double kHalfWidth = 4.5;
  const double x = arrow.tip.x - from.x;
  const double y = arrow.tip.y - from.y;
  const double length = std::hypot(x, y);
  if (length < kHead) {
    return fmt::format(
        "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\"/>\n",
        arrow.tip.x, arrow.tip.y, kHalfWidth, arrow.colour);
  }
  const double ux = x / length;
  const double uy = y / length;
  const PicturePoint neck = {arrow.tip.x - kHead * ux,
                             arrow.tip.y - kHead * uy};
  return fmt::format(
      "<path stroke=\"{0}\" stroke-width=\"2\""
      " d=\"M{1:.2f} {2:.2f}L{3:.2f} {4:.2f}\"/>\n"
      "<path d=\"M{5:.2f} {6:.2f}L{7:.2f} {8:.2f}L{9:.2f} "
      "{10:.2f}Z\" fill=\"{0}\"/>\n",
      arrow.colour, from.x, from.y, neck.x, neck.y, arrow.tip.x, arrow.tip.y,
      neck.x - kHalfWidth * uy, neck.y + kHalfWidth * ux,
      neck.x + kHalfWidth * uy, neck.y - kHalfWidth * ux);
}

}  // namespace

double LargestShareOf(const ArcGradients& gradients, std::size_t arc) {
  double largest = 0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (gradients.shares[channel] != GradientShares::kGiven) continue;
    const double share = gradients.arcs[arc].share[channel];
    if (std::abs(share) > std::abs(largest)) largest = share;
  }
  return largest;
}

std::string GradientBands(const InspectedView& inspected,
                          const ProjectedDisc& disc) {
  constexpr double kLeast = 0.01;
  const ArcGradients& gradients = inspected.arc_gradients;
  std::string paths;
  for (std::size_t a = 0; a < gradients.arcs.size(); ++a) {
    const double share = LargestShareOf(gradients, a);
    if (std::abs(share) < kLeast) continue;
    const std::string path = disc.ArcPath(
        ArcInFrame(inspected.view, inspected.view.arcs[a], inspected.frame));
    if (path.empty()) continue;
    paths += fmt::format(
        "<path stroke=\"{}\" stroke-width=\"{:.2f}\" d=\"{}\">{}</path>\n",
        share > 0 ? kWithGradientColour : kAgainstGradientColour,
        kWholeGradientWidth * std::min(std::abs(share), 1.0), path,
        SvgTitle(TitleOfArc(inspected, a)));
  }
  if (paths.empty()) return "";
  return "<g id=\"gradient\" fill=\"none\" stroke-opacity=\"0.55\">\n" + paths +
         "</g>\n";
}

std::string VectorArrows(const InspectedView& inspected,
                         const ProjectedDisc& disc, PicturePoint middle) {
  // Where E is discontinuous the fields of the derivatives mean nothing.
  if (inspected.derivatives.smoothness == Smoothness::kDiscontinuous) return "";
  const std::vector<Arrow> arrows = ArrowsOf(inspected, disc);
  if (arrows.empty()) return "";
  std::string svg = "<g id=\"vector-irradiance\" stroke-linecap=\"round\">\n" +
                    SvgTitle(TitleOfVectorIrradiance(inspected)) + "\n";
  for (const Arrow& arrow : arrows)
    svg += SvgArrow(middle, arrow);
  return svg + "</g>\n";
}

}  // namespace truelux
