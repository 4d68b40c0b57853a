// SPDX-License-Identifier: GPL-3.0-or-later
// Whole meshes: all lines are sides, values are certified, and interpolation is
// better than in a uniform mesh.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/isomesh.h"

#include "isolux/lit_floor.h"
#include "isolux/named_floor.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

using Place = std::tuple<double, double, double>;

Place PlaceOf(const Point3& p) {
  return {p.x, p.y, p.z};
}

double DistanceOf(const Point3& a, const Point3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// A lamp over a floor with a box on it and a plate in between.
Scene BoxScene() {
  std::vector<TestFace> above = {
      {{{-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}},
       {1, 1, 1}},
      {Floor(-1, -0.5, -1, -0.4, 1), {}}};
  AddBox(0.5, 1.2, -0.4, 0.5, 0, 0.6, above);
  return NamedFloor(2, above);
}

IsoMesh MeshOf(const Scene& scene, int threads = 2) {
  IsoMeshOptions options;
  options.contours.count = 6;
  options.contours.threads = threads;
  return IsoMeshOf(Oracle(scene), "floor", options);
}

double LengthOf(const Isolux& isolux, const std::vector<std::size_t>& levels) {
  double length = 0;
  for (const IsoluxContour& contour : isolux.contours) {
    if (!std::ranges::count(
            levels, static_cast<std::size_t>(
                        std::ranges::find(isolux.levels, contour.level) -
                        isolux.levels.begin())))
      continue;
    const std::size_t count = contour.vertices.size();
    for (std::size_t i = 0; i + (contour.is_closed ? 0 : 1) < count; ++i) {
      length += DistanceOf(contour.vertices[i].at,
                           contour.vertices[(i + 1) % count].at);
    }
  }
  return length;
}

/// The sides of all triangles by what they lie on.
std::map<MeshSide, double> LengthsOf(const IsoMesh& mesh) {
  std::map<MeshSide, double> lengths;
  for (const IsoMeshTriangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t corner) {
        return mesh
            .vertices[static_cast<std::size_t>(triangle.vertices[corner % 3])]
            .at;
      };
      lengths[triangle.sides[k]] += DistanceOf(at(k + 1), at(k + 2));
    }
  }
  return lengths;
}

/// Of triangles in z = 0, twice over.
double AreaOf(const IsoMesh& mesh, const IsoMeshTriangle& triangle) {
  const auto at = [&](std::size_t corner) {
    return FlatXY(
        mesh.vertices[static_cast<std::size_t>(triangle.vertices[corner])].at);
  };
  return Turn(at(0), at(1), at(2)) / 2;
}

class BoxMesh : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new Scene(BoxScene());
    mesh_ = new IsoMesh(MeshOf(*scene_));
  }

  static void TearDownTestSuite() {
    delete mesh_;
    delete scene_;
  }

  static const Scene* scene_;
  static const IsoMesh* mesh_;
};

const Scene* BoxMesh::scene_ = nullptr;
const IsoMesh* BoxMesh::mesh_ = nullptr;

TEST_F(BoxMesh, TrianglesFillTheFloor) {
  double area = 0;
  for (const IsoMeshTriangle& triangle : mesh_->triangles) {
    EXPECT_GT(AreaOf(*mesh_, triangle), 0);
    area += AreaOf(*mesh_, triangle);
  }
  EXPECT_NEAR(area, 16, 1e-9);
  // Small ones at feet are left.
  EXPECT_LT(mesh_->unfinished, mesh_->triangles.size() / 20);
  EXPECT_GT(mesh_->least_angle, 0);
  EXPECT_LT(mesh_->least_angle, 60);
}

