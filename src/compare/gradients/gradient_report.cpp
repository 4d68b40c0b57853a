// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/gradient_report.h"

#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numbers>
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
    return std::move(text_);
  }

 private:
  using Quantiles = GradientErrorSummary::Quantiles;

  template <class... Args>
  void Line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format,
                   std::forward<Args>(args)...);
    text_ += '\n';
  }

  void WriteHead() {
    const GradientErrorSummary& s = report_.summary;
    Line("scene           {}", report_.scene_name);
    Line("candidate       {}, gradient {}", report_.candidate_name,
         fmt::join(report_.data.value_names, ","));
    Line("tolerance       {}", Exactly(report_.tolerance));
    if (!s.compares_anything()) {
      Line(
          "result          FAIL: E is discontinuous at every receiver, so that "
          "nothing was compared");
    } else {
      Line("result          {}: {} of {} receivers fail",
           report_.passes() ? "PASS" : "FAIL", s.failing(), s.receivers);
    }
    Line("");
  }

  void WriteTable() {
    const GradientErrorSummary& s = report_.summary;
    Line("receivers       {:>8}", s.receivers);
    Line("gradient > 0    {:>8}   exact {}, failing {}", s.sloping,
         s.sloping_exact, s.sloping_failing);
    Line("gradient = 0    {:>8}   exact {}, failing {}, largest value {}",
         s.flat, s.flat_exact, s.flat_failing, Short(s.max_flat_absolute));
    Line(
        "at a kink       {:>8}   held against the nearest of the gradients "
        "there",
        s.kinks);
    Line("discontinuous   {:>8}   not compared", s.discontinuous);
    Line("not a number    {:>8}   or infinite", s.no_number);
    if (s.relative) {
      Line("");
      WriteQuantiles("relative error ", *s.relative, Short);
      WriteQuantiles("angle [degrees]", *s.angle, DegreesText);
      WriteQuantiles("length off by  ", *s.lengthening, Short);
      Line("  signed mean   {}", SignedText(s.mean_lengthening));
    }
    if (s.sloping + s.flat > 0)
      Line("absolute error  max {} W/m^3", Short(s.max_absolute));
  }

  template <class Text>
  void WriteQuantiles(std::string_view name, const Quantiles& q,
                      const Text& text) {
    Line("{} 50 % {}, 95 % {}, 99 % {}, 100 % {}", name, text(q.median),
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
      Line("       kink across the plane with the normal {}{}",
           TextOf(Point3{m.x, m.y, m.z}),
           kink.faces.empty()
               ? ": two edges cover each other"
               : ", edge-on: " + TextOfFace(report_.scene, kink.faces.front()));
    }
    if (kinks.size() > kMost)
      Line("       and {} more kinks", kinks.size() - kMost);
  }

  void WriteWorst() {
    if (report_.worst.empty()) return;
    Line("");
    Line("worst receivers");
    const GradientData& data = report_.data;
    for (std::size_t k = 0; k < report_.worst.size(); ++k) {
      const WorstGradient& worst = report_.worst[k];
      const std::size_t i = worst.receiver;
      const Receiver& r = data.receivers[i];
      const GradientError& e = report_.errors[i];
      Line("{:>3}. line {}: at {}, normal {}{}", k + 1, data.lines[i],
           TextOf(r.position),
           TextOf(Point3{r.normal.x, r.normal.y, r.normal.z}),
           r.on_face > 0 ? fmt::format(", on face {}", r.on_face) : "");
      Line("     candidate {}", RowText(data.values[i]));
      Line("     truelux   {}", RowText(data.truth[i].gradient));
      if (e.no_number) {
        Line("     not a number");
      } else if (e.is_flat) {
        Line("     gradient = 0; {} of the largest", Short(e.excess));
      } else {
        Line("     relative error {}, {} degrees, length {}", Short(e.excess),
             DegreesText(e.angle), SignedText(e.lengthening));
      }
      Line("     {}", SummaryOf(worst.detail));
      WriteKinks(worst.kinks);
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
  }

  const GradientReport& report_;
  std::string text_;
};

}  // namespace

std::string GradientText(const GradientReport& report) {
  return GradientWriter(report).Write();
}

}  // namespace truelux
