// The default engine: visible contours by walking edges (docs/method.md).

#ifndef TRUELUX_VISIBILITY_CONTOUR_ENGINE_H_
#define TRUELUX_VISIBILITY_CONTOUR_ENGINE_H_

#include <vector>

#include "exact/filter.h"
#include "visibility/contour.h"

namespace truelux {

/// Finds visible contours in one scene. Every decision is exact. Const
/// methods may be called from several threads.
class ContourEngine {
 public:
  /// Prepares what does not depend on a receiver.
  explicit ContourEngine(const Scene& scene);

  /// The visible contours of the query's sources; query.scene must be the
  /// engine's. One SourceArcs per source of which something is visible.
  [[nodiscard]] Contour Build(const ContourQuery& query) const;

 private:
  std::vector<FilteredPlane> triangle_normals_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CONTOUR_ENGINE_H_
