// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/mesh_notes.h"

#include <cstddef>
#include <fmt/format.h>

#include "plan/plan_notes.h"

namespace truelux {
namespace {

std::string ErrorText(const InterpolationError& error) {
  return fmt::format("{} at most, {} in 99 % of the points, {} on the average",
                     ShortBound(error.most), ShortBound(error.at_99),
                     ShortBound(error.mean));
}

}  // namespace

std::vector<std::string> MeshNotes(const IsoMesh& mesh) {
  std::vector<std::string> notes;
  notes.push_back(
      fmt::format("the mesh has {} and {}, with angles from {} degrees",
                  Counted(mesh.vertices.size(), "vertex", "vertices"),
                  Counted(mesh.triangles.size(), "triangle", "triangles"),
                  ShortNumber(mesh.least_angle)));
  notes.push_back("interpolation in it was found wrong by " +
                  ErrorText(mesh.interpolation) + " [W/m^2]");
  notes.push_back(
      fmt::format("a uniform mesh of {} vertices: ", mesh.uniform_vertices) +
      ErrorText(mesh.uniform));
  if (mesh.unfinished > 0) {
    notes.push_back(fmt::format(
        "{} wrong by more than {} and not divided: too small, or the mesh has "
        "too many vertices",
        Counted(mesh.unfinished, "triangle is", "triangles are"),
        ShortNumber(mesh.error)));
  }
  if (mesh.drawn > 0) {
    notes.push_back(fmt::format(
        "{} drawn to the corners of lines, by {} at most",
        Counted(static_cast<std::size_t>(mesh.drawn), "vertex of a contour is",
                "vertices of contours are"),
        ShortBound(mesh.most_drawn)));
  }
  return notes;
}

}  // namespace truelux
