// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/formulas.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace truelux {
namespace {

using NamedFormula = std::pair<Formula, std::string_view>;

constexpr std::array<NamedFormula, 14> kNames = {{
    {Formula::kAuto, "auto"},
    {Formula::kLambertAcos, "lambert-acos"},
    {Formula::kLambertAtan2, "lambert-atan2"},
    {Formula::kLambertEdge, "lambert-edge"},
    {Formula::kVertexLambert, "vertex-lambert"},
    {Formula::kImagePlane, "image-plane"},
    {Formula::kDirections, "directions"},
    {Formula::kSphere, "sphere"},
    {Formula::kProjective, "projective"},
    {Formula::kHomogeneous, "homogeneous"},
    {Formula::kUnified, "unified"},
    {Formula::kDifference, "difference"},
    {Formula::kSeries, "series"},
    {Formula::kCubature, "cubature"},
}};

constexpr std::array<Formula, kNames.size()> kAll = [] {
  std::array<Formula, kNames.size()> all{};
  std::ranges::transform(kNames, all.begin(), &NamedFormula::first);
  return all;
}();

}  // namespace

std::span<const Formula> AllFormulas() {
  return kAll;
}

std::string_view Name(Formula formula) {
  return std::ranges::find(kNames, formula, &NamedFormula::first)->second;
}

std::optional<Formula> FormulaByName(std::string_view name) {
  const auto* found = std::ranges::find(kNames, name, &NamedFormula::second);
  if (found == kNames.end()) return std::nullopt;
  return found->first;
}

}  // namespace truelux
