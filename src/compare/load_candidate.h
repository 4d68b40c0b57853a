// SPDX-License-Identifier: GPL-3.0-or-later
// A candidate's whole table.

#ifndef TRUELUX_COMPARE_LOAD_CANDIDATE_H_
#define TRUELUX_COMPARE_LOAD_CANDIDATE_H_

#include <string>
#include <variant>

#include "compare/candidate_errors.h"
#include "compare/candidates.h"
#include "compare/gradients/gradient_data.h"
#include "text/byte_source.h"
#include "text/face_choice.h"

namespace truelux {

/// A candidate without the truth.
struct LoadedCandidate {
  std::variant<CandidateData, GradientData> data;
  /// The table has irradiances, too, which are not compared.
  bool ignores_irradiance = false;
};

/// Reads `source`, which messages call `name`, to its end, and finds the faces
/// that have to be searched for. Throws UserError with all defects or if there
/// is no receiver, and what the source throws.
[[nodiscard]] LoadedCandidate LoadCandidate(ByteSource& source,
                                            const std::string& name,
                                            const CandidateRules& rules,
                                            FaceWords& faces);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_LOAD_CANDIDATE_H_
