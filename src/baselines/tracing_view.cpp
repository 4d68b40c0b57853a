// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/tracing_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "exact/recipe.h"
#include "exact/vec3.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

using Vec = Vec3<double>;

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

Vec Between(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

Vec Unit(const Vec& a) {
  return 1 / std::sqrt(Dot(a, a)) * a;
}

/// Right-handed axes u, v, n of the image plane.
struct Frame {
  Vec u{};
  Vec v{};
  Vec n{};

  [[nodiscard]] Vec Turned(const Vec& d) const {
    return {Dot(u, d), Dot(v, d), Dot(n, d)};
  }
};

Frame FrameAround(const Vector3& normal) {
  Frame frame;
  // The largest component first, so that no square over- or underflows.
  const double size =
      std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  frame.n = Unit({normal.x / size, normal.y / size, normal.z / size});
  // Beside the axis that is farthest from n; u = x, v = y for n = z.
  const double x = std::abs(frame.n.x);
  const double y = std::abs(frame.n.y);
  const double z = std::abs(frame.n.z);
  Vec axis{0, 0, 1};
  if (x <= y && x <= z) {
    axis = {1, 0, 0};
  } else if (y <= z) {
    axis = {0, 1, 0};
  }
  frame.v = Unit(Cross(frame.n, axis));
  frame.u = Cross(frame.v, frame.n);
  return frame;
}

/// A point in the frame, and the sides of the pyramid over the square on which
/// it was put by clipping: -1, 0 or 1 for x and for y.
struct ClipPoint {
  Vec p{};
  int x_side = 0;
  int y_side = 0;

  /// >= 0 inside of side s of an axis; 0 if clipping put it there.
  [[nodiscard]] double Distance(bool along_x, int s) const {
    if ((along_x ? x_side : y_side) == s) return 0;
    return kTracingHalfSide * p.z - s * (along_x ? p.x : p.y);
  }

  [[nodiscard]] TracingVertex Image() const {
    const double x = x_side != 0 ? x_side * kTracingHalfSide : p.x / p.z;
    const double y = y_side != 0 ? y_side * kTracingHalfSide : p.y / p.z;
    return {x, y, p.z, {}};
  }
};

/// All points of a view, those of the scene first. An edge that is clipped
/// for two polygons gets one point.
class ClipPoints {
 public:
  ClipPoints(std::span<const Point3> vertices, const Point3& r,
             const Frame& frame) {
    points_.reserve(vertices.size());
    for (const Point3& p : vertices)
      points_.push_back({frame.Turned(Between(r, p)), 0, 0});
  }

  [[nodiscard]] const ClipPoint& operator[](int i) const {
    return points_[Index(i)];
  }

  /// The ring above the pyramid over the square; empty if there is none.
  [[nodiscard]] std::vector<int> Clipped(std::vector<int> ring) {
    for (const bool along_x : {true, false}) {
      for (const int side : {1, -1})
        ring = ClippedAt(ring, along_x, side);
    }
    return ring.size() < 3 ? std::vector<int>() : ring;
  }

 private:
  std::vector<int> ClippedAt(const std::vector<int>& ring, bool along_x,
                             int side) {
    std::vector<int> kept;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const int a = ring[k];
      const int b = ring[(k + 1) % ring.size()];
      const double at_a = points_[Index(a)].Distance(along_x, side);
      const double at_b = points_[Index(b)].Distance(along_x, side);
      if (at_a >= 0) kept.push_back(a);
      if (at_a > 0 && at_b < 0) kept.push_back(Cut(a, b, along_x, side));
      if (at_a < 0 && at_b > 0) kept.push_back(Cut(b, a, along_x, side));
    }
    return kept;
  }

  int Cut(int inside, int outside, bool along_x, int side) {
    const std::tuple key{inside, outside, along_x, side};
    const auto found = cuts_.find(key);
    if (found != cuts_.end()) return found->second;
    const ClipPoint a = points_[Index(inside)];
    const ClipPoint b = points_[Index(outside)];
    const double at_a = a.Distance(along_x, side);
    const double at_b = b.Distance(along_x, side);
    ClipPoint cut;
    cut.p = a.p - at_a / (at_a - at_b) * (a.p - b.p);
    cut.x_side = a.x_side == b.x_side ? a.x_side : 0;
    cut.y_side = a.y_side == b.y_side ? a.y_side : 0;
    (along_x ? cut.x_side : cut.y_side) = side;
    const int id = static_cast<int>(points_.size());
    points_.push_back(cut);
    cuts_.emplace(key, id);
    return id;
  }

  std::vector<ClipPoint> points_;
  std::map<std::tuple<int, int, bool, int>, int> cuts_;
};

