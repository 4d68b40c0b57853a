// SPDX-License-Identifier: GPL-3.0-or-later
// Segments of the image that do not overlap, for CGAL's sweep.
//
// CGAL would find overlaps by itself, but up to 5.5.1 it mishandles one that
// begins within a curve which overlaps a third one there: an assertion of its
// fails. For arrangement_map.cpp; it includes CGAL.

#ifndef TRUELUX_VISIBILITY_ARRANGEMENT_IMAGE_SEGMENTS_H_
#define TRUELUX_VISIBILITY_ARRANGEMENT_IMAGE_SEGMENTS_H_

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include "base/ids.h"

namespace truelux {

// As CGAL::Epeck, but with an exact type that does not depend on how CGAL was
// configured: the numbers have to go in and out.
using Kernel = CGAL::Lazy_kernel<CGAL::Simple_cartesian<CGAL::Gmpq>>;

/// Index of one of the image triangles.
using ImageTriangleId = Id<struct ImageTriangleTag>;

/// Which triangles' boundary an edge is part of; none for a line where two
/// meet.
using TriangleIds = std::vector<ImageTriangleId>;

/// What two edges in one place are part of.
struct JoinIds {
  TriangleIds operator()(TriangleIds a, const TriangleIds& b) const {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }
};

/// A segment of the image, and what it is part of.
struct ImageSegment {
  ImageSegment(const Kernel::Point_2& p, const Kernel::Point_2& q,
               TriangleIds ids)
      : begin(std::min(p, q)),
        end(std::max(p, q)),
        line(begin, end),
        triangles(std::move(ids)) {}

  Kernel::Point_2 begin;  ///< before the end, by x and then by y
  Kernel::Point_2 end;
  Kernel::Line_2 line;
  TriangleIds triangles;
};

/// Where the line of one segment stands to that of another, in some order of
/// all lines.
inline CGAL::Comparison_result CompareLines(const ImageSegment& a,
                                            const ImageSegment& b) {
  if (a.line.is_vertical() || b.line.is_vertical()) {
    if (!b.line.is_vertical()) return CGAL::SMALLER;
    if (!a.line.is_vertical()) return CGAL::LARGER;
    return CGAL::compare_x(a.begin, b.begin);
  }
  const CGAL::Comparison_result slope = CGAL::compare_slope(a.line, b.line);
  if (slope != CGAL::EQUAL) return slope;
  return CGAL::compare_y_at_x(Kernel::Point_2(0, 0), a.line, b.line);
}

/// Adds segments of one line to `parts`, without overlaps: they are cut where
/// one of them begins or ends, and equal parts become one. segments: by begin.
inline void AddParts(std::span<const ImageSegment> segments,
                     std::vector<ImageSegment>& parts) {
  std::vector<Kernel::Point_2> ends;
  for (const ImageSegment& s : segments) {
    ends.push_back(s.begin);
    ends.push_back(s.end);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<const ImageSegment*> open;
  auto next = segments.begin();
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    std::erase_if(open, [&](const auto* s) { return !(ends[k] < s->end); });
    for (; next != segments.end() && next->begin == ends[k]; ++next)
      open.push_back(&*next);
    if (open.empty()) continue;
    TriangleIds triangles;
    for (const ImageSegment* s : open)
      triangles = JoinIds()(std::move(triangles), s->triangles);
    parts.emplace_back(ends[k], ends[k + 1], std::move(triangles));
  }
}

/// Segments that cover the same points, of which no two overlap. Each is part
/// of all triangles that a segment there was part of.
inline std::vector<ImageSegment> WithoutOverlaps(
    std::vector<ImageSegment> segments) {
  std::sort(segments.begin(), segments.end(), [](const auto& a, const auto& b) {
    const CGAL::Comparison_result lines = CompareLines(a, b);
    return lines == CGAL::EQUAL ? a.begin < b.begin : lines == CGAL::SMALLER;
  });
  std::vector<ImageSegment> parts;
  for (auto first = segments.begin(); first != segments.end();) {
    const auto last = std::find_if(first, segments.end(), [&](const auto& s) {
      return CompareLines(*first, s) != CGAL::EQUAL;
    });
    AddParts({first, last}, parts);
    first = last;
  }
  return parts;
}

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ARRANGEMENT_IMAGE_SEGMENTS_H_
