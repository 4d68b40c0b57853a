// SPDX-License-Identifier: GPL-3.0-or-later
// The visible contour of a case of a regime.

#ifndef TRUELUX_BASELINES_CASE_CONTOUR_H_
#define TRUELUX_BASELINES_CASE_CONTOUR_H_

#include <vector>

#include "baselines/regimes.h"
#include "radiometry/weighted_contour.h"
#include "visibility/contour.h"

namespace truelux {

/// Owns what a WeightedContour refers to. Every source emits {1, 1, 1}, so that
/// E is a form factor.
class CaseContour {
 public:
  /// A loop is taken as it is, edge by edge; what is seen of a scene is found
  /// by the contour engine.
  explicit CaseContour(RegimeCase made);
  CaseContour(const CaseContour&) = delete;
  CaseContour& operator=(const CaseContour&) = delete;

  [[nodiscard]] WeightedContour Weighted() const;

 private:
  void TakeLoop();

  RegimeCase case_;
  ContourQuery query_;
  Contour contour_;
  std::vector<Rgb> weights_;
};

}  // namespace truelux

#endif  // TRUELUX_BASELINES_CASE_CONTOUR_H_
