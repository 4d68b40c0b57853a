// SPDX-License-Identifier: GPL-3.0-or-later
#include "bar.h"

#include <string_view>

#include "methods.h"

namespace truelux::bench {
namespace {

/// A method on a scene.
struct Side {
  std::string scene;
  std::string method;
};

/// The time of a by that of b.
struct Demand {
  Side a;
  Side b;
  double at_most = 0;
  double aim = 0;
};

std::string Embree(int samples) {
  return SampledName(SamplePattern::kSobol, samples);
}

Demand OneScene(const std::string& scene, const std::string& a,
                const std::string& b, double at_most, double aim) {
  return {{scene, a}, {scene, b}, at_most, aim};
}

std::vector<Demand> Demands() {
  std::vector<Demand> demands = {
      OneScene("slab_100", kCertifiedName, Embree(1024), 0.9, 0.4),
      OneScene("slab_100", kDoubleName, Embree(256), 1.3, 0.9),
      OneScene("slab_1000", kCertifiedName, Embree(4096), 0.9, 0.45),
      OneScene("slab_1000", kDoubleName, Embree(4096), 0.5, 0.35),
      {{"slab_10", kCertifiedName}, {"slab_100", Embree(256)}, 0.5, 0.25},
      OneScene("slab_100", kCertifiedName, kDoubleName, 2.5, 1.5)};
  for (const char* scene : {"slab_100", "slab_1000"}) {
    demands.push_back(OneScene(scene, kDoubleName, kUnfilteredName, 1.3, 1.15));
  }
  for (const char* scene : {"lattice", "one_ulp"})
    demands.push_back(OneScene(scene, kDoubleName, kUnfilteredName, 5, 3));
  demands.push_back({{"outward_1000000", kCertifiedName},
                     {"outward_1000", kCertifiedName},
                     2,
                     1.3});
  demands.push_back(
      OneScene("overlapping_1000", kCertifiedName, kPolygonSetName, 1.2, 0.3));
  return demands;
}

std::string Text(const Demand& demand) {
  const std::string a = demand.a.scene + ": " + demand.a.method + " / ";
  if (demand.a.scene == demand.b.scene) return a + demand.b.method;
  return a + demand.b.scene + ": " + demand.b.method;
}

}  // namespace

std::vector<BarRow> RatioRows(const std::vector<Measurement>& measurements) {
  std::vector<BarRow> rows;
  for (const Demand& demand : Demands()) {
    BarRow row{Text(demand), {}, demand.at_most, demand.aim, ""};
    const Measurement* a = Find(measurements, demand.a.scene, demand.a.method);
    const Measurement* b = Find(measurements, demand.b.scene, demand.b.method);
    if (a != nullptr && b != nullptr) {
      row.measured = Ratio(*a, *b);
    } else {
      row.reason = "not measured in this run";
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace truelux::bench
