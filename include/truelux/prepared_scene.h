// SPDX-License-Identifier: GPL-3.0-or-later
// What all oracles over one scene share.

#ifndef TRUELUX_PREPARED_SCENE_H_
#define TRUELUX_PREPARED_SCENE_H_

#include <memory>

#include "truelux/export.h"
#include "truelux/scene.h"

namespace truelux {

/// A scene with its spatial index and all else that an Oracle prepares before
/// its first answer. Several oracles with different options can be made from
/// one prepared scene at no cost. Immutable; copies share the data and may be
/// used from several threads.
///
/// Example
///   const PreparedScene prepared(scene);
///   const Oracle certified(prepared);
///   const Oracle fast(prepared, {.method = Method::kDouble});
class TRUELUX_EXPORT PreparedScene {
 public:
  /// Takes time and memory in proportion to the scene (n log n for n faces).
  explicit PreparedScene(Scene scene);

  /// The scene that was given.
  [[nodiscard]] const Scene& scene() const;

 private:
  friend class Oracle;
  struct Data;
  std::shared_ptr<Data> data_;
};

}  // namespace truelux

#endif  // TRUELUX_PREPARED_SCENE_H_
