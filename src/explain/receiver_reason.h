// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver sees, and what may make it hard for other methods.

#ifndef TRUELUX_EXPLAIN_RECEIVER_REASON_H_
#define TRUELUX_EXPLAIN_RECEIVER_REASON_H_

#include <optional>
#include <string>
#include <string_view>

#include "truelux/receiver.h"
#include "truelux/scene.h"
#include "truelux/visibility.h"

namespace truelux {

/// What is visible of the sources, in a word.
enum class Lighting {
  kUnlit,     ///< nothing: no source is in front and above the horizon
  kUmbra,     ///< nothing: other faces hide every source that is
  kFullyLit,  ///< no shadow falls on what is seen: only the sources' own
              ///< outlines and the horizon bound it
  kPenumbra,  ///< an edge of something else bounds it somewhere
};

/// The least angle or width that says anything [rad].
inline constexpr double kRounding = 1e-15;

/// Facts about the visible contour of one receiver, all in binary64 and good
/// to a few digits. Angles in radians as seen from the receiver; what is
/// smaller than kRounding is rounding, since the directions of the contour are
/// rounded. The main source is the one whose visible part has the largest
/// vector irradiance (half the sum over its arcs of angle times unit normal of
/// the arc's plane), for small parts its solid angle.
struct ReceiverTraits {
  Lighting lighting = Lighting::kUnlit;
  int sources = 0;       ///< sources of which something is seen
  int arcs = 0;          ///< of all of them
  int horizon_arcs = 0;  ///< arcs that lie on the horizon

  /// Twice the largest angle between the mean direction of the vertices of the
  /// main source's visible part and one of these vertices: how large it looks.
  double extent = 0;
  /// Twice the length of the main source's vector irradiance by the length of
  /// its arcs: how wide a long part is.
  double width = 0;
  /// The shortest arc of all sources.
  double shortest_arc = 0;
  /// Height above the horizon of the highest vertex of all sources, and of the
  /// lowest one that is not on the horizon; 0 and nothing if there is none.
  double highest = 0;
  std::optional<double> lowest;

  /// Over all sources, the sum of the sizes of the terms of Lambert's formula
  /// (half an arc's angle times its plane's unit normal, along the receiver's
  /// normal) by the size of their sum: how many times the rounding errors of
  /// the terms grow in the result. At most 1 / kRounding.
  double cancellation = 1;

  int conjunctions = 0;  ///< conjunctive vertices, see ContourVertex
  int most_planes = 0;   ///< planes through the conjunctive vertex with most
};

/// "unlit", "umbra", "fully lit", "penumbra".
[[nodiscard]] std::string_view Name(Lighting lighting);

/// Whether anything is seen of a source.
[[nodiscard]] inline bool IsLit(const ReceiverTraits& traits) {
  return traits.lighting != Lighting::kUnlit &&
         traits.lighting != Lighting::kUmbra;
}

/// From this on a trait counts as a difficulty:
///
/// tiny source    what is seen of the main source spans less than a thousandth
///                of a radian, 0.06 degrees: its area or angle is a difference
///                of numbers a thousand times as large.
inline constexpr double kTinyExtent = 1e-3;
/// sliver         it is more than a thousand times as long as wide.
inline constexpr double kSliverRatio = 1e-3;
/// grazing        everything that is seen lies less than a hundredth of a
///                radian above the horizon, so that all cosines are small; or
inline constexpr double kGrazingHighest = 1e-2;
///                a vertex lies less than a millionth of a radian above the
///                horizon without being on it, so that methods disagree about
///                its side.
inline constexpr double kGrazingLowest = 1e-6;
/// cancellation   the terms of Lambert's formula are more than a hundred times
///                as large as their sum.
inline constexpr double kCancellation = 100;
/// short arc      an arc is shorter than a millionth of a radian and of the
///                extent: two vertices that all but coincide.
inline constexpr double kShortArc = 1e-6;
/// conjunction    any vertex at which several vertices coincide exactly.

[[nodiscard]] ReceiverTraits TraitsOf(const Scene& scene,
                                      const Receiver& receiver,
                                      const VisibleContour& contour);

/// The traits as a reader wants them: what is seen, and after a semicolon what
/// is hard about it, if anything. "penumbra, 12 arcs; conjunction (4 planes),
/// sliver (5e-08 wide)".
[[nodiscard]] std::string TextOf(const ReceiverTraits& traits);

/// TextOf(TraitsOf(...)).
[[nodiscard]] std::string ReasonOf(const Scene& scene, const Receiver& receiver,
                                   const VisibleContour& contour);

}  // namespace truelux

#endif  // TRUELUX_EXPLAIN_RECEIVER_REASON_H_
