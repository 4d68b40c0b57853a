// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/view_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "base/vector_math.h"
#include "draw/label_layout.h"
#include "draw/svg.h"
#include "inspect/view_light.h"
#include "inspect/view_measure.h"
#include "inspect/view_panel.h"
#include "inspect/view_style.h"
#include "inspect/view_titles.h"

namespace truelux {
namespace {

constexpr double kMargin = 34;  ///< around the disc, for the axes' names

/// From so many arcs on lines are thinner.
constexpr std::size_t kDense = 600;

/// Up to so many vertices marks have their full size, and all are drawn.
constexpr double kRoomForMarks = 120;

class ViewDrawing {
 public:
  ViewDrawing(const InspectedView& inspected, const ViewPicture& picture)
      : inspected_(inspected),
        picture_(picture),
        width_(picture.width),
        radius_((width_ - kViewPanelWidth) / 2 - kMargin),
        height_(std::max(2 * (radius_ + kMargin), kViewPanelHeight)),
        centre_{radius_ + kMargin, height_ / 2},
        disc_(picture.projection, centre_, radius_) {}

  std::string Write() {
    AddStart();
    AddRegions();
    AddRings();
    svg_ += GradientBands(inspected_, disc_);
    AddArcs();
    AddRim();
    AddAxes();
    svg_ += VectorArrows(inspected_, disc_, centre_);
    AddVertices();
    svg_ += ViewPanel(inspected_, picture_.projection,
                      {width_ - kViewPanelWidth + 12, 22}, height_ - 12);
    return std::move(svg_) + "</svg>\n";
  }

 private:
  void AddStart() {
    svg_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\""
        " height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\""
        " font-family=\"Helvetica, Arial, sans-serif\" fill=\"#1a1a1a\">\n",
        width_, height_);
    svg_ += SvgTitle("What a receiver sees of " + inspected_.scene_name) + "\n";
    svg_ += "<defs>\n" + MarkDefinitions(MarkScale());
    svg_ += fmt::format(
        "<clipPath id=\"disc\"><circle cx=\"{:.2f}\" cy=\"{:.2f}\""
        " r=\"{:.2f}\"/></clipPath>\n</defs>\n",
        centre_.x, centre_.y, radius_);
    svg_ += fmt::format(
        "<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#ffffff\"/>\n", width_,
        height_);
  }

  /// A region's own colour also runs along its border, so that nothing of the
  /// page shines through between two regions.
  void AddRegions() {
    svg_ +=
        "<g id=\"regions\" clip-path=\"url(#disc)\" fill-rule=\"evenodd\""
        " stroke-width=\"0.8\" stroke-linejoin=\"round\">\n";
    for (std::size_t r = 0; r < inspected_.view.regions.size(); ++r) {
      std::string path;
      for (const auto& loop :
           BorderOf(inspected_.view, static_cast<int>(r), inspected_.frame))
        path += disc_.LoopPath(loop);
      if (path.empty()) continue;
      const std::string colour = ColourOf(inspected_, static_cast<int>(r));
      svg_ += fmt::format(
          "<path fill=\"{0}\" stroke=\"{0}\" d=\"{1}\">{2}</path>\n", colour,
          path, SvgTitle(TitleOfRegion(inspected_, r)));
    }
    svg_ += "</g>\n";
  }

  [[nodiscard]] std::vector<double> Rings() const {
    if (picture_.projection == ViewProjection::kNusselt) return {30, 60};
    return {30, 60, 70};
  }

  /// Circles of equal angle from the normal.
  void AddRings() {
    svg_ +=
        "<g id=\"rings\" fill=\"none\" stroke=\"#000000\""
        " stroke-opacity=\"0.3\" stroke-width=\"0.7\""
        " stroke-dasharray=\"1.5 4\" pointer-events=\"none\">\n";
    for (const double degrees : Rings()) {
      svg_ +=
          fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n",
                      centre_.x, centre_.y, disc_.RadiusAt(degrees));
    }
    svg_ += "</g>\n";
  }

