// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "truelux/derivatives.h"
#include "truelux/irradiance.h"

#include "base/receiver_block.h"
#include "base/stop.h"
#include "radiometry/derivatives/receiver_derivatives.h"
#include "radiometry/derivatives/vertex_derivatives.h"
#include "radiometry/evaluate.h"
#include "radiometry/evaluate_weighted.h"
#include "radiometry/form_factors.h"
#include "radiometry/formula_sum.h"
#include "radiometry/prepared_scene.h"
#include "radiometry/stages/span_sum.h"
#include "visibility/arrangement/angular_spans.h"
#include "visibility/arrangement/arrangement_engine.h"
#include "visibility/visible_contour.h"

namespace truelux {
namespace {

bool Finite(double x, double y, double z) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
}

/// Why a number does not name a face; empty if it does. 0 is right if `least`
/// is 0.
std::string FaceDefect(int face, int least, const Scene& scene,
                       const char* what) {
  const auto count = static_cast<int>(scene.faces().size());
  if (face >= least && face <= count) return {};
  return std::string(what) + " is " + std::to_string(face) +
         ", the scene has " + std::to_string(count) + " faces";
}

/// Why a receiver cannot be used; empty if it can.
std::string ReceiverDefect(const Receiver& receiver, const Scene& scene) {
  const Point3& p = receiver.position;
  const Vector3& n = receiver.normal;
  if (!Finite(p.x, p.y, p.z)) return "the receiver's position is not finite";
  if (!Finite(n.x, n.y, n.z) || (n.x == 0 && n.y == 0 && n.z == 0)) {
    return "the receiver's normal is zero or not finite";
  }
  return FaceDefect(receiver.on_face, 0, scene, "on_face");
}

void RequireReceiver(const Receiver& receiver, const Scene& scene) {
  const std::string defect = ReceiverDefect(receiver, scene);
  if (!defect.empty()) throw ReceiverError(0, defect);
}

void RequireReceivers(std::span<const Receiver> receivers, const Scene& scene) {
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const std::string defect = ReceiverDefect(receivers[i], scene);
    if (defect.empty()) continue;
    throw ReceiverError(i, "receiver " + std::to_string(i) + ": " + defect);
  }
}

void BuildContour(const ContourQuery& query, Engine engine,
                  OracleWorkspace& workspace) {
  if (engine == Engine::kContour) {
    workspace.builder.Build(query, workspace.contour);
  } else {
    workspace.contour = ContourByArrangement(query);
  }
}

Irradiance Answer(const ContourQuery& query, Engine engine,
                  const EvaluationQuery& evaluation,
                  OracleWorkspace& workspace) {
  if (engine == Engine::kAngularSpans) {
    return EvaluateSpans(query, AngularSpansOf(query), evaluation);
  }
  BuildContour(query, engine, workspace);
  Irradiance result = EvaluateContour(query, workspace.contour, evaluation,
                                      workspace.evaluation);
  if (evaluation.method == Method::kDouble && workspace.contour.is_joined &&
      HasWideBound(result)) {
    // To choose a formula for each source takes the whole contour of each.
    ContourQuery each = query;
    each.join_sources = false;
    BuildContour(each, engine, workspace);
    const Irradiance joined = std::exchange(
        result, EvaluateContour(each, workspace.contour, evaluation,
                                workspace.evaluation));
    // The whole contours have more arcs, so that they may know less.
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (!(joined.bound[channel] < result.bound[channel])) continue;
      result.value[channel] = joined.value[channel];
      result.bound[channel] = joined.bound[channel];
    }
  }
  return result;
}

}  // namespace

Oracle::Oracle(Scene scene, const OracleOptions& options)
    : Oracle(PreparedScene(std::move(scene)), options) {}

Oracle::Oracle(PreparedScene prepared, const OracleOptions& options)
    : prepared_(std::move(prepared)), options_(options) {
  if (!(options.half_side > 0)) {
    throw std::invalid_argument("the half-side is not positive");
  }
}

void Oracle::Evaluate(
    std::span<const Receiver> receivers,
    const std::function<void(std::size_t, const Irradiance&)>& take) const {
  RequireReceivers(receivers, scene());
  const EvaluationQuery evaluation{options_.method, options_.emission,
                                   options_.formula, options_.half_side};
  const auto workspace = prepared_.data_->Borrow();
  // A formula by name needs the whole contour of every source.
  const bool join = options_.method == Method::kCertified ||
                    options_.formula == Formula::kAuto;
  ContourQuery query{scene(), {}, {}, join, options_.stop};
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    if (i % kReceiverBlock == 0) {
      workspace->builder.StartBlock(
          receivers.subspan(i, std::min(kReceiverBlock, receivers.size() - i)));
    }
    StopIfAsked(options_.stop);
    query.receiver = receivers[i];
    take(i, Answer(query, options_.engine, evaluation, *workspace));
  }
}

std::vector<Irradiance> Oracle::Evaluate(
    std::span<const Receiver> receivers) const {
  std::vector<Irradiance> results;
  results.reserve(receivers.size());
  Evaluate(receivers, [&results](std::size_t, const Irradiance& result) {
    results.push_back(result);
  });
  return results;
}

Irradiance Oracle::Evaluate(const Receiver& receiver) const {
  RequireReceiver(receiver, scene());
  Irradiance irradiance;
  Evaluate(std::span(&receiver, 1),
           [&irradiance](std::size_t, const Irradiance& result) {
             irradiance = result;
           });
  return irradiance;
}

