// The point and the side whose irradiance is asked for.

#ifndef TRUELUX_RECEIVER_H_
#define TRUELUX_RECEIVER_H_

#include "truelux/geometry.h"

namespace truelux {

/// A receiver sees the half-space of directions d with normal . d > 0.
struct Receiver {
  Point3 position;  ///< [scene length unit], finite
  Vector3 normal;   ///< any finite length but zero
  /// Number (1-based) of the face that the receiver lies on up to rounding:
  /// that face and all faces in exactly the same plane are ignored. 0: none.
  int on_face = 0;
};

}  // namespace truelux

#endif  // TRUELUX_RECEIVER_H_
