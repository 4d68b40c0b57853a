// SPDX-License-Identifier: GPL-3.0-or-later
// A surface by its name, with all that searches over it need.

#ifndef TRUELUX_ISOLUX_PREPARED_SURFACE_H_
#define TRUELUX_ISOLUX_PREPARED_SURFACE_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/irradiance.h"
#include "truelux/isolux.h"
#include "truelux/picture.h"

#include "isolux/first_mesh.h"
#include "isolux/light_features.h"
#include "isolux/light_probe.h"
#include "isolux/mesh_search.h"
#include "isolux/surface_side.h"
#include "run/watch.h"

namespace truelux {

/// One side of a surface and the search over it.
class SideSearch {
 public:
  /// weights: of the channels. planes: of the scene and the surface. The mesh is
  /// refined to a sixteenth of the size, and E known at its points.
  SideSearch(const Oracle& oracle, SurfaceSide side, const EdgePlanes& planes,
             const Rgb& weights, int threads, const Watch& watch);
  SideSearch(const SideSearch&) = delete;
  SideSearch& operator=(const SideSearch&) = delete;

  [[nodiscard]] const SurfaceSide& side() const { return side_; }

  [[nodiscard]] const PlanFrame& plan() const { return side_.plan; }

  [[nodiscard]] const FirstMesh& first() const { return first_; }

  [[nodiscard]] const LightFeatures& features() const { return features_; }

  [[nodiscard]] const LightProbe& probe() const { return probe_; }

  [[nodiscard]] MeshSearch& search() { return search_; }

  [[nodiscard]] const MeshSearch& search() const { return search_; }

 private:
  SurfaceSide side_;
  FirstMesh first_;
  LightFeatures features_;
  LightProbe probe_;
  MeshSearch search_;
};

/// The sides of a surface.
struct PreparedSurface {
  std::vector<std::unique_ptr<SideSearch>> sides;
  std::vector<Diagnostic> notes;
  double size = 0;           ///< longer side of the extent [length]
  double most_exitance = 0;  ///< E is not larger [W/m^2]
};

/// Throws std::invalid_argument if there is no such surface or it is not flat,
/// and Stopped.
PreparedSurface PrepareSurface(const Oracle& oracle, const std::string& surface,
                               std::optional<ScalarChannel> channel,
                               int threads, const Watch& watch);

/// The shares of the channels in what contours are of; nothing: luminance, or the
/// one value of a scene whose channels are all alike.
Rgb WeightsOf(const Scene& scene, std::optional<ScalarChannel> channel);

/// Where a point on a side of a triangle lies, in words for users.
ContourPlace PlaceOf(SideKind kind);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_PREPARED_SURFACE_H_
