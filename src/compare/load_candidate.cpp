// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/load_candidate.h"

#include <utility>
#include <vector>

#include "truelux/diagnostics.h"

#include "run/user_error.h"
#include "scene/diagnostic_list.h"

namespace truelux {

CandidateData LoadCandidate(ByteSource& source, const std::string& name,
                            const CandidateRules& rules) {
  CandidateReader reader(source, name, rules);
  DiagnosticList all_defects(name);
  std::vector<Diagnostic> defects;
  CandidateData data;
  CandidateRow row;
  auto status = CandidateReader::Status::kRow;
  // Rows mean nothing without a header.
  if (!reader.ReadHeader(defects)) status = CandidateReader::Status::kEnd;
  for (;;) {
    for (Diagnostic& defect : defects)
      all_defects.Add(std::move(defect));
    defects.clear();
    if (status == CandidateReader::Status::kEnd) break;
    status = reader.Next(row, defects);
    if (status != CandidateReader::Status::kRow) continue;
    data.receivers.push_back(row.receiver);
    data.lines.push_back(row.line);
    data.values.push_back(row.values);
  }
  if (all_defects.has_errors()) throw UserError(all_defects.Sorted());
  if (data.receivers.empty()) {
    throw UserError({Diagnostic{Severity::kError, name, 0,
                                "no receivers: the table has only a header"}});
  }
  data.channels = reader.channels();
  data.value_names = reader.value_names();
  return data;
}

}  // namespace truelux
