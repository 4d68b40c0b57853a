// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/failure_classes.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace truelux {
namespace {

bool IsNearHorizon(const ReceiverTraits& traits) {
  return IsLit(traits) && (traits.highest < kGrazingHighest ||
                           traits.lowest.value_or(1) < kGrazingLowest);
}

struct ClassTest {
  std::string_view name;
  bool (*holds)(const ReceiverTraits& traits);
};

constexpr std::array<ClassTest, 6> kClasses = {
    {{"unlit",
      [](const ReceiverTraits& t) { return t.lighting == Lighting::kUnlit; }},
     {"umbra",
      [](const ReceiverTraits& t) { return t.lighting == Lighting::kUmbra; }},
     {"fully lit",
      [](const ReceiverTraits& t) {
        return t.lighting == Lighting::kFullyLit;
      }},
     {"penumbra",
      [](const ReceiverTraits& t) {
        return t.lighting == Lighting::kPenumbra;
      }},
     {"with a conjunction",
      [](const ReceiverTraits& t) { return t.conjunctions > 0; }},
     {"near the horizon", IsNearHorizon}}};

}  // namespace

std::vector<FailureClass> FailureClasses(
    std::span<const ClassifiedReceiver> receivers) {
  std::vector<FailureClass> classes;
  for (const ClassTest& test : kClasses) {
    FailureClass found{test.name, 0, 0};
    for (const ClassifiedReceiver& receiver : receivers) {
      if (!test.holds(receiver.traits)) continue;
      ++found.receivers;
      if (!receiver.passes) ++found.failing;
    }
    if (found.receivers > 0) classes.push_back(found);
  }
  return classes;
}

std::string WhereItFails(std::span<const ClassifiedReceiver> receivers) {
  const auto passing = static_cast<std::size_t>(
      std::ranges::count_if(receivers, &ClassifiedReceiver::passes));
  const std::size_t failing = receivers.size() - passing;
  if (passing == 0)
    return fmt::format("all {} receivers looked at fail", receivers.size());
  // The narrowest class that holds all that fail, but not all receivers.
  const std::vector<FailureClass> classes = FailureClasses(receivers);
  const FailureClass* narrowest = nullptr;
  for (const FailureClass& c : classes) {
    if (c.failing != failing || c.receivers == receivers.size()) continue;
    if (narrowest == nullptr || c.receivers < narrowest->receivers)
      narrowest = &c;
  }
  const std::string count = fmt::format("{} of {} receivers looked at fail",
                                        failing, receivers.size());
  if (narrowest == nullptr) return count;
  return fmt::format("{}, all of them {} ({} of the {} such)", count,
                     narrowest->name, narrowest->failing, narrowest->receivers);
}

}  // namespace truelux
