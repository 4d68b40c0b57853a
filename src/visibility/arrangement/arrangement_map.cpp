// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that sees CGAL's arrangements; it is slow to compile.
//
// The edges of all triangles and the lines where two of them meet cut the
// chart into cells. Inside a cell the same triangles cover every point and
// their order in depth does not change: one comparison labels it.
//
// CGAL's lower_envelope_3 would do all of this in one call, and did until it
// crashed (5.5.1, without assertions) on soups of triangles with integer
// corners. The sweep behind Arrangement_2 has not failed on any of them, and it
// is given no segments that overlap (image_segments.h).

#include "visibility/arrangement/arrangement_map.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include "base/disjoint_sets.h"
#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/exact_conversion.h"
#include "visibility/arrangement/arrangement_depth.h"
#include "visibility/arrangement/image_segments.h"

namespace truelux {
namespace {

using Traits = CGAL::Arr_curve_data_traits_2<CGAL::Arr_segment_traits_2<Kernel>,
                                             TriangleIds, JoinIds>;
using Arrangement = CGAL::Arrangement_2<Traits>;
/// Index of a face of the arrangement, in its order.
using MapFaceId = Id<struct MapFaceTag>;

using Face = Arrangement::Face_const_handle;
using Halfedge = Arrangement::Halfedge_const_handle;

/// numerator / denominator, as a number whose exact value is known at once.
Kernel::FT Quotient(const Exact& numerator, const Exact& denominator) {
  return Kernel::FT(static_cast<CGAL::Gmpq>(numerator) /
                    static_cast<CGAL::Gmpq>(denominator));
}

Kernel::Point_2 PointOf(const ImageDirection& p) {
  return {Quotient(p.x, p.z), Quotient(p.y, p.z)};
}

/// CGAL::Mpzf 5.5 reads neither the sign of an integer nor zero.
Exact ExactOf(const CGAL::Gmpz& integer) {
  if (CGAL::is_zero(integer)) return Exact(0);
  if (CGAL::is_negative(integer)) return -Exact(-integer);
  return Exact(integer);
}

/// A point of the image as [x:y:w] without a denominator; the power of two
/// keeps w, and with it x and y, near 1.
ImageDirection DirectionOf(const Kernel::Point_2& point) {
  // Copies: the coordinates are temporary objects.
  const CGAL::Gmpq x = CGAL::exact(point.x());
  const CGAL::Gmpq y = CGAL::exact(point.y());
  const CGAL::Gmpz common = CGAL::gcd(x.denominator(), y.denominator());
  const CGAL::Gmpz x_factor = CGAL::integral_division(y.denominator(), common);
  const CGAL::Gmpz y_factor = CGAL::integral_division(x.denominator(), common);
  const CGAL::Gmpz w = x.denominator() * x_factor;
  const long exponent = -static_cast<long>(w.bit_size());
  return {TimesPowerOfTwo(ExactOf(x.numerator() * x_factor), exponent),
          TimesPowerOfTwo(ExactOf(y.numerator() * y_factor), exponent),
          TimesPowerOfTwo(ExactOf(w), exponent)};
}

/// Builds the map of one chart.
class MapBuilder {
 public:
  MapBuilder(std::span<const ImageTriangle> triangles, MapWalls walls)
      : triangles_(triangles), walls_(walls) {
    for (const ImageTriangle& t : triangles) {
      planes_.push_back(PlaneOf(t));
      corners_.push_back({PointOf(Flat(t.corners[0])),
                          PointOf(Flat(t.corners[1])),
                          PointOf(Flat(t.corners[2]))});
      boxes_.push_back(corners_.back()[0].bbox() + corners_.back()[1].bbox() +
                       corners_.back()[2].bbox());
    }
  }

  ViewMap Build() {
    AddEdges();
    AddMeetings();
    if (walls_ == MapWalls::kClosed) AddWalls();
    std::vector<Traits::Curve_2> curves;
    for (ImageSegment& s : WithoutOverlaps(std::move(segments_))) {
      curves.emplace_back(Kernel::Segment_2(s.begin, s.end),
                          std::move(s.triangles));
    }
    CGAL::insert(arrangement_, curves.begin(), curves.end());
    LabelFaces();
    NumberParts();
    return CollectEdges();
  }

 private:
  using Corners = std::array<Kernel::Point_2, 3>;

  /// Per half-edge that is part of the map its edge there.
  using EdgeIndex = std::unordered_map<const void*, MapEdgeId>;

  static ImageDirection Flat(const ImagePoint& p) { return {p.x, p.y, p.w}; }

