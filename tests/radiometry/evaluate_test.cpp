// EvaluateContour: what it takes from the scene and from the query.

#include "radiometry/evaluate.h"

#include <gtest/gtest.h>

#include "truelux/scene.h"

#include "radiometry/evaluation_workspace.h"

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
void AddTriangle(const Scene& scene, int facet, Contour& contour) {
  const Facet& source = scene.facets()[static_cast<std::size_t>(facet)];
  const auto& corners =
      scene.triangles()[static_cast<std::size_t>(source.first_triangle)]
          .vertices;
  const auto directions = static_cast<int>(contour.directions.size());
  SourceArcs arcs{facet, static_cast<int>(contour.arcs.size()), 3};
  for (int i = 0; i < 3; ++i) {
    const int a = corners[static_cast<std::size_t>(i)];
    const int b = corners[static_cast<std::size_t>((i + 1) % 3)];
    contour.directions.push_back({.a = a});
    contour.planes.push_back({.a = a, .b = b});
    // Counter-clockwise seen from r: (a - r) x (b - a) points outwards.
    contour.arcs.push_back({static_cast<int>(contour.planes.size()) - 1, false,
                            directions + (i + 1) % 3, directions + i, 0});
  }
  contour.sources.push_back(arcs);
}

class EvaluateContourTest : public ::testing::Test {
 protected:
  EvaluateContourTest() {
    AddTriangle(query_.scene, 0, contour_);
    AddTriangle(query_.scene, 1, contour_);
    contour_.statistics.arcs = 6;
    contour_.statistics.plane_side.filter = 11;
  }

  ContourQuery query_{TwoOctants(), {{0, 0, 0}, {0, 0, 1}, 0}, 0};
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
  query_.only_source = 1;
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
  shorter.sources.erase(shorter.sources.begin());
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