// Triangles that fill the floor without an overlap have sides that do not cross,
// so that no side crosses a contour that is made of sides.
TEST_F(BoxMesh, AllLinesAndContoursAreSides) {
  std::map<MeshSide, double> lengths = LengthsOf(*mesh_);
  double jumps = 0;
  double kinks = 0;
  std::set<std::pair<Place, Place>> seen;
  for (const SurfaceLine& line : mesh_->isolux.lines.lines) {
    // Two planes may have one trace.
    if (!seen.insert({PlaceOf(line.ends[0]), PlaceOf(line.ends[1])}).second)
      continue;
    (line.kind == SurfaceLineKind::kJump ? jumps : kinks) +=
        DistanceOf(line.ends[0], line.ends[1]);
  }
  EXPECT_GT(jumps, 3);
  EXPECT_GT(kinks, 1);
  EXPECT_NEAR(lengths[MeshSide::kJump], 2 * jumps, 1e-9);
  EXPECT_NEAR(lengths[MeshSide::kKink], 2 * kinks, 1e-9);
  EXPECT_NEAR(lengths[MeshSide::kOutline], 16, 1e-9);
  const double contours = LengthOf(mesh_->isolux, {0, 1, 2, 3, 4, 5});
  EXPECT_GT(contours, 20);
  // Chords within 2^-11 of the size are a little shorter, and what is drawn to
  // corners is short.
  EXPECT_NEAR(lengths[MeshSide::kContour], 2 * contours, 0.02 * contours);
}

TEST_F(BoxMesh, VerticesAreDoubledAtJumpsOnly) {
  std::set<Place> at_jumps;
  for (const IsoMeshTriangle& triangle : mesh_->triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle.sides[k] != MeshSide::kJump) continue;
      for (const std::size_t corner : {(k + 1) % 3, (k + 2) % 3}) {
        at_jumps.insert(PlaceOf(
            mesh_->vertices[static_cast<std::size_t>(triangle.vertices[corner])]
                .at));
      }
    }
  }
  std::map<Place, int> counts;
  for (const IsoMeshVertex& vertex : mesh_->vertices)
    ++counts[PlaceOf(vertex.at)];
  std::size_t doubled = 0;
  for (const auto& [place, count] : counts) {
    EXPECT_EQ(count > 1, at_jumps.contains(place));
    doubled += count > 1 ? 1 : 0;
  }
  EXPECT_GT(doubled, 20U);
}

TEST_F(BoxMesh, ValuesAreTheOracles) {
  const Oracle oracle(*scene_);
  std::set<Place> beside;  // of a jump or the outline
  for (const IsoMeshTriangle& triangle : mesh_->triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle.sides[k] != MeshSide::kJump &&
          triangle.sides[k] != MeshSide::kOutline)
        continue;
      for (const std::size_t corner : {(k + 1) % 3, (k + 2) % 3}) {
        beside.insert(PlaceOf(
            mesh_->vertices[static_cast<std::size_t>(triangle.vertices[corner])]
                .at));
      }
    }
  }
  std::size_t inner = 0;
  for (const IsoMeshVertex& vertex : mesh_->vertices) {
    EXPECT_EQ(vertex.value, vertex.irradiance[0]);
    if (beside.contains(PlaceOf(vertex.at))) continue;
    const Irradiance there =
        oracle.Evaluate({vertex.at, {0, 0, 1}, mesh_->triangles[0].face});
    EXPECT_EQ(vertex.irradiance, there.value);
    ++inner;
  }
  EXPECT_GT(inner, 200U);
}

TEST_F(BoxMesh, ContourSidesAreNearTheirLevels) {
  const Oracle oracle(*scene_);
  std::size_t count = 0;
  std::set<double> levels;
  for (const IsoMeshTriangle& triangle : mesh_->triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle.sides[k] != MeshSide::kContour) continue;
      const auto& a = mesh_->vertices[static_cast<std::size_t>(
          triangle.vertices[(k + 1) % 3])];
      const auto& b = mesh_->vertices[static_cast<std::size_t>(
          triangle.vertices[(k + 2) % 3])];
      const Point3 middle = {0.5 * (a.at.x + b.at.x), 0.5 * (a.at.y + b.at.y),
                             0.5 * (a.at.z + b.at.z)};
      const double value =
          oracle.Evaluate({middle, {0, 0, 1}, triangle.face}).value[0];
      const double level = *std::ranges::min_element(
          mesh_->isolux.levels, {},
          [&](double one) { return std::fabs(one - value); });
      // A chord is 2^-11 of the size, 4, from its contour and from what was
      // simplified; the gradient is below 0.4 but at feet.
      EXPECT_NEAR(value, level, 4 * 0x1p-10) << middle.x << ' ' << middle.y;
      levels.insert(level);
      ++count;
    }
  }
  EXPECT_GT(count, 200U);
  EXPECT_EQ(levels.size(), 6U);
}

