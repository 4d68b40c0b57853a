// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/load_candidate.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "truelux/diagnostics.h"

#include "run/user_error.h"
#include "scene/diagnostic_list.h"
#include "text/read_rows.h"

namespace truelux {

LoadedCandidate LoadCandidate(ByteSource& source, const std::string& name,
                              const CandidateRules& rules, FaceWords& faces) {
  CandidateReader reader(source, name, rules, faces);
  CandidateReceivers rows;
  std::vector<Rgb> values;
  std::vector<GradientRow> gradients;
  std::vector<FaceChoice> choices;
  const DiagnosticList defects =
      ReadRows<CandidateRow>(reader, name, [&](const CandidateRow& row) {
        rows.receivers.push_back(row.receiver);
        choices.push_back(row.face);
        rows.lines.push_back(static_cast<std::size_t>(row.line));
        if (reader.quantity() == Quantity::kGradient)
          gradients.push_back(row.gradient);
        else
          values.push_back(row.values);
      });
  if (defects.has_errors()) throw UserError(defects.Sorted());
  if (rows.receivers.empty()) {
    throw UserError({Diagnostic{Severity::kError, name, 0,
                                "no receivers: the table has only a header"}});
  }
  for (std::size_t i = 0; i < choices.size(); ++i)
    SetFace(faces.scene(), choices[i], rows.receivers[i], rows.found);
  rows.channels = reader.channels();
  rows.value_names = reader.value_names();
  if (reader.quantity() == Quantity::kGradient) {
    return {GradientData{std::move(rows), std::move(gradients), {}},
            reader.ignores_irradiance()};
  }
  return {CandidateData{std::move(rows), std::move(values), {}}, false};
}

}  // namespace truelux