  void AddArcs() {
    const bool dense = inspected_.view.arcs.size() > kDense;
    for (const ViewArcKind kind : kViewArcKinds) {
      std::string paths;
      for (std::size_t a = 0; a < inspected_.view.arcs.size(); ++a) {
        const WholeViewArc& arc = inspected_.view.arcs[a];
        if (arc.kind != kind) continue;
        const std::string path =
            disc_.ArcPath(ArcInFrame(inspected_.view, arc, inspected_.frame));
        if (path.empty()) continue;
        paths += fmt::format("<path d=\"{}\">{}</path>\n", path,
                             SvgTitle(TitleOfArc(inspected_, a)));
      }
      if (paths.empty()) continue;
      svg_ += fmt::format(
          "<g class=\"{}\" fill=\"none\" stroke-linecap=\"round\" "
          "{}>\n{}</g>\n",
          Name(kind), StrokeOf(kind, dense), paths);
    }
  }

  /// The gnomonic picture ends at a circle that is nothing in the scene.
  void AddRim() {
    if (picture_.projection == ViewProjection::kNusselt) return;
    svg_ += fmt::format(
        "<circle class=\"cut\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\""
        " fill=\"none\" stroke=\"#888888\" stroke-width=\"1\""
        " stroke-dasharray=\"6 4\"/>\n",
        centre_.x, centre_.y, radius_);
  }

  /// Where a scene's axis points to, seen from the middle of the disc.
  struct AxisTick {
    double x = 0;  ///< of length 1, y upwards
    double y = 0;
    std::string name;
  };

