// SPDX-License-Identifier: GPL-3.0-or-later
// One number of three channels, for pictures that show one.

#ifndef TRUELUX_IMAGE_SCALAR_CHANNEL_H_
#define TRUELUX_IMAGE_SCALAR_CHANNEL_H_

#include "truelux/geometry.h"
#include "truelux/picture.h"

namespace truelux {

/// One channel, or 0.2126 r + 0.7152 g + 0.0722 b (ITU-R BT.709), the luminance
/// of linear sRGB.
inline double ScalarOf(const Rgb& value, ScalarChannel channel) {
  constexpr Rgb kShares = {0.2126, 0.7152, 0.0722};
  switch (channel) {
    case ScalarChannel::kLuminance:
      break;
    case ScalarChannel::kRed:
      return value[0];
    case ScalarChannel::kGreen:
      return value[1];
    case ScalarChannel::kBlue:
      return value[2];
  }
  return kShares[0] * value[0] + kShares[1] * value[1] + kShares[2] * value[2];
}

}  // namespace truelux

#endif  // TRUELUX_IMAGE_SCALAR_CHANNEL_H_
