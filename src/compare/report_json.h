// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of reports as JSON; keys in docs/compare.md.

#ifndef TRUELUX_COMPARE_REPORT_JSON_H_
#define TRUELUX_COMPARE_REPORT_JSON_H_

#include <cstddef>
#include <nlohmann/json.hpp>

#include "truelux/comparison.h"
#include "truelux/scene.h"

#include "compare/candidate_receivers.h"
#include "explain/receiver_detail.h"

namespace truelux {

using Json = nlohmann::ordered_json;

/// A number; a string if it is not finite, for which JSON has no word.
[[nodiscard]] Json NumberJson(double value);

/// A list of three finite numbers.
[[nodiscard]] Json TripleJson(double x, double y, double z);

/// The line, position, normal and on_face of a receiver.
[[nodiscard]] Json PlaceJson(const CandidateReceivers& candidate,
                             std::size_t receiver);

/// What a receiver sees and what is hard about it.
[[nodiscard]] Json ReasonJson(const Scene& scene, const ReceiverDetail& detail);

/// A diagnosis, without classes of receivers.
[[nodiscard]] Json DiagnosisJson(const Diagnosis& diagnosis);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_REPORT_JSON_H_
