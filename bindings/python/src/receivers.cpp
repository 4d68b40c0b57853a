// SPDX-License-Identifier: GPL-3.0-or-later
#include "receivers.h"

#include <cmath>
#include <cstring>
#include <string>

#include "errors.h"

namespace truelux::python {
namespace {

constexpr std::size_t kMostDefects = 100;

bool IsFace(int number, std::size_t face_count) {
  return number >= 0 && static_cast<std::size_t>(number) <= face_count;
}

std::string OutOfRange(std::size_t face_count) {
  return "on_face is out of range; the scene has " +
         std::to_string(face_count) + " faces";
}

std::string DefectOf(const Receiver& r, std::size_t face_count) {
  if (!std::isfinite(r.position.x) || !std::isfinite(r.position.y) ||
      !std::isfinite(r.position.z)) {
    return "the point is not finite";
  }
  const Vector3& n = r.normal;
  if (!std::isfinite(n.x) || !std::isfinite(n.y) || !std::isfinite(n.z))
    return "the normal is not finite";
  if (n.x == 0 && n.y == 0 && n.z == 0) return "the normal is zero";
  return IsFace(r.on_face, face_count) ? "" : OutOfRange(face_count);
}

/// A number that no scene has, for those that an int does not hold.
int FaceNumber(std::int64_t number) {
  const auto narrow = static_cast<int>(number);
  return narrow == number ? narrow : -1;
}

}  // namespace

Numbers NoFace() {
  Numbers none(pybind11::ssize_t{1});
  none.mutable_data()[0] = 0;
  return none;
}

double Receivers::Row3::At(std::size_t i, std::size_t k) const {
  double value = 0;
  std::memcpy(&value,
              data + static_cast<std::ptrdiff_t>(i) * row +
                  static_cast<std::ptrdiff_t>(k) * column,
              sizeof value);
  return value;
}

Receivers::Row3 Receivers::RowsOf(const Rows& array, std::size_t size,
                                  const char* name) {
  if (array.ndim() != 2 || array.shape(1) != 3 ||
      static_cast<std::size_t>(array.shape(0)) != size) {
    throw InputError({std::string(name) + ": expected the shape (" +
                      std::to_string(size) + ", 3)"});
  }
  return {reinterpret_cast<const std::byte*>(array.data()), array.strides(0),
          array.strides(1)};
}

Receivers::Receivers(const Rows& points, const Rows& normals,
                     const Numbers& on_face, const Scene& scene)
    : size_(points.ndim() == 2 ? static_cast<std::size_t>(points.shape(0)) : 0),
      points_(RowsOf(points, size_, "points")),
      normals_(RowsOf(normals, size_, "normals")) {
  const auto numbers = on_face.unchecked<1>();
  if (numbers.shape(0) != 1 &&
      static_cast<std::size_t>(numbers.shape(0)) != size_) {
    throw InputError({"on_face: expected one number, or one per point"});
  }
  for (pybind11::ssize_t i = 0; i < numbers.shape(0); ++i)
    on_face_.push_back(FaceNumber(numbers(i)));
  const std::size_t face_count = scene.faces().size();
  if (on_face_.size() == 1 && !IsFace(on_face_[0], face_count))
    throw InputError({OutOfRange(face_count)});
  std::vector<std::string> defects;
  for (std::size_t i = 0; i < size_ && defects.size() < kMostDefects; ++i) {
    const std::string defect = DefectOf(At(i), face_count);
    if (!defect.empty())
      defects.push_back("receiver " + std::to_string(i) + ": " + defect);
  }
  if (defects.size() == kMostDefects)
    defects.emplace_back("and perhaps more; these are the first hundred");
  if (!defects.empty()) throw InputError(std::move(defects));
}

Receiver Receivers::At(std::size_t i) const {
  return {{points_.At(i, 0), points_.At(i, 1), points_.At(i, 2)},
          {normals_.At(i, 0), normals_.At(i, 1), normals_.At(i, 2)},
          on_face_.size() == 1 ? on_face_[0] : on_face_[i]};
}

void Receivers::Fill(std::size_t first, std::size_t count,
                     std::vector<Receiver>& receivers) const {
  receivers.clear();
  for (std::size_t i = first; i < first + count; ++i)
    receivers.push_back(At(i));
}

}  // namespace truelux::python
