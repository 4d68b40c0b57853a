// SPDX-License-Identifier: GPL-3.0-or-later
// Row by row quadrature of the irradiance: the rival without rays and without
// predicates.

#ifndef TRUELUX_BASELINES_SCANLINE_H_
#define TRUELUX_BASELINES_SCANLINE_H_

#include <array>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/vec3.h"

namespace truelux {

/// Midpoint rule over parallel rows of each emitting facet. Along a row the
/// integral is in closed form, over what the union of the blockers' shadows
/// leaves and what lies above the receiver's horizon:
///
///   E = (M h / pi) * sum over rows of dy * integral of
///       (A + B x) / (x^2 + D)^2 dx,   D = y^2 + h^2,
///
/// in a frame of the source's plane below r, where h is r's height above it
/// and A + B x is n . d for the unit normal n. The error is that of the
/// midpoint rule across the rows, about rows^-2 for shadows in general
/// position and rows^-1 where edges run along the rows.
///
/// In double, without tolerances but those of scanline_strips.h: coplanar
/// faces do not hide each other. Const methods may be called from several
/// threads.
class ScanlineQuadrature {
 public:
  explicit ScanlineQuadrature(Scene scene);

  /// E [W/m^2] per channel, Ke read as exitance. rows: per source, >= 1.
  [[nodiscard]] Rgb Evaluate(const Receiver& receiver, int rows) const;

 private:
  /// An emitting facet with a frame: u along the rows, v across, n outwards.
  struct Source {
    FacetId facet;
    Rgb exitance{};
    Vec3<double> u{};
    Vec3<double> v{};
    Vec3<double> n{};
    Point3 origin;
    std::vector<std::array<VertexId, 2>> boundary;
  };

  [[nodiscard]] double FormFactor(const Source& source,
                                  const Receiver& receiver,
                                  const IdVector<FacetId, bool>& ignored,
                                  int row_count) const;

  Scene scene_;
  std::vector<Source> sources_;
};

}  // namespace truelux

#endif  // TRUELUX_BASELINES_SCANLINE_H_
