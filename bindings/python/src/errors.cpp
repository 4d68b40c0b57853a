// SPDX-License-Identifier: GPL-3.0-or-later
#include "errors.h"

#include <exception>
#include <pybind11/stl.h>

#include "truelux/receiver.h"
#include "truelux/stop.h"

namespace py = pybind11;

namespace truelux::python {
namespace {

std::string Lines(const std::vector<std::string>& defects) {
  std::string text;
  for (const std::string& defect : defects) {
    if (!text.empty()) text += '\n';
    text += defect;
  }
  return text;
}

void Raise(const py::object& type, const std::vector<std::string>& defects) {
  const py::object error = type(TextOf(Lines(defects)));
  error.attr("defects") = TextsOf(defects);
  PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace

InputError::InputError(std::vector<std::string> defects)
    : std::runtime_error(Lines(defects)), defects_(std::move(defects)) {}

py::str TextOf(const std::string& bytes) {
  return py::reinterpret_steal<py::str>(PyUnicode_DecodeUTF8(
      bytes.data(), static_cast<py::ssize_t>(bytes.size()), "surrogateescape"));
}

py::list TextsOf(const std::vector<std::string>& all) {
  py::list texts;
  for (const std::string& bytes : all)
    texts.append(TextOf(bytes));
  return texts;
}

py::list MessagesOf(const std::vector<Diagnostic>& notes) {
  py::list texts;
  for (const Diagnostic& note : notes)
    texts.append(TextOf(note.message));
  return texts;
}

void BindErrors(py::module_& module) {
  const py::object type = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc("truelux.Error",
                                "An input that cannot be used.\n\n"
                                "Attributes\n----------\n"
                                "defects : list of str\n"
                                "    Every defect that was found, one line "
                                "each, with cause and cure.",
                                PyExc_ValueError, nullptr));
  module.attr("Error") = type;
  // The translator outlives the module; so does what it raises.
  static PyObject* const error = type.inc_ref().ptr();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& e) {
      Raise(py::reinterpret_borrow<py::object>(error), e.defects());
    } catch (const ReceiverError& e) {
      Raise(py::reinterpret_borrow<py::object>(error), {e.what()});
    } catch (const Stopped&) {
      // Python's own handler has seen the signal, too, and raises
      // KeyboardInterrupt, or what the user's handler raises.
      if (PyErr_CheckSignals() == 0) PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
}

}  // namespace truelux::python
