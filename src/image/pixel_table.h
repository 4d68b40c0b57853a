// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels as rows of comma-separated values.

#ifndef TRUELUX_IMAGE_PIXEL_TABLE_H_
#define TRUELUX_IMAGE_PIXEL_TABLE_H_

#include "truelux/irradiance.h"

#include "image/pixel_receivers.h"
#include "image/render_pixels.h"
#include "run/output_file.h"

namespace truelux {

/// Writes "x,y,z,nx,ny,nz,on_face,px,py" and a row for each pixel with a
/// receiver, row of pixels after row: a receivers table that eval reads. px and
/// py are the pixel's column and row from 0. Every number reads back to itself.
/// Throws UserError if writing fails, and Stopped.
void WritePixelReceivers(OutputFile& file, const PixelReceivers& receivers,
                         const IrradianceImage& image);

/// The same of "px,py,E_r,E_g,E_b" and, with kDouble, the bounds, which the
/// pixels have then.
void WritePixelValues(OutputFile& file, const RenderedPixels& pixels,
                      Method method);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PIXEL_TABLE_H_
