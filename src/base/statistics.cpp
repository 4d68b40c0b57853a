// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/statistics.h"

#include <algorithm>

namespace truelux {

StageCounts& StageCounts::operator+=(const StageCounts& other) {
  symbolic += other.symbolic;
  filter += other.filter;
  interval += other.interval;
  double_double += other.double_double;
  exact += other.exact;
  return *this;
}

Statistics& Statistics::operator+=(const Statistics& other) {
  receiver_side += other.receiver_side;
  vertex_side += other.vertex_side;
  plane_side += other.plane_side;
  edge_order += other.edge_order;
  sources += other.sources;
  blockers += other.blockers;
  arcs += other.arcs;
  evaluated_double += other.evaluated_double;
  evaluated_double_double += other.evaluated_double_double;
  evaluated_multiprecision += other.evaluated_multiprecision;
  evaluated_zero += other.evaluated_zero;
  ties += other.ties;
  overflows += other.overflows;
  max_precision_bits = std::max(max_precision_bits, other.max_precision_bits);
  return *this;
}

}  // namespace truelux
