// One source seen from one receiver: its cones, and the parts of blockers that
// can hide some of it (method.md, section 4).

#ifndef TRUELUX_VISIBILITY_EDGES_SOURCE_PARTS_H_
#define TRUELUX_VISIBILITY_EDGES_SOURCE_PARTS_H_

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "truelux/scene.h"

#include "exact/view_geometry.h"
#include "scene/index/convex_pieces.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/image_box.h"
#include "visibility/edges/part_bins.h"

namespace truelux {

/// A cone with, per edge, the id of the candidate edge it is; kNoCandidate for
/// an edge that is left out.
struct Part {
  static constexpr int kNoCandidate = -1;

  Cone cone;
  std::array<int, Cone::kMaxEdges> candidates{};
};

/// Collects the parts of one source after the other. What a source and what a
/// blocker is are separate steps, so that the blockers can come from any
/// superset of those that matter.
template <class Geometry>
class SourceParts {
 public:
  /// The arguments must outlive the object.
  SourceParts(const Scene& scene, const ConvexPieces& pieces,
              Geometry& geometry, ConeMaker<Geometry>& cones);

  /// Chooses the source: the union of a facet's pieces, above the horizon.
  /// False if nothing of it is. Requires r strictly in front of the facet.
  bool SetSource(int facet);

  /// Whether a piece may block the source, by its box; cheap. If so, `box` is
  /// its box.
  bool MayBlock(int piece, ImageBox& box);

  /// Adds a piece that may block the source. Ignores those that cannot hide
  /// any of it, and pieces whose plane contains r. box: from MayBlock.
  void AddBlocker(int piece, const ImageBox& box);

  /// Takes out the blockers that lie in the cone of another one; of equal ones
  /// one stays. `bins` hold the blockers' boxes, before and after.
  void DropHiddenBlockers(PartBins& bins);

  /// The pieces of the source above the horizon.
  [[nodiscard]] std::span<Part> sources() { return sources_; }

  [[nodiscard]] std::span<Part> blockers() { return blockers_; }

  /// The boxes of blockers(), in their order.
  [[nodiscard]] std::span<const ImageBox> blocker_boxes() const {
    return blocker_boxes_;
  }

  /// The boxes of sources(), in their order.
  [[nodiscard]] std::span<const ImageBox> source_boxes() const {
    return source_boxes_;
  }

  /// Contains them all.
  [[nodiscard]] const ImageBox& source_box() const { return source_box_; }

  /// Whether one blocker alone certainly hides the whole source.
  [[nodiscard]] bool hidden() const { return hidden_; }

  /// The box of an edge between two directions.
  ImageBox BoxOfEdge(int from, int to);

  /// Which of sources() SidesOfSource is about; at first the first one.
  void ChooseCone(std::size_t index) {
    chosen_ = index;
    ++choice_;
  }

  /// The cone that is chosen.
  [[nodiscard]] const Part& chosen() const { return sources_[chosen_]; }

  /// The sides of a direction to the planes of the chosen cone.
  BundleSides& SidesOfSource(int direction) {
    DirectionEntry& entry = EntryOf(direction);
    if (entry.choice != choice_) FindSides(direction, entry);
    return sides_[static_cast<std::size_t>(entry.sides)];
  }

  /// Whether a piece is one of sources().
  [[nodiscard]] bool IsSource(int piece) const {
    return source_of_[static_cast<std::size_t>(piece)] == source_generation_;
  }

  /// Whether a piece blocks the source with any part of it, hidden by other
  /// blockers or not.
  [[nodiscard]] bool IsBlocker(int piece) const {
    return blocker_of_[static_cast<std::size_t>(piece)] == source_generation_;
  }

 private:
  /// What a direction is to the source.
  struct DirectionEntry {
    std::uint64_t generation = 0;  ///< valid if it is the source's
    ImageBox box;
    bool misses = false;           ///< certainly never meets the source's plane
    signed char front = kUnknown;  ///< sign of VertexSide, for a vertex
    int sides = kNoSides;          ///< index into sides_, of ..
    std::uint64_t choice = 0;      ///< .. the cone that was chosen then
  };

  static constexpr int kNoSides = -1;
  static constexpr signed char kUnknown = 2;

  /// Valid until it is asked for another direction.
  DirectionEntry& EntryOf(int direction) {
    const auto index = static_cast<std::size_t>(direction);
    if (index >= entries_.size() ||
        entries_[index].generation != source_generation_) {
      FindEntry(direction);
    }
    return entries_[index];
  }

  /// Whether a facet is known, without arithmetic, to lie in the source's plane.
  [[nodiscard]] bool IsCoplanar(int facet) const {
    return pieces_.PlaneNumber(facet) == pieces_.PlaneNumber(facet_);
  }

  /// Whether a facet's face comes before the source's.
  [[nodiscard]] bool IsEarlier(int facet) const;

  /// Sign of VertexSide to the source's plane, asked once per source.
  Sign FrontSide(int vertex);

  void FindEntry(int direction);
  void FindSides(int direction, DirectionEntry& entry);
  ImageBox BoxOf(const Cone& cone);
  bool IsApart(const Cone& cone, const ImageBox& box);

  const Scene& scene_;
  const ConvexPieces& pieces_;
  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;

  int facet_ = -1;
  int plane_triangle_ = -1;  ///< carries the source's plane
  ImageChart chart_;
  ImageBox source_box_;
  std::vector<Part> sources_;
  std::vector<ImageBox> source_boxes_;
  std::size_t chosen_ = 0;    ///< of sources_
  std::uint64_t choice_ = 0;  ///< one more for every ChooseCone
  std::vector<Part> blockers_;
  std::vector<ImageBox> blocker_boxes_;
  std::vector<bool> dropped_;  ///< per blocker, while they are looked through
  bool hidden_ = false;
  std::uint64_t source_generation_ = 0;    ///< one more for every SetSource
  std::vector<std::uint64_t> source_of_;   ///< per piece: last source it is in
  std::vector<std::uint64_t> blocker_of_;  ///< per piece: last source it blocks
  std::vector<DirectionEntry> entries_;    ///< per direction id
  std::vector<BundleSides> sides_;         ///< of directions to the chosen cone
};

extern template class SourceParts<ViewGeometry>;
extern template class SourceParts<UnfilteredViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_SOURCE_PARTS_H_