TEST_F(BoxMesh, InterpolationIsBetterThanInAUniformMesh) {
  EXPECT_NEAR(static_cast<double>(mesh_->uniform_vertices),
              static_cast<double>(mesh_->vertices.size()),
              0.03 * static_cast<double>(mesh_->vertices.size()));
  EXPECT_LT(mesh_->interpolation.most, 0.5 * mesh_->uniform.most);
  EXPECT_LT(mesh_->interpolation.at_99, 0.5 * mesh_->uniform.at_99);
  EXPECT_LT(mesh_->interpolation.mean, mesh_->uniform.mean);
  // Three points of each triangle are below what was asked for.
  EXPECT_LT(mesh_->interpolation.at_99, 1.1 * mesh_->error);
  EXPECT_GT(mesh_->interpolation.mean, 0);
}

TEST_F(BoxMesh, IsTheSameWithOneThread) {
  const IsoMesh other = MeshOf(*scene_, 1);
  ASSERT_EQ(other.vertices.size(), mesh_->vertices.size());
  ASSERT_EQ(other.triangles.size(), mesh_->triangles.size());
  for (std::size_t i = 0; i < other.vertices.size(); ++i) {
    EXPECT_EQ(PlaceOf(other.vertices[i].at), PlaceOf(mesh_->vertices[i].at));
    EXPECT_EQ(other.vertices[i].value, mesh_->vertices[i].value);
  }
  for (std::size_t i = 0; i < other.triangles.size(); ++i) {
    EXPECT_EQ(other.triangles[i].vertices, mesh_->triangles[i].vertices);
    EXPECT_EQ(other.triangles[i].sides, mesh_->triangles[i].sides);
  }
  EXPECT_EQ(other.interpolation.most, mesh_->interpolation.most);
  EXPECT_EQ(other.uniform.mean, mesh_->uniform.mean);
}

TEST(IsoMesh, LessErrorMeansMoreVertices) {
  const Scene scene = BoxScene();
  IsoMeshOptions options;
  options.contours.count = 3;
  options.contours.smallest = 0.01;  // so that it does not take long
  std::vector<IsoMesh> meshes;
  for (const double error : {0.02, 0.002}) {
    options.error = error;
    meshes.push_back(IsoMeshOf(Oracle(scene), "floor", options));
    EXPECT_EQ(meshes.back().error, error);
    EXPECT_LT(meshes.back().interpolation.at_99, 1.1 * error);
  }
  EXPECT_GT(2 * meshes[1].vertices.size(), 3 * meshes[0].vertices.size());
  EXPECT_LT(meshes[1].interpolation.mean, 0.6 * meshes[0].interpolation.mean);
  options.most_vertices = meshes[0].vertices.size();
  const IsoMesh ended = IsoMeshOf(Oracle(scene), "floor", options);
  EXPECT_GT(ended.unfinished, 0U);
  EXPECT_LT(ended.vertices.size(), meshes[1].vertices.size());
}

TEST(IsoMesh, ASurfaceWithoutLightIsTriangulated) {
  const IsoMesh mesh = MeshOf(NamedFloor(1, {}));
  double area = 0;
  for (const IsoMeshTriangle& triangle : mesh.triangles)
    area += AreaOf(mesh, triangle);
  EXPECT_NEAR(area, 4, 1e-12);
  EXPECT_EQ(mesh.interpolation.most, 0);
  for (const IsoMeshVertex& vertex : mesh.vertices)
    EXPECT_EQ(vertex.value, 0);
}

// E is alike on both sides, and so are the places where contours end.
TEST(IsoMesh, AWallInThePlaneOfSymmetry) {
  const Scene scene = NamedFloor(
      2, {{{{-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}},
           {1, 1, 1}},
          {{{-1, 0, 0}, {1, 0, 0}, {1, 0, 1}, {-1, 0, 1}}, {}}});
  const IsoMesh mesh = MeshOf(scene);
  double area = 0;
  for (const IsoMeshTriangle& triangle : mesh.triangles)
    area += AreaOf(mesh, triangle);
  EXPECT_NEAR(area, 16, 1e-9);
}

