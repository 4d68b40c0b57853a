// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/load_candidate.h"

#include <cstddef>
#include <vector>

#include "truelux/diagnostics.h"

#include "run/user_error.h"
#include "scene/diagnostic_list.h"
#include "text/read_rows.h"

namespace truelux {

CandidateData LoadCandidate(ByteSource& source, const std::string& name,
                            const CandidateRules& rules, FaceWords& faces) {
  CandidateReader reader(source, name, rules, faces);
  CandidateData data;
  std::vector<FaceChoice> choices;
  const DiagnosticList defects =
      ReadRows<CandidateRow>(reader, name, [&](const CandidateRow& row) {
        data.receivers.push_back(row.receiver);
        choices.push_back(row.face);
        data.lines.push_back(row.line);
        data.values.push_back(row.values);
      });
  if (defects.has_errors()) throw UserError(defects.Sorted());
  if (data.receivers.empty()) {
    throw UserError({Diagnostic{Severity::kError, name, 0,
                                "no receivers: the table has only a header"}});
  }
  for (std::size_t i = 0; i < choices.size(); ++i)
    SetFace(faces.scene(), choices[i], data.receivers[i], data.found);
  data.channels = reader.channels();
  data.value_names = reader.value_names();
  return data;
}

}  // namespace truelux
