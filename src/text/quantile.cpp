// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/quantile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace truelux {

double Median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle]
                                : (values[middle - 1] + values[middle]) / 2;
}

double Quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const auto index = static_cast<std::size_t>(std::max(rank, 1.0)) - 1;
  return values[std::min(index, values.size() - 1)];
}

double RootMeanSquare(std::span<const double> values) {
  const double largest = *std::ranges::max_element(values);
  if (largest == 0 || std::isinf(largest)) return largest;
  double sum = 0;
  for (const double value : values)
    sum += (value / largest) * (value / largest);
  return largest * std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace truelux
