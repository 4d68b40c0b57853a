// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers in, derivatives out: in order, over threads, in bounded memory.

#ifndef TRUELUX_GRADIENT_GRADIENT_RUN_H_
#define TRUELUX_GRADIENT_GRADIENT_RUN_H_

#include <array>
#include <cstdint>
#include <vector>

#include "truelux/derivatives.h"
#include "truelux/diagnostics.h"
#include "truelux/irradiance.h"
#include "truelux/statistics.h"

#include "gradient/derivative_columns.h"
#include "run/output_file.h"
#include "run/progress.h"
#include "text/face_choice.h"
#include "text/receiver_sample.h"
#include "text/receivers.h"

namespace truelux {

/// What is written, and where to.
struct GradientTask {
  int threads = 1;
  bool shows_faces = false;  ///< the output has a column on_face_found
  ColumnChoice columns;
  OutputFile* table = nullptr;  ///< one row per receiver
  OutputFile* kinks = nullptr;  ///< the table of kinks; null: none
  /// That of the sum over receivers and channels of weight times dE/dv, with
  /// weights from the columns kWeightColumns; null: none.
  OutputFile* vertex_gradient = nullptr;
  OutputFile* vertices = nullptr;  ///< that of dE/dv; null: none
};

/// Columns of a table whose receivers have weights.
inline constexpr std::array kWeightColumns = {"weight_r", "weight_g",
                                              "weight_b"};

/// How it went.
struct GradientSummary {
  std::uint64_t receivers = 0;
  std::uint64_t lit = 0;            ///< of these, with E > 0
  std::uint64_t kinks = 0;          ///< of these, at a kink
  std::uint64_t discontinuous = 0;  ///< of these, on a face
  std::uint64_t undecided = 0;      ///< numbers given as 0 with a bound
  int one_sided = 0;  ///< slopes of the vertex gradient that are means
  FoundFaces faces;
  Statistics statistics;
  ReceiverSample sample;
  std::vector<Diagnostic> defects;  ///< what ended the input early
};

/// Finds the derivatives at every receiver that `reader` still has (its header
/// has been read). The rows, and their order, do not depend on the number of
/// threads. Throws as Evaluate of run/evaluation.h does.
GradientSummary RunGradientTask(const Oracle& oracle, ReceiverReader& reader,
                                const GradientTask& task, Progress& progress);

}  // namespace truelux

#endif  // TRUELUX_GRADIENT_GRADIENT_RUN_H_
