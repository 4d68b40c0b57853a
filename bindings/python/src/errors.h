// SPDX-License-Identifier: GPL-3.0-or-later
// Defects of inputs as one exception, and calls that end on Ctrl-C.

#ifndef TRUELUX_BINDINGS_PYTHON_ERRORS_H_
#define TRUELUX_BINDINGS_PYTHON_ERRORS_H_

#include <pybind11/pybind11.h>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "truelux/diagnostics.h"

namespace truelux::python {

/// What cannot be used, one line per defect. Python sees truelux.Error.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<std::string> defects);

  [[nodiscard]] const std::vector<std::string>& defects() const {
    return defects_;
  }

 private:
  std::vector<std::string> defects_;
};

/// Bytes of a file, or of a text that holds some, as text: UTF-8, and what is not
/// by surrogates, as Python has it in names of files.
[[nodiscard]] pybind11::str TextOf(const std::string& bytes);
[[nodiscard]] pybind11::list TextsOf(const std::vector<std::string>& all);

/// The messages alone: notes on a scene that is no file.
[[nodiscard]] pybind11::list MessagesOf(const std::vector<Diagnostic>& notes);

/// f(), where what the library finds wrong in arguments is an InputError.
template <class F>
auto Checked(const F& f) {
  try {
    return f();
  } catch (const std::invalid_argument& defect) {
    throw InputError({defect.what()});
  }
}

/// Adds truelux.Error to the module and translates exceptions of the library.
void BindErrors(pybind11::module_& module);

}  // namespace truelux::python

#endif  // TRUELUX_BINDINGS_PYTHON_ERRORS_H_
