// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/rounding.h"

#include "exact/number.h"

namespace truelux {

bool IsRoundingUpward() {
  // Not std::fegetround, which on x86 reads the control word of the x87 unit:
  // CGAL sets that of the SSE unit only.
  return CGAL::FPU_get_cw() == CGAL_FE_UPWARD;
}

}  // namespace truelux
