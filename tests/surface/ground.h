// SPDX-License-Identifier: GPL-3.0-or-later
// A surface z = 0 and its kinks.

#ifndef TRUELUX_TESTS_SURFACE_GROUND_H_
#define TRUELUX_TESTS_SURFACE_GROUND_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include <gtest/gtest.h>

#include "exact/rational.h"
#include "support/scenes.h"
#include "surface/edge_planes.h"
#include "surface/kink_pieces.h"
#include "surface/surface_frame.h"

namespace truelux::testing {

/// The surface, which looks up.
inline TestFace GroundFace() {
  return {Floor(-8, 8, -8, 8, 0)};
}

/// A point of the surface.
inline RationalVector PointOf(const mpq_class& x, const mpq_class& y) {
  return {x, y, 0};
}

/// A scene whose first face lies in z = 0 and looks up, with what it has.
class Ground {
 public:
  /// above: the faces from number 2 on.
  explicit Ground(const std::vector<TestFace>& above)
      : Ground(MakeScene(WithGround(above))) {}

  /// scene: its first face is GroundFace().
  explicit Ground(Scene scene) : scene_(std::move(scene)) {
    const std::array<int, 1> faces = {0};
    std::string defect;
    frame_ = SurfaceFrameOf(scene_, faces, defect).value();
    planes_ = EdgePlanesOf(scene_, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  }

  [[nodiscard]] const Scene& scene() const { return scene_; }

  [[nodiscard]] const EdgePlanes& planes() const { return planes_; }

  /// The plane with a normal and an offset; throws if there is none.
  [[nodiscard]] std::size_t PlaneOf(const std::array<int, 3>& normal,
                                    const mpq_class& offset) const {
    const auto found =
        std::ranges::find_if(planes_.planes, [&](const EdgePlane& plane) {
          return plane.normal.x == normal[0] && plane.normal.y == normal[1] &&
                 plane.normal.z == normal[2] && plane.offset == offset;
        });
    if (found == planes_.planes.end()) throw std::out_of_range("no plane");
    return static_cast<std::size_t>(found - planes_.planes.begin());
  }

  /// KinkPiecesOf between two points of a plane's trace.
  [[nodiscard]] std::vector<KinkPiece> Pieces(
      std::size_t plane, const RationalVector& from, const RationalVector& to,
      bool reversed_side = false) const {
    return KinkPiecesOf(scene_, frame_, planes_, plane, from, to,
                        reversed_side);
  }

  /// Of the plane x = 0, from y = -8 to 8.
  [[nodiscard]] std::vector<KinkPiece> PiecesAtX0(
      bool reversed_side = false) const {
    return Pieces(PlaneOf({1, 0, 0}, 0), PointOf(0, -8), PointOf(0, 8),
                  reversed_side);
  }

 private:
  static std::vector<TestFace> WithGround(std::vector<TestFace> faces) {
    faces.insert(faces.begin(), GroundFace());
    return faces;
  }

  Scene scene_;
  SurfaceFrame frame_;
  EdgePlanes planes_;
};

/// To 1e-12 of the numbers.
inline void ExpectNear(const Rgb& found, const Rgb& expected) {
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(found[k], expected[k], 1e-12 * std::fabs(expected[k]));
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SURFACE_GROUND_H_
