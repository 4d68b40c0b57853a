// SPDX-License-Identifier: GPL-3.0-or-later
// The receivers of a candidate, without their values.

#ifndef TRUELUX_COMPARE_CANDIDATE_RECEIVERS_H_
#define TRUELUX_COMPARE_CANDIDATE_RECEIVERS_H_

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "truelux/receiver.h"

#include "text/face_choice.h"

namespace truelux {

struct CandidateReceivers {
  std::vector<std::string> value_names;  ///< of the compared columns: "E_r"
  std::vector<std::size_t> channels;     ///< which channels of the scene
  std::vector<Receiver> receivers;
  FoundFaces found;            ///< how faces of the receivers were found
  const char* place = "line";  ///< what `lines` are, for reports
  std::vector<std::size_t>
      lines;  ///< of the receivers in the candidate's table
};

/// The entries of the compared channels, first; the others are 0.
template <class T>
[[nodiscard]] std::array<T, 3> PickChannels(
    std::span<const std::size_t> channels, const std::array<T, 3>& all) {
  std::array<T, 3> picked{};
  for (std::size_t c = 0; c < channels.size(); ++c)
    picked[c] = all[channels[c]];
  return picked;
}

/// These entries in their places again; the others are 0.
template <class T>
[[nodiscard]] std::array<T, 3> SpreadChannels(
    std::span<const std::size_t> channels, const std::array<T, 3>& picked) {
  std::array<T, 3> all{};
  for (std::size_t c = 0; c < channels.size(); ++c)
    all[channels[c]] = picked[c];
  return all;
}

/// Some of them, by their indices; without `found`.
[[nodiscard]] inline CandidateReceivers SomeReceiversOf(
    const CandidateReceivers& all, std::span<const std::size_t> indices) {
  CandidateReceivers some;
  some.value_names = all.value_names;
  some.channels = all.channels;
  some.place = all.place;
  for (const std::size_t i : indices) {
    some.receivers.push_back(all.receivers[i]);
    some.lines.push_back(all.lines[i]);
  }
  return some;
}

}  // namespace truelux

#endif  // TRUELUX_COMPARE_CANDIDATE_RECEIVERS_H_
