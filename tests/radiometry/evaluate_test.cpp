// SPDX-License-Identifier: GPL-3.0-or-later
// EvaluateContour: what it takes from the scene and from the query.

#include "radiometry/evaluate.h"

#include <array>
#include <cstddef>

#include <gtest/gtest.h>

#include "truelux/scene.h"

#include "radiometry/evaluation_workspace.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// Two octants above the origin, the second of them reddish.
Scene TwoOctants() {
  SceneBuilder builder;
  builder.AddFace({{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {1, 2, 0});
  builder.AddFace({{0, 1, 0}, {0, 0, 1}, {-1, 0, 0}}, {4, 0, 0});
  return *builder.Build().value;
}

/// The arcs of facet `facet`, a triangle that nothing hides.
void AddTriangle(const Scene& scene, FacetId facet, Contour& contour) {
  const Facet& source = FacetsOf(scene)[facet];
  const auto corners = CornersOf(TrianglesOf(scene)[FirstTriangleOf(source)]);
  contour.sources.push_back({facet, contour.arcs.end_id(), 3});
  std::array<DirectionId, 3> directions;
  for (std::size_t i = 0; i < 3; ++i) {
    directions[i] =
        contour.directions.push_back(DirectionRecipe::ToVertex(corners[i]));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    // Counter-clockwise seen from r: (a - r) x (b - a) points outwards.
    const PlaneId plane = contour.planes.push_back(
        PlaneRecipe::OfEdge(corners[i], corners[next]));
    contour.arcs.push_back({plane, false, directions[next], directions[i], {}});
  }
}

class EvaluateContourTest : public ::testing::Test {
 protected:
  EvaluateContourTest() {
    AddTriangle(query_.scene, FacetId(0), contour_);
    AddTriangle(query_.scene, FacetId(1), contour_);
    contour_.statistics.arcs = 6;
    contour_.statistics.plane_side.filter = 11;
  }

  ContourQuery query_{TwoOctants(), {{0, 0, 0}, {0, 0, 1}, 0}};
  Contour contour_;
};

TEST_F(EvaluateContourTest, WeightsSourcesWithTheirFacesEmission) {
  const Irradiance result = EvaluateContour(query_, contour_, {});
  EXPECT_EQ(result.value, (Rgb{1.25, 0.5, 0}));
}

TEST_F(EvaluateContourTest, AddsToTheContoursStatistics) {
  const Irradiance result = EvaluateContour(query_, contour_, {});
  EXPECT_EQ(result.statistics.arcs, 6U);
  EXPECT_EQ(result.statistics.plane_side.filter, 11U);
  EXPECT_EQ(result.statistics.evaluated_double_double, 1U);
}

TEST_F(EvaluateContourTest, AFormFactorIsForUnitExitance) {
  contour_.sources.pop_back();
  query_.only_source = FaceNumber(1);
  for (const Emission emission : {Emission::kExitance, Emission::kRadiance}) {
    const Irradiance result = EvaluateContour(
        query_, contour_, {Method::kCertified, emission, Formula::kAuto});
    EXPECT_EQ(result.value, (Rgb{0.25, 0.25, 0.25}));
  }
}

// What a workspace holds of a longer contour, or of another method, does not
// reach the next result.
TEST_F(EvaluateContourTest, AWorkspaceCarriesNothingOver) {
  Contour shorter = contour_;
  shorter.sources = {contour_.sources.back()};
  EvaluationWorkspace workspace;
  for (const Method method : {Method::kDouble, Method::kCertified}) {
    for (const Formula formula : {Formula::kAuto, Formula::kUnified}) {
      const EvaluationQuery how{method, Emission::kExitance, formula};
      for (const Contour* contour : {&contour_, &shorter, &contour_}) {
        const Irradiance again =
            EvaluateContour(query_, *contour, how, workspace);
        const Irradiance fresh = EvaluateContour(query_, *contour, how);
        EXPECT_EQ(again.value, fresh.value);
        EXPECT_EQ(again.bound, fresh.bound);
      }
    }
  }
}

}  // namespace
}  // namespace truelux
