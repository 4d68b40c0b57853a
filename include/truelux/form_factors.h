// SPDX-License-Identifier: GPL-3.0-or-later
// The form factors of all sources at one receiver, as plain data.

#ifndef TRUELUX_FORM_FACTORS_H_
#define TRUELUX_FORM_FACTORS_H_

#include <vector>

#include "truelux/statistics.h"

namespace truelux {

/// The form factor of one face at a receiver: the irradiance if that face
/// emitted M = 1 and no other face emitted, while all faces block. It lies in
/// [0, 1].
struct FaceFormFactor {
  int face = 0;      ///< the face's number, counted from 1
  double value = 0;  ///< F [1]
  double bound = 0;  ///< bound on |value - F| [1], as Irradiance::bound
};

/// The form factors of a scene's sources at one receiver.
struct FormFactorTable {
  /// One entry for every face that emits in some channel, by face number. A
  /// face of which nothing is visible has F = 0 and is listed, too.
  std::vector<FaceFormFactor> faces;
  /// The visibility of all faces together, counted once, and one evaluation
  /// for each face.
  Statistics statistics;
};

}  // namespace truelux

#endif  // TRUELUX_FORM_FACTORS_H_
