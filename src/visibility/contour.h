// What leaves src/visibility: the visible contours of the sources seen from
// one receiver, exactly.
//
// A Contour is a list of arcs per source. An arc is part of a great circle
// (a plane through r), between two directions less than pi apart; exactly one
// side of it is visible source. The arcs of a source bound its visible region
// completely; they need not be joined end to end or sorted, and an engine may
// split an arc or add pairs of equal opposite arcs.

#ifndef TRUELUX_VISIBILITY_CONTOUR_H_
#define TRUELUX_VISIBILITY_CONTOUR_H_

#include <vector>

#include "truelux/receiver.h"
#include "truelux/scene.h"
#include "truelux/statistics.h"

#include "base/stamped_table.h"
#include "exact/explicit_vectors.h"
#include "exact/recipe.h"

namespace truelux {

/// Part of the boundary of the visible region of one source.
struct Arc {
  int plane = -1;        ///< index into Contour::planes
  bool positive = true;  ///< the visible side is N . d > 0 (else N . d < 0)
  int from = -1;         ///< index into Contour::directions
  int to = -1;           ///< (from x to) . N > 0 if positive, else < 0
  int edge_face = 0;     ///< face number of the edge it lies on; 0: horizon,
                         ///< or not known
};

/// The arcs first_arc .. first_arc + arc_count - 1 bound what is visible of
/// one facet (or, from the contour engine, of one triangle of it).
struct SourceArcs {
  int facet = -1;  ///< index into Scene::facets()
  int first_arc = 0;
  int arc_count = 0;
};

/// Sources of which nothing is visible have no entry.
struct Contour {
  std::vector<PlaneRecipe> planes;
  std::vector<DirectionRecipe> directions;
  ExplicitVectors explicit_vectors;
  std::vector<Arc> arcs;
  std::vector<SourceArcs> sources;
  /// Arcs between sources that emit the same were left out: only the sum over
  /// all sources is bounded completely.
  bool is_joined = false;
  Statistics statistics;  ///< the predicates' part
};

/// What an engine is asked.
struct ContourQuery {
  Scene scene;
  Receiver receiver;
  /// Face number of the only face taken as a source (also if black); 0: every
  /// face that emits in some channel.
  int only_source = 0;
  /// Whether arcs between two emitting faces may be left out where both emit
  /// the same: then the sum over all sources is right, each one's is not.
  bool join_sources = false;
};

/// The recipes' input for a query; it refers to the query's scene.
ReceiverView ViewOf(const ContourQuery& query);

/// Which facets are not there for this receiver because of `on_face`: those
/// of that face and those in exactly the same plane as one of them. One entry
/// per facet, empty if on_face is 0. (Facets whose plane contains r are left
/// out by the engines themselves.)
std::vector<bool> IgnoredFacets(const ContourQuery& query);

/// The same, facet by facet as they are asked for, remembered as long as
/// receivers name the same face.
class IgnoredFacetCache {
 public:
  explicit IgnoredFacetCache(const Scene& scene);

  /// on_face: as in Receiver.
  void SetOnFace(int on_face);

  bool IsIgnored(int facet) { return on_face_ != 0 && Ask(facet); }

 private:
  bool Ask(int facet);
  [[nodiscard]] bool IsInPlaneOfFace(int facet) const;

  const Scene& scene_;
  int on_face_ = 0;
  StampedTable<bool> is_ignored_;  ///< per facet, once a face was named
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CONTOUR_H_
