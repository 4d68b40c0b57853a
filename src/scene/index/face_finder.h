// SPDX-License-Identifier: GPL-3.0-or-later
// The face on which a receiver lies up to rounding.

#ifndef TRUELUX_SCENE_INDEX_FACE_FINDER_H_
#define TRUELUX_SCENE_INDEX_FACE_FINDER_H_

#include <optional>
#include <span>
#include <vector>

#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "base/ids.h"
#include "scene/index/box.h"
#include "scene/index/triangle_tree.h"
#include "scene/near_triangle.h"

namespace truelux {

// The backs of faces that emit to both sides are not looked at: they lie where
// the fronts do. A receiver is finite, with a normal that is not zero; its
// on_face is not looked at.

/// As Scene::FaceNear(receiver, limit).
[[nodiscard]] std::optional<NearFace> FaceWithin(const Scene& scene,
                                                 const Receiver& receiver,
                                                 std::optional<double> limit);

/// As Scene::IsBehindFace.
[[nodiscard]] bool IsBehindFace(const Scene& scene, const Receiver& receiver);

/// Finds the nearest of some faces. Immutable; any number of threads may ask.
class FaceFinder {
 public:
  /// faces: indices into Scene::faces().
  FaceFinder(const Scene& scene, std::span<const int> faces);

  /// As Scene::FaceNear(receiver, name). scene: the same.
  [[nodiscard]] std::optional<NearFace> Nearest(const Scene& scene,
                                                const Receiver& receiver) const;

 private:
  /// A triangle of a face.
  struct Found {
    NearTriangle triangle;
    FaceId face;
  };

  [[nodiscard]] std::optional<Found> NearestTurned(const Scene& scene,
                                                   const Receiver& receiver,
                                                   Turn turn) const;

  std::vector<TriangleId> triangles_;  ///< what the tree's boxes are of
  TriangleTree tree_;
  Box box_;  ///< of all of them
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_FACE_FINDER_H_
