// SPDX-License-Identifier: GPL-3.0-or-later
// What central differences of the irradiance lose, against the step: errors
// relative to the certified gradient, as a table on standard output and as a
// picture.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "truelux/derivatives.h"
#include "truelux/irradiance.h"

#include "baselines/emitter_samples.h"
#include "baselines/sampled.h"
#include "double_rays.h"
#include "run/exit_status.h"
#include "run/messages.h"
#include "run/output_file.h"
#include "run/user_error.h"
#include "scene_parts.h"
#include "step_chart.h"
#include "text/quantile.h"

namespace truelux::bench {
namespace {

/// Half decades from the greatest step, 1e-1, to the least, 1e-12.
constexpr int kSteps = 23;

struct Options {
  int seeds = 9;
  std::string svg;  ///< where to draw the chart; "": nowhere
};

/// A receiver, under the name that the table and the picture give it.
struct Place {
  std::string name;
  Receiver receiver;
};

/// E [W/m^2] in the first channel.
using Value = std::function<double(const Receiver&)>;

/// A way to E. One that draws samples has one function per seed.
struct Way {
  std::string name;
  std::vector<Value> values;
};

/// The unit lamp above a tilted triangle and an upright plate in the plane
/// x = kPlate. No edge of the plate is parallel to one of the lamp, so that the
/// only kink near the places below is in the plane of the plate.
constexpr double kPlate = 0.2;

Scene LampWithTwoBlockers() {
  const Ring triangle = {{-0.3, -0.2, 0.5}, {0.1, -0.35, 0.6}, {0, 0.25, 0.45}};
  const Ring plate = {{kPlate, -0.3, 0.35},
                      {kPlate, 0.35, 0.3},
                      {kPlate, 0.4, 0.65},
                      {kPlate, -0.25, 0.7}};
  return testing::MakeScene(
      {UnitLamp(), {triangle, testing::kBlack}, {plate, testing::kBlack}});
}

std::vector<Place> Places() {
  return {{"in the penumbra", {{-0.15, -0.1, 0}, {0, 0, 1}, 0}},
          {"1e-3 beside a kink", {{kPlate + 1e-3, -0.1, 0}, {0, 0, 1}, 0}}};
}

Way Certified(const Scene& scene, Method method, const std::string& name) {
  const Oracle oracle(scene, {.method = method});
  return {name, {[oracle](const Receiver& receiver) {
            return oracle.Evaluate(receiver).value[0];
          }}};
}

double FirstChannel(const Rgb& value) {
  return value[0];
}

double FirstChannel(double value) {
  return value;
}

/// The same samples at all places: common random numbers.
template <class Rays>
Way Sampled(const Scene& scene, const std::shared_ptr<const Rays>& rays,
            int count, int seeds, const std::string& name) {
  Way way{name, {}};
  for (int seed = 1; seed <= seeds; ++seed) {
    way.values.emplace_back(
        [rays, samples = SampleEmitters(scene, SamplePattern::kSobol, count,
                                        static_cast<std::uint64_t>(seed))](
            const Receiver& receiver) {
          return FirstChannel(rays->Estimate(receiver, samples));
        });
  }
  return way;
}

std::vector<Way> Ways(const Scene& scene, int seeds) {
  std::vector<Way> ways = {Certified(scene, Method::kCertified, "E certified"),
                           Certified(scene, Method::kDouble, "E in double")};
  if (ShadowRaysAvailable()) {
    const auto rays = std::make_shared<const ShadowRays>(scene);
    for (const int count : {4096, 65536}) {
      ways.push_back(Sampled(scene, rays, count, seeds,
                             fmt::format("Embree Sobol {}", count)));
    }
  }
  ways.push_back(Sampled(scene, std::make_shared<const DoubleRays>(scene),
                         65536, seeds, "rays in double Sobol 65536"));
  return ways;
}

/// The largest error of a component of the difference quotient, relative to
/// the length of the gradient.
double ErrorOf(const Value& value, const Receiver& receiver, double step,
               const Vector3& gradient) {
  constexpr std::array kPosition = {&Point3::x, &Point3::y, &Point3::z};
  constexpr std::array kGradient = {&Vector3::x, &Vector3::y, &Vector3::z};
  double worst = 0;
  for (std::size_t axis = 0; axis < kPosition.size(); ++axis) {
    Receiver below = receiver;
    Receiver above = receiver;
    below.position.*kPosition[axis] -= step;
    above.position.*kPosition[axis] += step;
    // The distance between the rounded places, which is exact; 2 h would add
    // an error that a careful caller does not make.
    const double distance =
        above.position.*kPosition[axis] - below.position.*kPosition[axis];
    const double quotient = (value(above) - value(below)) / distance;
    worst = std::max(worst, std::abs(quotient - gradient.*kGradient[axis]));
  }
  return worst / std::hypot(gradient.x, gradient.y, gradient.z);
}

/// Medians over the seeds, by descending steps.
StepCurve Measure(const Way& way, const Place& place, const Vector3& gradient) {
  StepCurve curve{place.name, way.name, {}};
  for (int i = 0; i < kSteps; ++i) {
    const double step = std::pow(10, -1 - i / 2.0);
    std::vector<double> errors;
    for (const Value& value : way.values)
      errors.push_back(ErrorOf(value, place.receiver, step, gradient));
    curve.points.push_back({step, Median(errors)});
  }
  return curve;
}

/// One row per receiver, method and step.
void PrintTable(const std::vector<StepCurve>& curves) {
  fmt::print("receiver,method,step,relative_error\n");
  for (const StepCurve& curve : curves) {
    for (const StepError& point : curve.points) {
      fmt::print("{},{},{:.2e},{:.2e}\n", curve.receiver, curve.method,
                 point.step, point.error);
    }
  }
}

void WriteFile(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.Write(text);
  file.Finish();
  file.Commit();
}

void Measure(const Options& options) {
  const Scene scene = LampWithTwoBlockers();
  const Oracle oracle(scene);
  const std::vector<Way> ways = Ways(scene, options.seeds);
  std::vector<StepCurve> curves;
  for (const Place& place : Places()) {
    const Derivatives truth = oracle.Derivatives(place.receiver);
    for (const Way& way : ways)
      curves.push_back(Measure(way, place, truth.channels[0].gradient));
  }
  PrintTable(curves);
  if (!options.svg.empty()) WriteFile(options.svg, StepChart(curves));
}

ExitStatus Run(int argc, char** argv) {
  Options options;
  CLI::App app("What central differences of the irradiance lose.",
               "finite_differences");
  app.add_option("--seeds", options.seeds,
                 "of the samples of shadow rays; errors are medians over them")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--svg", options.svg, "draw the errors against the step")
      ->type_name("FILE");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ExitStatus::kDone : ExitStatus::kBadInput;
  }
  try {
    Measure(options);
    return ExitStatus::kDone;
  } catch (const UserError& error) {
    Print(error.diagnostics());
    return ExitStatus::kBadInput;
  }
}

}  // namespace
}  // namespace truelux::bench

int main(int argc, char** argv) {
  try {
    return static_cast<int>(truelux::bench::Run(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error: %s\n", error.what());
  }
  return static_cast<int>(truelux::ExitStatus::kInternalError);
}
