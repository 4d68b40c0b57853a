// SPDX-License-Identifier: GPL-3.0-or-later
// A validated, immutable scene: polygons that emit, block, or both.

#ifndef TRUELUX_SCENE_H_
#define TRUELUX_SCENE_H_

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/export.h"
#include "truelux/geometry.h"
#include "truelux/receiver.h"

namespace truelux {

/// A polygon of the input, in input order. It emits from its front, the side
/// from which its corners run counter-clockwise (if asked for, from both), and
/// blocks from both sides.
///
/// Its *number* is its index in Scene::faces() plus 1, as f lines are counted:
/// numbers are what receivers, contours and form factors name a face by, 0 is
/// no face. Everything in this header that is called an index counts from 0. A
/// face without area keeps its number but has no facets.
struct Face {
  Rgb emission{};           ///< M [W/m^2] or L [W/m^2/sr], as the oracle's
                            ///< Emission says; (0, 0, 0): the face only blocks
  bool is_emitter = false;  ///< whether the scene's input has it emit, also
                            ///< where a variant of the scene does not: such
                            ///< faces go before others in their plane
  int line = 0;          ///< line of its f statement, from 1; 0: made in code
  int first_facet = 0;   ///< index into Scene::facets(); its facets are
                         ///< first_facet ..
  int facet_count = 0;   ///< .. first_facet + facet_count - 1
  int group = 0;         ///< index into Scene::group_names()
  int first_corner = 0;  ///< index into Scene::corners(); its corners are
                         ///< first_corner ..
  int corner_count = 0;  ///< .. first_corner + corner_count - 1
};

/// An exactly planar part of a face: the face itself, or one triangle of a
/// face that is not planar. A facet is one source and one blocker. A face that
/// emits to both sides has each of them twice: the second is its back.
struct Facet {
  int face = 0;            ///< index into Scene::faces()
  bool is_back = false;    ///< whether it is turned to the back of the face
  int first_triangle = 0;  ///< index into Scene::triangles(); its triangles
                           ///< are first_triangle ..
  int triangle_count = 0;  ///< .. first_triangle + triangle_count - 1
};

/// A triangle of a facet, counter-clockwise seen from the facet's front.
/// Its three points are never on one line.
struct Triangle {
  std::array<int, 3> vertices{};  ///< indices into Scene::vertices()
  int facet = 0;                  ///< index into Scene::facets()
};

/// Faces that a scene is without: they keep their numbers, but neither emit nor
/// block.
struct TRUELUX_EXPORT LeftOutFaces {
  std::string reason;        ///< why, e.g. "a vertex that does not exist"
  std::vector<int> numbers;  ///< of the faces, from 1; ascending
};

/// The face that a receiver lies on up to rounding.
struct NearFace {
  int number = 0;       ///< of the face, from 1
  double distance = 0;  ///< of the receiver to the face's plane (found by a
                        ///< name: to the face) in the scene's unit, within a
                        ///< few ulps
  bool has_second = false;  ///< another face is within the limit, too
};

/// Immutable; copies share the data. Equal points are one vertex, so that two
/// triangles share an edge exactly if they share its two vertex indices.
class TRUELUX_EXPORT Scene {
 public:
  /// A scene without faces: every irradiance is 0.
  Scene();

  /// The corners of all faces, each point once, in the scene's frame.
  [[nodiscard]] std::span<const Point3> vertices() const;
  /// The triangles of all facets, facet by facet.
  [[nodiscard]] std::span<const Triangle> triangles() const;
  /// The facets of all faces, face by face.
  [[nodiscard]] std::span<const Facet> facets() const;
  /// The faces, in input order; face number k is faces()[k - 1].
  [[nodiscard]] std::span<const Face> faces() const;
  /// The rings of all faces, one after the other, as indices into vertices():
  /// each from the first corner of the input, without equal neighbours.
  [[nodiscard]] std::span<const int> corners() const;
  /// The input's number of the vertex of each corner, in the order of
  /// corners(): two vertices of a file in one place keep their numbers. Made in
  /// code without numbers: the index into vertices() plus 1.
  [[nodiscard]] std::span<const int> corner_numbers() const;
  /// Names of objects and groups as "object/group"; entry 0 is "".
  [[nodiscard]] std::span<const std::string> group_names() const;
  /// The faces that were left out on request, reason by reason.
  [[nodiscard]] std::span<const LeftOutFaces> left_out() const;

