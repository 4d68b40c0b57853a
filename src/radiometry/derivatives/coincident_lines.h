// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of the scene that coincide as seen from a receiver.
//
// A line of the scene here is an edge, or where a face goes through the plane of
// a source (a cut); the receiver plane stands for the horizon.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_COINCIDENT_LINES_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_COINCIDENT_LINES_H_

#include <memory>
#include <vector>

#include "exact/number.h"
#include "exact/recipe.h"
#include "exact/vec3.h"
#include "visibility/contour.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {

/// Two lines in one plane through r that overlap as seen from there over a
/// positive angle.
struct LinePair {
  PlaneRecipe first;
  PlaneRecipe second;
  Vec3<Exact> normal;   ///< of the plane
  bool is_one = false;  ///< whether they are one line in space
};

/// What is around a receiver.
struct SeenLines {
  std::vector<PieceId> pieces;   ///< all on the way to any source, its own, too
  std::vector<FacetId> sources;  ///< that r is in front of
  std::vector<PieceId> edge_on;  ///< of the pieces, those whose plane holds r
  std::vector<LinePair> pairs;   ///< hidden or not
};

/// The first component that is not zero becomes positive.
Vec3<Exact> Canonical(const Vec3<Exact>& v);

/// Whether a x b = 0.
bool AreParallel(const Vec3<Exact>& a, const Vec3<Exact>& b);

/// Finds them for one receiver after the other: n log n for n edges on the way
/// to sources, and exact numbers for what coincides up to rounding. For one
/// thread.
class SeenLineFinder {
 public:
  /// The engine must outlive the object.
  explicit SeenLineFinder(const ContourEngine& engine);
  ~SeenLineFinder();
  SeenLineFinder(const SeenLineFinder&) = delete;
  SeenLineFinder& operator=(const SeenLineFinder&) = delete;

  /// Valid until the next call. query: of the engine's scene. with_level: if
  /// not, pairs in the receiver plane may be left out.
  const SeenLines& Find(const ContourQuery& query, bool with_level = true);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_COINCIDENT_LINES_H_
