// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/candidate_report.h"

#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <utility>

#include "explain/edge_text.h"
#include "text/number_text.h"
#include "text/results.h"

namespace truelux {
namespace {

constexpr int kDigits = 2;

std::string Short(double value) {
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

/// Builds the text line by line.
class CandidateWriter {
 public:
  explicit CandidateWriter(const CandidateReport& report) : report_(report) {}

  std::string Write() {
    WriteHead();
    WriteTable();
    WriteWorst();
    WriteDiagnosis();
    return std::move(text_);
  }

 private:
  template <class... Args>
  void Line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format,
                   std::forward<Args>(args)...);
    text_ += '\n';
  }

  void WriteHead() {
    const CandidateSummary& s = report_.summary;
    Line("scene           {}", report_.scene_name);
    Line("candidate       {}, {} {}", report_.candidate_name,
         report_.options.quantity == Quantity::kFormFactor ? "form factor"
                                                           : "irradiance",
         fmt::join(report_.data.value_names, ","));
    Line("tolerance       {}", Exactly(report_.tolerance));
    Line("result          {}: {} of {} receivers fail",
         report_.passes() ? "PASS" : "FAIL", s.failing(), s.receivers);
    Line("");
  }

  void WriteTable() {
    const CandidateSummary& s = report_.summary;
    Line("receivers       {:>8}", s.receivers);
    Line("E > 0           {:>8}   exact {}, failing {}", s.lit, s.lit_exact,
         s.lit_failing);
    Line("E = 0           {:>8}   exact {}, failing {}, largest value {}",
         s.dark, s.dark_exact, s.dark_failing, Short(s.max_dark_absolute));
    Line("not a number    {:>8}", s.no_number);
    if (s.relative) {
      const CandidateSummary::Relative& r = *s.relative;
      Line("");
      Line("relative error  RMS {}, mean {}, signed mean {}", Short(r.rms),
           Short(r.mean), SignedText(r.bias));
      Line("  where E > 0   50 % {}, 95 % {}, 99 % {}, 100 % {}",
           Short(r.median), Short(r.percentile_95), Short(r.percentile_99),
           Short(r.max));
    }
    if (s.lit + s.dark > 0)
      Line("absolute error  max {}", Short(s.max_absolute));
    if (s.lit > 0) {
      std::string bins;
      for (std::size_t i = 0; i < s.ulps.counts.size(); ++i) {
        if (s.ulps.counts[i] == 0) continue;
        if (!bins.empty()) bins += ", ";
        bins +=
            fmt::format("{}: {}", UlpHistogram::BinText(i), s.ulps.counts[i]);
      }
      Line("ulps            {}", bins);
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
    Line("");
    Line("worst receivers");
    const CandidateData& data = report_.data;
    for (std::size_t k = 0; k < report_.worst.size(); ++k) {
      const WorstCandidate& worst = report_.worst[k];
      const std::size_t i = worst.receiver;
      const Receiver& r = data.receivers[i];
      const CandidateError& e = report_.errors[i];
      Line("{:>3}. line {}: at {}, normal {}{}", k + 1, data.lines[i],
           TextOf(r.position),
           TextOf(Point3{r.normal.x, r.normal.y, r.normal.z}),
           r.on_face > 0 ? fmt::format(", on face {}", r.on_face) : "");
      Line("     candidate {}", ValuesText(data.values[i]));
      Line("     truelux   {}", ValuesText(data.truth[i]));
      if (e.no_number) {
        Line("     not a number");
      } else if (e.is_dark) {
        Line("     E = 0; {} of the largest E", Short(e.excess));
      } else {
        Line("     relative error {}, absolute {}", Short(e.excess),
             Short(e.error.absolute));
      }
      Line("     {}", SummaryOf(worst.detail));
      constexpr std::size_t kMostLines = 3;
      for (const std::string& line :
           LinesOf(report_.scene, worst.detail, kMostLines))
        Line("       {}", line);
    }
  }

  void WriteDiagnosis() {
    if (report_.diagnosis.verdict == Verdict::kNothingFails) return;
    Line("");
    Line("diagnosis");
    Line("  {}", report_.diagnosis.text);
    for (const std::string& sentence : report_.diagnosis.equally)
      Line("  equally well explained: {}", sentence);
    for (const std::string& note : report_.diagnosis.notes)
      Line("  {}", note);
    if (report_.classified.empty()) return;
    Line("  {}", WhereItFails(report_.classified));
    for (const FailureClass& c : FailureClasses(report_.classified)) {
      Line("    {:<20}{:>6} of {} fail", c.name, c.failing, c.receivers);
    }
  }

  const CandidateReport& report_;
  std::string text_;
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
