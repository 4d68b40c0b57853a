// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of the library as arrays of NumPy.

#ifndef TRUELUX_BINDINGS_PYTHON_ROWS_H_
#define TRUELUX_BINDINGS_PYTHON_ROWS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <pybind11/numpy.h>
#include <string>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/irradiance.h"

namespace truelux::python {

/// A copy of the shape (n, ...row).
template <class T>
[[nodiscard]] pybind11::array_t<T> ArrayOf(
    const std::vector<T>& numbers,
    std::initializer_list<pybind11::ssize_t> row = {}) {
  pybind11::ssize_t width = 1;
  for (const pybind11::ssize_t size : row)
    width *= size;
  std::vector<pybind11::ssize_t> shape = {
      static_cast<pybind11::ssize_t>(numbers.size()) / width};
  shape.insert(shape.end(), row);
  return pybind11::array_t<T>(shape, numbers.data());
}

/// Numbers that become an array, row by row.
class NumberRows {
 public:
  void Add(double x) { numbers_.push_back(x); }

  void Add(const Rgb& rgb) {
    numbers_.insert(numbers_.end(), rgb.begin(), rgb.end());
  }

  void Add(const Point3& p) { Add(Rgb{p.x, p.y, p.z}); }

  void Add(const Vector3& v) { Add(Rgb{v.x, v.y, v.z}); }

  template <std::size_t kCount>
  void Add(const std::array<Point3, kCount>& points) {
    for (const Point3& p : points)
      Add(p);
  }

  /// Of the shape (n, ...row).
  [[nodiscard]] pybind11::array_t<double> Array(
      std::initializer_list<pybind11::ssize_t> row = {}) const {
    return ArrayOf(numbers_, row);
  }

 private:
  std::vector<double> numbers_;
};

/// Of enumerators: indices into their names.
class Codes {
 public:
  template <class T>
  void Add(T value) {
    codes_.push_back(static_cast<std::uint8_t>(value));
  }

  /// Of the shape (n, ...row).
  [[nodiscard]] pybind11::array_t<std::uint8_t> Array(
      std::initializer_list<pybind11::ssize_t> row = {}) const {
    return ArrayOf(codes_, row);
  }

 private:
  std::vector<std::uint8_t> codes_;
};

/// The names of enumerators, which are 0, 1, 2 and so on.
template <class T>
[[nodiscard]] pybind11::list NamesOf(std::initializer_list<T> values) {
  pybind11::list names;
  for (const T value : values)
    names.append(std::string(Name(value)));
  return names;
}

}  // namespace truelux::python

#endif  // TRUELUX_BINDINGS_PYTHON_ROWS_H_
