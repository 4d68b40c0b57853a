// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/inspected_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <map>

#include "base/vector_math.h"
#include "inspect/view_measure.h"
#include "scene/emitters.h"
#include "scene/facet_normal.h"

namespace truelux {
namespace {

using Announcement = std::function<void(const std::string&)>;

constexpr const char* kSky = "#eef5fb";

const Face& FaceOf(const Scene& scene, int number) {
  return scene.faces()[static_cast<std::size_t>(number - 1)];
}

std::string HexOf(const std::array<double, 3>& colour) {
  const auto byte = [](double c) {
    return static_cast<int>(std::lround(255 * std::clamp(c, 0.0, 1.0)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour[0]), byte(colour[1]),
                     byte(colour[2]));
}

/// Ke with its largest channel full, lightened so that marks stay readable;
/// what is nearly white is light yellow, to differ from greys and the page.
std::string SourceColour(const Rgb& emission) {
  const double largest = *std::ranges::max_element(emission);
  const double smallest = *std::ranges::min_element(emission);
  constexpr double kNearlyWhite = 0.8;
  if (smallest > kNearlyWhite * largest) return "#ffe680";
  constexpr double kWhite = 0.35;
  std::array<double, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = kWhite + (1 - kWhite) * emission[c] / largest;
  return HexOf(colour);
}

/// |cos| of the angle between a facet's normal and a direction of length 1.
double Facing(const Scene& scene, int facet, const Vector3& direction) {
  const Vector3 n = UnitOf(FacetNormal(scene, facet));
  return std::abs(Dot(n, direction));
}

Vector3 OutOfFrame(const Vector3& v, const ViewFrame& f) {
  return {v.x * f.right.x + v.y * f.up.x + v.z * f.ahead.x,
          v.x * f.right.y + v.y * f.up.y + v.z * f.ahead.y,
          v.x * f.right.z + v.y * f.up.z + v.z * f.ahead.z};
}

std::vector<SeenSource> SourcesOf(const Oracle& oracle,
                                  const InspectedView& inspected,
                                  const Announcement& announce) {
  std::map<int, SeenSource> by_face;
  for (std::size_t r = 0; r < inspected.view.regions.size(); ++r) {
    const ViewRegion& region = inspected.view.regions[r];
    if (KindOf(inspected.scene, region) != RegionKind::kSource) continue;
    SeenSource& source = by_face[region.face];
    source.face = region.face;
    source.solid_angle += SolidAngleOf(
        BorderOf(inspected.view, static_cast<int>(r), inspected.frame));
    ++source.regions;
  }
  std::vector<SeenSource> sources;
  for (auto& [face, source] : by_face) {
    if (announce)
      announce(
          fmt::format("source {} of {}", sources.size() + 1, by_face.size()));
    source.form_factor = oracle.FormFactor(inspected.receiver, face).value[0];
    sources.push_back(source);
  }
  std::ranges::stable_sort(sources, std::greater(), &SeenSource::form_factor);
  return sources;
}

}  // namespace

InspectedView Inspect(const Oracle& oracle, const std::string& scene_name,
                      const Receiver& receiver,
                      const std::function<void(const std::string&)>& announce) {
  InspectedView inspected;
  inspected.irradiance = oracle.Evaluate(receiver).value;
  inspected.derivatives =
      oracle.Derivatives(receiver, {.sphere = false, .jacobian = false});
  inspected.scene = oracle.scene();
  inspected.scene_name = scene_name;
  inspected.receiver = receiver;
  inspected.emission = oracle.options().emission;
  inspected.frame = FrameOf(receiver.normal);
  inspected.view =
      WholeViewOf({oracle.scene(), receiver}, [&announce](int step) {
        if (announce) {
          announce(fmt::format("looking around, step {} of {}", step + 1,
                               kWholeViewSteps));
        }
      });
  inspected.arc_gradients =
      ArcGradientsOf(inspected.scene, receiver, inspected.emission,
                     inspected.view, inspected.derivatives);
  inspected.sources = SourcesOf(oracle, inspected, announce);
  return inspected;
}

RegionKind KindOf(const Scene& scene, const ViewRegion& region) {
  if (region.face == 0) return RegionKind::kNothing;
  if (!Emits(FaceOf(scene, region.face))) return RegionKind::kBlocker;
  return region.front ? RegionKind::kSource : RegionKind::kBack;
}

const char* Name(RegionKind kind) {
  switch (kind) {
    case RegionKind::kNothing:
      return "nothing";
    case RegionKind::kBlocker:
      return "blocker";
    case RegionKind::kBack:
      return "back";
    case RegionKind::kSource:
      break;
  }
  return "source";
}

const char* Name(ViewArcKind kind) {
  switch (kind) {
    case ViewArcKind::kHorizon:
      return "horizon";
    case ViewArcKind::kSilhouette:
      return "silhouette";
    case ViewArcKind::kInner:
      return "inner";
    case ViewArcKind::kContact:
      return "contact";
    case ViewArcKind::kMeeting:
      break;
  }
  return "meeting";
}

std::string ColourOf(const InspectedView& inspected, int region) {
  const ViewRegion& r =
      inspected.view.regions[static_cast<std::size_t>(region)];
  const RegionKind kind = KindOf(inspected.scene, r);
  if (kind == RegionKind::kNothing) return kSky;
  if (kind == RegionKind::kSource)
    return SourceColour(FaceOf(inspected.scene, r.face).emission);
  const Vector3 middle =
      OutOfFrame(MiddleOf(BorderOf(inspected.view, region, inspected.frame)),
                 inspected.frame);
  constexpr double kDark = 0.36;
  constexpr double kLight = 0.84;
  const double grey =
      kDark + (kLight - kDark) * Facing(inspected.scene, r.facet, middle);
  // Backs of emitters are a little brown.
  if (kind == RegionKind::kBack) return HexOf({grey, 0.9 * grey, 0.74 * grey});
  return HexOf({grey, grey, grey});
}

}  // namespace truelux
