// SPDX-License-Identifier: GPL-3.0-or-later
// The edges through a direction by brute force: every triangle of the scene, in
// the scene's own space, in rational numbers. The slow twin of EdgesAt and
// NearestEdge, with which it shares neither planes through the receiver nor an
// index.

#ifndef TRUELUX_TESTS_SUPPORT_PLAIN_EDGES_H_
#define TRUELUX_TESTS_SUPPORT_PLAIN_EDGES_H_

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "exact/rational.h"
#include "visibility/contour.h"
#include "visibility/view/edge_hit.h"

namespace truelux::testing {

/// What is known of an edge through a direction. Two of a plane are equal
/// whatever the length and the sense of its normal.
struct PlainHit {
  SeenEdge edge;
  int vertex = -1;
  std::array<mpq_class, 3> plane;

  friend bool operator<(const PlainHit& a, const PlainHit& b);
  friend bool operator==(const PlainHit&, const PlainHit&) = default;
};

/// An EdgeHit in that form.
PlainHit PlainHitOf(const EdgeHit& hit);

/// By which faces an edge gets its number.
enum class NamedBy {
  kView,    ///< the first face that takes part in the view and has the edge
  kSource,  ///< the first one that has it, of the source and what can hide it
};

/// Looks along rays from the receiver of a query.
class PlainEdges {
 public:
  /// The query must outlive the object.
  explicit PlainEdges(const ContourQuery& query);

  /// Whether a facet takes part in the view.
  [[nodiscard]] bool TakesPart(int facet) const;

  /// Whether the ray along d meets a closed triangle of a facet.
  [[nodiscard]] bool Meets(int facet, const RationalVector& d) const;

  /// As EdgesAt::OfSource.
  [[nodiscard]] std::set<PlainHit> OfSource(int facet, const RationalVector& d,
                                            NamedBy named_by) const;

  /// As EdgesAt::NotBehind.
  [[nodiscard]] std::set<PlainHit> NotBehind(int facet,
                                             const RationalVector& d) const;

  /// Whether an edge that could bound a source passes through d behind the
  /// source's plane.
  [[nodiscard]] bool PassesBehind(int facet, const RationalVector& d) const;

  /// The angle from d to the nearest segment that could bound a source and does
  /// not pass through d [rad]; nothing if there is none.
  [[nodiscard]] std::optional<double> NearestAngle(
      int facet, const RationalVector& d) const;

 private:
  /// An edge of a triangle, from its corner k to the next.
  struct Side {
    int triangle = 0;
    int a = 0;
    int b = 0;
    int third = 0;
  };

  [[nodiscard]] const Triangle& At(int triangle) const;
  [[nodiscard]] RationalVector Vertex(int v) const;
  [[nodiscard]] RationalVector Corner(int triangle, std::size_t k) const;
  [[nodiscard]] RationalVector Normal(int triangle) const;
  [[nodiscard]] int FaceNumber(int triangle) const;
  [[nodiscard]] int SideOfPlane(int facet, const RationalVector& p) const;
  [[nodiscard]] bool CanHide(int triangle, int facet) const;
  [[nodiscard]] std::vector<int> Relevant(int facet) const;
  [[nodiscard]] std::vector<Side> SidesOf(
      const std::vector<int>& triangles) const;
  [[nodiscard]] bool AreBeyondEachOther(const Side& s, const Side& t) const;
  [[nodiscard]] std::vector<Side> BoundsOf(int facet) const;
  [[nodiscard]] std::optional<RationalVector> PointOn(
      const Side& side, const RationalVector& d) const;
  [[nodiscard]] std::optional<RationalVector> PointInPlane(
      int triangle, const RationalVector& d) const;
  [[nodiscard]] bool Holds(int triangle, const RationalVector& p) const;
  [[nodiscard]] int VertexAt(const RationalVector& p,
                             std::span<const int> vertices) const;
  [[nodiscard]] PlainHit HitOf(const Side& side, const RationalVector& p,
                               const std::vector<Side>& named) const;
  [[nodiscard]] std::optional<PlainHit> CutAt(int triangle, int facet,
                                              const RationalVector& d) const;
  [[nodiscard]] std::optional<PlainHit> MeetingAt(
      int s, int t, const RationalVector& d) const;
  [[nodiscard]] std::vector<RationalVector> CutEnds(int triangle,
                                                    int facet) const;

  const ContourQuery& query_;
  RationalVector r_;
  std::vector<int> triangles_;  ///< that take part
};

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_PLAIN_EDGES_H_
