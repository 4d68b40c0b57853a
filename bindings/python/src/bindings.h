// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the module truelux._truelux, which the Python files beside it
// turn into what users see.

#ifndef TRUELUX_BINDINGS_PYTHON_BINDINGS_H_
#define TRUELUX_BINDINGS_PYTHON_BINDINGS_H_

#include <pybind11/pybind11.h>

#include "truelux/prepared_scene.h"
#include "truelux/scene.h"

namespace truelux::python {

/// A scene, prepared for any number of oracles.
struct SharedScene {
  explicit SharedScene(const Scene& s) : scene(s), prepared(s) {}

  Scene scene;
  PreparedScene prepared;
};

/// Scenes from files and arrays, and back.
void BindScene(pybind11::module_& module);

/// Irradiance, form factors, contours.
void BindOracle(pybind11::module_& module);

/// Derivatives.
void BindDerivatives(pybind11::module_& module);

/// Other programs' values beside the truth.
void BindComparison(pybind11::module_& module);

/// Pictures.
void BindRender(pybind11::module_& module);

/// Lines of light on surfaces, contours and extrema.
void BindIsolux(pybind11::module_& module);

/// Meshes whose edges follow the light.
void BindIsoMesh(pybind11::module_& module);

/// Images of OpenEXR.
void BindExr(pybind11::module_& module);

}  // namespace truelux::python

#endif  // TRUELUX_BINDINGS_PYTHON_BINDINGS_H_
