// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/certify.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "radiometry/stages/multiprecision_stage.h"
#include "radiometry/stages/rounding.h"

namespace truelux {
namespace {

constexpr slong kFirstPrecision = 128;
constexpr slong kLastPrecision = 4096;

Enclosure EnclosureOf(const ArbReal& x) {
  const slong precision = std::max(x.precision(), slong{64});
  Enclosure enclosure{Multiprecision(precision), Multiprecision(precision)};
  arb_get_interval_mpfr(enclosure.lower.get(), enclosure.upper.get(), x.get());
  return enclosure;
}

/// The largest magnitude in an enclosure, rounded up.
double MostOf(const Enclosure& x) {
  return std::max(std::fabs(mpfr_get_d(x.lower.get(), MPFR_RNDA)),
                  std::fabs(mpfr_get_d(x.upper.get(), MPFR_RNDA)));
}

}  // namespace

CertifiedNumbers Certify(const NumberSource& source, std::vector<bool> open) {
  CertifiedNumbers result;
  result.values.resize(open.size());
  result.bounds.resize(open.size());
  for (slong p = kFirstPrecision;
       std::find(open.begin(), open.end(), true) != open.end(); p *= 2) {
    const std::vector<ArbReal> all = source.at(p);
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (!open[i]) continue;
      const Enclosure enclosure = EnclosureOf(all[i]);
      if (const auto rounded = RoundIfCertain(enclosure)) {
        result.values[i] = *rounded;
        result.bounds[i] = HalfSpacing(std::fabs(*rounded));
        open[i] = false;
        continue;
      }
      // Whether it is zero needs to be asked once.
      if (p == kFirstPrecision && arb_contains_zero(all[i].get()) != 0 &&
          source.is_zero(i, all[i])) {
        open[i] = false;
      } else if (p >= kLastPrecision) {
        result.bounds[i] = MostOf(enclosure);
        open[i] = false;
        ++result.undecided;
      }
    }
  }
  return result;
}

}  // namespace truelux