std::optional<Rgb> Oracle::EvaluateFormula(const Receiver& receiver,
                                           Formula formula,
                                           Arithmetic arithmetic,
                                           int precision) const {
  RequireReceiver(receiver, scene());
  if (formula == Formula::kAuto) {
    throw std::invalid_argument("auto is no formula of its own");
  }
  if (precision < 53) {
    throw std::invalid_argument("the precision is less than 53 bits");
  }
  const ContourQuery query{scene(), receiver, {}, false, options_.stop};
  const auto workspace = prepared_.data_->Borrow();
  workspace->builder.StartBlock({});  // whatever it was used for before
  BuildContour(query, options_.engine, *workspace);
  const truelux::Contour& contour = workspace->contour;
  std::vector<Rgb> weights;
  FindWeights(query, contour, weights);
  const auto sum = [&]<class T>(T /*number type*/) {
    FormulaEvaluation<T> formulas({ViewOf(query), contour, weights},
                                  options_.half_side, precision);
    formulas.Prepare(formula);
    return SumByFormula(formulas, formula, weights);
  };
  std::optional<Rgb> value;
  if (arithmetic == Arithmetic::kFloat) value = sum(0.0F);
  if (arithmetic == Arithmetic::kDouble) value = sum(0.0);
  if (arithmetic == Arithmetic::kDoubleDouble) value = sum(DoubleDouble{});
  if (arithmetic == Arithmetic::kMultiprecision) value = sum(Multiprecision{});
  if (value && options_.emission == Emission::kRadiance) {
    for (double& channel : *value)
      channel *= std::numbers::pi;
  }
  return value;
}

Irradiance Oracle::FormFactor(const Receiver& receiver, int face) const {
  RequireReceiver(receiver, scene());
  const std::string defect = FaceDefect(face, 1, scene(), "the face number");
  if (!defect.empty()) throw std::invalid_argument(defect);
  const ContourQuery query{scene(), receiver, FaceNumber(face), false,
                           options_.stop};
  const auto workspace = prepared_.data_->Borrow();
  return Answer(query, options_.engine,
                {options_.method, Emission::kExitance, options_.formula,
                 options_.half_side},
                *workspace);
}

FormFactorTable Oracle::FormFactors(const Receiver& receiver) const {
  RequireReceiver(receiver, scene());
  const ContourQuery query{scene(), receiver, {}, false, options_.stop};
  const EvaluationQuery evaluation{options_.method, Emission::kExitance,
                                   options_.formula, options_.half_side};
  if (options_.engine == Engine::kAngularSpans) {
    return FormFactorsOf(query, AngularSpansOf(query), evaluation);
  }
  const auto workspace = prepared_.data_->Borrow();
  workspace->builder.StartBlock({});  // whatever it was used for before
  BuildContour(query, options_.engine, *workspace);
  return FormFactorsOf(query, workspace->contour, evaluation,
                       workspace->evaluation);
}

truelux::Derivatives Oracle::Derivatives(const Receiver& receiver) const {
  return Derivatives(receiver, {});
}

truelux::Derivatives Oracle::Derivatives(
    const Receiver& receiver, const DerivativeOptions& options) const {
  RequireReceiver(receiver, scene());
  truelux::Derivatives derivatives;
  Derivatives(std::span(&receiver, 1), options,
              [&derivatives](std::size_t, const truelux::Derivatives& found) {
                derivatives = found;
              });
  return derivatives;
}

void Oracle::Derivatives(
    std::span<const Receiver> receivers, const DerivativeOptions& options,
    const std::function<void(std::size_t, const truelux::Derivatives&)>& take)
    const {
  RequireReceivers(receivers, scene());
  const auto workspace = prepared_.data_->Borrow();
  const EvaluationQuery evaluation{options_.method, options_.emission,
                                   Formula::kAuto, 0x1p20};
  ContourQuery query{scene(), {}, {}, false, options_.stop};
  // In double, E depends on the contour, and Evaluate joins the sources.
  const bool has_contour_of_irradiance =
      options_.method == Method::kCertified ||
      (options_.engine == Engine::kContour &&
       options_.formula == Formula::kAuto &&
       prepared_.data_->engine.emitters().size() == 1);
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    if (i % kReceiverBlock == 0) {
      workspace->builder.StartBlock(
          receivers.subspan(i, std::min(kReceiverBlock, receivers.size() - i)));
    }
    StopIfAsked(options_.stop);
    query.receiver = receivers[i];
    truelux::Derivatives found =
        DerivativesAt(prepared_.data_->engine, query, evaluation, options,
                      has_contour_of_irradiance, *workspace);
    if (!has_contour_of_irradiance) found.irradiance = Evaluate(receivers[i]);
    take(i, found);
  }
}

truelux::VertexDerivatives Oracle::VertexDerivatives(
    const Receiver& receiver) const {
  RequireReceiver(receiver, scene());
  const ContourQuery query{scene(), receiver, {}, false, options_.stop};
  const auto workspace = prepared_.data_->Borrow();
  return VertexDerivativesAt(
      prepared_.data_->engine, prepared_.data_->GetContacts(),
      [this]() -> const LooseEngine& { return prepared_.data_->GetLoose(); },
      query, {Method::kCertified, options_.emission, Formula::kAuto, 0x1p20},
      *workspace);
}

VisibleContour Oracle::Contour(const Receiver& receiver) const {
  RequireReceiver(receiver, scene());
  const ContourQuery query{scene(), receiver, {}, false, options_.stop};
  const auto workspace = prepared_.data_->Borrow();
  workspace->builder.StartBlock({});  // whatever it was used for before
  BuildContour(query, options_.engine, *workspace);
  return DescribeContour(query, workspace->contour);
}

}  // namespace truelux
