// SPDX-License-Identifier: GPL-3.0-or-later
// Faces -> the arrays of a scene, and what is wrong with them.

#ifndef TRUELUX_SCENE_SCENE_ASSEMBLY_H_
#define TRUELUX_SCENE_SCENE_ASSEMBLY_H_

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/scene.h"

#include "scene/point_index.h"
#include "scene/polygon.h"
#include "scene/scene_data.h"

namespace truelux {

/// Validates faces one by one and turns them into facets and triangles.
class SceneAssembly {
 public:
  explicit SceneAssembly(std::string file_name);

  /// Whether faces that are no polygons are left out from now on, instead of
  /// being errors.
  void set_lenient(bool lenient) { lenient_ = lenient; }

  /// Whether faces that emit do so to both sides from now on.
  void set_two_sided(bool two_sided) { two_sided_ = two_sided; }

  /// Adds a face with line and group set that is left out for a reason.
  void LeaveOut(Face face, std::string_view reason);

  /// Adds a face with emission, line and group set. ring: n x 3. numbers: of
  /// its vertices in the input; as many as the ring has, or none.
  void AddFace(Face face, std::span<const Point3> ring,
               std::span<const int> numbers = {});

  [[nodiscard]] int face_count() const {
    return static_cast<int>(arrays_.faces.size());
  }

  /// Every defect, in the order of faces, then the notes.
  std::vector<Diagnostic> TakeDiagnostics();

  /// The arrays, without names of groups. Meaningless if there are errors.
  SceneArrays TakeArrays();

 private:
  /// Faces that are remarked on together.
  struct Tally {
    int count = 0;
    int first_face = 0;  ///< index
  };

  bool CheckNumbers(std::span<const Point3> ring);
  void TakeRing(std::span<const Point3> ring);
  void BeginFace(Face face);
  void AddPolygon();
  void AddBacks();
  void AddFacet(std::span<const RingTriangle> triangles);
  void CountFace(Tally& tally) const;
  void ReportError(const std::string& message);
  void LeaveOutLast(std::string_view reason);
  void ReportNoPolygon();
  void ReportLeftOut(const LeftOutFaces& left_out);
  [[nodiscard]] std::string PlaceOf(int face) const;
  void ReportTally(const Tally& tally, const std::string& one,
                   const std::string& many);

  std::string file_name_;
  SceneArrays arrays_;  ///< the current face is the last
  PointIndex points_;
  PolygonReader polygon_;
  bool lenient_ = false;
  bool two_sided_ = false;

  /// A corner of the current face: index in the scene, and number from 1 among
  /// the corners of the face.
  struct RingCorner {
    int vertex = 0;
    int number = 0;
  };

  // The current ring without consecutive duplicates and spikes.
  std::vector<RingCorner> ring_;
  std::vector<Point3> ring_points_;
  /// Index into SceneArrays::left_out.
  std::unordered_map<std::string, std::size_t> reasons_;
  std::vector<Diagnostic> diagnostics_;
  Tally without_area_;
  Tally not_planar_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_SCENE_ASSEMBLY_H_
