// SPDX-License-Identifier: GPL-3.0-or-later
// The point and the side whose irradiance is asked for, and what is thrown if
// they cannot be used.

#ifndef TRUELUX_RECEIVER_H_
#define TRUELUX_RECEIVER_H_

#include <cstddef>
#include <stdexcept>
#include <string>

#include "truelux/export.h"
#include "truelux/geometry.h"

namespace truelux {

/// A point with a side. It sees the half-space of directions d with
/// normal . d > 0. It need not lie on a face of the scene.
struct Receiver {
  Point3 position;  ///< in the scene's frame; finite
  Vector3 normal;   ///< in the scene's frame; of any finite length but zero
  /// The number, counted from 1, of the face that the receiver lies on up to
  /// rounding. That face and all faces in exactly the same plane neither emit
  /// nor block for this receiver. 0: the receiver lies on no face.
  int on_face = 0;
};

/// Thrown for a receiver that cannot be used: a position that is not finite, a
/// normal that is zero or not finite, an on_face that the scene does not have.
class TRUELUX_EXPORT ReceiverError : public std::invalid_argument {
 public:
  /// index: as index() below. message: what what() says.
  ReceiverError(std::size_t index, const std::string& message);

  ~ReceiverError() override;
  ReceiverError(const ReceiverError&) = default;
  ReceiverError& operator=(const ReceiverError&) = default;

  /// Which of the receivers of the call it was, counted from 0 as in the span
  /// that was given. 0 if the call takes one receiver.
  [[nodiscard]] std::size_t index() const { return index_; }

 private:
  std::size_t index_;
};

}  // namespace truelux

#endif  // TRUELUX_RECEIVER_H_
