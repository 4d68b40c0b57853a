// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/derivatives.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

#include "bindings.h"
#include "interruptible.h"
#include "oracle_options.h"
#include "receivers.h"

namespace py = pybind11;

namespace truelux::python {
namespace {

/// Numbers per receiver and channel: an array of the shape (n, 3, ...).
class Column {
 public:
  Column(std::size_t receivers, std::vector<py::ssize_t> inner) {
    std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(receivers), 3};
    for (const py::ssize_t size : inner) {
      shape.push_back(size);
      width_ *= static_cast<std::size_t>(size);
    }
    array_ = py::array_t<double>(shape);
    data_ = array_.mutable_data();
  }

  void Put(std::size_t receiver, std::size_t channel, const Vector3& v) {
    double* out = At(receiver, channel);
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
  }

  void Put(std::size_t receiver, std::size_t channel, const Matrix3& m) {
    double* out = At(receiver, channel);
    for (const auto& row : m)
      out = std::ranges::copy(row, out).out;
  }

  void Put(std::size_t receiver, std::size_t channel, double x) {
    *At(receiver, channel) = x;
  }

  [[nodiscard]] const py::array_t<double>& array() const { return array_; }

 private:
  double* At(std::size_t receiver, std::size_t channel) {
    return data_ + (3 * receiver + channel) * width_;
  }

  std::size_t width_ = 1;
  py::array_t<double> array_;
  double* data_ = nullptr;
};

/// ChannelDerivatives as arrays.
class Columns {
 public:
  explicit Columns(std::size_t n)
      : gradient_(n, {3}),
        tangential_(n, {3}),
        normal_(n, {3}),
        vector_(n, {3}),
        jacobian_(n, {3, 3}),
        sphere_(n, {3}),
        flux_(n, {}),
        sphere_jacobian_(n, {3, 3}) {}

  void Put(std::size_t i, std::size_t c, const ChannelDerivatives& d) {
    gradient_.Put(i, c, d.gradient);
    tangential_.Put(i, c, d.tangential);
    normal_.Put(i, c, d.normal);
    vector_.Put(i, c, d.vector);
    jacobian_.Put(i, c, d.jacobian);
    sphere_.Put(i, c, d.sphere);
    flux_.Put(i, c, d.flux);
    sphere_jacobian_.Put(i, c, d.sphere_jacobian);
  }

  [[nodiscard]] py::dict Dict() const {
    py::dict dict;
    dict["gradient"] = gradient_.array();
    dict["tangential"] = tangential_.array();
    dict["normal"] = normal_.array();
    dict["vector"] = vector_.array();
    dict["jacobian"] = jacobian_.array();
    dict["sphere"] = sphere_.array();
    dict["flux"] = flux_.array();
    dict["sphere_jacobian"] = sphere_jacobian_.array();
    return dict;
  }

 private:
  Column gradient_;
  Column tangential_;
  Column normal_;
  Column vector_;
  Column jacobian_;
  Column sphere_;
  Column flux_;
  Column sphere_jacobian_;
};

py::list KinkList(const std::vector<std::vector<Kink>>& kinks) {
  py::list list;
  for (std::size_t i = 0; i < kinks.size(); ++i) {
    for (const Kink& kink : kinks[i]) {
      const Vector3& m = kink.normal;
      list.append(py::make_tuple(i, std::array{m.x, m.y, m.z}, kink.size,
                                 kink.faces, kink.edges));
    }
  }
  return list;
}

/// Everything by name: values, bounds, E, its bound, smoothness and kinks.
py::dict DerivativesOf(const SharedScene& scene, const Choice& choice,
                       const Rows& points, const Rows& normals,
                       const Numbers& on_face, bool sphere, bool jacobian) {
  const Receivers receivers(points, normals, on_face, scene.scene);
  const std::size_t n = receivers.size();
  Columns values(n);
  Columns bounds(n);
  Column irradiance(n, {});
  Column irradiance_bound(n, {});
  py::array_t<std::uint8_t> smoothness(static_cast<py::ssize_t>(n));
  std::uint8_t* const smooth = smoothness.mutable_data();
  std::vector<std::vector<Kink>> kinks(n);
  {
    const Interruptible interruptible;
    const Oracle oracle(scene.prepared, choice.Options(interruptible.flag()));
    const DerivativeOptions options{.sphere = sphere, .jacobian = jacobian};
    ForBlocks(n, choice.threads, [&](std::size_t first, std::size_t count) {
      std::vector<Receiver> block;
      receivers.Fill(first, count, block);
      oracle.Derivatives(block, options,
                         [&](std::size_t k, const Derivatives& d) {
                           const std::size_t i = first + k;
                           smooth[i] = static_cast<std::uint8_t>(d.smoothness);
                           kinks[i] = d.kinks;
                           for (std::size_t c = 0; c < 3; ++c) {
                             values.Put(i, c, d.channels[c]);
                             bounds.Put(i, c, d.bounds[c]);
                             irradiance.Put(i, c, d.irradiance.value[c]);
                             irradiance_bound.Put(i, c, d.irradiance.bound[c]);
                           }
                         });
    });
  }
  py::dict all;
  all["values"] = values.Dict();
  all["bounds"] = bounds.Dict();
  all["irradiance"] = irradiance.array();
  all["irradiance_bound"] = irradiance_bound.array();
  all["smoothness"] = smoothness;
  all["kinks"] = KinkList(kinks);
  return all;
}

/// Numbers of vertices, shape (v), their gradients, shape (v, 3), and how many
/// slopes were one-sided. weights: shape (n, 3).
py::tuple VertexGradientOf(const SharedScene& scene, const Choice& choice,
                           const Rows& points, const Rows& normals,
                           const Numbers& on_face, const Rows& weights) {
  const Receivers receivers(points, normals, on_face, scene.scene);
  const auto weight = weights.unchecked<2>();
  VertexGradient sum(scene.scene);
  {
    const Interruptible interruptible;
    const Oracle oracle(scene.prepared, choice.Options(interruptible.flag()));
    // Found in any order and added in one, a part at a time: derivatives of
    // all receivers may not fit into memory.
    constexpr std::size_t kPart = 64 * kLargestBlock;
    std::vector<VertexDerivatives> part;
    for (std::size_t begin = 0; begin < receivers.size(); begin += kPart) {
      const std::size_t size = std::min(kPart, receivers.size() - begin);
      part.assign(size, {});
      ForBlocks(size, choice.threads,
                [&](std::size_t first, std::size_t count) {
                  for (std::size_t i = first; i < first + count; ++i) {
                    part[i] = oracle.VertexDerivatives(receivers.At(begin + i));
                  }
                });
      for (std::size_t i = 0; i < size; ++i) {
        const auto row = static_cast<py::ssize_t>(begin + i);
        sum.Add(part[i], {weight(row, 0), weight(row, 1), weight(row, 2)});
      }
    }
  }
  const std::vector<int>& numbers = sum.numbers();
  py::array_t<double> values(
      {static_cast<py::ssize_t>(numbers.size()), py::ssize_t{3}});
  double* out = values.mutable_data();
  for (const Vector3& v : sum.values()) {
    for (const double x : {v.x, v.y, v.z})
      *out++ = x;
  }
  return py::make_tuple(
      py::array_t<std::int64_t>(py::array_t<int>(
          static_cast<py::ssize_t>(numbers.size()), numbers.data())),
      std::move(values), sum.one_sided());
}

}  // namespace

void BindDerivatives(py::module_& module) {
  module.def("derivatives", DerivativesOf);
  module.def("vertex_gradient", VertexGradientOf);
}

}  // namespace truelux::python
