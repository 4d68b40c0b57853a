// SPDX-License-Identifier: GPL-3.0-or-later
// What the contour engine and the search for faces both need of a scene.

#ifndef TRUELUX_SCENE_INDEX_SCENE_INDEX_H_
#define TRUELUX_SCENE_INDEX_SCENE_INDEX_H_

#include "truelux/scene.h"

#include "scene/index/box.h"
#include "scene/index/convex_pieces.h"
#include "scene/index/silhouette_tree.h"
#include "scene/index/triangle_tree.h"

namespace truelux {

/// A scene as convex pieces with a tree over their boxes. Immutable.
class SceneIndex {
 public:
  explicit SceneIndex(const Scene& scene);

  /// The index of a scene, made when it is first asked for; it lives as long as
  /// the scene's data. May be called from several threads.
  static const SceneIndex& Of(const Scene& scene);

  [[nodiscard]] const ConvexPieces& pieces() const { return pieces_; }

  /// The boxes of the pieces.
  [[nodiscard]] const TriangleTree& tree() const { return tree_; }

  /// The edges of the pieces, for what may be seen as a silhouette.
  [[nodiscard]] const SilhouetteTree& silhouettes() const {
    return silhouettes_;
  }

  /// Of all pieces; empty if there are none.
  [[nodiscard]] const Box& box() const { return box_; }

 private:
  ConvexPieces pieces_;
  TriangleTree tree_;
  SilhouetteTree silhouettes_;
  Box box_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_SCENE_INDEX_H_
