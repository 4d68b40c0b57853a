// SPDX-License-Identifier: GPL-3.0-or-later
// Where faces of a scene touch so that a vertex may have one-sided derivatives,
// whatever the receiver.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_SCENE_CONTACTS_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_SCENE_CONTACTS_H_

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "base/ids.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {

/// A piece near a source that lies in the source's plane, or has an edge there.
struct SourceContact {
  PieceId piece;
  bool is_coplanar = false;
  std::array<VertexId, 2> edge;  ///< unless it is coplanar
};

/// An edge that another piece has, too, one in space, but with end points of
/// other numbers.
struct EdgeTwin {
  PieceId other;
  std::array<int, 4> numbers{};  ///< of the ends, of both edges
};

/// What FindSuspects needs to know of a scene. Immutable.
class SceneContacts {
 public:
  /// Decides exactly; near-linear time in the number of pieces for scenes whose
  /// faces are small beside them.
  explicit SceneContacts(const ContourEngine& engine);

  /// Pieces whose boxes meet that of an emitting facet.
  [[nodiscard]] std::span<const SourceContact> ContactsOf(
      FacetId source) const {
    return Find(contacts_, source);
  }

  /// The edges of a piece that have twins.
  [[nodiscard]] std::span<const EdgeTwin> TwinsOf(PieceId piece) const {
    return Find(twins_, piece);
  }

  /// The numbers of the vertices around the corners of 180 degrees that a
  /// piece's face has.
  [[nodiscard]] std::span<const int> StraightCornersOf(PieceId piece) const {
    return Find(straight_, piece);
  }

 private:
  template <class Key, class Value>
  static std::span<const Value> Find(
      const std::map<Key, std::vector<Value>>& table, Key key) {
    const auto found = table.find(key);
    if (found == table.end()) return {};
    return found->second;
  }

  void FindContacts(const ContourEngine& engine);
  void FindTwins(const ContourEngine& engine);
  void FindStraightCorners(const ContourEngine& engine);

  std::map<FacetId, std::vector<SourceContact>> contacts_;
  std::map<PieceId, std::vector<EdgeTwin>> twins_;
  std::map<PieceId, std::vector<int>> straight_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_SCENE_CONTACTS_H_
