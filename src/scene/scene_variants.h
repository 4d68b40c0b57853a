// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that differ from a given one in what some faces emit or block.

#ifndef TRUELUX_SCENE_SCENE_VARIANTS_H_
#define TRUELUX_SCENE_SCENE_VARIANTS_H_

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <span>

#include "truelux/geometry.h"
#include "truelux/scene.h"

namespace truelux {

/// What a face is in a variant.
struct FaceChange {
  Rgb emission{};          ///< instead of Face::emission
  bool reversed = false;   ///< front and back are exchanged
  bool removed = false;    ///< it neither emits nor blocks
  bool two_sided = false;  ///< it emits to both sides, if it emits
};

/// Makes variants. Faces keep their numbers, lines and groups, and a face that
/// is not planar keeps its triangles, also if it is reversed; a face that is
/// removed stays as one without facets. Vertices keep their indices.
class SceneVariants {
 public:
  /// change(face index, change): is called for every face, in order, with what
  /// leaves it as it is, and may alter that. Emission stays finite and >= 0.
  [[nodiscard]] static Scene Changed(
      const Scene& scene,
      const std::function<void(std::size_t, FaceChange&)>& change);

  /// As scene/loose_scene.h says.
  [[nodiscard]] static Scene Loose(const Scene& scene);

  /// A loose scene with other triangles of some faces. triangles: per face,
  /// by its index, corners of its ring; a face that is not there keeps its own.
  [[nodiscard]] static Scene WithTriangles(
      const Scene& loose,
      const std::map<std::size_t, std::vector<std::array<int, 3>>>& triangles);

  /// Whether it was made by Loose.
  [[nodiscard]] static bool IsLoose(const Scene& scene);
};

/// Every face that emits in some channel has M = 1 in all channels.
[[nodiscard]] Scene WithUnitExitance(const Scene& scene);

/// Every face that emits does so from its other side.
[[nodiscard]] Scene WithReversedEmitters(const Scene& scene);

/// Every face that emits does so to both sides.
[[nodiscard]] Scene WithTwoSidedEmitters(const Scene& scene);

/// Some faces are not there. faces: indices into Scene::faces().
[[nodiscard]] Scene WithoutFaces(const Scene& scene,
                                 std::span<const int> faces);

/// Some faces do not emit. They still block.
[[nodiscard]] Scene WithBlackFaces(const Scene& scene,
                                   std::span<const int> faces);

/// Only one face emits. All faces still block. face: index into Scene::faces().
[[nodiscard]] Scene WithOneEmitter(const Scene& scene, int face);

}  // namespace truelux

#endif  // TRUELUX_SCENE_SCENE_VARIANTS_H_
