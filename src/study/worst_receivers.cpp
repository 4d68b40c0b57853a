// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/worst_receivers.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace truelux {
namespace {

/// The worst and the best answer of a group at one receiver, if any is wrong.
std::optional<WorstReceiver> AtReceiver(const Comparison& comparison,
                                        std::span<const std::size_t> methods,
                                        std::size_t receiver) {
  std::optional<WorstReceiver> found;
  for (const std::size_t m : methods) {
    const std::optional<Rgb>& value = comparison.methods[m].values[receiver];
    if (!value) continue;
    const ValueError error = ErrorOf(*value, comparison.truth[receiver]);
    if (!found) found = WorstReceiver{receiver, m, error, m, error};
    if (RankOf(error) > RankOf(found->error)) {
      found->method = m;
      found->error = error;
    }
    if (RankOf(error) < RankOf(found->best_error)) {
      found->best_method = m;
      found->best_error = error;
    }
  }
  if (found && found->error.exact) found.reset();
  return found;
}

WorstOfGroup WorstOf(const Comparison& comparison, const std::string& group,
                     std::size_t most) {
  std::vector<std::size_t> methods;
  for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
    if (comparison.methods[m].group == group) methods.push_back(m);
  }
  WorstOfGroup result{group, 0, {}};
  for (std::size_t i = 0; i < comparison.receivers.size(); ++i) {
    if (const auto found = AtReceiver(comparison, methods, i))
      result.worst.push_back(*found);
  }
  result.wrong = result.worst.size();
  std::ranges::stable_sort(result.worst,
                           [](const WorstReceiver& a, const WorstReceiver& b) {
                             return RankOf(a.error) > RankOf(b.error);
                           });
  if (result.worst.size() > most) result.worst.resize(most);
  return result;
}

}  // namespace

double RankOf(const ValueError& error) {
  return error.false_light ? std::numeric_limits<double>::infinity()
                           : error.relative.value_or(0);
}

std::vector<WorstOfGroup> WorstReceivers(const Comparison& comparison,
                                         std::size_t most) {
  std::vector<WorstOfGroup> groups;
  for (const std::string& group : GroupsOf(comparison))
    groups.push_back(WorstOf(comparison, group, most));
  return groups;
}

std::vector<std::size_t> ReceiversOf(std::span<const WorstOfGroup> groups) {
  std::size_t longest = 0;
  for (const WorstOfGroup& group : groups)
    longest = std::max(longest, group.worst.size());
  std::vector<std::size_t> receivers;
  for (std::size_t rank = 0; rank < longest; ++rank) {
    for (const WorstOfGroup& group : groups) {
      if (rank >= group.worst.size()) continue;
      const std::size_t receiver = group.worst[rank].receiver;
      if (std::ranges::find(receivers, receiver) == receivers.end())
        receivers.push_back(receiver);
    }
  }
  return receivers;
}

}  // namespace truelux
