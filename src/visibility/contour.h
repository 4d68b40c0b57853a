// SPDX-License-Identifier: GPL-3.0-or-later
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

#include <span>

#include "truelux/receiver.h"
#include "truelux/scene.h"
#include "truelux/statistics.h"
#include "truelux/stop.h"

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/stamped_table.h"
#include "exact/explicit_vectors.h"
#include "exact/recipe.h"

namespace truelux {

/// Part of the boundary of the visible region of one source.
struct Arc {
  PlaneId plane;
  bool positive = true;  ///< the visible side is N . d > 0 (else N . d < 0)
  DirectionId from;
  DirectionId to;        ///< (from x to) . N > 0 if positive, else < 0
  FaceNumber edge_face;  ///< of the edge it lies on; none: horizon, or not
                         ///< known
};

/// The arcs first_arc .. first_arc + arc_count - 1 bound what is visible of
/// one facet (or, from the contour engine, of one triangle of it). Where sources
/// are joined it may be several facets of one plane that emit the same; `facet`
/// is the first of them.
struct SourceArcs {
  FacetId facet;
  ArcId first_arc{0};
  int arc_count = 0;
};

/// Sources of which nothing is visible have no entry.
struct Contour {
  IdVector<PlaneId, PlaneRecipe> planes;
  IdVector<DirectionId, DirectionRecipe> directions;
  ExplicitVectors explicit_vectors;
  IdVector<ArcId, Arc> arcs;
  IdVector<SourceId, SourceArcs> sources;
  /// Arcs between sources that emit the same were left out: only the sum over
  /// all sources is bounded completely.
  bool is_joined = false;
  Statistics statistics;  ///< the predicates' part

  /// The arcs of one source.
  [[nodiscard]] std::span<const Arc> ArcsOf(const SourceArcs& source) const {
    return arcs.Part(source.first_arc, source.arc_count);
  }
};

/// What an engine is asked.
struct ContourQuery {
  Scene scene;
  Receiver receiver;
  /// The only face taken as a source (also if black); none: every face that
  /// emits in some channel.
  FaceNumber only_source{};
  /// Whether arcs between two emitting faces may be left out where both emit
  /// the same: then the sum over all sources is right, each one's is not.
  bool join_sources = false;
  /// Looked at before every source, if given: Stopped is thrown if it is set.
  const StopFlag* stop = nullptr;
  /// Whether sources count wherever they are seen, also below the receiver
  /// plane. Only the contour engine knows it.
  bool whole_sphere = false;
  /// Where r is instead; null: where it is. Only DisplacedContourBuilder takes
  /// it into account.
  const Displacement* displacement = nullptr;
};

/// The recipes' input for a query; it refers to the query's scene.
ReceiverView ViewOf(const ContourQuery& query);

/// Which facets are not there for this receiver because of `on_face`: those
/// of that face and those in exactly the same plane as one of them. One entry
/// per facet, empty if on_face is 0. (Facets whose plane contains r are left
/// out by the engines themselves.)
IdVector<FacetId, bool> IgnoredFacets(const ContourQuery& query);

/// The same, facet by facet as they are asked for, remembered as long as
/// receivers name the same face.
class IgnoredFacetCache {
 public:
  explicit IgnoredFacetCache(const Scene& scene);

  /// on_face: as in Receiver.
  void SetOnFace(FaceNumber on_face);

  /// As it was set last.
  [[nodiscard]] FaceNumber on_face() const { return on_face_; }

  /// Whether a facet is not there.
  bool IsIgnored(FacetId facet) { return on_face_.valid() && Ask(facet); }

 private:
  bool Ask(FacetId facet);
  [[nodiscard]] bool IsInPlaneOfFace(FacetId facet) const;

  const Scene& scene_;
  FaceNumber on_face_;
  StampedTable<bool, FacetId> is_ignored_;  ///< once a face was named
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CONTOUR_H_
