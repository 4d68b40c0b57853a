// A validated, immutable scene: polygons that emit, block, or both.

#ifndef TRUELUX_SCENE_H_
#define TRUELUX_SCENE_H_

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/geometry.h"

namespace truelux {

/// A face of the input, in input order. Its `number` is its index + 1; a face
/// without area keeps its number but has no facets.
struct Face {
  Rgb emission{};        ///< Ke of its material; (0, 0, 0): a pure blocker
  int line = 0;          ///< line of its f statement; 0: made in code
  int first_facet = 0;   ///< its facets are first_facet ..
  int facet_count = 0;   ///< .. first_facet + facet_count - 1
  int group = 0;         ///< index into Scene::group_names()
  int first_corner = 0;  ///< its corners are first_corner ..
  int corner_count = 0;  ///< .. first_corner + corner_count - 1
};

/// An exactly planar part of a face: the face itself, or one triangle of a
/// face that is not planar. A facet is one source and one blocker.
struct Facet {
  int face = 0;            ///< index into Scene::faces()
  int first_triangle = 0;  ///< its triangles are first_triangle ..
  int triangle_count = 0;  ///< .. first_triangle + triangle_count - 1
};

/// A triangle of a facet, counter-clockwise seen from the facet's front.
/// Its three points are never on one line.
struct Triangle {
  std::array<int, 3> vertices{};  ///< indices into Scene::vertices()
  int facet = 0;                  ///< index into Scene::facets()
};

/// Immutable; copies share the data. Equal points are one vertex, so that two
/// triangles share an edge exactly if they share its two vertex indices.
class Scene {
 public:
  Scene();  ///< no faces: every irradiance is 0

  [[nodiscard]] std::span<const Point3> vertices() const;
  [[nodiscard]] std::span<const Triangle> triangles() const;
  [[nodiscard]] std::span<const Facet> facets() const;
  [[nodiscard]] std::span<const Face> faces() const;
  /// The rings of all faces, one after the other, as indices into vertices():
  /// each from the first corner of the input, without equal neighbours.
  [[nodiscard]] std::span<const int> corners() const;
  /// Names of objects and groups as "object/group"; entry 0 is "".
  [[nodiscard]] std::span<const std::string> group_names() const;

 private:
  friend class SceneBuilder;
  friend class SceneVariants;
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// Builds a scene in code, face by face, and validates it as a whole.
///
/// Example
///   SceneBuilder builder;
///   builder.AddFace({{0, 0, 1}, {0, 1, 1}, {1, 0, 1}}, {1, 1, 1});
///   Result<Scene> scene = builder.Build();
class SceneBuilder {
 public:
  /// `file_name` prefixes the diagnostics.
  explicit SceneBuilder(std::string file_name = "");
  ~SceneBuilder();
  SceneBuilder(SceneBuilder&&) noexcept;
  SceneBuilder& operator=(SceneBuilder&&) noexcept;

  /// Adds a polygon. ring: n x 3, counter-clockwise seen from the side that
  /// emits, not closed. emission: Ke [W/m^2, or W/m^2/sr if the oracle reads
  /// radiance], all >= 0. line: for diagnostics. Returns the face's number,
  /// counted from 1. Defects are reported by Build().
  int AddFace(std::vector<Point3> ring, const Rgb& emission = {}, int line = 0);

  /// Names the object or group of the faces that follow.
  void SetGroup(std::string_view name);

  /// The scene, or every defect of it: a coordinate or an emission that is
  /// not finite, a negative emission, a ring with fewer than 3 points, a
  /// polygon that is not simple seen along its Newell normal. Notes: faces
  /// without area (ignored), faces that are not planar (split in triangles).
  /// The builder is empty afterwards.
  Result<Scene> Build();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_H_
