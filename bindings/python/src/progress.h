// SPDX-License-Identifier: GPL-3.0-or-later
// Python's functions as the library's progress hooks.

#ifndef TRUELUX_BINDINGS_PYTHON_PROGRESS_H_
#define TRUELUX_BINDINGS_PYTHON_PROGRESS_H_

#include <pybind11/pybind11.h>
#include <string>

#include "truelux/progress.h"

#include "interruptible.h"

namespace truelux::python {

/// told: None, or called with done, total and what is counted; it must outlive
/// the hook. What told throws is dropped: a bar does not end the work.
inline ProgressHook HookOf(const pybind11::object& told) {
  if (told.is_none()) return {};
  return [function = pybind11::handle(told)](const ProgressState& state) {
    try {
      const pybind11::gil_scoped_acquire locked;
      try {
        function(state.done, state.total, std::string(state.things));
      } catch (pybind11::error_already_set& error) {
        error.discard_as_unraisable("truelux: progress");
      }
    } catch (...) {  // no lock to be had
      StayForEver();
    }
  };
}

}  // namespace truelux::python

#endif  // TRUELUX_BINDINGS_PYTHON_PROGRESS_H_
