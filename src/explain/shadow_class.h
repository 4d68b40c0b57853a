// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver gets of the sources, as one word a pixel.

#ifndef TRUELUX_EXPLAIN_SHADOW_CLASS_H_
#define TRUELUX_EXPLAIN_SHADOW_CLASS_H_

#include "truelux/receiver.h"
#include "truelux/rendered_pixels.h"
#include "truelux/scene.h"
#include "truelux/visibility.h"

namespace truelux {

/// contour: Oracle::Contour of the receiver.
[[nodiscard]] ShadowClass ShadowClassOf(const Scene& scene,
                                        const Receiver& receiver,
                                        const VisibleContour& contour);

}  // namespace truelux

#endif  // TRUELUX_EXPLAIN_SHADOW_CLASS_H_
