// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/darkness.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "scene/emitters.h"
#include "scene/scene_access.h"
#include "visibility/contour.h"
#include "visibility/view/triangle_sides.h"

namespace truelux {
namespace {

/// How near to light an emitter comes, from nothing on.
enum class Stage : std::size_t { kEdgeOn, kBack, kBelowHorizon, kHidden };

/// One receiver's view of emitters.
class EmitterView {
 public:
  EmitterView(const Scene& scene, const Receiver& receiver)
      : query_{scene, receiver},
        sides_(ViewOf(query_)),
        ignored_(IgnoredFacets(query_)) {}

  [[nodiscard]] Stage StageOf(const Face& face) const {
    Stage best = Stage::kEdgeOn;
    for (const FacetId facet : FacetsOf(face))
      best = std::max(best, StageOf(facet));
    return best;
  }

 private:
  [[nodiscard]] Stage StageOf(FacetId id) const {
    const Facet& facet = FacetsOf(query_.scene)[id];
    const Sign side = sides_.OfReceiver(FirstTriangleOf(facet));
    const bool is_ignored = !ignored_.empty() && ignored_[id];
    if (side == Sign::kZero || is_ignored) return Stage::kEdgeOn;
    if (side == Sign::kPositive) return Stage::kBack;
    for (const Triangle& triangle : TrianglesOf(query_.scene, facet)) {
      for (const VertexId v : CornersOf(triangle)) {
        if (SignOf(sides_.exact().AboveHorizon(v)) == Sign::kPositive) {
          return Stage::kHidden;
        }
      }
    }
    return Stage::kBelowHorizon;
  }

  ContourQuery query_;
  TriangleSides sides_;
  IdVector<FacetId, bool> ignored_;
};

}  // namespace

Darkness DarknessOf(const Scene& scene, std::span<const Receiver> receivers) {
  const std::vector<int> emitters = EmittersOf(scene);
  std::vector<Stage> best(emitters.size(), Stage::kEdgeOn);
  for (const Receiver& receiver : receivers) {
    const EmitterView view(scene, receiver);
    for (std::size_t i = 0; i < emitters.size(); ++i) {
      const Face& face = scene.faces()[static_cast<std::size_t>(emitters[i])];
      best[i] = std::max(best[i], view.StageOf(face));
    }
  }
  std::array<std::size_t, 4> counts{};
  for (const Stage stage : best)
    ++counts[static_cast<std::size_t>(stage)];
  return {emitters.size(), counts[0], counts[1], counts[2], counts[3]};
}

std::string DarknessText(const Darkness& darkness) {
  if (darkness.emitters == 0) return "";
  std::string reasons;
  const auto add = [&](std::size_t count, const char* one, const char* many) {
    if (count == 0) return;
    reasons +=
        fmt::format("{}{} of {} emitters {}", reasons.empty() ? "" : ", ",
                    count, darkness.emitters, count == 1 ? one : many);
  };
  add(darkness.backs, "shows its back", "show their backs");
  add(darkness.below_horizon, "is below the horizon", "are below the horizon");
  add(darkness.hidden, "is hidden", "are hidden");
  add(darkness.edge_on, "is seen edge-on", "are seen edge-on");
  if (darkness.backs > 0) {
    reasons +=
        " (wound the wrong way? --two-sided lets faces emit to both sides)";
  }
  return fmt::format("everything is 0 although faces emit: {}", reasons);
}

}  // namespace truelux
