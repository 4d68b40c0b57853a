// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers in, results out: spread over threads, in order, in bounded memory.

#ifndef TRUELUX_RUN_EVALUATION_H_
#define TRUELUX_RUN_EVALUATION_H_

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/irradiance.h"
#include "truelux/statistics.h"

#include "run/output_file.h"
#include "run/progress.h"
#include "text/face_choice.h"
#include "text/receiver_sample.h"
#include "text/receivers.h"

namespace truelux {

/// What rows are counted by.
struct EvaluationCounts {
  std::uint64_t receivers = 0;    ///< rows written
  std::uint64_t lit = 0;          ///< of these, with a value that is not 0
  std::uint64_t overflowing = 0;  ///< of these, with an infinite value
  /// Of these, with a value that the formula does not give or not bound.
  std::uint64_t unanswered = 0;
  std::uint64_t behind_faces = 0;  ///< of these, with no face and no light, see
                                   ///< Scene::IsBehindFace
  FoundFaces faces;                ///< how faces of the receivers were found

  EvaluationCounts& operator+=(const EvaluationCounts& other);
};

/// Where the rows go, block after block, in their order.
class RowSink {
 public:
  RowSink() = default;
  virtual ~RowSink() = default;
  RowSink(const RowSink&) = delete;
  RowSink& operator=(const RowSink&) = delete;

  /// rows: whole lines, and what they are counted by.
  virtual void Take(std::string_view rows, const EvaluationCounts& counts) = 0;
};

/// Rows to a file.
class OutputRows : public RowSink {
 public:
  /// output: must outlive the object.
  explicit OutputRows(OutputFile& output) : output_(output) {}

  void Take(std::string_view rows,
            const EvaluationCounts& /*counts*/) override {
    output_.Write(rows);
  }

 private:
  OutputFile& output_;
};

/// How an evaluation went.
struct EvaluationSummary : EvaluationCounts {
  Statistics statistics;  ///< of the rows that this run has evaluated
  ReceiverSample sample;  ///< of the receivers
  /// What ended the input early: the defects of the first defective row.
  std::vector<Diagnostic> defects;
};

/// How a table is evaluated.
struct EvaluationTask {
  int threads = 1;
  bool shows_faces = false;  ///< the output has a column on_face_found
  /// What an earlier run has done: the header, and the first rows.
  std::optional<EvaluationCounts> done = {};
};

/// Evaluates every receiver that `reader` still has (its header has been
/// read), but for the first rows that are done, and hands the rows of the table
/// with the results to `sink`.
///
/// The rows, and their order, do not depend on the number of threads. What is
/// held in memory does not grow with the number of rows. Throws Stopped
/// within one receiver per thread after the program was interrupted, and what
/// the reader, the oracle and the output throw.
EvaluationSummary Evaluate(const Oracle& oracle, ReceiverReader& reader,
                           RowSink& sink, const EvaluationTask& task,
                           Progress& progress);

}  // namespace truelux

#endif  // TRUELUX_RUN_EVALUATION_H_
