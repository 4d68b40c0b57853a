// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_assembly.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace truelux {
namespace {

bool IsFinite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool IsEmission(const Rgb& emission) {
  return std::ranges::all_of(
      emission, [](double e) { return std::isfinite(e) && e >= 0; });
}

}  // namespace

SceneAssembly::SceneAssembly(std::string file_name)
    : file_name_(std::move(file_name)) {}

void SceneAssembly::AddFace(Face face, std::span<const Point3> ring) {
  face.first_facet = static_cast<int>(arrays_.facets.size());
  face.facet_count = 0;
  face.first_corner = static_cast<int>(arrays_.corners.size());
  face.corner_count = 0;
  for (double& e : face.emission) {
    if (e == 0) e = 0;  // also -0
  }
  arrays_.faces.push_back(face);
  if (!CheckNumbers(ring)) return;
  TakeRing(ring);
  arrays_.corners.insert(arrays_.corners.end(), ring_vertices_.begin(),
                         ring_vertices_.end());
  arrays_.faces.back().corner_count = static_cast<int>(ring_vertices_.size());
  if (ring_points_.size() < 3) {
    CountFace(without_area_);
  } else {
    AddPolygon();
  }
}

bool SceneAssembly::CheckNumbers(std::span<const Point3> ring) {
  if (ring.size() < 3) {
    ReportError("a face with " + std::to_string(ring.size()) +
                " vertices, expected at least 3");
    return false;
  }
  if (!std::ranges::all_of(ring, IsFinite)) {
    ReportError("a coordinate is not finite, expected finite numbers");
    return false;
  }
  if (!IsEmission(arrays_.faces.back().emission)) {
    ReportError(
        "the emission is negative or not finite, expected finite "
        "numbers >= 0");
    return false;
  }
  return true;
}

void SceneAssembly::TakeRing(std::span<const Point3> ring) {
  ring_vertices_.clear();
  ring_points_.clear();
  ring_corners_.clear();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const int vertex = points_.Insert(ring[i]);
    if (!ring_vertices_.empty() && ring_vertices_.back() == vertex) continue;
    ring_vertices_.push_back(vertex);
    ring_points_.push_back(ring[i]);
    ring_corners_.push_back(static_cast<int>(i) + 1);
  }
  while (ring_vertices_.size() > 1 &&
         ring_vertices_.front() == ring_vertices_.back()) {
    ring_vertices_.pop_back();
    ring_points_.pop_back();
    ring_corners_.pop_back();
  }
}

void SceneAssembly::AddPolygon() {
  switch (polygon_.Read(ring_points_)) {
    case PolygonKind::kNoArea:
      CountFace(without_area_);
      break;
    case PolygonKind::kZeroNormal:
      ReportError(
          "not a simple polygon: its Newell normal is zero, expected a "
          "boundary that nowhere meets itself");
      break;
    case PolygonKind::kNotSimple:
      ReportContact();
      break;
    case PolygonKind::kPlanar:
      AddFacet(polygon_.triangles());
      break;
    case PolygonKind::kNotPlanar:
      CountFace(not_planar_);
      for (const RingTriangle& triangle : polygon_.triangles()) {
        AddFacet({&triangle, 1});
      }
      break;
  }
}

void SceneAssembly::AddFacet(std::span<const RingTriangle> triangles) {
  const int facet = static_cast<int>(arrays_.facets.size());
  arrays_.facets.push_back({face_count() - 1,
                            static_cast<int>(arrays_.triangles.size()),
                            static_cast<int>(triangles.size())});
  ++arrays_.faces.back().facet_count;
  const auto vertex = [this](int i) {
    return ring_vertices_[static_cast<std::size_t>(i)];
  };
  for (const RingTriangle& t : triangles) {
    arrays_.triangles.push_back(
        {{vertex(t[0]), vertex(t[1]), vertex(t[2])}, facet});
  }
}

void SceneAssembly::CountFace(Tally& tally) const {
  if (tally.count++ == 0) tally.first_face = face_count() - 1;
}

void SceneAssembly::ReportError(const std::string& message) {
  const int line = arrays_.faces.back().line;
  const std::string where =
      line > 0 ? "" : "face " + std::to_string(face_count()) + ": ";
  diagnostics_.push_back({Severity::kError, file_name_, line, where + message});
}

void SceneAssembly::ReportContact() {
  const auto edge = [this](int i) {
    const auto first = static_cast<std::size_t>(i);
    const std::size_t second = first + 1 < ring_corners_.size() ? first + 1 : 0;
    return std::to_string(ring_corners_[first]) + "-" +
           std::to_string(ring_corners_[second]);
  };
  ReportError("not a simple polygon: its edges " +
              edge(polygon_.contact().first_edge) + " and " +
              edge(polygon_.contact().second_edge) +
              " meet (vertices of the face counted from 1), expected a "
              "boundary that nowhere meets itself");
}

void SceneAssembly::ReportTally(const Tally& tally, const std::string& one,
                                const std::string& many) {
  if (tally.count == 0) return;
  const int line =
      arrays_.faces[static_cast<std::size_t>(tally.first_face)].line;
  const std::string first =
      line > 0 ? "line " + std::to_string(line)
               : "face " + std::to_string(tally.first_face + 1);
  diagnostics_.push_back({Severity::kNote, file_name_, line,
                          std::to_string(tally.count) +
                              (tally.count == 1 ? one : many) + ", first at " +
                              first});
}

std::vector<Diagnostic> SceneAssembly::TakeDiagnostics() {
  ReportTally(without_area_, " face without area is ignored",
              " faces without area are ignored");
  ReportTally(not_planar_, " face is not planar and is split into triangles",
              " faces are not planar and are split into triangles");
  return std::exchange(diagnostics_, {});
}

SceneArrays SceneAssembly::TakeArrays() {
  arrays_.vertices = points_.TakePoints();
  return std::exchange(arrays_, {});
}

}  // namespace truelux
