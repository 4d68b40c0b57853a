#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "truelux/irradiance.h"

#include "base/pool.h"
#include "radiometry/evaluate.h"
#include "radiometry/evaluation_workspace.h"
#include "radiometry/formula_sum.h"
#include "radiometry/stages/span_sum.h"
#include "visibility/arrangement/angular_spans.h"
#include "visibility/arrangement/arrangement_engine.h"
#include "visibility/edges/contour_engine.h"
#include "visibility/visible_contour.h"

namespace truelux {
namespace {

bool Finite(double x, double y, double z) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
}

void RequireFace(int face, int least, const Scene& scene, const char* what) {
  const auto count = static_cast<int>(scene.faces().size());
  if (face < least || face > count) {
    throw std::invalid_argument(std::string(what) + " is " +
                                std::to_string(face) + ", the scene has " +
                                std::to_string(count) + " faces");
  }
}

void RequireReceiver(const Receiver& receiver, const Scene& scene) {
  const Point3& p = receiver.position;
  const Vector3& n = receiver.normal;
  if (!Finite(p.x, p.y, p.z)) {
    throw std::invalid_argument("the receiver's position is not finite");
  }
  if (!Finite(n.x, n.y, n.z) || (n.x == 0 && n.y == 0 && n.z == 0)) {
    throw std::invalid_argument("the receiver's normal is zero or not finite");
  }
  RequireFace(receiver.on_face, 0, scene, "on_face");
}

/// Consecutive receivers that share where their blockers are.
constexpr std::size_t kBlockSize = 16;

/// What one thread needs for one receiver after the other.
struct Workspace {
  explicit Workspace(const ContourEngine& engine) : builder(engine) {}

  ContourBuilder builder;
  truelux::Contour contour;
  EvaluationWorkspace evaluation;
};

}  // namespace

/// What an oracle prepares once; shared by its copies.
struct Oracle::Prepared {
  explicit Prepared(const Scene& scene) : engine(scene) {}

  Pool<Workspace>::Loan Borrow() {
    return workspaces.Borrow(
        [this] { return std::make_unique<Workspace>(engine); });
  }

  ContourEngine engine;
  Pool<Workspace> workspaces;
};

namespace {

void BuildContour(const ContourQuery& query, Engine engine,
                  Workspace& workspace) {
  if (engine == Engine::kContour) {
    workspace.builder.Build(query, workspace.contour);
  } else {
    workspace.contour = ContourByArrangement(query);
  }
}

Irradiance Answer(const ContourQuery& query, Engine engine,
                  const EvaluationQuery& evaluation, Workspace& workspace) {
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
    : scene_(std::move(scene)),
      options_(options),
      prepared_(std::make_shared<Prepared>(scene_)) {}

void Oracle::Evaluate(
    std::span<const Receiver> receivers,
    const std::function<void(std::size_t, const Irradiance&)>& take) const {
  for (const Receiver& receiver : receivers)
    RequireReceiver(receiver, scene_);
  const EvaluationQuery evaluation{options_.method, options_.emission,
                                   options_.formula, options_.half_side};
  const auto workspace = prepared_->Borrow();
  // A formula by name needs the whole contour of every source.
  const bool join = options_.method == Method::kCertified ||
                    options_.formula == Formula::kAuto;
  ContourQuery query{scene_, {}, {}, join};
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    if (i % kBlockSize == 0) {
      workspace->builder.StartBlock(
          receivers.subspan(i, std::min(kBlockSize, receivers.size() - i)));
    }
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
  RequireReceiver(receiver, scene_);
  if (formula == Formula::kAuto) {
    throw std::invalid_argument("auto is no formula of its own");
  }
  if (precision < 53) {
    throw std::invalid_argument("the precision is less than 53 bits");
  }
  const ContourQuery query{scene_, receiver};
  const auto workspace = prepared_->Borrow();
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
  RequireReceiver(receiver, scene_);
  RequireFace(face, 1, scene_, "the face number");
  const ContourQuery query{scene_, receiver, FaceNumber(face)};
  const auto workspace = prepared_->Borrow();
  return Answer(query, options_.engine,
                {options_.method, Emission::kExitance, options_.formula,
                 options_.half_side},
                *workspace);
}

VisibleContour Oracle::Contour(const Receiver& receiver) const {
  RequireReceiver(receiver, scene_);
  const ContourQuery query{scene_, receiver};
  const auto workspace = prepared_->Borrow();
  workspace->builder.StartBlock({});  // whatever it was used for before
  BuildContour(query, options_.engine, *workspace);
  return DescribeContour(query, workspace->contour);
}

}  // namespace truelux
