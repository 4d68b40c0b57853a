// The default engine: visible contours by walking edges (docs/method.md).

#ifndef TRUELUX_VISIBILITY_CONTOUR_ENGINE_H_
#define TRUELUX_VISIBILITY_CONTOUR_ENGINE_H_

#include <memory>
#include <vector>

#include "exact/filter.h"
#include "exact/view_geometry.h"
#include "scene/convex_pieces.h"
#include "visibility/contour.h"

namespace truelux {

/// What the contour engine knows of a scene, whatever the receiver. Immutable.
class ContourEngine {
 public:
  explicit ContourEngine(const Scene& scene);

  /// The visible contours of the query's sources; query.scene must be the
  /// engine's. One SourceArcs per source of which something is visible. For
  /// one receiver; a ContourBuilder does many without allocating.
  [[nodiscard]] Contour Build(const ContourQuery& query) const;

  [[nodiscard]] const Scene& scene() const { return scene_; }

  [[nodiscard]] const ConvexPieces& pieces() const { return pieces_; }

  [[nodiscard]] std::span<const FilteredPlane> triangle_normals() const {
    return triangle_normals_;
  }

  /// The facets of the faces that emit, in their order.
  [[nodiscard]] std::span<const int> emitters() const { return emitters_; }

 private:
  Scene scene_;
  ConvexPieces pieces_;
  std::vector<FilteredPlane> triangle_normals_;
  std::vector<int> emitters_;
};

/// Finds visible contours in one scene, one receiver after the other; every
/// decision is exact (with PredicateKind::kExact). For one thread.
template <PredicateKind kKind>
class BasicContourBuilder {
 public:
  /// The engine must outlive the object.
  explicit BasicContourBuilder(const ContourEngine& engine);
  ~BasicContourBuilder();
  BasicContourBuilder(BasicContourBuilder&&) noexcept;
  BasicContourBuilder& operator=(BasicContourBuilder&&) noexcept;

  /// As ContourEngine::Build, into `contour`, whose storage is used again.
  void Build(const ContourQuery& query, Contour& contour);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

using ContourBuilder = BasicContourBuilder<PredicateKind::kExact>;
using UnfilteredContourBuilder =
    BasicContourBuilder<PredicateKind::kUnfiltered>;

extern template class BasicContourBuilder<PredicateKind::kExact>;
extern template class BasicContourBuilder<PredicateKind::kUnfiltered>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CONTOUR_ENGINE_H_
