// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals of an edge from which covers are taken away.

#ifndef TRUELUX_VISIBILITY_EDGES_OPEN_RANGE_H_
#define TRUELUX_VISIBILITY_EDGES_OPEN_RANGE_H_

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "visibility/edges/coverage.h"

namespace truelux {

/// What is left of an interval of an edge. A cover that reaches an end moves
/// that end; the others are kept until the end. Exact. Used again for every
/// edge, without allocation in the steady state.
template <class Geometry>
class OpenRange {
 public:
  /// Starts with the interval from `begin` to `end`, which is not empty.
  void Start(const EdgePosition& begin, const EdgePosition& end) {
    begin_ = begin;
    end_ = end;
    holes_.clear();
  }

  /// Takes a cover away. False if nothing is left between the ends.
  bool Remove(Geometry& geometry, const ViewEdge& edge, const Cover& cover) {
    const auto before = [&](const EdgePosition& a, const EdgePosition& b) {
      return ComparePositions(geometry, edge, a, b) == Sign::kNegative;
    };
    if (!before(begin_, cover.begin)) {
      if (!before(begin_, cover.end)) return true;
      begin_ = cover.end;
      return before(begin_, end_);
    }
    if (!before(cover.end, end_)) {
      if (before(cover.begin, end_)) end_ = cover.begin;
      return true;
    }
    holes_.push_back({cover.begin, cover.end});
    return true;
  }

  /// Calls visit(begin, end) for every interval that is left, in order. Ends
  /// the range.
  template <class Visit>
  void ForEachLeft(Geometry& geometry, const ViewEdge& edge, Visit&& visit) {
    const auto before = [&](const EdgePosition& a, const EdgePosition& b) {
      return ComparePositions(geometry, edge, a, b) == Sign::kNegative;
    };
    if (holes_.size() > 1) {
      std::ranges::sort(holes_, [&](const Hole& a, const Hole& b) {
        return before(a.begin, b.begin);
      });
    }
    for (const Hole& hole : holes_) {
      if (before(begin_, hole.begin)) {
        if (!before(hole.begin, end_)) break;
        visit(begin_, hole.begin);
      }
      if (before(begin_, hole.end)) begin_ = hole.end;
    }
    if (before(begin_, end_)) visit(begin_, end_);
  }

 private:
  struct Hole {
    EdgePosition begin;
    EdgePosition end;
  };

  EdgePosition begin_ = kEdgeFrom;
  EdgePosition end_ = kEdgeTo;
  std::vector<Hole> holes_;
};

/// Disjoint intervals of one edge, treated alike.
template <class Geometry>
class OpenRanges {
 public:
  void Clear() { size_ = 0; }

  void Start(const EdgePosition& begin, const EdgePosition& end) {
    if (size_ == ranges_.size()) ranges_.emplace_back();
    ranges_[size_++].Start(begin, end);
  }

  [[nodiscard]] bool empty() const { return size_ == 0; }

  /// Takes a cover away. False if nothing is left of any.
  bool Remove(Geometry& geometry, const ViewEdge& edge, const Cover& cover) {
    for (std::size_t i = 0; i < size_;) {
      if (ranges_[i].Remove(geometry, edge, cover)) {
        ++i;
      } else {
        std::swap(ranges_[i], ranges_[--size_]);
      }
    }
    return size_ > 0;
  }

  /// Calls visit(begin, end) for every interval that is left. Ends the ranges.
  template <class Visit>
  void ForEachLeft(Geometry& geometry, const ViewEdge& edge, Visit&& visit) {
    for (std::size_t i = 0; i < size_; ++i)
      ranges_[i].ForEachLeft(geometry, edge, visit);
  }

 private:
  std::vector<OpenRange<Geometry>> ranges_;  ///< in use are the first size_
  std::size_t size_ = 0;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_OPEN_RANGE_H_
