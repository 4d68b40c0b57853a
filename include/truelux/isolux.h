// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of light on a flat surface: where irradiance or its gradient jumps, and
// contours of equal irradiance. In the library truelux_tools.
//
// Source: Arvo, The Irradiance Jacobian for Partially Occluded Polyhedral
// Sources, 1994, section 5 (isolux contours, discontinuities); docs/isolux.md
// tells what is proven and how.

#ifndef TRUELUX_ISOLUX_H_
#define TRUELUX_ISOLUX_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/export.h"
#include "truelux/geometry.h"
#include "truelux/irradiance.h"
#include "truelux/picture.h"
#include "truelux/progress.h"

namespace truelux {

/// What happens across a straight line on a surface.
enum class SurfaceLineKind {
  kJump,  ///< "jump": a face stands there, or goes through; E may jump
  kKink,  ///< "kink": E is continuous, and its gradient jumps
};

/// The word in quotes above.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(SurfaceLineKind kind);

/// A piece of such a line; all its points are alike.
struct SurfaceLine {
  SurfaceLineKind kind = SurfaceLineKind::kKink;
  /// In the scene's frame. The line itself is exact; each coordinate is rounded
  /// once.
  std::array<Point3, 2> ends;
  /// Numbers: of the faces that stand there; of a kink, of those that lie in the
  /// plane and are seen edge-on.
  std::vector<int> faces;
  /// Of a kink: edges that cover each other as seen from the line, by indices
  /// into Scene::vertices(), the lower one first; -1: a line where faces pierce each
  /// other.
  std::vector<std::array<int, 2>> edges;
  /// Of a kink: b in the middle [W/m^3]: beside the line the gradient jumps by
  /// 2 b m, m the unit normal of the plane through the edges. It may pass
  /// through 0 there.
  Rgb size{};
  /// Of a jump: E in the middle [W/m^2], 2^-36 of the surface's size (at least
  /// 2^-48 of the coordinates) to the left and to the right of the way from end
  /// to end, as seen from the lit side.
  Rgb left{};
  Rgb right{};
};

/// The lines of a surface.
struct SurfaceLines {
  std::vector<SurfaceLine> lines;
  /// False if the scene has so many edges that only those were looked at in
  /// pairs that meet in a vertex.
  bool is_complete = true;
  std::vector<Diagnostic> notes;  ///< what the user should know
};

/// All lines on a flat surface, by the name of its object or group, as truelux
/// render takes it. Which lines there are is decided exactly. By `oracle`: its
/// scene, engine, emission and stop flag. Throws std::invalid_argument if there
/// is no such surface or it is not flat, and Stopped.
[[nodiscard]] TRUELUX_EXPORT SurfaceLines
SurfaceLinesOf(const Oracle& oracle, const std::string& surface);

/// Where a vertex of a contour lies.
enum class ContourPlace {
  kInside,   ///< "inside"
  kKink,     ///< "kink": on a line across which the gradient jumps
  kJump,     ///< "jump": at a face that stands on the surface; contours end
  kOutline,  ///< "outline": at the surface's outline, likewise
};

/// The word in quotes above.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(ContourPlace place);

/// A vertex of a contour with its transversal, the segment from
/// at - half_width across to at + half_width across.
struct IsoluxVertex {
  Point3 at;
  Vector3 across;         ///< of length 1, along the surface, to larger E
  double half_width = 0;  ///< [length]
  /// Whether E was found, certified, below the level at the first end of the
  /// transversal and above it at the second. E is continuous between them, so
  /// that the contour passes there.
  bool is_certified = false;
  ContourPlace on = ContourPlace::kInside;
};

/// A line on which E is a level, with what is larger on its left as seen from
/// the lit side.
struct IsoluxContour {
  double level = 0;  ///< [W/m^2]
  /// The number of a face of the surface that looks to the contour's side, for
  /// Receiver::on_face: faces of a surface may look to both.
  int face = 0;
  bool is_closed = false;
  std::vector<IsoluxVertex> vertices;
  /// The chord that begins at vertex k, of a closed line also that from the last
  /// vertex to the first: how far the contour is from it at most [length]; +inf:
  /// not known.
  std::vector<double> widths;
};

/// A triangle in which it is not proven which contours there are.
struct OpenTriangle {
  std::array<Point3, 3> corners;
  /// E lies in this range [W/m^2]; 0 and the largest exitance if nothing better
  /// is known.
  double least = 0;
  double most = 0;
};

/// What is asked for. 0 chooses what suits the surface.
struct IsoluxOptions {
  /// Ascending, > 0 [W/m^2]; none: `count` levels with equal steps between the
  /// least and the largest value that were met, rounded to three digits or to
  /// as many as keep them apart.
  std::vector<double> levels;
  int count = 10;
  /// What contours are of; nothing: luminance, 0.2126 R + 0.7152 G + 0.0722 B,
  /// or the one value of a scene whose channels are all alike.
  std::optional<ScalarChannel> channel;
  double half_width = 0;  ///< of transversals [length]; 0: 1e-9 of the size
  double chord = 0;     ///< most width of a chord [length]; 0: 1e-3 of the size
  double smallest = 0;  ///< triangles get no smaller [length]; 0: 2^-18
  std::size_t most_triangles = 0;  ///< 0: 4 million
  int threads = 1;                 ///< 1 .. 1024
  ProgressHook progress{};
};

/// Contours, with what is known about those that are missing.
struct Isolux {
  std::vector<double> levels;
  std::vector<IsoluxContour> contours;  ///< by levels
  SurfaceLines lines;
  /// Of length 1, along the surface: as the lit side of the first face is seen,
  /// `right` is to the right and `up`, the normal x `right`, is up. `right` is
  /// the direction of the first side of that face, u of truelux render.
  Vector3 right{};
  Vector3 up{};
  /// The surface's outline, walls or not, each of its sides once.
  std::vector<std::array<Point3, 2>> outline;
  /// What was not found lies in these triangles; all other parts of the surface
  /// (but for a margin of 2^-36 of its size, at least 2^-48 of the coordinates,
  /// along outlines and jumps) have the contours that are listed and no others.
  /// Where E is constant and is a level, there are no contours but open
  /// triangles.
  std::vector<OpenTriangle> open;
  double size = 0;       ///< longer side of the surface's extent [length]
  double area = 0;       ///< [length^2]
  double open_area = 0;  ///< of `open`
  double dark_area = 0;  ///< at least so much has E = 0, proven
  double least = 0;      ///< the least E that was met [W/m^2]
  double most = 0;       ///< the largest
  std::uint64_t search_evaluations = 0;  ///< to settle what is where
  std::uint64_t line_evaluations = 0;    ///< for vertices and chords
  std::size_t triangles = 0;
};

/// What a critical point is.
enum class ExtremumKind {
  kMaximum,  ///< "maximum": E is nowhere larger near it
  kMinimum,  ///< "minimum"
  kSaddle,   ///< "saddle"
};

/// The word in quotes above.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(ExtremumKind kind);

/// A local maximum, minimum or saddle of E on a surface.
struct SurfaceExtremum {
  ExtremumKind kind = ExtremumKind::kMaximum;
  Point3 at;         ///< the best point that was met
  double value = 0;  ///< E there [W/m^2]
  /// The extremum, or E in the saddle, is proven to be in this range, and not
  /// farther away from `at` than the radius [length]. More than one critical
  /// point so near would not be told apart.
  double least = 0;
  double most = 0;
  double radius = 0;
  ContourPlace on = ContourPlace::kInside;
};

/// A part of a surface that may have further critical points.
struct UndecidedRegion {
  std::vector<std::array<Point3, 3>> triangles;
  double least = 0;  ///< E is in this range there [W/m^2]
  double most = 0;
};

/// What is known of the critical points of a surface.
struct SurfaceExtrema {
  std::vector<SurfaceExtremum> points;
  /// All critical points that are not among the points lie here, or where E is
  /// proven to be 0.
  std::vector<UndecidedRegion> undecided;
  double undecided_area = 0;  ///< [length^2]
  double area = 0;
  double dark_area = 0;  ///< at least so much has E = 0, proven
  double least = 0;      ///< E on the whole surface is proven to be in this
  double most = 0;       ///< range [W/m^2]
  double size = 0;       ///< as in Isolux
  std::uint64_t evaluations = 0;
  std::vector<Diagnostic> notes;
};

/// What is asked for.
struct ExtremaOptions {
  std::optional<ScalarChannel> channel;  ///< as in IsoluxOptions
  int threads = 1;                       ///< 1 .. 1024
  ProgressHook progress{};
};

/// All local maxima, minima and saddles of E on a flat surface, those at its
/// outline, at walls and on kinks included. By `oracle`, as IsoluxOf. Throws as
/// IsoluxOf does.
[[nodiscard]] TRUELUX_EXPORT SurfaceExtrema
ExtremaOf(const Oracle& oracle, const std::string& surface,
          const ExtremaOptions& options);

/// The contours of a flat surface. By `oracle`: its method, engine, emission and
/// stop flag. The result does not depend on threads.
///
/// Throws std::invalid_argument as SurfaceLinesOf does, and for a level that is
/// not above 0 or not finite, levels that do not ascend, or a number outside its
/// range; and Stopped.
[[nodiscard]] TRUELUX_EXPORT Isolux IsoluxOf(const Oracle& oracle,
                                             const std::string& surface,
                                             const IsoluxOptions& options);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_H_
