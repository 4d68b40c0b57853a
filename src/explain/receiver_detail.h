// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver sees, with the edges that make it hard by name.

#ifndef TRUELUX_EXPLAIN_RECEIVER_DETAIL_H_
#define TRUELUX_EXPLAIN_RECEIVER_DETAIL_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "explain/receiver_reason.h"
#include "visibility/edges/contour_engine.h"
#include "visibility/view/seen_edge.h"
#include "visibility/visible_contour.h"

namespace truelux {

/// A vertex of the visible contour in which several vertices coincide.
struct MeetingEdges {
  int planes = 0;               ///< as ContourVertex::planes
  bool on_horizon = false;      ///< the horizon is one of them
  std::vector<SeenEdge> edges;  ///< that pass through it or end there
};

/// An edge that all but passes through a vertex of the visible contour.
struct NearConjunction {
  SeenEdge edge;
  double angle = 0;  ///< from the vertex [rad], > 0
};

/// A near-conjunction is worth a word below this angle [rad].
inline constexpr double kNearConjunction = 1e-6;

struct ReceiverDetail {
  ReceiverTraits traits;
  std::vector<MeetingEdges> meetings;  ///< of every conjunctive vertex
  /// The smallest angle of all vertices; nothing if nothing is seen.
  std::optional<NearConjunction> nearest;
};

[[nodiscard]] ReceiverDetail DetailOf(const Scene& scene,
                                      const Receiver& receiver,
                                      const ContourInDetail& contour);

/// TextOf(traits), and what all but meets, if it is near enough.
[[nodiscard]] std::string SummaryOf(const ReceiverDetail& detail);

/// One line for each conjunctive vertex, which edges meet there, and one for
/// the near-conjunction; at most `most` lines and one that counts the rest.
[[nodiscard]] std::vector<std::string> LinesOf(const Scene& scene,
                                               const ReceiverDetail& detail,
                                               std::size_t most);

/// Finds contours in detail; for any thread.
class DetailFinder {
 public:
  explicit DetailFinder(const Scene& scene) : engine_(scene) {}

  /// With edges if in_detail, otherwise the traits alone, which is cheaper.
  [[nodiscard]] ReceiverDetail Find(const Receiver& receiver,
                                    bool in_detail) const;

 private:
  ContourEngine engine_;
};

}  // namespace truelux

#endif  // TRUELUX_EXPLAIN_RECEIVER_DETAIL_H_
