// SPDX-License-Identifier: GPL-3.0-or-later
// A receiver's view with the numbers that belong to it: what pictures and
// reports of it are made from.

#ifndef TRUELUX_INSPECT_INSPECTED_VIEW_H_
#define TRUELUX_INSPECT_INSPECTED_VIEW_H_

#include <functional>
#include <string>
#include <vector>

#include "truelux/derivatives.h"
#include "truelux/irradiance.h"

#include "inspect/arc_gradients.h"
#include "inspect/projection.h"
#include "visibility/view/whole_view.h"

namespace truelux {

/// An emitting face of which something is seen from its front.
struct SeenSource {
  int face = 0;            ///< its number, from 1
  double form_factor = 0;  ///< the binary64 nearest to it [1]
  double solid_angle = 0;  ///< of what is seen of it, see SolidAngleOf [sr]
  int regions = 0;         ///< in how many pieces it is seen
};

struct InspectedView {
  Scene scene;
  std::string scene_name;  ///< as the user named it
  Receiver receiver;
  Emission emission = Emission::kExitance;
  Rgb irradiance{};         ///< E, certified [W/m^2]
  Derivatives derivatives;  ///< without Jacobians and the whole sphere
  ViewFrame frame;
  WholeView view;
  ArcGradients arc_gradients;       ///< of the view
  std::vector<SeenSource> sources;  ///< largest form factor first
};

/// Looks around. Slow: the arrangement engine's whole view, and one certified
/// form factor for every source that is seen. Throws what Oracle::Evaluate
/// throws. announce is told what comes next; what it throws ends it.
InspectedView Inspect(
    const Oracle& oracle, const std::string& scene_name,
    const Receiver& receiver,
    const std::function<void(const std::string&)>& announce = {});

/// What a region shows.
enum class RegionKind {
  kNothing,
  kBlocker,
  kBack,    ///< an emitting face from behind
  kSource,  ///< an emitting face from its front
};

[[nodiscard]] RegionKind KindOf(const Scene& scene, const ViewRegion& region);

/// The name in reports: "nothing", "blocker", "back", "source".
[[nodiscard]] const char* Name(RegionKind kind);

/// "horizon", "silhouette", "inner", "contact", "meeting".
[[nodiscard]] const char* Name(ViewArcKind kind);

/// The colour in which a region is filled, "#rrggbb": a source's own, blockers
/// and backs in greys, the lighter the more they face the receiver.
[[nodiscard]] std::string ColourOf(const InspectedView& inspected, int region);

}  // namespace truelux

#endif  // TRUELUX_INSPECT_INSPECTED_VIEW_H_
