// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/bench_methods.h"

#include <fmt/format.h>
#include <memory>
#include <stdexcept>
#include <utility>

#include "baselines/formula_contender.h"
#include "baselines/vertex_tracing.h"

namespace truelux {
namespace {

/// What methods are prepared from, and where they go.
struct Setting {
  const Scene& scene;
  const MethodChoice& choice;
  MethodList& list;

  void Add(Contender method, std::string group) const {
    method.group = std::move(group);
    list.methods.push_back(std::move(method));
  }

  void Add(Contender method) const {
    list.methods.push_back(std::move(method));
  }
};

constexpr const char* kOwnGroup = "truelux";

void AddOracles(const Setting& setting) {
  setting.Add(OracleContender(setting.scene, "certified", {}), kOwnGroup);
  setting.Add(
      OracleContender(setting.scene, "double", {.method = Method::kDouble}),
      kOwnGroup);
}

void AddArrangement(const Setting& setting) {
  const std::size_t triangles = setting.scene.triangles().size();
  if (triangles > kArrangementTriangles && !setting.choice.arrangement) {
    setting.list.absent.push_back(
        fmt::format("arrangement engine: too slow for {} triangles (more than "
                    "{}); --arrangement runs it",
                    triangles, kArrangementTriangles));
    return;
  }
  Contender method = OracleContender(setting.scene, "arrangement engine",
                                     {.engine = Engine::kArrangement});
  method.max_receivers = kArrangementReceivers;
  setting.Add(std::move(method), kOwnGroup);
}

void AddAngularSpans(const Setting& setting) {
  if (setting.scene.triangles().size() > kArrangementTriangles &&
      !setting.choice.arrangement) {
    return;  // the arrangement engine has said why
  }
  Contender method = OracleContender(setting.scene, "angular spans",
                                     {.engine = Engine::kAngularSpans});
  method.max_receivers = kArrangementReceivers;
  setting.Add(std::move(method), kOwnGroup);
}

/// Every formula in every arithmetic.
void AddFormulas(const Setting& setting) {
  for (const Arithmetic arithmetic :
       {Arithmetic::kFloat, Arithmetic::kDouble, Arithmetic::kDoubleDouble,
        Arithmetic::kMultiprecision}) {
    for (const Formula formula : AllFormulas()) {
      // kAuto is --method double, with the oracles.
      if (formula == Formula::kAuto) continue;
      setting.Add(FormulaContender(setting.scene, formula, arithmetic));
    }
  }
}

void AddVertexTracing(const Setting& setting) {
  const auto add = [&setting](const std::string& name,
                              const VertexTracingOptions& options) {
    const auto tracing =
        std::make_shared<const VertexTracing>(setting.scene, options);
    setting.Add(EachReceiver(name, "vertex tracing",
                             [tracing](const Receiver& receiver, std::size_t) {
                               return tracing->Evaluate(receiver);
                             }));
  };
  add("vertex tracing, rays", {});
  const std::vector<double> angles =
      setting.choice.quick ? std::vector{1e-6} : std::vector{1e-4, 1e-6, 1e-8};
  for (const double angle : angles) {
    add(fmt::format("vertex tracing, cones {:g}", angle),
        {.tracing = Tracing::kCones, .nape_angle = angle});
  }
}

void AddUnfiltered(const Setting& setting) {
  Contender method =
      UnfilteredContender(setting.scene, "unfiltered predicates");
  method.note = "takes rounded signs for true";
  setting.Add(std::move(method));
}

/// Monte Carlo and quasi-Monte Carlo.
void AddShadowRays(const Setting& setting) {
  std::shared_ptr<const ShadowRays> rays;
  try {
    rays = std::make_shared<const ShadowRays>(setting.scene);
  } catch (const std::runtime_error& error) {
    setting.list.absent.push_back(
        ShadowRaysAvailable()
            ? fmt::format("shadow rays: {}", error.what())
            : "shadow rays: Embree 3 was not found when this was built");
    return;
  }
  // Square numbers, as the pattern in rows needs.
  const std::vector<int> counts = setting.choice.quick
                                      ? std::vector{16, 256, 4096}
                                      : std::vector{16, 64, 256, 1024, 4096};
  for (const SamplePattern pattern :
       {SamplePattern::kRandom, SamplePattern::kSobol,
        SamplePattern::kRowOrdered}) {
    for (const int count : counts) {
      setting.Add(SampledContender(setting.scene, rays, pattern, count,
                                   setting.choice.seed));
    }
  }
}

void AddScanline(const Setting& setting) {
  const std::vector<int> rows = setting.choice.quick
                                    ? std::vector{8, 64, 256}
                                    : std::vector{8, 16, 32, 64, 128, 256};
  for (const int count : rows)
    setting.Add(ScanlineContender(setting.scene, count));
}

/// The families of methods, in the order in which a report shows them. Each
/// adds what it can run and says what it cannot. The first one adds the truth.
constexpr auto kFamilies = {AddOracles,    AddArrangement,   AddAngularSpans,
                            AddFormulas,   AddVertexTracing, AddUnfiltered,
                            AddShadowRays, AddScanline};

}  // namespace

MethodList PrepareMethods(const Scene& scene, const MethodChoice& choice) {
  MethodList list;
  const Setting setting{scene, choice, list};
  for (const auto add : kFamilies)
    add(setting);
  return list;
}

}  // namespace truelux
