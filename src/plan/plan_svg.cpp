// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_svg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <set>
#include <utf8.h>
#include <utility>
#include <vector>

#include "draw/gap_label.h"
#include "draw/label_places.h"
#include "draw/svg.h"
#include "plan/level_style.h"
#include "plan/object_drawing.h"
#include "plan/paper.h"
#include "plan/plan_legend.h"
#include "plan/plan_notes.h"
#include "plan/plan_tables.h"

namespace truelux {
namespace {

constexpr double kMargin = 24;
constexpr double kTitleHeight = 52;
constexpr double kLargestSide = 780;
/// Between the plan and its legend.
constexpr double kSpace = 32;
constexpr int kTitleFont = 16;
constexpr int kSubtitleFont = 12;

/// Names of users need not be UTF-8: then without what is not ASCII.
std::string Readable(std::string name) {
  if (utf8::is_valid(name.begin(), name.end())) return name;
  std::ranges::replace_if(
      name, [](char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; },
      '?');
  return name;
}

void AppendPath(std::string& text, const PaperPath& path) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{}{:.2f} {:.2f}",
                   i == 0 ? "M" : (i == 1 ? "L" : " "), path[i].x, path[i].y);
  }
}

/// An element with a text under the pointer.
std::string PathElement(const std::string& path, const std::string& style,
                        const std::string& title) {
  return "<path d=\"" + path + "\"" + style + "><title>" + EscapedXml(title) +
         "</title></path>\n";
}

std::string TitleOf(const IsoluxContour& contour) {
  double widest = 0;
  for (const double width : contour.widths)
    widest = std::max(widest, width);
  const auto uncertified =
      std::ranges::count(contour.vertices, false, &IsoluxVertex::is_certified);
  std::string text = fmt::format(
      "{} W/m², {}, {} vertices{}; ", contour.level,
      contour.is_closed ? "closed" : "open", contour.vertices.size(),
      uncertified > 0 ? fmt::format(", {} not certified", uncertified) : "");
  return text +
         (std::isfinite(widest)
              ? fmt::format("within {} of its chords", ShortBound(widest))
              : "how far it is from its chords is not known everywhere");
}

std::string ChannelsText(const Rgb& values) {
  return fmt::format("{:.4g}, {:.4g}, {:.4g}", values[0], values[1], values[2]);
}

std::string TitleOf(const SurfaceLine& line, const PlanSubject& subject) {
  std::string text =
      line.kind == SurfaceLineKind::kJump
          ? fmt::format(
                "irradiance jumps: {} on the left, {} on "
                "the right; ",
                ChannelsText(line.left), ChannelsText(line.right))
          : fmt::format("the gradient jumps: b = {}; ",
                        ChannelsText(line.size));
  text += line.faces.empty() ? "" : "faces";
  for (const int face : line.faces)
    text += fmt::format(" {}", face);
  if (line.edges.empty()) return text;
  return text + (line.faces.empty() ? "edges " : ", edges ") +
         EdgeText(line.edges, subject.vertex_numbers);
}

class PlanDrawing {
 public:
  PlanDrawing(const Isolux& isolux, const PlanSubject& subject)
      : isolux_(isolux),
        subject_(subject),
        paper_(isolux, {kMargin, kMargin + kTitleHeight, kMargin + kLargestSide,
                        kMargin + kTitleHeight + kLargestSide}) {}

  std::string Draw() {
    PlaceLabels();
    const ObjectDrawing objects = DrawObjects(subject_.objects, paper_);
    std::string body = objects.elements;
    AddLines(body, SurfaceLineKind::kKink, "kinks", kKinkStyle);
    AddOutline(body);
    AddLines(body, SurfaceLineKind::kJump, "jumps", kJumpStyle);
    AddOpen(body);
    AddContours(body);
    AddLabels(body);
    const LabelBox& area = paper_.area();
    const LegendDrawing legend =
        PlanLegend(isolux_, subject_, objects, area.right + kSpace,
                   area.top - kMargin, paper_.scale());
    const double width = area.right + kSpace + kLegendWidth + kMargin;
    const double height = std::max(area.bottom, legend.bottom) + kMargin;
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "font-family=\"Helvetica, Arial, sans-serif\">\n"
        "<title>{2}</title>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        std::ceil(width), std::ceil(height), EscapedXml(Title()));
    const double room = width - 2 * kMargin;
    text += SvgText(kMargin, kMargin + kTitleFont, "start", kTitleFont,
                    Fitted(Title(), kTitleFont, room));
    text +=
        SvgText(kMargin, kMargin + kTitleFont + 20, "start", kSubtitleFont,
                Fitted(Readable(subject_.scene) + ", seen from the lit side",
                       kSubtitleFont, room),
                " fill=\"#444444\"");
    return text + body + "<g id=\"legend\">\n" + legend.elements +
           "</g>\n</svg>\n";
  }

 private:
  [[nodiscard]] std::string Title() const {
    return "Isolux lines on " + Readable(subject_.surface);
  }