/// A piece that is seen, before it is known whether it matters.
struct SeenPiece {
  const Piece* piece = nullptr;
  Vec normal{};  ///< in the scene's frame
  Point3 on_plane;
  double height = 0;  ///< normal . (on_plane - r), < 0 seen from the front
  Rgb exitance{};
  std::vector<int> ring;  ///< clockwise in the image plane
  ImageExtent extent;
};

class ViewBuilder {
 public:
  ViewBuilder(const Scene& scene, const ConvexPieces& pieces,
              const Receiver& receiver)
      : scene_(scene),
        pieces_(pieces),
        receiver_(receiver),
        frame_(FrameAround(receiver.normal)),
        points_(scene.vertices(), receiver.position, frame_) {}

  /// Whether a source is seen.
  bool Look(const IdVector<FacetId, bool>& ignored);
  void DropWhatCannotMatter(double cone_angle);
  [[nodiscard]] TracingView Finish();

 private:
  void LookAt(const Piece& piece);
  [[nodiscard]] bool IsBehind(const SeenPiece& piece,
                              const SeenPiece& source) const;
  void AddPolygon(const SeenPiece& seen, TracingView& view);
  int VertexOf(int point, TracingView& view);
  int EdgeBetween(int a, int b, TracingView& view);

  const Scene& scene_;
  const ConvexPieces& pieces_;
  const Receiver& receiver_;
  Frame frame_;
  ClipPoints points_;
  std::vector<SeenPiece> sources_;
  std::vector<SeenPiece> others_;
  std::unordered_map<int, int> vertex_of_;
  std::unordered_map<std::uint64_t, int> edge_of_;
};

bool ViewBuilder::Look(const IdVector<FacetId, bool>& ignored) {
  for (const Piece& piece : pieces_.pieces()) {
    if (ignored.empty() || !ignored[piece.facet]) LookAt(piece);
  }
  return !sources_.empty();
}

void ViewBuilder::LookAt(const Piece& piece) {
  const auto vertices = VerticesOf(scene_);
  const auto corners = CornersOf(TrianglesOf(scene_)[piece.triangle]);
  const Point3& a = vertices[corners[0]];
  SeenPiece seen;
  seen.piece = &piece;
  seen.normal =
      Cross(Between(a, vertices[corners[1]]), Between(a, vertices[corners[2]]));
  seen.on_plane = a;
  seen.height = Dot(seen.normal, Between(receiver_.position, a));
  if (seen.height == 0) return;
  const bool is_front = seen.height < 0;
  const auto ring = pieces_.CornersOf(piece);
  std::vector<int> order;
  order.reserve(ring.size());
  for (const VertexId vertex : ring)
    order.push_back(vertex.value());
  if (!is_front) std::ranges::reverse(order);
  seen.ring = points_.Clipped(std::move(order));
  if (seen.ring.empty()) return;
  for (const int i : seen.ring) {
    const TracingVertex image = points_[i].Image();
    seen.extent.Add(image.x, image.y);
  }
  if (is_front) {
    seen.exitance = FacesOf(scene_)[FaceOf(scene_, piece.facet)].emission;
  }
  (seen.exitance == Rgb{} ? others_ : sources_).push_back(std::move(seen));
}

bool ViewBuilder::IsBehind(const SeenPiece& piece,
                           const SeenPiece& source) const {
  return std::ranges::all_of(pieces_.CornersOf(*piece.piece), [&](VertexId v) {
    const Point3& p = VerticesOf(scene_)[v];
    return Dot(source.normal, Between(source.on_plane, p)) <= 0;
  });
}

void ViewBuilder::DropWhatCannotMatter(double cone_angle) {
  std::vector<double> margins;
  for (const SeenPiece& source : sources_) {
    const ImageExtent& e = source.extent;
    margins.push_back(ConeReach(std::max(std::abs(e.x_low), std::abs(e.x_high)),
                                std::max(std::abs(e.y_low), std::abs(e.y_high)),
                                cone_angle));
  }
  std::erase_if(others_, [&](const SeenPiece& piece) {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (piece.extent.Meets(sources_[i].extent, margins[i]) &&
          !IsBehind(piece, sources_[i]))
        return false;
    }
    return true;
  });
}

int ViewBuilder::VertexOf(int point, TracingView& view) {
  const auto [found, is_new] =
      vertex_of_.emplace(point, static_cast<int>(view.vertices.size()));
  if (is_new) view.vertices.push_back(points_[point].Image());
  return found->second;
}