  /// The face that a receiver near it lies on, for Receiver::on_face. Nothing
  /// if there is none, or if the receiver is not finite or has no normal.
  ///
  /// Of the faces whose plane is at most t away, with the foot of the
  /// perpendicular in the face or at most t away from it, first those count
  /// whose front is turned like the normal (n . m >= |n| |m| / 2), without such
  /// ones those with n . m > 0, then those with n . m < 0; among these the face
  /// whose plane is nearest, then the first one. All is decided exactly. A face
  /// that is not planar counts by its triangles.
  ///
  /// limit: t, finite and >= 0. By default t is 2^-22 of the receiver's largest
  /// coordinate in absolute value plus 2^-20 of the longest edge of the face's
  /// bounding box, which is more than rounding to binary32 moves a point.
  ///
  /// The first call makes the index that oracles share (n log n for n faces).
  /// May be called from several threads.
  [[nodiscard]] std::optional<NearFace> FaceNear(
      const Receiver& receiver, std::optional<double> limit = {}) const;

  /// The same among the faces of an object or a group (as --surface names
  /// them), by the distance to the face and without a limit. Nothing if no face
  /// has the name and an area.
  [[nodiscard]] std::optional<NearFace> FaceNear(const Receiver& receiver,
                                                 std::string_view name) const;

  /// Whether a face within the default limit lies above the receiver, on the
  /// side that its normal points to: a receiver that rounding has moved behind
  /// its own face sees nothing else. Nothing is asked of the face's front.
  [[nodiscard]] bool IsBehindFace(const Receiver& receiver) const;

 private:
  friend class SceneBuilder;
  friend class SceneIndex;
  friend class SceneVariants;
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// Builds a scene in code, face by face, and validates it as a whole. For one
/// thread.
///
/// Example
///   SceneBuilder builder;
///   builder.AddFace({{0, 0, 1}, {0, 1, 1}, {1, 0, 1}}, {1, 1, 1});
///   Result<Scene> scene = builder.Build();
class TRUELUX_EXPORT SceneBuilder {
 public:
  /// `file_name` prefixes the diagnostics.
  explicit SceneBuilder(const std::string& file_name = "");
  ~SceneBuilder();
  SceneBuilder(SceneBuilder&&) noexcept;
  SceneBuilder& operator=(SceneBuilder&&) noexcept;

  /// Adds a polygon. ring: its corners in the scene's frame,
  /// counter-clockwise seen from the side that emits; the first corner need not
  /// be repeated at the end. emission: M [W/m^2], or L [W/m^2/sr] if the oracle
  /// reads radiance; finite and >= 0. line: for diagnostics, from 1; 0: none.
  /// Returns the face's number, counted from 1. Defects are reported by
  /// Build(), not here.
  int AddFace(std::vector<Point3> ring, const Rgb& emission = {}, int line = 0);

  /// Names the vertices of the next face, one number per corner of its ring,
  /// for Scene::corner_numbers(); all faces of a scene have numbers, or none.
  void SetVertexNumbers(std::vector<int> numbers);

  /// Adds a face that only keeps its number, in the place of one that cannot be
  /// taken. reason: for Scene::left_out(). Returns the face's number.
  int LeaveOutFace(std::string_view reason, int line = 0);

  /// Names the object or group of the faces that follow.
  void SetGroup(std::string_view name);

  /// Whether faces that emit do so to both sides, from now on.
  void SetTwoSided(bool two_sided);

  /// Whether rings that are no polygons are left out from now on, with a note,
  /// instead of being errors.
  void SetLenient(bool lenient);

  /// The scene, or every defect of it: a coordinate or an emission that is
  /// not finite, a negative emission, a planar ring that encloses some points
  /// other than once. Notes: faces without area (ignored), faces that are not
  /// planar (split in triangles), faces that were left out. The builder is
  /// empty afterwards, neither lenient nor two-sided.
  [[nodiscard]] Result<Scene> Build();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_H_
