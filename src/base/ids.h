// SPDX-License-Identifier: GPL-3.0-or-later
// Ids that cannot be mixed: the index of a vertex is no index of a plane, and
// the number of a face is no index of one.

#ifndef TRUELUX_BASE_IDS_H_
#define TRUELUX_BASE_IDS_H_

#include <cassert>
#include <compare>
#include <cstddef>
#include <functional>

namespace truelux {

/// The index, from 0, of a thing in the array of all things of its kind; or
/// none. An Id is an int that only becomes one where it is asked to.
template <class Tag>
class Id {
 public:
  /// None.
  constexpr Id() = default;

  /// The id with this index; a negative number stands for none.
  constexpr explicit Id(int value) : value_(value) {}

  /// The index; negative if there is none.
  [[nodiscard]] constexpr int value() const { return value_; }

  /// The index, to subscript an array with. Requires valid().
  [[nodiscard]] constexpr std::size_t index() const {
    assert(valid());
    return static_cast<std::size_t>(value_);
  }

  /// Whether there is one.
  [[nodiscard]] constexpr bool valid() const { return value_ >= 0; }

  /// The id of the next thing in the array.
  constexpr Id& operator++() {
    ++value_;
    return *this;
  }

  friend constexpr bool operator==(const Id&, const Id&) = default;
  friend constexpr auto operator<=>(const Id&, const Id&) = default;

 private:
  int value_ = -1;
};

/// Index into Scene::vertices().
using VertexId = Id<struct VertexTag>;
/// Index of an edge of a convex piece, and of the corner where it starts.
using EdgeId = Id<struct EdgeTag>;
/// Index into Scene::triangles().
using TriangleId = Id<struct TriangleTag>;
/// Index into Scene::facets().
using FacetId = Id<struct FacetTag>;
/// Index into Scene::faces().
using FaceId = Id<struct FaceTag>;
/// Index of a convex piece of a facet.
using PieceId = Id<struct PieceTag>;
/// Index of a plane through the receiver, into Contour::planes.
using PlaneId = Id<struct PlaneTag>;
/// Index of a direction from the receiver, into Contour::directions.
using DirectionId = Id<struct DirectionTag>;
/// Index of a plane of a ViewGeometry, which has more than a Contour takes.
using ViewPlaneId = Id<struct ViewPlaneTag>;
/// Index of a direction of a ViewGeometry.
using ViewDirectionId = Id<struct ViewDirectionTag>;
/// Index of several planes of a ViewGeometry that are asked together.
using BundleId = Id<struct BundleTag>;
/// Index of a vector that no recipe describes, into ExplicitVectors.
using ExplicitId = Id<struct ExplicitTag>;
/// Index into Contour::arcs.
using ArcId = Id<struct ArcTag>;
/// Index into Contour::sources.
using SourceId = Id<struct SourceTag>;

/// The number of a face as users count: from 1 in the order of the input; 0
/// stands for none.
class FaceNumber {
 public:
  /// None.
  constexpr FaceNumber() = default;

  /// The number as a user wrote it; 0 stands for none.
  constexpr explicit FaceNumber(int value) : value_(value) {}

  /// The number; 0 if there is none.
  [[nodiscard]] constexpr int value() const { return value_; }

  /// Whether there is one.
  [[nodiscard]] constexpr bool valid() const { return value_ > 0; }

  friend constexpr bool operator==(const FaceNumber&,
                                   const FaceNumber&) = default;
  friend constexpr auto operator<=>(const FaceNumber&,
                                    const FaceNumber&) = default;

 private:
  int value_ = 0;
};

/// The number of the face with this index; none for none.
constexpr FaceNumber NumberOf(FaceId face) {
  return FaceNumber(face.value() + 1);
}

/// The index of the face with this number; none for none.
constexpr FaceId IndexOf(FaceNumber number) {
  return FaceId(number.value() - 1);
}

}  // namespace truelux

/// Ids as keys of unordered containers.
template <class Tag>
struct std::hash<truelux::Id<Tag>> {
  std::size_t operator()(truelux::Id<Tag> id) const noexcept {
    return std::hash<int>()(id.value());
  }
};

#endif  // TRUELUX_BASE_IDS_H_
