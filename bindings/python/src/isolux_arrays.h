// SPDX-License-Identifier: GPL-3.0-or-later
// What calls share that find contours on a surface.

#ifndef TRUELUX_BINDINGS_PYTHON_ISOLUX_ARRAYS_H_
#define TRUELUX_BINDINGS_PYTHON_ISOLUX_ARRAYS_H_

#include <array>
#include <cstddef>
#include <optional>
#include <pybind11/pybind11.h>
#include <string>
#include <tuple>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/isolux.h"

#include "bindings.h"
#include "errors.h"
#include "interruptible.h"
#include "oracle_options.h"

namespace truelux::python {

/// Members of IsoluxOptions: levels; count; channel, by its name; half_width,
/// chord, smallest; most_triangles.
using ContourArguments =
    std::tuple<std::vector<double>, int, std::optional<std::string>,
               std::array<double, 3>, std::size_t>;

/// threads: 0: as many as `choice` has. told: as of HookOf. Throws InputError.
[[nodiscard]] IsoluxOptions ContourOptionsOf(const Choice& choice,
                                             const ContourArguments& arguments,
                                             int threads,
                                             const pybind11::object& told);

/// Arrays and lists, which the Python file isolux.py names.
[[nodiscard]] pybind11::dict IsoluxDictOf(const Isolux& isolux);

/// find(oracle) without the interpreter's lock; Ctrl-C ends it.
template <class F>
auto Found(const SharedScene& scene, const Choice& choice, const F& find) {
  return Checked([&] {
    const Interruptible interruptible;
    return find(Oracle(scene.prepared, choice.Options(interruptible.flag())));
  });
}

}  // namespace truelux::python

#endif  // TRUELUX_BINDINGS_PYTHON_ISOLUX_ARRAYS_H_
