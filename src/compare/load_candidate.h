// SPDX-License-Identifier: GPL-3.0-or-later
// A candidate's whole table.

#ifndef TRUELUX_COMPARE_LOAD_CANDIDATE_H_
#define TRUELUX_COMPARE_LOAD_CANDIDATE_H_

#include <string>

#include "compare/candidate_errors.h"
#include "compare/candidates.h"
#include "text/byte_source.h"
#include "text/face_choice.h"

namespace truelux {

/// Reads `source`, which messages call `name`, to its end, and finds the faces
/// that have to be searched for. The truth is left
/// empty. Throws UserError with all defects or if there is no receiver, and
/// what the source throws.
[[nodiscard]] CandidateData LoadCandidate(ByteSource& source,
                                          const std::string& name,
                                          const CandidateRules& rules,
                                          FaceWords& faces);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_LOAD_CANDIDATE_H_
