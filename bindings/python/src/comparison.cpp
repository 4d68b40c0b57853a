// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <limits>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

#include "truelux/compare.h"

#include "bindings.h"
#include "errors.h"
#include "interruptible.h"
#include "oracle_options.h"
#include "progress.h"
#include "receivers.h"

namespace py = pybind11;

namespace truelux::python {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A candidate without values. C: Candidate or GradientCandidate.
template <class C>
C WithReceivers(const Receivers& receivers, const ChannelNumbers& channels) {
  C candidate;
  receivers.Fill(0, receivers.size(), candidate.receivers);
  candidate.channels = channels;
  return candidate;
}

/// What reports of both kinds bring along. errors: by receiver.
template <class Result>
py::dict CommonPart(const Result& result) {
  const auto count = static_cast<py::ssize_t>(result.errors.size());
  py::array_t<double> excess(count);
  py::array_t<bool> passes(count);
  for (py::ssize_t i = 0; i < count; ++i) {
    const auto& error = result.errors[static_cast<std::size_t>(i)];
    excess.mutable_at(i) = error.excess;
    passes.mutable_at(i) = error.passes;
  }
  py::list worst;
  for (const ReceiverReason& w : result.worst)
    worst.append(py::make_tuple(w.receiver, TextOf(w.reason)));
  py::dict report;
  report["passes"] = result.passes();
  report["error"] = std::move(excess);
  report["within"] = std::move(passes);
  report["worst"] = std::move(worst);
  report["verdict"] = std::string(Name(result.diagnosis.verdict));
  report["mistake"] = TextOf(result.diagnosis.mistake);
  report["diagnosis"] = TextOf(result.diagnosis.text);
  report["factor"] = result.diagnosis.factor;
  report["text"] = TextOf(result.text);
  report["json"] = TextOf(result.json);
  return report;
}

CompareOptions OptionsOf(const Choice& choice, double tolerance,
                         const std::string& name, const py::object& told) {
  CompareOptions options;
  options.candidate_name = name;
  options.tolerance = tolerance;
  options.emission = choice.emission;
  options.threads = choice.ThreadCount();
  options.progress = HookOf(told);
  return options;
}

/// compare(options), which Ctrl-C ends.
template <class F>
auto Run(CompareOptions options, const F& compare) {
  return Checked([&] {
    const Interruptible interruptible;
    options.stop = interruptible.flag();
    return compare(options);
  });
}

/// values: (n, 3); of form factors the first column counts.
py::dict CompareValues(const SharedScene& scene, const Choice& choice,
                       const Rows& points, const Rows& normals,
                       const Numbers& on_face, const Rows& values,
                       const ChannelNumbers& channels, bool has_form_factors,
                       double tolerance, const std::string& name,
                       const py::object& told) {
  auto candidate = WithReceivers<Candidate>(
      {points, normals, on_face, scene.scene}, channels);
  candidate.has_form_factors = has_form_factors;
  const auto rows = values.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    candidate.values.push_back({rows(i, 0), rows(i, 1), rows(i, 2)});
  const CandidateComparison result =
      Run(OptionsOf(choice, tolerance, name, told),
          [&](const CompareOptions& options) {
            return Compare(scene.scene, candidate, options);
          });
  py::dict report = CommonPart(result);
  py::array_t<double> truth({rows.shape(0), py::ssize_t{3}});
  std::copy_n(result.truth.front().data(), 3 * result.truth.size(),
              truth.mutable_data());
  report["truth"] = std::move(truth);
  return report;
}

/// values: (n, 3, 3), by channel and axis. The truth is nan where E is
/// discontinuous.
py::dict CompareSlopes(const SharedScene& scene, const Choice& choice,
                       const Rows& points, const Rows& normals,
                       const Numbers& on_face,
                       const py::array_t<double>& values,
                       const ChannelNumbers& channels, double tolerance,
                       const std::string& name, const py::object& told) {
  auto candidate = WithReceivers<GradientCandidate>(
      {points, normals, on_face, scene.scene}, channels);
  const auto rows = values.unchecked<3>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    GradientRow row;
    for (py::ssize_t c = 0; c < 3; ++c)
      row[static_cast<std::size_t>(c)] = {rows(i, c, 0), rows(i, c, 1),
                                          rows(i, c, 2)};
    candidate.values.push_back(row);
  }
  const GradientComparison result =
      Run(OptionsOf(choice, tolerance, name, told),
          [&](const CompareOptions& options) {
            return CompareGradients(scene.scene, candidate, options);
          });
  py::dict report = CommonPart(result);
  py::array_t<double> truth({rows.shape(0), py::ssize_t{3}, py::ssize_t{3}});
  auto out = truth.mutable_unchecked<3>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const GradientTruth& at = result.truth[static_cast<std::size_t>(i)];
    const bool has_gradient = at.smoothness != Smoothness::kDiscontinuous;
    for (py::ssize_t c = 0; c < 3; ++c) {
      const Vector3& g = at.gradient[static_cast<std::size_t>(c)];
      out(i, c, 0) = has_gradient ? g.x : kNan;
      out(i, c, 1) = has_gradient ? g.y : kNan;
      out(i, c, 2) = has_gradient ? g.z : kNan;
    }
  }
  report["truth"] = std::move(truth);
  return report;
}

}  // namespace

void BindComparison(py::module_& module) {
  module.def("compare", CompareValues);
  module.def("compare_gradients", CompareSlopes);
}

}  // namespace truelux::python
