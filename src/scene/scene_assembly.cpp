// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_assembly.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/diagnostic_list.h"
#include "scene/emitters.h"
#include "scene/ring_spikes.h"

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

void AppendBacks(int first_facet, int end, SceneArrays& arrays) {
  for (int i = first_facet; i < end; ++i) {
    Facet back = arrays.facets[static_cast<std::size_t>(i)];
    const auto first = static_cast<std::size_t>(back.first_triangle);
    const auto count = static_cast<std::size_t>(back.triangle_count);
    back.is_back = true;
    back.first_triangle = static_cast<int>(arrays.triangles.size());
    for (std::size_t k = first; k < first + count; ++k) {
      Triangle triangle = arrays.triangles[k];
      std::swap(triangle.vertices[1], triangle.vertices[2]);
      triangle.facet = static_cast<int>(arrays.facets.size());
      arrays.triangles.push_back(triangle);
    }
    arrays.facets.push_back(back);
  }
}

void SceneAssembly::BeginFace(Face face) {
  face.first_facet = static_cast<int>(arrays_.facets.size());
  face.facet_count = 0;
  face.first_corner = static_cast<int>(arrays_.corners.size());
  face.corner_count = 0;
  for (double& e : face.emission) {
    if (e == 0) e = 0;  // also -0
  }
  face.is_emitter = Emits(face);
  arrays_.faces.push_back(face);
}

void SceneAssembly::AddFace(Face face, std::span<const Point3> ring,
                            std::span<const int> numbers) {
  BeginFace(face);
  if (!CheckNumbers(ring)) return;
  TakeRing(ring);
  for (const RingCorner& corner : ring_) {
    arrays_.corners.push_back(corner.vertex);
    if (numbers.empty()) continue;
    arrays_.corner_numbers.push_back(
        numbers[static_cast<std::size_t>(corner.number - 1)]);
  }
  arrays_.faces.back().corner_count = static_cast<int>(ring_.size());
  if (ring_.size() < 3) {
    CountFace(without_area_);
  } else {
    AddPolygon();
    if (two_sided_ && arrays_.faces.back().is_emitter) AddBacks();
  }
}

void SceneAssembly::LeaveOut(Face face, std::string_view reason) {
  BeginFace(face);
  LeaveOutLast(reason);
}

void SceneAssembly::LeaveOutLast(std::string_view reason) {
  const auto [entry, is_new] =
      reasons_.try_emplace(std::string(reason), arrays_.left_out.size());
  if (is_new) arrays_.left_out.push_back({std::string(reason), {}});
  arrays_.left_out[entry->second].numbers.push_back(face_count());
}

bool SceneAssembly::CheckNumbers(std::span<const Point3> ring) {
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
  ring_.clear();
  ring_points_.clear();
  int number = 0;
  for (const Point3& point : ring) {
    const int vertex = points_.Insert(point);
    ++number;
    if (!ring_.empty() && ring_.back().vertex == vertex) continue;
    ring_.push_back({vertex, number});
  }
  while (ring_.size() > 1 && ring_.front().vertex == ring_.back().vertex)
    ring_.pop_back();
  RemoveSpikes(ring_, [](const RingCorner& a, const RingCorner& b) {
    return a.vertex == b.vertex;
  });
  for (const RingCorner& corner : ring_)
    ring_points_.push_back(ring[static_cast<std::size_t>(corner.number - 1)]);
}

void SceneAssembly::AddPolygon() {
  switch (polygon_.Read(ring_points_)) {
    case PolygonKind::kNoArea:
      CountFace(without_area_);
      break;
    case PolygonKind::kNoPolygon:
      if (lenient_) {
        LeaveOutLast("no polygon, the boundary crosses itself");
      } else {
        ReportNoPolygon();
      }
      break;
    case PolygonKind::kTooLarge:
      if (lenient_) {
        LeaveOutLast("too many corners for a face that is not planar");
      } else {
        ReportError(
            "the face is not planar and has " + std::to_string(ring_.size()) +
            " corners, expected at most " + std::to_string(kMostNotPlanar) +
            "; --lenient leaves it out");
      }
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
  arrays_.facets.push_back({face_count() - 1, false,
                            static_cast<int>(arrays_.triangles.size()),
                            static_cast<int>(triangles.size())});
  ++arrays_.faces.back().facet_count;
  const auto vertex = [this](int i) {
    return ring_[static_cast<std::size_t>(i)].vertex;
  };
  for (const RingTriangle& t : triangles) {
    arrays_.triangles.push_back(
        {{vertex(t[0]), vertex(t[1]), vertex(t[2])}, facet});
  }
}

/// Adds every facet of the last face once more, turned round.
void SceneAssembly::AddBacks() {
  const Face& face = arrays_.faces.back();
  const int end = face.first_facet + face.facet_count;
  AppendBacks(face.first_facet, end, arrays_);
  arrays_.faces.back().facet_count *= 2;
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

void SceneAssembly::ReportNoPolygon() {
  const auto edge = [this](int i) {
    const auto first = static_cast<std::size_t>(i);
    const std::size_t second = first + 1 < ring_.size() ? first + 1 : 0;
    return std::to_string(ring_[first].number) + "-" +
           std::to_string(ring_[second].number);
  };
  ReportError("no polygon: its edges " + edge(polygon_.contact().first_edge) +
              " and " + edge(polygon_.contact().second_edge) +
              " meet (vertices of the face counted from 1), and some points "
              "are enclosed other than once, expected a boundary that does not "
              "cross itself (--lenient leaves such faces out)");
}

std::string SceneAssembly::PlaceOf(int face) const {
  const int line = arrays_.faces[static_cast<std::size_t>(face)].line;
  return line > 0 ? "line " + std::to_string(line)
                  : "face " + std::to_string(face + 1);
}

void SceneAssembly::ReportLeftOut(const LeftOutFaces& left_out) {
  const std::size_t count = left_out.numbers.size();
  const std::string places = FirstTen(
      count, [&](std::size_t i) { return PlaceOf(left_out.numbers[i] - 1); });
  const int first = left_out.numbers.front() - 1;
  diagnostics_.push_back(
      {Severity::kNote, file_name_,
       arrays_.faces[static_cast<std::size_t>(first)].line,
       std::to_string(count) + (count == 1 ? " face is" : " faces are") +
           " left out: " + left_out.reason + " (" + places + ")"});
}

void SceneAssembly::ReportTally(const Tally& tally, const std::string& one,
                                const std::string& many) {
  if (tally.count == 0) return;
  const int line =
      arrays_.faces[static_cast<std::size_t>(tally.first_face)].line;
  diagnostics_.push_back({Severity::kNote, file_name_, line,
                          std::to_string(tally.count) +
                              (tally.count == 1 ? one : many) + ", first at " +
                              PlaceOf(tally.first_face)});
}

std::vector<Diagnostic> SceneAssembly::TakeDiagnostics() {
  ReportTally(without_area_, " face without area is ignored",
              " faces without area are ignored");
  ReportTally(not_planar_, " face is not planar and is split into triangles",
              " faces are not planar and are split into triangles");
  for (const LeftOutFaces& left_out : arrays_.left_out)
    ReportLeftOut(left_out);
  return std::exchange(diagnostics_, {});
}

SceneArrays SceneAssembly::TakeArrays() {
  arrays_.vertices = points_.TakePoints();
  return std::exchange(arrays_, {});
}

}  // namespace truelux
