// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/face_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

#include "exact/decide.h"
#include "exact/number.h"
#include "scene/index/box_overlap.h"
#include "scene/index/scene_index.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// The axis along which a box is longest.
std::size_t LongestAxis(const Box& box) {
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    const Sign longer = Decide([&]<class NT>() {
      return (NT(box.hi[axis]) - NT(box.lo[axis])) -
             (NT(box.hi[longest]) - NT(box.lo[longest]));
    });
    if (longer == Sign::kPositive) longest = axis;
  }
  return longest;
}

Box BoxOfFace(const Scene& scene, const Face& face) {
  Box box;
  for (const int v :
       scene.corners().subspan(static_cast<std::size_t>(face.first_corner),
                               static_cast<std::size_t>(face.corner_count)))
    box.Include(VerticesOf(scene)[VertexId(v)]);
  return box;
}

/// What is near a receiver: a limit that the user gave, or one for each face.
class Limits {
 public:
  Limits(const Scene& scene, const Receiver& receiver,
         std::optional<double> given)
      : scene_(scene), is_given_(given.has_value()) {
    const Point3& p = receiver.position;
    if (given) {
      common_.plain = *given;
    } else {
      common_.coordinate =
          std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
  }

  [[nodiscard]] NearLimit Of(FaceId face) const {
    if (is_given_) return common_;
    const Box box = BoxOfFace(scene_, FacesOf(scene_)[face]);
    const std::size_t axis = LongestAxis(box);
    NearLimit limit = common_;
    limit.low = box.lo[axis];
    limit.high = box.hi[axis];
    return limit;
  }

  /// At least that of any face. Requires a RoundUpward object.
  [[nodiscard]] double Most() const {
    double longest = 0;
    if (!is_given_) {
      const Box& box = SceneIndex::Of(scene_).box();
      for (std::size_t axis = 0; axis < 3; ++axis)
        longest = std::max(longest, box.hi[axis] - box.lo[axis]);
    }
    // A number, however large: exact numbers know no infinity.
    return std::min(
        common_.plain + 0x1p-22 * common_.coordinate + 0x1p-20 * longest,
        std::numeric_limits<double>::max());
  }

 private:
  const Scene& scene_;
  bool is_given_;
  NearLimit common_;
};

/// Calls visit(triangle, face) for each face within the limit of a receiver,
/// with a triangle in its plane, perhaps more than once for a face. Such a face
/// has a point whose distance to the receiver is at most sqrt(2) t, so that its
/// box meets a cube of twice t.
template <class Function>
void VisitFacesWithin(const Scene& scene, const Receiver& receiver,
                      std::optional<double> given, const Function& visit) {
  const SceneIndex& index = SceneIndex::Of(scene);
  const RoundUpward rounding;
  const Limits limits(scene, receiver, given);
  const NearLimit most{limits.Most(), 0, 0, 0};
  const auto cube = BoxOverlap::Around(receiver.position, 2 * most.plain);
  index.tree().Visit(cube, [&](int number) {
    const Piece& piece = index.pieces().pieces()[PieceId(number)];
    const Facet& facet = FacetsOf(scene)[piece.facet];
    if (facet.is_back) return;
    const std::span<const VertexId> corners = index.pieces().CornersOf(piece);
    const auto vertices = VerticesOf(scene);
    // A strictly convex polygon is a fan of triangles.
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const NearTriangle triangle(
          {vertices[corners[0]], vertices[corners[k - 1]],
           vertices[corners[k]]},
          receiver);
      if (!triangle.IsPlaneWithin(most)) return;
      const NearLimit limit = limits.Of(FaceOf(facet));
      if (!triangle.IsPlaneWithin(limit)) return;
      if (!triangle.IsFootWithin(limit)) continue;
      visit(triangle, FaceOf(facet));
      return;
    }
  });
}

}  // namespace

