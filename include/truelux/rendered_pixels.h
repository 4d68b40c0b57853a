// SPDX-License-Identifier: GPL-3.0-or-later
// A picture as numbers, pixel by pixel (render.h).

#ifndef TRUELUX_RENDERED_PIXELS_H_
#define TRUELUX_RENDERED_PIXELS_H_

#include <cstdint>
#include <optional>

#include "truelux/export.h"
#include "truelux/geometry.h"
#include "truelux/raster.h"

namespace truelux {

/// Both rasters have the same size.
struct IrradianceImage {
  Raster<Rgb> values;            ///< E [W/m^2]; 0 where nothing is
  Raster<std::uint8_t> covered;  ///< 1: a receiver; 0: nothing, transparent
};

/// What a receiver gets of the sources, as one word a pixel.
enum class ShadowClass : std::uint8_t {
  kNothing,      ///< no receiver
  kNoSource,     ///< no source looks to the receiver from above its horizon
  kUmbra,        ///< there are such sources, and nothing of them is visible
  kPenumbra,     ///< an edge of something else bounds what is visible
  kLit,          ///< only the sources' outlines and the horizon bound it
  kConjunctive,  ///< a vertex of the contour is conjunctive, lit or penumbra
};

inline constexpr int kShadowClassCount = 6;

/// The name in legends.
[[nodiscard]] TRUELUX_EXPORT const char* Name(ShadowClass shadow);

/// Jumps of the tangential gradient, pixel by pixel.
struct KinkJumps {
  /// The largest length of a jump in the pixel, per channel [W/m^3]; 0 where
  /// there is none.
  Raster<Rgb> lengths;
  /// Whether nothing was measured, since there are more places to measure at
  /// than pixels.
  bool is_left_out = false;
  /// Whether kinks may be missing, EdgePlanes::is_complete being false.
  bool is_partial = false;
};

/// A raster that is not wished for is empty.
struct RenderedPixels {
  IrradianceImage image;
  Raster<Rgb> bounds;         ///< as in Irradiance
  Raster<Rgb> differences;    ///< |value - the other method's|
  Raster<std::int32_t> arcs;  ///< 0 where there is no receiver
  Raster<ShadowClass> classes;
  Raster<Rgb> gradients;  ///< lengths of tangential gradients [W/m^3]
  /// How far these jump, on a surface.
  std::optional<KinkJumps> kinks;
};

}  // namespace truelux

#endif  // TRUELUX_RENDERED_PIXELS_H_
