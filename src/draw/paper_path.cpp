// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/paper_path.h"

#include <cmath>
#include <cstddef>

namespace truelux {

double LengthOf(const PaperPath& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
  return length;
}

}  // namespace truelux
