// SPDX-License-Identifier: GPL-3.0-or-later
// One number of three channels, for pictures that show one.

#ifndef TRUELUX_BASE_SCALAR_CHANNEL_H_
#define TRUELUX_BASE_SCALAR_CHANNEL_H_

#include "truelux/geometry.h"
#include "truelux/picture.h"

namespace truelux {

/// Of red, green and blue in luminance (Rec. 709).
inline constexpr Rgb kLuminanceShares = {0.2126, 0.7152, 0.0722};

/// The shares of the channels in the number that is shown.
inline Rgb SharesOf(ScalarChannel channel) {
  switch (channel) {
    case ScalarChannel::kLuminance:
      break;
    case ScalarChannel::kRed:
      return {1, 0, 0};
    case ScalarChannel::kGreen:
      return {0, 1, 0};
    case ScalarChannel::kBlue:
      return {0, 0, 1};
  }
  return kLuminanceShares;
}

/// One channel, or 0.2126 r + 0.7152 g + 0.0722 b (ITU-R BT.709), the luminance
/// of linear sRGB.
inline double ScalarOf(const Rgb& value, ScalarChannel channel) {
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
  return kLuminanceShares[0] * value[0] + kLuminanceShares[1] * value[1] +
         kLuminanceShares[2] * value[2];
}

}  // namespace truelux

#endif  // TRUELUX_BASE_SCALAR_CHANNEL_H_
