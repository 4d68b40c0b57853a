// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/candidate_report.h"

#include <fmt/format.h>
#include <utility>

#include "compare/report_lines.h"

namespace truelux {
namespace {

/// Builds the text line by line.
class CandidateWriter {
 public:
  explicit CandidateWriter(const CandidateReport& report) : report_(report) {}

  std::string Write() {
    WriteHead();
    WriteTable();
    WriteWorst();
    WriteDiagnosis();
    return lines_.Take();
  }

 private:
  void WriteHead() {
    const CandidateSummary& s = report_.summary;
    lines_.Line("scene           {}", report_.scene_name);
    lines_.Line("candidate       {}, {} {}", report_.candidate_name,
                report_.options.quantity == Quantity::kFormFactor
                    ? "form factor"
                    : "irradiance",
                fmt::join(report_.data.value_names, ","));
    lines_.Line("tolerance       {}", Exactly(report_.tolerance));
    lines_.Line("result          {}: {} of {} receivers fail",
                report_.passes() ? "PASS" : "FAIL", s.failing(), s.receivers);
    lines_.Line("");
  }

  void WriteTable() {
    const CandidateSummary& s = report_.summary;
    lines_.Line("receivers       {:>8}", s.receivers);
    lines_.Line("E > 0           {:>8}   exact {}, failing {}", s.lit,
                s.lit_exact, s.lit_failing);
    lines_.Line(
        "E = 0           {:>8}   exact {}, failing {}, largest value {}",
        s.dark, s.dark_exact, s.dark_failing, Short(s.max_dark_absolute));
    lines_.Line("not a number    {:>8}", s.no_number);
    if (s.relative) {
      const CandidateSummary::Relative& r = *s.relative;
      lines_.Line("");
      lines_.Line("relative error  RMS {}, mean {}, signed mean {}",
                  Short(r.rms), Short(r.mean), SignedText(r.bias));
      lines_.Line("  where E > 0   50 % {}, 95 % {}, 99 % {}, 100 % {}",
                  Short(r.median), Short(r.percentile_95),
                  Short(r.percentile_99), Short(r.max));
    }
    if (s.lit + s.dark > 0)
      lines_.Line("absolute error  max {}", Short(s.max_absolute));
    if (s.lit > 0) {
      std::string bins;
      for (std::size_t i = 0; i < s.ulps.counts.size(); ++i) {
        if (s.ulps.counts[i] == 0) continue;
        if (!bins.empty()) bins += ", ";
        bins += fmt::format("{}: {}", UlpBinText(i), s.ulps.counts[i]);
      }
      lines_.Line("ulps            {}", bins);
    }
  }

  [[nodiscard]] std::string ValuesText(const Rgb& values) const {
    std::string text;
    for (std::size_t c = 0; c < report_.data.channels.size(); ++c)
      text += (c == 0 ? "" : ", ") + Exactly(values[c]);
    return text;
  }

  void WriteWorst() {
    if (report_.worst.empty()) return;
    lines_.Line("");
    lines_.Line("worst receivers");
    const CandidateData& data = report_.data;
    for (std::size_t k = 0; k < report_.worst.size(); ++k) {
      const WorstCandidate& worst = report_.worst[k];
      const std::size_t i = worst.receiver;
      const CandidateError& e = report_.errors[i];
      lines_.AddPlace(k, data, i);
      lines_.Line("     candidate {}", ValuesText(data.values[i]));
      lines_.Line("     truelux   {}", ValuesText(data.truth[i]));
      if (e.no_number) {
        lines_.Line("     not a number");
      } else if (e.is_dark) {
        lines_.Line("     E = 0; {} of the largest E", Short(e.excess));
      } else {
        lines_.Line("     relative error {}, absolute {}", Short(e.excess),
                    Short(e.error.absolute));
      }
      lines_.Line("     {}", SummaryOf(worst.detail));
      constexpr std::size_t kMostLines = 3;
      for (const std::string& line :
           LinesOf(report_.scene, worst.detail, kMostLines))
        lines_.Line("       {}", line);
    }
  }

  void WriteDiagnosis() {
    lines_.AddDiagnosis(report_.diagnosis);
    if (report_.classified.empty()) return;
    lines_.Line("  {}", WhereItFails(report_.classified));
    for (const FailureClass& c : FailureClasses(report_.classified)) {
      lines_.Line("    {:<20}{:>6} of {} fail", c.name, c.failing, c.receivers);
    }
  }

  const CandidateReport& report_;
  ReportLines lines_;
};

}  // namespace

std::string_view Name(Quantity quantity) {
  switch (quantity) {
    case Quantity::kIrradiance:
      break;
    case Quantity::kFormFactor:
      return "form-factor";
    case Quantity::kGradient:
      return "gradient";
  }
  return "irradiance";
}

std::string CandidateText(const CandidateReport& report) {
  return CandidateWriter(report).Write();
}

}  // namespace truelux
