// SPDX-License-Identifier: GPL-3.0-or-later
// How many digits each closed formula keeps in each arithmetic, on the cases of
// a regime; and whether the printed bounds hold.

#ifndef TRUELUX_BASELINES_STABILITY_STUDY_H_
#define TRUELUX_BASELINES_STABILITY_STUDY_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/formulas.h"

#include "baselines/regimes.h"

namespace truelux {

/// Where a formula is evaluated. kBounded is double with a running bound, as
/// --method double computes it: what is measured there is the bound.
enum class StudyArithmetic {
  kFloat,
  kDouble,
  kBounded,
  kDoubleDouble,
  kMpfr128
};

inline constexpr std::array kArithmetics = {
    StudyArithmetic::kFloat, StudyArithmetic::kDouble,
    StudyArithmetic::kBounded, StudyArithmetic::kDoubleDouble,
    StudyArithmetic::kMpfr128};

/// "float", "double", "bounded double", "double-double", "MPFR 128".
std::string_view Name(StudyArithmetic arithmetic);

inline constexpr std::size_t kFormulaCount = 14;

struct StabilityOptions {
  int cases = 1000;
  std::uint64_t seed = 1;
  /// In MPFR only the first cases: a cubature there may take a second.
  int slow_cases = 100;
  /// On how many of the first cases evaluations are timed.
  int timed_cases = 20;
  std::vector<StudyArithmetic> arithmetics = {kArithmetics.begin(),
                                              kArithmetics.end()};
};

/// One formula in one arithmetic on the cases of a regime.
struct StabilityCell {
  /// |value - E| / E, value rounded to double, in the order of the cases;
  /// kBounded: bound / E, where the bound holds the truncation. Infinite where
  /// there is no number. Cases to which the formula does not apply are left
  /// out.
  std::vector<double> errors;
  /// For each timed case, the processor time of an evaluation [ns]: the sum only, with
  /// the coordinates of the contour ready at hand.
  std::vector<double> nanoseconds;
  int not_applicable = 0;  ///< number of cases

  friend bool operator==(const StabilityCell&, const StabilityCell&) = default;
};

/// A bound that does not hold: a defect.
struct BoundViolation {
  std::string regime;
  std::uint64_t index = 0;  ///< of the case
  Formula formula = Formula::kAuto;
  double value = 0;
  double bound = 0;
  double truth = 0;
};

/// All measurements on one regime.
struct RegimeStability {
  std::string regime;
  bool occluded = false;
  int cases = 0;
  int dark = 0;              ///< cases of which nothing is visible: left out
  std::vector<int> arcs;     ///< per case that is not dark
  std::vector<int> sources;  ///< the same
  std::array<std::array<StabilityCell, kFormulaCount>, kArithmetics.size()>
      cells;
  std::int64_t bounds_checked = 0;
  std::vector<BoundViolation> violations;

  [[nodiscard]] const StabilityCell& At(StudyArithmetic arithmetic,
                                        Formula formula) const {
    return cells[static_cast<std::size_t>(arithmetic)]
                [static_cast<std::size_t>(formula)];
  }

  StabilityCell& At(StudyArithmetic arithmetic, Formula formula) {
    return cells[static_cast<std::size_t>(arithmetic)]
                [static_cast<std::size_t>(formula)];
  }
};

/// 0 of nothing.
double Largest(const std::vector<double>& values);

/// Measures one regime. Truth: Lambert's sum with 400 bits. kAuto, which is not
/// a formula of its own, is in kBounded only, as --method double has it, and
/// its value's error in kDouble. after_case: called after every case; what it
/// throws ends the measurement.
RegimeStability MeasureStability(const Regime& regime,
                                 const StabilityOptions& options,
                                 const std::function<void()>& after_case);

}  // namespace truelux

#endif  // TRUELUX_BASELINES_STABILITY_STUDY_H_
