// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of a surface for its picture.

#ifndef TRUELUX_IMAGE_PICTURE_CONTOURS_H_
#define TRUELUX_IMAGE_PICTURE_CONTOURS_H_

#include <string>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/picture.h"

#include "run/watch.h"

namespace truelux {

/// PictureContoursOf of truelux/render.h, with the watch in place of the hook and
/// the oracle's stop flag.
[[nodiscard]] std::vector<PictureContour> FindPictureContours(
    const Oracle& oracle, const std::string& surface,
    const IrradianceImage& image, const PictureStyle& style, int threads,
    const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PICTURE_CONTOURS_H_