  /// Axes that point to the same place share their tick.
  [[nodiscard]] std::vector<AxisTick> AxisTicks() const {
    constexpr std::array kNames = {"x", "y", "z"};
    constexpr std::array kAxes = {Vector3{1, 0, 0}, Vector3{0, 1, 0},
                                  Vector3{0, 0, 1}};
    constexpr double kAlmostAhead = 0.3;
    constexpr double kSamePlace = 0.05;
    std::vector<AxisTick> ticks;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 v = InFrame(kAxes[i], inspected_.frame);
      const double length = std::hypot(v.x, v.y);
      if (length < kAlmostAhead) continue;
      for (const double sign : {1.0, -1.0}) {
        const AxisTick tick{sign * v.x / length, sign * v.y / length,
                            (sign > 0 ? "+" : "−") + std::string(kNames[i])};
        const auto same = std::ranges::find_if(ticks, [&](const AxisTick& t) {
          return std::hypot(t.x - tick.x, t.y - tick.y) < kSamePlace;
        });
        if (same == ticks.end()) {
          ticks.push_back(tick);
        } else {
          same->name += tick.name;
        }
      }
    }
    return ticks;
  }

  void AddAxes() {
    constexpr std::size_t kOneAxis = 4;  // a minus takes three bytes
    svg_ += "<g id=\"axes\" stroke-width=\"1\" fill=\"#444444\">\n";
    for (const AxisTick& tick : AxisTicks()) {
      const auto at = [&](double beyond) {
        return PicturePoint{centre_.x + (radius_ + beyond) * tick.x,
                            centre_.y - (radius_ + beyond) * tick.y};
      };
      svg_ += SvgLine(at(0).x, at(0).y, at(7).x, at(7).y, "#444444");
      const bool is_long = tick.name.size() > kOneAxis;
      const PicturePoint place = at(is_long ? 21 : 19);
      svg_ +=
          SvgText(place.x, place.y + 4, "middle", is_long ? 9 : 12, tick.name);
    }
    svg_ += "</g>\n";
  }

  [[nodiscard]] double MarkScale() const {
    const auto count = static_cast<double>(inspected_.view.vertices.size());
    return std::clamp(std::sqrt(kRoomForMarks / std::max(count, 1.0)), 0.4,
                      1.0);
  }

  /// Where many vertices are, corners that only shared edges meet in say
  /// little.
  [[nodiscard]] std::vector<bool> VerticesToDraw() const {
    const WholeView& view = inspected_.view;
    const bool all =
        static_cast<double>(view.vertices.size()) <= 2 * kRoomForMarks;
    std::vector<bool> draw(view.vertices.size(), all);
    for (const WholeViewArc& arc : view.arcs) {
      if (arc.kind == ViewArcKind::kInner) continue;
      for (const int v : {arc.from, arc.to}) {
        if (v >= 0) draw[static_cast<std::size_t>(v)] = true;
      }
    }
    return draw;
  }

  [[nodiscard]] std::optional<PicturePoint> PlaceOf(std::size_t vertex) const {
    return disc_.PointOf(
        InFrame(UnitOf(inspected_.view.vertices[vertex].vertex.direction),
                inspected_.frame));
  }

  /// Conjunctive vertices come last, on top.
  void AddVertices() {
    const std::vector<bool> draw = VerticesToDraw();
    LabelLayout layout({0, 0, width_ - kViewPanelWidth, height_});
    std::string labels;
    svg_ += "<g id=\"vertices\">\n";
    for (const ViewMark mark : kViewMarks) {
      const bool conjunctive = mark == ViewMark::kConjunctive;
      for (std::size_t v = 0; v < draw.size(); ++v) {
        const ContourVertex& vertex = inspected_.view.vertices[v].vertex;
        if (MarkOf(vertex) != mark || (!draw[v] && !conjunctive)) continue;
        const auto at = PlaceOf(v);
        if (!at) continue;
        svg_ += SvgViewMark(mark, *at, false, TitleOfVertex(inspected_, v));
        // Labels may cover the marks of others where these are many.
        if (conjunctive || MarkScale() == 1)
          layout.Avoid({at->x - 5, at->y - 5, at->x + 5, at->y + 5});
      }
    }
    svg_ += "</g>\n";
    AddLabels(layout);
  }

  /// Those with the most edges first: they find a place for their label.
  [[nodiscard]] std::vector<std::size_t> ConjunctiveVertices() const {
    std::vector<std::size_t> found;
    for (std::size_t v = 0; v < inspected_.view.vertices.size(); ++v) {
      if (inspected_.view.vertices[v].vertex.conjunctive) found.push_back(v);
    }
    std::ranges::stable_sort(found, std::greater(), [this](std::size_t v) {
      return inspected_.view.vertices[v].vertex.planes;
    });
    return found;
  }

  /// Beside its vertex or, if that is crowded, at the end of a line from it.
  void AddLabel(const PicturePoint& at, const std::string& text,
                LabelLayout& layout) {
    constexpr int kSize = 13;
    constexpr std::array kFarther = {0.0, 16.0, 30.0, 46.0};
    constexpr int kDirections = 8;
    for (const double distance : kFarther) {
      for (int i = 0; i < (distance > 0 ? kDirections : 1); ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / kDirections;
        const double x = at.x + distance * std::cos(angle);
        const double y = at.y - distance * std::sin(angle);
        const auto place = layout.Place(x, y, text, kSize);
        if (!place) continue;
        if (distance > 0) {
          svg_ += fmt::format(
              "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\""
              " stroke-width=\"1\"/>\n",
              at.x, at.y, x, y, kConjunctionColour);
        }
        svg_ += SvgText(place->x, place->y, place->anchor, kSize, text);
        return;
      }
    }
  }

  void AddLabels(LabelLayout& layout) {
    svg_ += fmt::format(
        "<g id=\"labels\" fill=\"{}\" font-weight=\"bold\" stroke=\"#ffffff\""
        " stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\""
        " pointer-events=\"none\">\n",
        kConjunctionColour);
    for (const std::size_t v : ConjunctiveVertices()) {
      const auto at = PlaceOf(v);
      if (!at) continue;
      const WholeViewVertex& vertex = inspected_.view.vertices[v];
      std::string text = std::to_string(vertex.vertex.planes);
      if (vertex.planes_with_hidden > vertex.vertex.planes)
        text += fmt::format(" of {}", vertex.planes_with_hidden);
      AddLabel(*at, text, layout);
    }
    svg_ +=
        "</g>\n<g id=\"ring-labels\" fill=\"#444444\" stroke=\"#ffffff\""
        " stroke-width=\"2.5\" stroke-opacity=\"0.8\""
        " paint-order=\"stroke\" pointer-events=\"none\">\n";
    for (const double degrees : Rings()) {
      const double r = disc_.RadiusAt(degrees) * std::numbers::sqrt2 / 2;
      const auto place = layout.Place(centre_.x + r - 9, centre_.y + r,
                                      fmt::format("{}°", degrees), 10);
      if (place) {
        svg_ += SvgText(place->x, place->y, place->anchor, 10,
                        fmt::format("{}°", degrees));
      }
    }
    svg_ += "</g>\n";
  }

  const InspectedView& inspected_;
  const ViewPicture& picture_;
  double width_;
  double radius_;
  double height_;
  PicturePoint centre_;
  ProjectedDisc disc_;
  std::string svg_;
};

}  // namespace

std::string ViewSvg(const InspectedView& inspected,
                    const ViewPicture& picture) {
  return ViewDrawing(inspected, picture).Write();
}

}  // namespace truelux
