// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers in scenes from which faces were taken, and on faces near them.

#ifndef TRUELUX_COMPARE_RECEIVERS_WITHOUT_H_
#define TRUELUX_COMPARE_RECEIVERS_WITHOUT_H_

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "truelux/receiver.h"
#include "truelux/scene.h"

namespace truelux {

/// Gives receivers another face to lie on where theirs is taken.
class ReceiversWithout {
 public:
  /// scene: with all faces; must outlive the object.
  explicit ReceiversWithout(const Scene& scene) : scene_(scene) {}

  /// The receivers for a scene without some faces (indices). One that names one
  /// of them by on_face names another face in the same plane instead, if there
  /// is one, else none.
  [[nodiscard]] std::vector<Receiver> Of(std::span<const Receiver> receivers,
                                         std::span<const int> faces);

 private:
  const std::vector<int>& FacesInPlaneOf(int on_face);

  const Scene& scene_;
  std::map<int, std::vector<int>> faces_in_plane_;  ///< by on_face
};

/// The receivers on their faces, as Scene::FaceNear finds them where on_face
/// names none; nothing if it finds no face.
[[nodiscard]] std::optional<std::vector<Receiver>> ReceiversOnFaces(
    const Scene& scene, std::span<const Receiver> receivers);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_RECEIVERS_WITHOUT_H_