  void AddEdges() {
    for (const ImageTriangleId t : corners_.ids()) {
      for (std::size_t k = 0; k < 3; ++k) {
        segments_.emplace_back(corners_[t][k], corners_[t][(k + 1) % 3],
                               TriangleIds{t});
      }
    }
  }

  void AddWalls() {
    const Corners corners = {Kernel::Point_2(0, 0), Kernel::Point_2(1, 0),
                             Kernel::Point_2(0, 1)};
    for (std::size_t k = 0; k < 3; ++k) {
      segments_.emplace_back(corners[k], corners[(k + 1) % 3], TriangleIds{});
    }
  }

  void AddMeetings() {
    std::vector<ImageTriangleId> by_x;
    for (const ImageTriangleId t : boxes_.ids())
      by_x.push_back(t);
    std::ranges::sort(by_x, {},
                      [this](ImageTriangleId t) { return boxes_[t].xmin(); });
    for (std::size_t i = 0; i < by_x.size(); ++i) {
      const CGAL::Bbox_2& box = boxes_[by_x[i]];
      for (std::size_t j = i + 1; j < by_x.size(); ++j) {
        if (boxes_[by_x[j]].xmin() > box.xmax()) break;
        if (CGAL::do_overlap(box, boxes_[by_x[j]])) {
          AddMeeting(by_x[i], by_x[j]);
        }
      }
    }
  }

  /// The segment over which both triangles are at the same depth.
  void AddMeeting(ImageTriangleId i, ImageTriangleId j) {
    const Vec3<Exact> f = DepthDifference(planes_[i], planes_[j]);
    const auto in_i = LineInTriangle(f, triangles_[i]);
    if (!in_i) return;
    const auto in_j = LineInTriangle(f, triangles_[j]);
    if (!in_j) return;
    // On one line the order of points is that of their coordinates.
    const auto [p0, p1] =
        std::minmax({PointOf(in_i->first), PointOf(in_i->second)});
    const auto [q0, q1] =
        std::minmax({PointOf(in_j->first), PointOf(in_j->second)});
    const Kernel::Point_2 begin = std::max(p0, q0);
    const Kernel::Point_2 end = std::min(p1, q1);
    if (begin < end) {
      segments_.emplace_back(begin, end, TriangleIds{});
    }
  }

  /// Walks over all faces from the unbounded one; crossing a triangle's
  /// boundary enters or leaves it.
  void LabelFaces() {
    std::vector<std::pair<Face, TriangleIds>> open;
    const Face outside = arrangement_.unbounded_face();
    front_.emplace(&*outside,
                   walls_ == MapWalls::kClosed ? kOutside : FacetId());
    open.emplace_back(outside, TriangleIds{});
    const auto enter = [&](const Halfedge& own, const TriangleIds& cover) {
      const Face next = own->twin()->face();
      if (front_.contains(&*next)) return;
      TriangleIds next_cover = cover;
      for (const ImageTriangleId t : own->curve().data()) {
        const auto place = std::ranges::find(next_cover, t);
        if (place == next_cover.end()) {
          next_cover.push_back(t);
        } else {
          next_cover.erase(place);
        }
      }
      front_.emplace(&*next, FrontFacet(own->twin(), next_cover));
      open.emplace_back(next, std::move(next_cover));
    };
    while (!open.empty()) {
      const auto [face, face_cover] = std::move(open.back());
      open.pop_back();
      // A name of its own: clang 14 cannot capture a structured binding.
      const TriangleIds& cover = face_cover;
      const auto walk = [&](Arrangement::Ccb_halfedge_const_circulator first) {
        auto edge = first;
        do {
          enter(edge, cover);
        } while (++edge != first);
      };
      if (!face->is_unbounded()) walk(face->outer_ccb());
      for (auto hole = face->inner_ccbs_begin(); hole != face->inner_ccbs_end();
           ++hole) {
        walk(*hole);
      }
    }
  }

  /// Joins the faces on both sides of every edge that separates nothing.
  void NumberParts() {
    std::vector<const void*> faces;
    std::unordered_map<const void*, MapFaceId> id_of;
    for (auto face = arrangement_.faces_begin();
         face != arrangement_.faces_end(); ++face) {
      id_of.emplace(&*face, EndId<MapFaceId>(faces.size()));
      faces.push_back(&*face);
    }
    DisjointSets<MapFaceId> parts(faces.size());
    for (auto edge = arrangement_.edges_begin();
         edge != arrangement_.edges_end(); ++edge) {
      const Face left = edge->face();
      const Face right = edge->twin()->face();
      if (front_.at(&*left) != front_.at(&*right)) continue;
      parts.Join(id_of.at(&*left), id_of.at(&*right));
    }
    IdVector<MapFaceId, int> number(faces.size(), -1);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      int& own = number[parts.LeastOf(EndId<MapFaceId>(i))];
      if (own < 0) own = part_count_++;
      part_.emplace(faces[i], own);
    }
  }

