// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/gradient_report.h"

#include <fmt/format.h>
#include <numbers>
#include <utility>

#include "compare/report_lines.h"
#include "explain/edge_text.h"

namespace truelux {
namespace {

std::string DegreesText(double radians) {
  return Short(radians * 180 / std::numbers::pi);
}

/// Builds the text line by line.
class GradientWriter {
 public:
  explicit GradientWriter(const GradientReport& report) : report_(report) {}

  std::string Write() {
    WriteHead();
    WriteTable();
    WriteWorst();
    WriteDiagnosis();
    return lines_.Take();
  }

 private:
  using Quantiles = GradientErrorSummary::Quantiles;

  void WriteHead() {
    const GradientErrorSummary& s = report_.summary;
    lines_.Line("scene           {}", report_.scene_name);
    lines_.Line("candidate       {}, gradient {}", report_.candidate_name,
                fmt::join(report_.data.value_names, ","));
    lines_.Line("tolerance       {}", Exactly(report_.tolerance));
    if (!s.compares_anything()) {
      lines_.Line(
          "result          FAIL: E is discontinuous at every receiver, so that "
          "nothing was compared");
    } else {
      lines_.Line("result          {}: {} of {} receivers fail",
                  report_.passes() ? "PASS" : "FAIL", s.failing(), s.receivers);
    }
    lines_.Line("");
  }

  void WriteTable() {
    const GradientErrorSummary& s = report_.summary;
    lines_.Line("receivers       {:>8}", s.receivers);
    lines_.Line("gradient > 0    {:>8}   exact {}, failing {}", s.sloping,
                s.sloping_exact, s.sloping_failing);
    lines_.Line(
        "gradient = 0    {:>8}   exact {}, failing {}, largest value {}",
        s.flat, s.flat_exact, s.flat_failing, Short(s.max_flat_absolute));
    lines_.Line(
        "at a kink       {:>8}   held against the nearest of the gradients "
        "there",
        s.kinks);
    lines_.Line("discontinuous   {:>8}   not compared", s.discontinuous);
    lines_.Line("not a number    {:>8}   or infinite", s.no_number);
    if (s.relative) {
      lines_.Line("");
      WriteQuantiles("relative error ", *s.relative, Short);
      WriteQuantiles("angle [degrees]", *s.angle, DegreesText);
      WriteQuantiles("length off by  ", *s.lengthening, Short);
      lines_.Line("  signed mean   {}", SignedText(s.mean_lengthening));
    }
    if (s.sloping + s.flat > 0)
      lines_.Line("absolute error  max {} W/m^3", Short(s.max_absolute));
  }

  template <class Text>
  void WriteQuantiles(std::string_view name, const Quantiles& q,
                      const Text& text) {
    lines_.Line("{} 50 % {}, 95 % {}, 99 % {}, 100 % {}", name, text(q.median),
                text(q.percentile_95), text(q.percentile_99), text(q.max));
  }

  [[nodiscard]] std::string RowText(const GradientRow& row) const {
    std::string text;
    for (std::size_t c = 0; c < report_.data.channels.size(); ++c) {
      const Vector3& g = row[c];
      text += fmt::format("{}({}, {}, {})", c == 0 ? "" : ", ", Exactly(g.x),
                          Exactly(g.y), Exactly(g.z));
    }
    return text;
  }

  void WriteKinks(const std::vector<Kink>& kinks) {
    constexpr std::size_t kMost = 3;
    for (std::size_t k = 0; k < kinks.size() && k < kMost; ++k) {
      const Kink& kink = kinks[k];
      const Vector3& m = kink.normal;
      lines_.Line(
          "       kink across the plane with the normal {}{}",
          TextOf(Point3{m.x, m.y, m.z}),
          kink.faces.empty()
              ? ": two edges cover each other"
              : ", edge-on: " + TextOfFace(report_.scene, kink.faces.front()));
    }
    if (kinks.size() > kMost)
      lines_.Line("       and {} more kinks", kinks.size() - kMost);
  }

  void WriteWorst() {
    if (report_.worst.empty()) return;
    lines_.Line("");
    lines_.Line("worst receivers");
    const GradientData& data = report_.data;
    for (std::size_t k = 0; k < report_.worst.size(); ++k) {
      const WorstGradient& worst = report_.worst[k];
      const std::size_t i = worst.receiver;
      const GradientError& e = report_.errors[i];
      lines_.AddPlace(k, data, i);
      lines_.Line("     candidate {}", RowText(data.values[i]));
      lines_.Line("     truelux   {}", RowText(data.truth[i].gradient));
      if (e.no_number) {
        lines_.Line("     not a number");
      } else if (e.is_flat) {
        lines_.Line("     gradient = 0; {} of the largest", Short(e.excess));
      } else {
        lines_.Line("     relative error {}, {} degrees, length {}",
                    Short(e.excess), DegreesText(e.angle),
                    SignedText(e.lengthening));
      }
      lines_.Line("     {}", SummaryOf(worst.detail));
      WriteKinks(worst.kinks);
    }
  }

  void WriteDiagnosis() { lines_.AddDiagnosis(report_.diagnosis); }

  const GradientReport& report_;
  ReportLines lines_;
};

}  // namespace

std::string GradientText(const GradientReport& report) {
  return GradientWriter(report).Write();
}

}  // namespace truelux
