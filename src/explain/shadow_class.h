// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver gets of the sources, as one word a pixel.

#ifndef TRUELUX_EXPLAIN_SHADOW_CLASS_H_
#define TRUELUX_EXPLAIN_SHADOW_CLASS_H_

#include <cstdint>

#include "truelux/receiver.h"
#include "truelux/scene.h"
#include "truelux/visibility.h"

namespace truelux {

enum class ShadowClass : std::uint8_t {
  kNothing,      ///< no receiver
  kNoSource,     ///< no source looks to the receiver from above its horizon
  kUmbra,        ///< there are such sources, and nothing of them is visible
  kPenumbra,     ///< an edge of something else bounds what is visible
  kLit,          ///< only the sources' outlines and the horizon bound it
  kConjunctive,  ///< a vertex of the contour is conjunctive, lit or penumbra
};

inline constexpr int kShadowClassCount = 6;

/// The name in a legend.
[[nodiscard]] const char* Name(ShadowClass shadow);

/// contour: Oracle::Contour of the receiver.
[[nodiscard]] ShadowClass ShadowClassOf(const Scene& scene,
                                        const Receiver& receiver,
                                        const VisibleContour& contour);

}  // namespace truelux

#endif  // TRUELUX_EXPLAIN_SHADOW_CLASS_H_
