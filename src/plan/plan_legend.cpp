// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <string_view>
#include <vector>

#include "draw/svg.h"
#include "plan/level_style.h"
#include "plan/plan_notes.h"
#include "text/results.h"

namespace truelux {
namespace {

constexpr int kFont = 12;
constexpr int kHeadingFont = 13;
constexpr double kRow = 17;
constexpr double kSwatch = 26;
constexpr double kTextLeft = 34;

/// By the font's size, as the wider ones of usual fonts have it. Of a character
/// of several bytes the first one has it all.
double CharacterWidth(char c) {
  constexpr std::string_view kNarrow = "fijltI.,:;!|'()[] -";
  constexpr std::string_view kWide = "mwMWOQ@%";
  const auto byte = static_cast<unsigned char>(c);
  if ((byte & 0xC0U) == 0x80U) return 0;
  if (byte >= 0x80U || kWide.find(c) != kWide.npos) return 1;
  if (kNarrow.find(c) != kNarrow.npos) return 0.4;
  return c >= 'A' && c <= 'Z' ? 0.75 : 0.62;
}

/// Lines that are no wider; a longer word is cut.
std::vector<std::string> Wrapped(const std::string& text, double width) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t blank = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, blank - at);
    std::string longer = line;
    if (!line.empty()) longer += ' ';
    longer += word;
    if (!line.empty() && PrintedWidth(longer, kFont) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
    at = blank + 1;
  }
  lines.push_back(line);
  for (std::string& each : lines)
    each = Fitted(each, kFont, width);
  return lines;
}

std::string VectorText(const Vector3& v) {
  constexpr double kShown = 1e4;
  const auto rounded = [](double x) {
    return std::round(kShown * x) / kShown + 0.0;  // no -0
  };
  return fmt::format("({:g}, {:g}, {:g})", rounded(v.x), rounded(v.y),
                     rounded(v.z));
}

class LegendWriter {
 public:
  LegendWriter(const Isolux& isolux, const PlanSubject& subject,
               const ObjectDrawing& objects, double left, double top,
               double scale)
      : isolux_(isolux),
        subject_(subject),
        objects_(objects),
        left_(left),
        y_(top),
        scale_(scale) {}

  LegendDrawing Write() {
    AddLevels();
    AddMarks();
    AddScaleBar();
    AddHeading("What is proven");
    for (const std::string& note : PlanNotes(isolux_))
      AddNote(note);
    return {std::move(text_), y_};
  }

 private:
  void AddHeading(const std::string& heading) {
    y_ += kRow;
    text_ += SvgText(left_, y_, "start", kHeadingFont,
                     Fitted(heading, kHeadingFont, kLegendWidth),
                     " font-weight=\"bold\"");
    y_ += 4;
  }

  void AddLines(const std::vector<std::string>& lines, double x) {
    for (const std::string& line : lines) {
      text_ += SvgText(x, y_, "start", kFont, line);
      y_ += kRow - 2;
    }
    y_ -= kRow - 2;
  }

  void AddNote(std::string note) {
    constexpr std::string_view kPlain = "m^2";
    const std::size_t unit = note.find(kPlain);
    if (unit != std::string::npos) note.replace(unit, kPlain.size(), "m²");
    y_ += kRow;
    AddLines(Wrapped(note, kLegendWidth), left_);
  }