  void PlaceLabels() {
    for (const IsoluxContour& contour : isolux_.contours) {
      const auto level =
          std::ranges::lower_bound(isolux_.levels, contour.level);
      lines_.push_back(
          {paper_.PathOf(contour),
           static_cast<std::size_t>(level - isolux_.levels.begin())});
    }
    constexpr double kKinkWeight = 0.02;
    std::vector<Obstacle> obstacles;
    for (const SurfaceLine& line : isolux_.lines.lines) {
      obstacles.push_back(
          {{paper_.At(line.ends[0]), paper_.At(line.ends[1])},
           line.kind == SurfaceLineKind::kJump ? 1 : kKinkWeight});
    }
    for (const auto& side : isolux_.outline)
      obstacles.push_back({{paper_.At(side[0]), paper_.At(side[1])}, 1});
    texts_ = LevelTexts(isolux_.levels);
    labels_ = PlaceGapLabels(lines_, texts_, obstacles, paper_.area());
  }

  /// Triangles; where they are too small to see, a ring around a few.
  void AddOpen(std::string& text) const {
    if (isolux_.open.empty()) return;
    constexpr double kSmallest = 1.5;
    constexpr double kCell = 12;
    std::set<std::pair<int, int>> ringed;
    std::string rings;
    text += fmt::format("<g id=\"open\" {}>\n", kOpenStyle);
    for (const OpenTriangle& open : isolux_.open) {
      const PaperPath corners = {paper_.At(open.corners[0]),
                                 paper_.At(open.corners[1]),
                                 paper_.At(open.corners[2])};
      const auto [left, right] =
          std::ranges::minmax(corners, {}, &PaperPoint::x);
      const auto [top, bottom] =
          std::ranges::minmax(corners, {}, &PaperPoint::y);
      if (std::max(right.x - left.x, bottom.y - top.y) >= kSmallest) {
        std::string path;
        AppendPath(path, corners);
        text +=
            PathElement(path + "Z", "",
                        fmt::format("open: irradiance from {:.4g} to {:.4g}",
                                    open.least, open.most));
        continue;
      }
      const PaperPoint& p = corners[0];
      if (!ringed
               .emplace(static_cast<int>(std::floor(p.x / kCell)),
                        static_cast<int>(std::floor(p.y / kCell)))
               .second)
        continue;
      rings += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\"/>\n",
                           p.x, p.y);
    }
    text += "</g>\n";
    if (!rings.empty())
      text += fmt::format("<g id=\"open_rings\" {}>\n", kRingStyle) + rings +
              "</g>\n";
  }

  void AddLines(std::string& text, SurfaceLineKind kind, const char* id,
                const char* style) const {
    text += fmt::format("<g id=\"{}\" {}>\n", id, style);
    for (const SurfaceLine& line : isolux_.lines.lines) {
      if (line.kind != kind) continue;
      std::string path;
      for (const PaperPath& piece : OutsideLabels(
               {paper_.At(line.ends[0]), paper_.At(line.ends[1])}, labels_))
        AppendPath(path, piece);
      if (!path.empty()) text += PathElement(path, "", TitleOf(line, subject_));
    }
    text += "</g>\n";
  }

  void AddOutline(std::string& text) const {
    text += fmt::format("<path id=\"outline\" {} d=\"", kOutlineStyle);
    for (const auto& side : isolux_.outline)
      AppendPath(text, {paper_.At(side[0]), paper_.At(side[1])});
    text += "\"/>\n";
  }

  void AddContours(std::string& text) const {
    text +=
        "<g id=\"contours\" fill=\"none\" stroke-width=\"1.4\" "
        "stroke-linejoin=\"round\">\n";
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      std::string path;
      for (const PaperPath& piece : OutsideLabels(lines_[i].path, labels_))
        AppendPath(path, piece);
      if (path.empty()) continue;
      text += PathElement(
          path,
          " stroke=\"" + LevelColour(lines_[i].series, texts_.size()) + "\"",
          TitleOf(isolux_.contours[i]));
    }
    text += "</g>\n";
  }

  void AddLabels(std::string& text) const {
    text += "<g id=\"labels\">\n";
    for (const GapLabel& label : labels_) {
      text += SvgText(
          0, 0.36 * kGapFont, "middle", kGapFont, texts_[label.series],
          fmt::format(" fill=\"{}\" transform=\"translate({:.2f} {:.2f}) "
                      "rotate({:.2f})\"",
                      LevelColour(label.series, texts_.size()), label.middle.x,
                      label.middle.y, label.angle));
    }
    text += "</g>\n";
  }

  const Isolux& isolux_;
  const PlanSubject& subject_;
  Paper paper_;
  std::vector<LabelledLine> lines_;  ///< by contour
  std::vector<std::string> texts_;   ///< by level
  std::vector<GapLabel> labels_;
};

}  // namespace

std::string PlanSvg(const Isolux& isolux, const PlanSubject& subject) {
  return PlanDrawing(isolux, subject).Draw();
}

}  // namespace truelux
