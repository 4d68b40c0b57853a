// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include "bindings.h"
#include "errors.h"

PYBIND11_MODULE(_truelux, module) {
  module.doc() = "What truelux's Python files are made of; not for use.";
  truelux::python::BindErrors(module);
  truelux::python::BindScene(module);
  truelux::python::BindOracle(module);
  truelux::python::BindDerivatives(module);
  truelux::python::BindComparison(module);
  truelux::python::BindRender(module);
  truelux::python::BindIsolux(module);
  truelux::python::BindIsoMesh(module);
  truelux::python::BindExr(module);
}