  /// A line of the legend with a mark before its text.
  void AddMark(const char* style, const std::string& text) {
    y_ += kRow;
    text_ += fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}\" {}/>\n", left_,
                         y_ - 0.35 * kFont, kSwatch, style);
    AddLines(Wrapped(text, kLegendWidth - kTextLeft), left_ + kTextLeft);
  }

  /// The same with a mark that has an inside.
  void AddArea(const char* style, const std::string& text) {
    y_ += kRow;
    text_ += AreaMark(style);
    AddLines(Wrapped(text, kLegendWidth - kTextLeft), left_ + kTextLeft);
  }

  [[nodiscard]] std::string AreaMark(const char* style) const {
    return fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}v9h{:.1f}z\" {}/>\n",
                       left_, y_ - 9, kSwatch, -kSwatch, style);
  }

  void AddLevels() {
    const std::string of = subject_.channel == "all"
                               ? "Irradiance"
                               : "Irradiance, " + subject_.channel;
    AddHeading(of + " [W/m²]");
    const std::size_t count = isolux_.levels.size();
    if (count == 0) AddNote("no levels");
    std::size_t widest = 0;
    std::vector<std::string> texts;
    for (const double level : isolux_.levels) {
      std::string& text = texts.emplace_back();
      AppendNumber(text, level);
      const bool is_met = std::ranges::any_of(
          isolux_.contours, [level](const IsoluxContour& contour) {
            return contour.level == level;
          });
      if (!is_met) text += " (no line)";
      widest = std::max(widest, text.size());
    }
    constexpr std::size_t kOneColumn = 14;
    constexpr std::size_t kNarrow = 10;
    constexpr std::size_t kMostRows = 120;
    const std::size_t columns = count > kOneColumn && widest <= kNarrow ? 2 : 1;
    const std::size_t step = 1 + count / kMostRows;
    std::size_t shown = 0;
    for (std::size_t i = count; i-- > 0;) {
      if (i % step != 0) continue;
      const std::size_t column = shown++ % columns;
      if (column == 0) y_ += kRow;
      const double x = left_ + static_cast<double>(column) * kLegendWidth / 2;
      text_ += fmt::format(
          "<path d=\"M{:.1f} {:.1f}h{:.1f}\" stroke=\"{}\" "
          "stroke-width=\"2\"/>\n",
          x, y_ - 0.35 * kFont, kSwatch, LevelColour(i, count));
      text_ += SvgText(x + kTextLeft, y_, "start", kFont, texts[i]);
    }
    if (step > 1) AddNote(fmt::format("(one of {} levels)", step));
    y_ += 4;
  }

  void AddMarks() {
    const auto has = [this](SurfaceLineKind kind) {
      return std::ranges::any_of(
          isolux_.lines.lines,
          [kind](const SurfaceLine& line) { return line.kind == kind; });
    };
    if (has(SurfaceLineKind::kJump)) {
      AddMark(kJumpStyle,
              "foot of a face that stands here: irradiance may jump");
    }
    if (has(SurfaceLineKind::kKink))
      AddMark(kKinkStyle, "the gradient of irradiance jumps");
    if (!isolux_.open.empty()) {
      y_ += kRow;
      text_ += AreaMark(kOpenStyle);
      text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" {}/>\n",
                           left_ + 0.5 * kSwatch, y_ - 4.5, kRingStyle);
      AddLines(Wrapped(fmt::format("open: {} triangles, {} of the surface; "
                                   "with rings where they are small",
                                   isolux_.open.size(),
                                   ShareText(isolux_.open_area, isolux_.area)),
                       kLegendWidth - kTextLeft),
               left_ + kTextLeft);
    }
    if (objects_.has_objects)
      AddArea(kObjectStyle, "objects above, from above");
    if (objects_.has_lamps) AddArea(kLampStyle, "lamps");
    y_ += 4;
  }

  /// 1, 2 or 5 times a power of ten, as long as there is room for.
  void AddScaleBar() {
    const double room = (kLegendWidth - 30) / scale_;
    if (!(room > 0) || !std::isfinite(room)) return;
    const double decade = std::pow(10, std::floor(std::log10(room)));
    double length = decade;
    for (const double factor : {2, 5}) {
      if (factor * decade <= room) length = factor * decade;
    }
    const double width = length * scale_;
    y_ += 1.5 * kRow;
    text_ += fmt::format(
        "<path d=\"M{:.1f} {:.1f}v6h{:.2f}v-6\" fill=\"none\" "
        "stroke=\"#000000\" stroke-width=\"1.2\"/>\n",
        left_ + 1, y_ - 10, width);
    y_ += kRow - 5;
    text_ += SvgText(left_, y_, "start", kFont,
                     fmt::format("{:g} (the scene's unit of length)", length));
    AddNote("to the right " + VectorText(isolux_.right) + ", up " +
            VectorText(isolux_.up));
    y_ += 4;
  }

  const Isolux& isolux_;
  const PlanSubject& subject_;
  const ObjectDrawing& objects_;
  double left_;
  double y_;
  double scale_;
  std::string text_;
};

}  // namespace

double PrintedWidth(std::string_view text, int font) {
  double width = 0;
  for (const char c : text)
    width += font * CharacterWidth(c);
  return width;
}

std::string Fitted(const std::string& text, int font, double width) {
  if (PrintedWidth(text, font) <= width) return text;
  std::string fitted = text;
  do {
    // A whole character.
    while (!fitted.empty() &&
           (static_cast<unsigned char>(fitted.back()) & 0xC0U) == 0x80U)
      fitted.pop_back();
    if (!fitted.empty()) fitted.pop_back();
  } while (!fitted.empty() && PrintedWidth(fitted + "…", font) > width);
  return fitted + "…";
}

LegendDrawing PlanLegend(const Isolux& isolux, const PlanSubject& subject,
                         const ObjectDrawing& objects, double left, double top,
                         double scale) {
  return LegendWriter(isolux, subject, objects, left, top, scale).Write();
}

}  // namespace truelux