// Lines that cross within a rounding of their ends have corners that are rounded
// to one place.
TEST(IsoMesh, WallsThatAreAlikeWithinRounding) {
  const double turn = 1e-9;
  std::vector<TestFace> above = {
      {{{-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}},
       {1, 1, 1}}};
  AddBox(0.5, 1.2, -0.4, 0.5, 0, 0.6, above);
  AddBox(1.2, 1.5, -0.4, 0.2, 0, 0.4, above);
  AddBox(-1, -0.4, -0.4, 0.5, 0, 0.6, above);
  above.push_back(
      {{{-1.5, -0.4, 0}, {-0.5, -0.4, 0}, {-0.5, -0.4, 0.3}, {-1.5, -0.4, 0.3}},
       {}});
  for (std::size_t i = 1; i < above.size(); ++i) {
    for (Point3& p : above[i].ring) {
      p = {std::cos(turn) * p.x - std::sin(turn) * p.y,
           std::sin(turn) * p.x + std::cos(turn) * p.y, p.z};
    }
  }
  // Walls that are apart by a little more have many triangles in between.
  IsoMeshOptions options;
  options.contours.count = 3;
  options.most_vertices = 2000;
  const IsoMesh mesh =
      IsoMeshOf(Oracle(NamedFloor(2, above)), "floor", options);
  double area = 0;
  for (const IsoMeshTriangle& triangle : mesh.triangles)
    area += AreaOf(mesh, triangle);
  EXPECT_NEAR(area, 16, 1e-9);
}

// The corner of one is within the side of the other, and no edge goes on from
// there.
TEST(IsoMesh, FacesThatMeetWithinASide) {
  SceneBuilder builder("scene");
  builder.SetGroup("floor");
  builder.AddFace(Floor(-2, 2, -2, 0, 0));
  builder.AddFace(Floor(-2, 0, 0, 2, 0));
  builder.SetGroup("rest");
  builder.AddFace(
      {{-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}},
      {1, 1, 1});
  const Result<Scene> scene = builder.Build();
  ASSERT_TRUE(scene.ok());
  const IsoMesh mesh = MeshOf(*scene.value);
  double area = 0;
  for (const IsoMeshTriangle& triangle : mesh.triangles)
    area += AreaOf(mesh, triangle);
  EXPECT_NEAR(area, 12, 1e-9);
  EXPECT_GT(mesh.uniform_vertices, 10U);
}

TEST(IsoMesh, RefusesWhatMakesNoSense) {
  const Scene scene = BoxScene();
  IsoMeshOptions options;
  options.error = -1;
  EXPECT_THROW(IsoMeshOf(Oracle(scene), "floor", options),
               std::invalid_argument);
  options.error = 0;
  options.smallest = HUGE_VAL;
  EXPECT_THROW(IsoMeshOf(Oracle(scene), "floor", options),
               std::invalid_argument);
  options.smallest = 0;
  EXPECT_THROW(IsoMeshOf(Oracle(scene), "roof", options),
               std::invalid_argument);
  StopFlag stop = true;
  OracleOptions stopped;
  stopped.stop = &stop;
  EXPECT_THROW(IsoMeshOf(Oracle(scene, stopped), "floor", options), Stopped);
}

// The bar: at most half the error of a uniform mesh. The other scenes of the
// table in docs/performance.md take longer: bench/iso_meshes has them.
TEST(IsoMesh, CornellFloor) {
  IsoMeshOptions options;
  options.contours.threads = 2;
  options.contours.smallest = 0.2;  // so that it does not take long
  const IsoMesh mesh =
      IsoMeshOf(Oracle(ExampleScene("cornell_box.obj")), "floor", options);
  EXPECT_LT(mesh.interpolation.most, 0.5 * mesh.uniform.most);
  EXPECT_LT(mesh.interpolation.at_99, 0.5 * mesh.uniform.at_99);
  EXPECT_LT(mesh.interpolation.mean, 0.5 * mesh.uniform.mean);
  EXPECT_LT(mesh.vertices.size(), 10'000U);
}

}  // namespace
}  // namespace truelux