std::optional<NearFace> FaceWithin(const Scene& scene, const Receiver& receiver,
                                   std::optional<double> limit) {
  struct Best {
    NearTriangle triangle;
    Turn turn;
    FaceId face;
  };

  std::optional<Best> best;
  FaceId any;
  bool has_second = false;
  VisitFacesWithin(
      scene, receiver, limit, [&](const NearTriangle& triangle, FaceId face) {
        has_second = has_second || (any.valid() && any != face);
        any = face;
        const Turn turn = triangle.TurnOf();
        if (turn == Turn::kAcross) return;
        if (best) {
          if (turn > best->turn) return;
          if (turn == best->turn) {
            const Sign order = triangle.ComparePlanes(best->triangle);
            if (order == Sign::kPositive) return;
            if (order == Sign::kZero && face >= best->face) return;
          }
        }
        best.emplace(Best{triangle, turn, face});
      });
  if (!best) return std::nullopt;
  const RoundUpward rounding;
  return NearFace{best->face.value() + 1, best->triangle.PlaneDistance(),
                  has_second};
}

bool IsBehindFace(const Scene& scene, const Receiver& receiver) {
  bool is_behind = false;
  VisitFacesWithin(scene, receiver, std::nullopt,
                   [&](const NearTriangle& triangle, FaceId /*face*/) {
                     is_behind = is_behind || triangle.HasReceiverBehind();
                   });
  return is_behind;
}

FaceFinder::FaceFinder(const Scene& scene, std::span<const int> faces) {
  std::vector<Box> boxes;
  for (const int face : faces) {
    for (const FacetId id : FacetsOf(FacesOf(scene)[FaceId(face)])) {
      const Facet& facet = FacetsOf(scene)[id];
      if (facet.is_back) continue;
      for (int i = 0; i < facet.triangle_count; ++i) {
        const TriangleId triangle(facet.first_triangle + i);
        triangles_.push_back(triangle);
        Box& box = boxes.emplace_back();
        for (const int v : TrianglesOf(scene)[triangle].vertices)
          box.Include(VerticesOf(scene)[VertexId(v)]);
        box_.Include(box);
      }
    }
  }
  tree_ = TriangleTree(boxes);
}

/// The nearest triangle that is turned so; of those at the same distance that
/// of the first face.
std::optional<FaceFinder::Found> FaceFinder::NearestTurned(
    const Scene& scene, const Receiver& receiver, Turn turn) const {
  // Cubes that grow until one holds the nearest triangle for certain.
  double size = 0;
  double half = 0;
  const std::array<double, 3> at{receiver.position.x, receiver.position.y,
                                 receiver.position.z};
  for (std::size_t k = 0; k < 3; ++k) {
    size = std::max(size, box_.hi[k] - box_.lo[k]);
    half = std::max({half, at[k] - box_.hi[k], box_.lo[k] - at[k]});
  }
  const double step = std::max(0x1p-10 * size, 0x1p-1000);
  for (half += step;; half = 2 * half + step) {
    const auto cube = BoxOverlap::Around(receiver.position, half);
    std::optional<Found> best;
    tree_.Visit(cube, [&](int index) {
      const Triangle& triangle =
          TrianglesOf(scene)[triangles_[static_cast<std::size_t>(index)]];
      std::array<Point3, 3> corners;
      for (std::size_t k = 0; k < corners.size(); ++k)
        corners[k] = VerticesOf(scene)[VertexId(triangle.vertices[k])];
      const NearTriangle near(corners, receiver);
      if (near.TurnOf() != turn) return;
      const FaceId face = FaceOf(scene, FacetOf(triangle));
      if (best) {
        const Sign order = near.CompareDistances(best->triangle);
        if (order == Sign::kPositive) return;
        if (order == Sign::kZero && face >= best->face) return;
      }
      best.emplace(Found{near, face});
    });
    if (cube.Holds(box_)) return best;
    // What meets no such cube is farther away than half.
    if (best && best->triangle.IsWithin(half)) return best;
  }
}

std::optional<NearFace> FaceFinder::Nearest(const Scene& scene,
                                            const Receiver& receiver) const {
  if (triangles_.empty()) return std::nullopt;
  const RoundUpward rounding;
  for (const Turn turn : {Turn::kAlike, Turn::kSameSide, Turn::kOpposite}) {
    if (const auto found = NearestTurned(scene, receiver, turn)) {
      return NearFace{found->face.value() + 1, found->triangle.Distance(),
                      false};
    }
  }
  return std::nullopt;
}

}  // namespace truelux
