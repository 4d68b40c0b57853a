// Pixels as rows of comma-separated values.

#ifndef TRUELUX_IMAGE_PIXEL_TABLE_H_
#define TRUELUX_IMAGE_PIXEL_TABLE_H_

#include <string>

#include "truelux/irradiance.h"
#include "truelux/receiver.h"

namespace truelux {

/// "x,y,z,nx,ny,nz,on_face,px,py": a receivers table that eval reads; px and
/// py are the pixel's column and row from 0. Without the line end.
[[nodiscard]] std::string PixelReceiverHeader();

/// One row of it, with the line end. Every number reads back to itself.
void AppendPixelReceiver(std::string& text, int x, int y,
                         const Receiver& receiver);

/// "px,py,E_r,E_g,E_b" and the bounds of kDouble, without the line end.
[[nodiscard]] std::string PixelValueHeader(Method method);

/// One row of it, with the line end; the bound is not looked at with
/// kCertified.
void AppendPixelValue(std::string& text, int x, int y, const Rgb& value,
                      const Rgb& bound, Method method);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PIXEL_TABLE_H_
