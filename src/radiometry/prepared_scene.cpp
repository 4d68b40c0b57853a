// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/prepared_scene.h"

#include <memory>
#include <utility>

namespace truelux {

PreparedScene::PreparedScene(Scene scene)
    : data_(std::make_shared<Data>(std::move(scene))) {}

const Scene& PreparedScene::scene() const {
  return data_->scene;
}

}  // namespace truelux
