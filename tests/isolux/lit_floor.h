// SPDX-License-Identifier: GPL-3.0-or-later
// A floor z = 0 under lamps and blockers, ready for searches.

#ifndef TRUELUX_TESTS_ISOLUX_LIT_FLOOR_H_
#define TRUELUX_TESTS_ISOLUX_LIT_FLOOR_H_

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/scene.h"

#include "isolux/first_mesh.h"
#include "isolux/light_features.h"
#include "isolux/light_probe.h"
#include "isolux/mesh_search.h"
#include "isolux/plan_frame.h"
#include "support/scenes.h"
#include "surface/edge_planes.h"
#include "surface/surface_frame.h"
#include "surface/surface_lines.h"

namespace truelux::testing {

/// A lamp's emission: 1 in the first channel.
inline constexpr Rgb kUnitLamp = {1, 1, 1};

/// The first face of a scene as a surface, with all that a search needs.
class LitFloor {
 public:
  explicit LitFloor(const Scene& scene)
      : oracle_(scene),
        frame_(FrameOf(scene)),
        planes_(EdgePlanesOf(scene, CornersOfSurface(scene, frame_))),
        faces_(FacesOfSide(frame_, false)),
        plan_(scene, frame_, false),
        lines_(SurfaceLinesOf(scene, frame_, planes_, false, nullptr)),
        first_(FirstMeshOf(scene, plan_, faces_, lines_.lines)),
        features_(scene, plan_, planes_, Emission::kExitance, {1, 0, 0}),
        probe_(oracle_, plan_, {1, 0, 0}) {}

  /// A floor of a half side, and faces over it.
  LitFloor(double half_side, std::vector<TestFace> above)
      : LitFloor(SceneWith(half_side, std::move(above))) {}

  static Scene SceneWith(double half_side, std::vector<TestFace> above) {
    above.insert(above.begin(),
                 {Floor(-half_side, half_side, -half_side, half_side, 0), {}});
    return MakeScene(above);
  }

  [[nodiscard]] const Oracle& oracle() const { return oracle_; }

  [[nodiscard]] const Scene& scene() const { return oracle_.scene(); }

  [[nodiscard]] const SurfaceFrame& frame() const { return frame_; }

  [[nodiscard]] const std::vector<int>& faces() const { return faces_; }

  [[nodiscard]] const PlanFrame& plan() const { return plan_; }

  [[nodiscard]] const ExactSurfaceLines& lines() const { return lines_; }

  [[nodiscard]] const FirstMesh& first() const { return first_; }

  [[nodiscard]] const LightFeatures& features() const { return features_; }

  [[nodiscard]] const LightProbe& probe() const { return probe_; }

  [[nodiscard]] MeshSearch Search() const {
    return {probe_, features_, first_.mesh};
  }

 private:
  static SurfaceFrame FrameOf(const Scene& scene) {
    const std::array<int, 1> faces = {0};
    std::string defect;
    auto frame = SurfaceFrameOf(scene, faces, defect);
    if (!frame) throw std::invalid_argument(defect);
    return std::move(*frame);
  }

  Oracle oracle_;
  SurfaceFrame frame_;
  EdgePlanes planes_;
  std::vector<int> faces_;
  PlanFrame plan_;
  ExactSurfaceLines lines_;
  FirstMesh first_;
  LightFeatures features_;
  LightProbe probe_;
};

/// A box on the floor, open below, its faces turned outwards.
inline void AddBox(double x0, double x1, double y0, double y1, double z0,
                   double z1, std::vector<TestFace>& faces) {
  faces.push_back({Floor(x0, x1, y0, y1, z1), {}});
  faces.push_back(
      {{{x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1}}, {}});
  faces.push_back(
      {{{x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x1, y0, z1}}, {}});
  faces.push_back(
      {{{x1, y1, z0}, {x0, y1, z0}, {x0, y1, z1}, {x1, y1, z1}}, {}});
  faces.push_back(
      {{{x0, y1, z0}, {x0, y0, z0}, {x0, y0, z1}, {x0, y1, z1}}, {}});
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_ISOLUX_LIT_FLOOR_H_
