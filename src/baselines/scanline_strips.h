// SPDX-License-Identifier: GPL-3.0-or-later
// Shadows in the plane of a source, cut into strips along its rows.

#ifndef TRUELUX_BASELINES_SCANLINE_STRIPS_H_
#define TRUELUX_BASELINES_SCANLINE_STRIPS_H_

#include <array>
#include <vector>

namespace truelux {

/// A point seen from the receiver r, in a frame of the source's plane: along
/// the rows, across the rows, and the height above r as a fraction of the
/// source's height. Its shadow on the source falls on (x / s, y / s).
struct ShadowPoint {
  double x = 0;
  double y = 0;
  double s = 0;
};

/// Rows y = first + (j + 1/2) * step for j = 0 .. count - 1.
struct Rows {
  double first = 0;
  double step = 0;
  int count = 0;

  [[nodiscard]] double At(int row) const { return first + (row + 0.5) * step; }

  /// The smallest row with At(row) >= y, in 0 .. count.
  [[nodiscard]] int FirstFrom(double y) const;
};

/// x = x0 + slope * (y - y0).
struct Line {
  double x0 = 0;
  double y0 = 0;
  double slope = 0;

  [[nodiscard]] double At(double y) const { return x0 + slope * (y - y0); }
};

/// What lies between two lines on the rows first .. end - 1.
struct Strip {
  int first = 0;
  int end = 0;
  Line left;
  Line right;
};

/// What a source spans in its plane.
struct Window {
  double x_low = 0;
  double x_high = 0;
  double y_low = 0;
  double y_high = 0;
};

/// Appends the shadow of a triangle: of its part in front of the source's
/// plane (0 < s < 1), unless that certainly misses the window. Parts closer to r than kNearest of the source's height
/// are dropped, and so are triangles that keep within 1e-12 of the source's
/// plane: in double they cannot be told from coplanar ones.
void AppendShadow(const std::array<ShadowPoint, 3>& triangle,
                  const Window& window, const Rows& rows,
                  std::vector<Strip>& strips);

inline constexpr double kNearest = 1e-9;

}  // namespace truelux

#endif  // TRUELUX_BASELINES_SCANLINE_STRIPS_H_
