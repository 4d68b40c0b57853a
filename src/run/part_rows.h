// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of an evaluation that are kept if it is interrupted.

#ifndef TRUELUX_RUN_PART_ROWS_H_
#define TRUELUX_RUN_PART_ROWS_H_

#include <optional>
#include <string>
#include <string_view>

#include "run/evaluation.h"
#include "run/output_file.h"
#include "run/part_file.h"

namespace truelux {

/// Rows to a PartFile, whose blocks say what their rows are counted by.
class PartRows : public RowSink {
 public:
  /// As PartFile.
  PartRows(const std::string& path, const std::string& key);

  /// What is done, those of earlier runs included; nothing if not even the
  /// header is.
  [[nodiscard]] std::optional<EvaluationCounts> done() const;

  [[nodiscard]] const std::string& path() const { return file_.path(); }

  void Take(std::string_view rows, const EvaluationCounts& counts) override;

  /// Writes all rows.
  void CopyTo(OutputFile& output) const;

  /// After the output has its name.
  void Remove() { file_.Remove(); }

 private:
  EvaluationCounts counts_;  ///< before file_, which fills it
  PartFile file_;
};

}  // namespace truelux

#endif  // TRUELUX_RUN_PART_ROWS_H_
