// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as files; meshio reads them back in tests/python.

#include "plan/mesh_files.h"

#include <string>

#include <gtest/gtest.h>

#include "plan/made_isolux.h"
#include "plan/mesh_notes.h"
#include "support/well_formed.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

IsoMesh MadeMesh() {
  IsoMesh mesh;
  mesh.vertices = {{{0, 0, 1}, {1, 2, 3}, 0.1},
                   {{2, 0, 1}, {4, 5, 6}, 0.2},
                   {{0, 1e-7, 1}, {7, 8, 9e-300}, 0.30000000000000004}};
  mesh.triangles = {
      {{0, 1, 2}, {MeshSide::kInside, MeshSide::kJump, MeshSide::kContour}, 4}};
  mesh.error = 0.01;
  mesh.least_angle = 12.34;
  mesh.interpolation = {0.0123, 0.004, 1e-4};
  mesh.uniform = {0.5, 0.25, 0.125};
  mesh.uniform_vertices = 5;
  return mesh;
}

TEST(MeshFiles, Obj) {
  EXPECT_EQ(MeshObj(MadeMesh(), MadeSubject()),
            "# irradiance E [W/m^2] on floor of room.obj, of luminance: in vt "
            "E 0\n"
            "v 0 0 1\nv 2 0 1\nv 0 1e-07 1\n"
            "vt 0.1 0\nvt 0.2 0\nvt 0.30000000000000004 0\n"
            "f 1/1 2/2 3/3\n");
}

TEST(MeshFiles, Ply) {
  EXPECT_EQ(MeshPly(MadeMesh(), MadeSubject()),
            "ply\nformat ascii 1.0\n"
            "comment irradiance E [W/m^2] on floor of room.obj, of luminance\n"
            "element vertex 3\n"
            "property double x\nproperty double y\nproperty double z\n"
            "property double E\nproperty double E_r\nproperty double E_g\n"
            "property double E_b\n"
            "element face 1\nproperty list uchar int vertex_indices\n"
            "end_header\n"
            "0 0 1 0.1 1 2 3\n2 0 1 0.2 4 5 6\n"
            "0 1e-07 1 0.30000000000000004 7 8 9e-300\n"
            "3 0 1 2\n");
}

TEST(MeshFiles, Vtu) {
  const std::string text = MeshVtu(MadeMesh());
  EXPECT_EQ(MarkupDefect(text), "");
  for (const char* part :
       {"NumberOfPoints=\"3\" NumberOfCells=\"1\"",
        "Name=\"E\" format=\"ascii\">\n0.1\n0.2\n0.30000000000000004\n</",
        "Name=\"E_rgb\" NumberOfComponents=\"3\" format=\"ascii\">\n1 2 3\n",
        "Name=\"face\" format=\"ascii\">\n4\n</",
        "Name=\"sides\" NumberOfComponents=\"3\" format=\"ascii\">\n0 3 1\n</",
        "Name=\"connectivity\" format=\"ascii\">\n0 1 2\n</",
        "Name=\"offsets\" format=\"ascii\">\n3\n</",
        "Name=\"types\" format=\"ascii\">\n5\n</"}) {
    EXPECT_EQ(CountOf(text, part), 1U) << part << " in\n" << text;
  }
}

TEST(MeshFiles, NamesStayInTheirLine) {
  PlanSubject subject = MadeSubject();
  subject.surface = "a\nv 1 2 3\r";
  EXPECT_EQ(CountOf(MeshObj(MadeMesh(), subject), "\nv "), 3U);
  EXPECT_EQ(CountOf(MeshPly(MadeMesh(), subject), "\r"), 0U);
}

TEST(MeshNotes, SayWhatWasMeasured) {
  IsoMesh mesh = MadeMesh();
  const auto notes = MeshNotes(mesh);
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0],
            "the mesh has 3 vertices and 1 triangle, with angles from 12 "
            "degrees");
  EXPECT_EQ(notes[1],
            "interpolation in it was found wrong by 0.013 at most, 0.004 in "
            "99 % of the points, 0.0001 on the average [W/m^2]");
  EXPECT_EQ(notes[2],
            "a uniform mesh of 5 vertices: 0.5 at most, 0.25 in 99 % of the "
            "points, 0.13 on the average");
  mesh.unfinished = 1;
  mesh.drawn = 2;
  mesh.most_drawn = 0.00211;
  const auto more = MeshNotes(mesh);
  ASSERT_EQ(more.size(), 5U);
  EXPECT_EQ(more[3],
            "1 triangle is wrong by more than 0.01 and not divided: too small, "
            "or the mesh has too many vertices");
  EXPECT_EQ(more[4],
            "2 vertices of contours are drawn to the corners of lines, by "
            "0.0022 at most");
}

}  // namespace
}  // namespace truelux
