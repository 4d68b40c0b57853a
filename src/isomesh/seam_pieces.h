// SPDX-License-Identifier: GPL-3.0-or-later
// Seams with ends and places on them that are one if rounding divides them.

#ifndef TRUELUX_ISOMESH_SEAM_PIECES_H_
#define TRUELUX_ISOMESH_SEAM_PIECES_H_

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "isolux/first_mesh.h"
#include "isolux/plan_frame.h"
#include "isolux/plan_mesh.h"

namespace truelux {

/// A part of one seam, or of several that are alike.
struct SeamPiece {
  PlanPoint from;
  PlanPoint to;
  SideKind kind = SideKind::kInner;  ///< of them all that which says most
  int seam = -1;                     ///< which has it
};

/// The pieces meet in their ends only, but for seams that cross. No piece passes
/// an end of another within the distance of what is alike: the mesher, which
/// rounds the points that it puts in, cannot divide the triangle in between.
class SeamPieces {
 public:
  /// alike: how far places are apart that are one [length].
  SeamPieces(std::span<const Seam> seams, double alike);

  [[nodiscard]] std::span<const SeamPiece> pieces() const { return pieces_; }

  /// Divides a piece where a contour meets a seam. p: on the seam, or beside it
  /// by a margin. Returns where that is, on the piece: from both sides of a jump
  /// where E is alike, as in a plane of symmetry, contours come to one place.
  PlanPoint Divide(int seam, const PlanPoint& p);

  [[nodiscard]] bool AreAlike(const PlanPoint& p, const PlanPoint& q) const {
    return LengthOf(p - q) <= alike_;
  }

  /// The piece with the points that divide it, from end to end.
  [[nodiscard]] std::vector<PlanPoint> PathOf(std::size_t piece) const;

 private:
  void AddSeam(int index, const Seam& seam, std::span<const PlanPoint> corners);

  double alike_;
  std::vector<SeamPiece> pieces_;
  /// By their ends.
  std::map<std::pair<std::pair<double, double>, std::pair<double, double>>,
           std::size_t>
      names_;
  std::vector<std::vector<PlanPoint>> points_;  ///< by pieces
  std::vector<std::vector<std::size_t>> of_seams_;
};

}  // namespace truelux

#endif  // TRUELUX_ISOMESH_SEAM_PIECES_H_
