// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report_lines.h"

#include <cmath>

#include "explain/edge_text.h"
#include "text/number_text.h"
#include "text/results.h"

namespace truelux {

std::string Short(double value) {
  constexpr int kDigits = 2;
  return ScientificText(value, kDigits);
}

std::string SignedText(double value) {
  return (value < 0 ? "-" : "+") + Short(std::abs(value));
}

std::string Exactly(double value) {
  std::string text;
  AppendNumber(text, value);
  return text;
}

void ReportLines::AddPlace(std::size_t number,
                           const CandidateReceivers& candidate,
                           std::size_t receiver) {
  const Receiver& r = candidate.receivers[receiver];
  Line("{:>3}. {} {}: at {}, normal {}{}", number + 1, candidate.place,
       candidate.lines[receiver], TextOf(r.position),
       TextOf(Point3{r.normal.x, r.normal.y, r.normal.z}),
       r.on_face > 0 ? fmt::format(", on face {}", r.on_face) : "");
}

void ReportLines::AddDiagnosis(const Diagnosis& diagnosis) {
  if (diagnosis.verdict == Verdict::kNothingFails) return;
  Line("");
  Line("diagnosis");
  Line("  {}", diagnosis.text);
  for (const std::string& sentence : diagnosis.equally)
    Line("  equally well explained: {}", sentence);
  for (const std::string& note : diagnosis.notes)
    Line("  {}", note);
}

}  // namespace truelux
