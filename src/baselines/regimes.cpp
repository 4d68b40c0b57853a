// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/regimes.h"

#include <cmath>
#include <initializer_list>
#include <utility>

#include "baselines/regime_loops.h"
#include "baselines/regime_shadows.h"

namespace truelux {
namespace {

constexpr Receiver kUp{{0, 0, 0}, {0, 0, 1}, 0};

/// A power of ten as in "1e-3", and its value.
struct Size {
  std::string text;
  double value;
};

Size Tenth(int exponent) {
  return {"1e-" + std::to_string(exponent), std::pow(10, -exponent)};
}

class List {
 public:
  /// loop: (CaseRandom&) -> Loop.
  template <class Function>
  void AddLoops(const std::string& name, Function loop) {
    Add(name, false, [loop](CaseRandom& random) {
      return RegimeCase{{}, kUp, loop(random)};
    });
  }

  void Add(std::string name, bool occluded,
           std::function<RegimeCase(CaseRandom&)> draw) {
    regimes_.push_back({std::move(name), occluded, std::move(draw)});
  }

  std::vector<Regime> Take() { return std::move(regimes_); }

 private:
  std::vector<Regime> regimes_;
};

void AddUnoccluded(List& list) {
  for (int k = 0; k <= 8; ++k) {
    list.AddLoops("size " + Tenth(k).text, [size = Tenth(k).value](auto& r) {
      return LoopOfSize(r, size);
    });
  }
  for (const int k : {2, 4, 6, 8}) {
    list.AddLoops("elevation " + Tenth(k).text + " iso",
                  [elevation = Tenth(k).value](auto& r) {
                    return LowLoop(r, elevation);
                  });
  }
  for (const int k : {2, 4, 6, 8}) {
    list.AddLoops("elevation " + Tenth(k).text + " wide",
                  [elevation = Tenth(k).value](auto& r) {
                    return WideLowLoop(r, elevation);
                  });
  }
  list.AddLoops("1 vertex at 1e-12",
                [](auto& r) { return LoopDownToTheHorizon(r, 1); });
  list.AddLoops("2 vertices at 1e-12",
                [](auto& r) { return LoopDownToTheHorizon(r, 2); });
  list.AddLoops("sliver 0.5 x 5e-7",
                [](auto& r) { return SliverLoop(r, 0.5, 5e-7); });
  list.AddLoops("sliver 2e-3 x 2e-9",
                [](auto& r) { return SliverLoop(r, 2e-3, 2e-9); });
  for (const int k : {4, 8}) {
    list.AddLoops(Tenth(k).text + " off the source plane",
                  [distance = Tenth(k).value](auto& r) {
                    return LoopSeenFlat(r, distance);
                  });
  }
  list.AddLoops("source plane 1e-8 up beside",
                [](auto& r) { return LoopInFloor(r, 1e-8, false); });
  list.AddLoops("source plane 1e-8 up above",
                [](auto& r) { return LoopInFloor(r, 1e-8, true); });
  list.AddLoops("vertical edges",
                [](auto& r) { return LoopWithVerticalEdges(r, 0); });
  list.AddLoops("edges 1e-9 off vertical",
                [](auto& r) { return LoopWithVerticalEdges(r, 1e-9); });
  list.AddLoops("edge 1e-9 off the axis",
                [](auto& r) { return LoopBesideTheAxis(r, 1e-9); });
  for (const Size& size : {Size{"1", 1.0}, Size{"1e-3", 1e-3}}) {
    for (const Size& offset : {Size{"0", 0.0}, Size{"1e3", 1e3},
                               Size{"1e6", 1e6}, Size{"1e9", 1e9}}) {
      list.Add("far " + offset.text + " size " + size.text, false,
               [o = offset.value, s = size.value](CaseRandom& r) {
                 return FarCase(r, o, s);
               });
    }
  }
}

void AddOccluded(List& list) {
  using Family = RegimeCase (*)(CaseRandom&, double);
  const auto add = [&list](const std::string& name, Family family,
                           std::initializer_list<int> exponents) {
    for (const int k : exponents) {
      list.Add(name + " " + Tenth(k).text, true,
               [family, size = Tenth(k).value](CaseRandom& r) {
                 return family(r, size);
               });
    }
  };
  const std::initializer_list<int> to_rounding = {2, 4, 6, 8, 10, 12, 14};
  add("conjunction missed by", NearConjunction, to_rounding);
  add("vertex misses edge by", VertexNearEdge, to_rounding);
  add("edges apart by", NearlyEqualEdges, to_rounding);
  add("slit", Slit, to_rounding);
  add("thin blockers", ThinBlockers, {3, 6, 9});
  add("pinhole", Pinhole, {3, 6});
}

}  // namespace

RegimeCase Regime::Make(std::uint64_t seed, std::uint64_t index) const {
  CaseRandom random(seed, index);
  return draw(random);
}

std::vector<Regime> Regimes() {
  List list;
  AddUnoccluded(list);
  AddOccluded(list);
  return list.Take();
}

}  // namespace truelux
