// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as colours, in steps that look equal.

#ifndef TRUELUX_IMAGE_FALSE_COLOUR_H_
#define TRUELUX_IMAGE_FALSE_COLOUR_H_

#include <vector>

#include "image/png_image.h"

namespace truelux {

/// The colour of a share in [0, 1], dark violet to yellow: viridis (S. van der
/// Walt and N. Smith, CC0), by nine of its colours with straight lines in sRGB
/// codes in between. Equal steps look about equally large, lighter is always
/// more, and colour-blind readers can tell them apart. Shares outside are cut.
[[nodiscard]] Rgba8 FalseColour(double share);

/// Which share of the colours a number gets.
class ColourScale {
 public:
  /// From 0 to `most`; most > 0, finite. whole: ticks at whole numbers only.
  static ColourScale Linear(double most, bool whole = false);

  /// By logarithms, from `least` to `most`; 0 < least <= most, finite. Widened
  /// to whole powers of ten, and at most kDecades of them.
  static ColourScale Logarithmic(double least, double most);

  static constexpr int kDecades = 8;

  /// In [0, 1]; what is below the scale is 0, above 1, not a number 0.
  [[nodiscard]] double At(double value) const;

  /// Round numbers on the scale, ascending: on a linear one 0 and the multiples
  /// of 1, 2 or 5 times a power of ten, up to eight of them; on a logarithmic
  /// one the powers of ten.
  [[nodiscard]] const std::vector<double>& ticks() const { return ticks_; }

 private:
  bool logarithmic_ = false;
  double low_ = 0;  ///< decimal logarithms if logarithmic
  double high_ = 1;
  std::vector<double> ticks_;
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_FALSE_COLOUR_H_
