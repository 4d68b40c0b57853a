// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/scene_index.h"

#include <memory>
#include <mutex>

#include "base/id_vector.h"
#include "base/ids.h"
#include "scene/scene_access.h"
#include "scene/scene_data.h"

namespace truelux {

SceneIndex::SceneIndex(const Scene& scene) : pieces_(scene) {
  IdVector<PieceId, Box> boxes(pieces_.pieces().size());
  for (const PieceId piece : boxes.ids()) {
    for (const VertexId vertex : pieces_.CornersOf(piece))
      boxes[piece].Include(VerticesOf(scene)[vertex]);
    box_.Include(boxes[piece]);
  }
  tree_ = TriangleTree(boxes.values());
  silhouettes_ = SilhouetteTree(scene, pieces_);
}

const SceneIndex& SceneIndex::Of(const Scene& scene) {
  const Scene::Data& data = *scene.data_;
  std::call_once(data.lazy.index_is_made, [&] {
    data.lazy.index = std::make_shared<const SceneIndex>(scene);
  });
  return *data.lazy.index;
}

}  // namespace truelux
