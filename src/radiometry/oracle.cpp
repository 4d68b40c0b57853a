#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "truelux/irradiance.h"

#include "radiometry/evaluate.h"
#include "visibility/arrangement_engine.h"
#include "visibility/contour_engine.h"
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

Contour BuildContour(const ContourQuery& query, Engine engine,
                     const ContourEngine& contour_engine) {
  return engine == Engine::kContour ? contour_engine.Build(query)
                                    : ContourByArrangement(query);
}

}  // namespace

Oracle::Oracle(Scene scene, const OracleOptions& options)
    : scene_(std::move(scene)),
      options_(options),
      contour_engine_(std::make_shared<const ContourEngine>(scene_)) {}

Irradiance Oracle::Evaluate(const Receiver& receiver) const {
  RequireReceiver(receiver, scene_);
  const ContourQuery query{scene_, receiver, 0};
  return EvaluateContour(
      query, BuildContour(query, options_.engine, *contour_engine_),
      {options_.method, options_.emission, options_.formula});
}

std::vector<Irradiance> Oracle::Evaluate(
    std::span<const Receiver> receivers) const {
  std::vector<Irradiance> results;
  results.reserve(receivers.size());
  for (const Receiver& receiver : receivers)
    results.push_back(Evaluate(receiver));
  return results;
}

Irradiance Oracle::FormFactor(const Receiver& receiver, int face) const {
  RequireReceiver(receiver, scene_);
  RequireFace(face, 1, scene_, "the face number");
  const ContourQuery query{scene_, receiver, face};
  return EvaluateContour(
      query, BuildContour(query, options_.engine, *contour_engine_),
      {options_.method, Emission::kExitance, options_.formula});
}

VisibleContour Oracle::Contour(const Receiver& receiver) const {
  RequireReceiver(receiver, scene_);
  const ContourQuery query{scene_, receiver, 0};
  return DescribeContour(
      query, BuildContour(query, options_.engine, *contour_engine_));
}

}  // namespace truelux