int ViewBuilder::EdgeBetween(int a, int b, TracingView& view) {
  if (a > b) std::swap(a, b);
  const std::uint64_t key =
      static_cast<std::uint64_t>(a) << 32U | static_cast<std::uint64_t>(b);
  const int id = static_cast<int>(view.edges.size());
  const auto [found, is_new] = edge_of_.emplace(key, id);
  if (is_new) {
    view.edges.push_back({a, b, {}, true});
    view.vertices[Index(a)].edges.push_back(id);
    view.vertices[Index(b)].edges.push_back(id);
  }
  return found->second;
}

void ViewBuilder::AddPolygon(const SeenPiece& seen, TracingView& view) {
  const int id = static_cast<int>(view.polygons.size());
  ImagePolygon polygon;
  polygon.exitance = seen.exitance;
  polygon.extent = seen.extent;
  const Vec slope = 1 / seen.height * frame_.Turned(seen.normal);
  polygon.inverse_depth = {slope.x, slope.y, slope.z};
  for (const int point : seen.ring)
    polygon.vertices.push_back(VertexOf(point, view));
  for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
    const int next = polygon.vertices[(k + 1) % polygon.vertices.size()];
    const int edge = EdgeBetween(polygon.vertices[k], next, view);
    polygon.edges.push_back(edge);
    view.edges[Index(edge)].polygons.push_back(id);
  }
  view.polygons.push_back(std::move(polygon));
}

/// Whether two polygons lie on different sides of their common edge.
bool AreSideBySide(const ImagePolygon& p, const ImagePolygon& q, int edge) {
  const auto start = [edge](const ImagePolygon& polygon) {
    const auto at = std::ranges::find(polygon.edges, edge);
    return polygon.vertices[static_cast<std::size_t>(
        std::distance(polygon.edges.begin(), at))];
  };
  return start(p) != start(q);
}

TracingView ViewBuilder::Finish() {
  TracingView view;
  for (const SeenPiece& source : sources_)
    AddPolygon(source, view);
  view.source_count = static_cast<int>(view.polygons.size());
  for (const SeenPiece& other : others_)
    AddPolygon(other, view);
  for (std::size_t e = 0; e < view.edges.size(); ++e) {
    ImageEdge& edge = view.edges[e];
    if (edge.polygons.size() != 2) continue;
    const ImagePolygon& p = view.polygons[Index(edge.polygons[0])];
    const ImagePolygon& q = view.polygons[Index(edge.polygons[1])];
    edge.is_contour =
        p.exitance != q.exitance || !AreSideBySide(p, q, static_cast<int>(e));
  }
  return view;
}

}  // namespace

void ImageExtent::Add(double x, double y) {
  x_low = std::min(x_low, x);
  x_high = std::max(x_high, x);
  y_low = std::min(y_low, y);
  y_high = std::max(y_high, y);
}

bool ImageExtent::Holds(double x, double y, double margin) const {
  return x >= x_low - margin && x <= x_high + margin && y >= y_low - margin &&
         y <= y_high + margin;
}

bool ImageExtent::Meets(const ImageExtent& other, double margin) const {
  return x_low <= other.x_high + margin && other.x_low <= x_high + margin &&
         y_low <= other.y_high + margin && other.y_low <= y_high + margin;
}

double TracingView::Side(const ImageEdge& edge, double x, double y) const {
  const TracingVertex& a = vertices[Index(edge.a)];
  const TracingVertex& b = vertices[Index(edge.b)];
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

double ConeReach(double x, double y, double cone_angle) {
  // tan(t + c) - tan t <= 2 c (1 + tan^2 t) if c tan t <= 1/4, c <= 1/4. The
  // first term is for the rounding of (x, y) itself.
  const double square = 1 + x * x + y * y;
  const double rounding = 0x1p-40 * std::sqrt(square);
  if (cone_angle * std::sqrt(square) > 0.25)
    return std::numeric_limits<double>::infinity();
  return rounding + 2 * cone_angle * square;
}

TracingView MakeTracingView(const Scene& scene, const ConvexPieces& pieces,
                            const Receiver& receiver,
                            const IdVector<FacetId, bool>& ignored,
                            double cone_angle) {
  ViewBuilder builder(scene, pieces, receiver);
  if (!builder.Look(ignored)) return {};
  builder.DropWhatCannotMatter(cone_angle);
  return builder.Finish();
}

}  // namespace truelux
