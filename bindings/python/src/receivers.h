// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers out of arrays.

#ifndef TRUELUX_BINDINGS_PYTHON_RECEIVERS_H_
#define TRUELUX_BINDINGS_PYTHON_RECEIVERS_H_

#include <cstddef>
#include <cstdint>
#include <pybind11/numpy.h>
#include <vector>

#include "truelux/receiver.h"
#include "truelux/scene.h"

namespace truelux::python {

/// Points or normals, shape (n, 3), rows of any stride.
using Rows = pybind11::array_t<double>;

/// Face numbers, shape (n).
using Numbers = pybind11::array_t<std::int64_t>;

/// Receivers on no face: the number 0 for all.
[[nodiscard]] Numbers NoFace();

/// Receivers that stay where they are, in arrays that must outlive the object
/// and are not written to meanwhile. A row of points has one of normals.
class Receivers {
 public:
  /// on_face: shape (n); or (1), the same for all. Throws InputError for what
  /// cannot be used: every defect, up to a hundred.
  Receivers(const Rows& points, const Rows& normals, const Numbers& on_face,
            const Scene& scene);

  [[nodiscard]] std::size_t size() const { return size_; }

  [[nodiscard]] Receiver At(std::size_t i) const;

  /// Some that follow each other.
  void Fill(std::size_t first, std::size_t count,
            std::vector<Receiver>& receivers) const;

 private:
  /// Numbers at equal distances in memory.
  struct Row3 {
    const std::byte* data = nullptr;
    std::ptrdiff_t row = 0;
    std::ptrdiff_t column = 0;

    [[nodiscard]] double At(std::size_t i, std::size_t k) const;
  };

  static Row3 RowsOf(const Rows& array, std::size_t size, const char* name);

  std::size_t size_;
  Row3 points_;
  Row3 normals_;
  std::vector<int> on_face_;
};

}  // namespace truelux::python

#endif  // TRUELUX_BINDINGS_PYTHON_RECEIVERS_H_
