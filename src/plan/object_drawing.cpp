// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/object_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <set>
#include <vector>

#include "draw/svg.h"
#include "plan/merged_outline.h"

namespace truelux {
namespace {

/// Points of the grid a pixel: what the file's numbers keep.
constexpr double kGrid = 100;
/// A ring with less [px^2] is a wall that is seen from above.
constexpr double kLeastArea = 0.01;
/// More corners make a file too large.
constexpr std::size_t kMostCorners = 20'000;
/// The part of the area that the box of a shown object covers at most.
constexpr double kMostCovered = 0.75;

/// The part of a ring at which `depth` is not negative; it is linear.
template <class Depth>
PaperPath Cut(const PaperPath& ring, const Depth& depth) {
  PaperPath kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PaperPoint& a = ring[i];
    const PaperPoint& b = ring[(i + 1) % ring.size()];
    const double at_a = depth(a);
    const double at_b = depth(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a >= 0) == (at_b >= 0)) continue;
    const double t = at_a / (at_a - at_b);
    kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
  }
  return kept;
}

/// Sutherland and Hodgman's clipping. Parts that are apart stay joined along the
/// box.
PaperPath CutAt(const LabelBox& box, PaperPath ring) {
  ring = Cut(ring, [&box](const PaperPoint& p) { return p.x - box.left; });
  ring = Cut(ring, [&box](const PaperPoint& p) { return box.right - p.x; });
  ring = Cut(ring, [&box](const PaperPoint& p) { return p.y - box.top; });
  return Cut(ring, [&box](const PaperPoint& p) { return box.bottom - p.y; });
}

/// What is seen of the faces of an object.
std::vector<GridRing> RingsOf(const PlanObject& object, const Paper& paper) {
  // Cut off out of sight, so that no stroke runs along the plan's edge. Far
  // away, pictures have no room for coordinates.
  constexpr double kMargin = 8;
  const LabelBox& area = paper.area();
  const LabelBox box = {area.left - kMargin, area.top - kMargin,
                        area.right + kMargin, area.bottom + kMargin};
  MergedOutline outline;
  for (const std::vector<Point3>& face : object.faces) {
    PaperPath path;
    for (const Point3& p : face)
      path.push_back(paper.At(p));
    if (!std::ranges::all_of(path, [](const PaperPoint& p) {
          return std::isfinite(p.x) && std::isfinite(p.y);
        }))
      continue;
    GridRing ring;
    for (const PaperPoint& p : CutAt(box, std::move(path))) {
      ring.push_back({static_cast<int>(std::lround(kGrid * p.x)),
                      static_cast<int>(std::lround(kGrid * p.y))});
    }
    outline.Add(ring);
  }
  std::vector<GridRing> rings = outline.Rings();
  std::erase_if(rings, [](const GridRing& ring) {
    return std::abs(SignedArea(ring)) < kLeastArea * kGrid * kGrid;
  });
  return rings;
}

/// The box around rings, within the plan's area [px]; empty if right <= left or
/// bottom <= top.
LabelBox BoxAround(const std::vector<GridRing>& rings, const LabelBox& area) {
  LabelBox box = {area.right, area.bottom, area.left, area.top};
  for (const GridRing& ring : rings) {
    for (const GridPoint& p : ring) {
      box.left = std::min(box.left, p[0] / kGrid);
      box.right = std::max(box.right, p[0] / kGrid);
      box.top = std::min(box.top, p[1] / kGrid);
      box.bottom = std::max(box.bottom, p[1] / kGrid);
    }
  }
  return {std::max(box.left, area.left), std::max(box.top, area.top),
          std::min(box.right, area.right), std::min(box.bottom, area.bottom)};
}

double AreaOf(const LabelBox& box) {
  return std::max(0.0, box.right - box.left) *
         std::max(0.0, box.bottom - box.top);
}

/// Of rings that cover each other, one: dashes of one would fill the gaps of
/// the other.
std::vector<GridRing> EachOnce(const std::vector<GridRing>& rings) {
  std::set<GridRing> seen;
  std::vector<GridRing> once;
  for (const GridRing& ring : rings) {
    GridRing from_least = ring;
    std::rotate(from_least.begin(), std::ranges::min_element(from_least),
                from_least.end());
    if (seen.insert(from_least).second) once.push_back(ring);
  }
  return once;
}

std::string PathOf(const std::vector<GridRing>& rings) {
  std::string path;
  for (const GridRing& ring : rings) {
    const char* before = "M";
    for (const GridPoint& p : ring) {
      fmt::format_to(std::back_inserter(path), "{}{} {}", before, p[0] / kGrid,
                     p[1] / kGrid);
      before = before[0] == 'M' ? "L" : " ";
    }
    path += 'Z';
  }
  return path;
}

std::size_t CountCorners(const std::vector<GridRing>& rings) {
  std::size_t count = 0;
  for (const GridRing& ring : rings)
    count += ring.size();
  return count;
}

/// The path's element, or nothing if nothing is to be seen.
std::string ElementOf(const PlanObject& object, const Paper& paper) {
  std::vector<GridRing> rings = RingsOf(object, paper);
  const LabelBox box = BoxAround(rings, paper.area());
  if (!(AreaOf(box) > 0)) return "";
  std::string title = object.name.empty() ? "without a name" : object.name;
  std::string path;
  if (object.emits) {
    rings = EachOnce(rings);
  } else if (AreaOf(box) >= kMostCovered * AreaOf(paper.area())) {
    return "";
  }
  if (CountCorners(rings) > kMostCorners) {
    path = fmt::format("M{:.2f} {:.2f}H{:.2f}V{:.2f}H{:.2f}Z", box.left,
                       box.top, box.right, box.bottom, box.left);
    title += " (the box around it, which has too many corners to draw)";
  } else {
    path = PathOf(rings);
  }
  return fmt::format("<path d=\"{}\" {}><title>{}</title></path>\n", path,
                     object.emits ? kLampStyle : kObjectStyle,
                     EscapedXml(title));
}

}  // namespace

ObjectDrawing DrawObjects(std::span<const PlanObject> objects,
                          const Paper& paper) {
  const LabelBox& area = paper.area();
  if (!(AreaOf(area) > 0)) return {};
  std::string bodies;
  std::string lamps;
  for (const PlanObject& object : objects)
    (object.emits ? lamps : bodies) += ElementOf(object, paper);
  if (bodies.empty() && lamps.empty()) return {};
  ObjectDrawing drawing;
  drawing.has_objects = !bodies.empty();
  drawing.has_lamps = !lamps.empty();
  drawing.elements = fmt::format(
      "<clipPath id=\"plan_area\"><rect x=\"{:.2f}\" y=\"{:.2f}\" "
      "width=\"{:.2f}\" height=\"{:.2f}\"/></clipPath>\n"
      "<g id=\"objects\" clip-path=\"url(#plan_area)\">\n{}{}</g>\n",
      area.left, area.top, area.right - area.left, area.bottom - area.top,
      bodies, lamps);
  return drawing;
}

}  // namespace truelux
