// SPDX-License-Identifier: GPL-3.0-or-later
// Uses each public header's part that has to be linked; exits with 0 if the
// answers are right.

#include <cmath>
#include <cstdio>
#include <vector>

#include "truelux/truelux.h"

#ifdef CGAL_VERSION
#error "the public headers must not include CGAL"
#endif

namespace {

/// Says what is wrong, and counts.
class Checks {
 public:
  void Expect(bool right, const char* what) {
    if (right) return;
    std::printf("wrong: %s\n", what);
    ++failures_;
  }

  [[nodiscard]] bool AllRight() const { return failures_ == 0; }

 private:
  int failures_ = 0;
};

/// An exception has to be the same type inside the library and here.
bool NamesTheReceiver(const truelux::Oracle& oracle) {
  std::vector<truelux::Receiver> receivers(3, {{0, 0, 0}, {0, 0, 1}, 0});
  receivers[2].normal = {0, 0, 0};
  try {
    (void)oracle.Evaluate(receivers);
  } catch (const truelux::ReceiverError& error) {
    return error.index() == 2;
  }
  return false;
}

void CheckOracles(const truelux::Scene& scene, Checks& checks) {
  const truelux::PreparedScene prepared(scene);
  const truelux::Oracle oracle(prepared);
  const truelux::Oracle fast(prepared, {.method = truelux::Method::kDouble});
  const truelux::Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  truelux::Irradiance e = oracle.Evaluate(receiver);
  std::printf("%.17g\n", e.value[0]);
  checks.Expect(std::abs(e.value[0] - 0.5541) < 1e-4, "Evaluate");
  const double difference = fast.Evaluate(receiver).value[0] - e.value[0];
  checks.Expect(std::abs(difference) < 1e-14, "the second oracle");
  const truelux::FormFactorTable factors = oracle.FormFactors(receiver);
  checks.Expect(
      factors.faces.size() == 1 && factors.faces[0].face == 1 &&
          factors.faces[0].value == oracle.FormFactor(receiver, 1).value[0],
      "FormFactors");
  checks.Expect(oracle.Contour(receiver).arcs.size() == 4, "Contour");
  const auto single = oracle.EvaluateFormula(
      receiver, truelux::Formula::kUnified, truelux::Arithmetic::kFloat);
  checks.Expect(single && std::abs((*single)[0] - e.value[0]) < 1e-6,
                "EvaluateFormula");
  checks.Expect(NamesTheReceiver(oracle), "ReceiverError");
  e.statistics += e.statistics;
  checks.Expect(e.statistics.sources == 2, "Statistics");
}

}  // namespace

int main() {
  truelux::SceneBuilder builder;
  builder.AddFace({{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}}, {1, 1, 1});
  const truelux::Result<truelux::Scene> scene = builder.Build();
  if (!scene.ok()) return 1;
  Checks checks;
  CheckOracles(*scene.value, checks);
  const truelux::Result<truelux::Scene> none =
      truelux::ReadScene("no such file");
  checks.Expect(!none.ok() && !none.diagnostics[0].Text().empty(), "ReadScene");
  checks.Expect(truelux::ParseNumber("1e3") == 1000, "ParseNumber");
  checks.Expect(
      truelux::IrradianceFromSphere({{0, 0, 0}, {0, 0, 1}, 0},
                                    {{0, 0, 2}, 1, {4, 4, 4}})[0] == 1,
      "IrradianceFromSphere");
  checks.Expect(truelux::Name(truelux::Engine::kContour) == "contour", "Name");
  checks.Expect(truelux::FormulaByName("auto") == truelux::Formula::kAuto,
                "FormulaByName");
  checks.Expect(truelux::VersionNumber() == TRUELUX_VERSION, "VersionNumber");
  return checks.AllRight() ? 0 : 1;
}
