// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/arc_integral.h"

#include <cmath>

#include "base/vector_math.h"

namespace truelux {

Vector3 InverseDistances(const Vector3& first, const Vector3& last, double q1,
                         double q2, double angle) {
  const double sine = std::sin(angle);
  const double wide = 1 + std::cos(angle);
  const double a = (angle + sine) / (4 * wide);
  // (angle - sine) has no digits left on short arcs; the next term of the
  // series is angle^2 / 30 times this one.
  constexpr double kShort = 1e-4;
  const double b =
      angle < kShort ? angle / 12 : (angle - sine) * wide / (4 * sine * sine);
  return Sum(Times(a * (q1 + q2), Sum(first, last)),
             Times(b * (q2 - q1), Difference(last, first)));
}

}  // namespace truelux