  /// The nearest of the triangles that cover the face on the left of an edge:
  /// judged at the middle of the edge and, where two are equal there, a step
  /// to the left of it.
  FacetId FrontFacet(const Halfedge& edge, const TriangleIds& cover) const {
    if (cover.empty()) return {};
    const Kernel::Point_2& source = edge->source()->point();
    const Kernel::Point_2& target = edge->target()->point();
    const ImageDirection middle = DirectionOf(CGAL::midpoint(source, target));
    const ImageDirection from = DirectionOf(source);
    const ImageDirection to = DirectionOf(target);
    // target - source turned left; from and to have positive depths.
    const Exact step_x = from.y * to.z - to.y * from.z;
    const Exact step_y = to.x * from.z - from.x * to.z;
    const auto nearer = [&](ImageTriangleId a, ImageTriangleId b) {
      const Vec3<Exact> f = DepthDifference(planes_[a], planes_[b]);
      Sign sign = SignOf(Dot(f, middle));
      if (sign == Sign::kZero) sign = SignOf(f.x * step_x + f.y * step_y);
      if (sign != Sign::kZero) return sign == Sign::kNegative;
      return std::tuple(triangles_[a].coplanar_class, triangles_[a].facet) <
             std::tuple(triangles_[b].coplanar_class, triangles_[b].facet);
    };
    return triangles_[*std::ranges::min_element(cover, nearer)].facet;
  }

  ViewMap CollectEdges() const {
    ViewMap map;
    std::unordered_map<const void*, MapVertexId> index_of;
    const auto index = [&](Arrangement::Vertex_const_handle vertex) {
      const auto [entry, is_new] =
          index_of.try_emplace(&*vertex, map.vertices.end_id());
      if (is_new) map.vertices.push_back(DirectionOf(vertex->point()));
      return entry->second;
    };
    EdgeIndex edge_index;
    for (auto edge = arrangement_.edges_begin();
         edge != arrangement_.edges_end(); ++edge) {
      const void* left_face = &*edge->face();
      const void* right_face = &*edge->twin()->face();
      const FacetId left = front_.at(left_face);
      const FacetId right = front_.at(right_face);
      if (left == right) continue;
      const MapVertexId from = index(edge->source());
      const MapVertexId to = index(edge->target());
      const MapEdgeId id = map.edges.push_back(
          {from, to, left, right, part_.at(left_face), part_.at(right_face)});
      edge_index[&*edge] = id;
      edge_index[&*edge->twin()] = id;
    }
    map.part_count = part_count_;
    map.edges_around.resize(map.vertices.size());
    for (auto vertex = arrangement_.vertices_begin();
         vertex != arrangement_.vertices_end(); ++vertex) {
      const auto entry = index_of.find(&*vertex);
      if (entry == index_of.end()) continue;
      map.edges_around[entry->second] = EdgesAround(vertex, edge_index);
    }
    return map;
  }

  /// The edges of the map among those that end at a vertex.
  static std::vector<MapEdgeId> EdgesAround(
      Arrangement::Vertex_const_handle vertex, const EdgeIndex& edge_index) {
    std::vector<MapEdgeId> edges;
    const auto first = vertex->incident_halfedges();
    auto edge = first;
    do {
      const auto entry = edge_index.find(&*edge);
      if (entry != edge_index.end()) edges.push_back(entry->second);
    } while (++edge != first);
    std::ranges::reverse(edges);  // CGAL turns to the right
    return edges;
  }

  IdSpan<ImageTriangleId, const ImageTriangle> triangles_;
  IdVector<ImageTriangleId, ImagePlane> planes_;
  IdVector<ImageTriangleId, Corners> corners_;
  IdVector<ImageTriangleId, CGAL::Bbox_2> boxes_;
  std::vector<ImageSegment> segments_;
  Arrangement arrangement_;
  MapWalls walls_;
  std::unordered_map<const void*, FacetId> front_;  ///< per face
  std::unordered_map<const void*, int> part_;       ///< see MapEdge, per face
  int part_count_ = 0;
};

}  // namespace

ViewMap FrontMost(std::span<const ImageTriangle> triangles, MapWalls walls) {
  return MapBuilder(triangles, walls).Build();
}

}  // namespace truelux
