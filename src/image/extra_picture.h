// SPDX-License-Identifier: GPL-3.0-or-later
// What pictures of how an irradiance comes about need.

#ifndef TRUELUX_IMAGE_EXTRA_PICTURE_H_
#define TRUELUX_IMAGE_EXTRA_PICTURE_H_

#include "truelux/picture.h"
#include "truelux/render.h"

namespace truelux {

/// Sets the wish that the picture needs.
void Wish(ExtraPicture extra, PixelWishes& wishes);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_EXTRA_PICTURE_H_
