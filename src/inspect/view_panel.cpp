// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/view_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

#include "draw/svg.h"
#include "explain/edge_text.h"
#include "inspect/view_light.h"
#include "inspect/view_style.h"
#include "text/results.h"

namespace truelux {
namespace {

constexpr double kLine = 18;
constexpr int kText = 12;
constexpr const char* kFaint = " fill=\"#666666\"";
constexpr const char* kBold = " font-weight=\"bold\"";

/// A text cut to so many characters; none of UTF-8's is broken.
std::string Shortened(const std::string& text, std::size_t length) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (starts && ++count > length) return text.substr(0, i) + "…";
  }
  return text;
}

/// Six digits, as short as it goes.
std::string SixDigits(double value) {
  return fmt::format("{:.6g}", value);
}

std::string CountText(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string ShortestText(double value) {
  std::string text;
  AppendNumber(text, value);
  return text;
}

class Panel {
 public:
  Panel(const InspectedView& inspected, PicturePoint corner, double bottom)
      : inspected_(inspected), x_(corner.x), y_(corner.y), bottom_(bottom) {}

  std::string Write(ViewProjection projection) {
    AddHeading(projection);
    AddIrradiance();
    AddFills();
    AddArcs();
    AddMarks();
    AddSources();
    return std::move(svg_);
  }

 private:
  void Put(double x, const char* anchor, std::string_view text,
           std::string_view more = "") {
    svg_ += SvgText(x_ + x, y_, anchor, kText, text, more);
  }

  void Next(double lines = 1) { y_ += lines * kLine; }

  void AddHeading(ViewProjection projection) {
    y_ += 14;
    svg_ += SvgText(x_, y_, "start", 17, Shortened(inspected_.scene_name, 40),
                    kBold);
    Next(1.3);
    const Receiver& r = inspected_.receiver;
    Put(0, "start", "receiver " + TextOf(r.position));
    Next();
    std::string normal =
        "normal " + TextOf(Point3{r.normal.x, r.normal.y, r.normal.z});
    if (r.on_face > 0) normal += fmt::format(", on face {}", r.on_face);
    Put(0, "start", normal);
    Next();
    Put(0, "start",
        projection == ViewProjection::kNusselt
            ? "Nusselt disc: a share of its area is a form factor"
            : fmt::format("gnomonic image plane, cut {}° from the normal",
                          kGnomonicLimit),
        kFaint);
    Next();
    Put(0, "start",
        CountText(inspected_.view.regions.size(), "region", "regions") + ", " +
            CountText(inspected_.view.arcs.size(), "arc", "arcs") + ", " +
            CountText(inspected_.view.vertices.size(), "vertex", "vertices"),
        kFaint);
    Next(1.5);
  }

  void AddIrradiance() {
    Put(0, "start", "Irradiance [W/m²]", kBold);
    const Derivatives& derivatives = inspected_.derivatives;
    const bool has_gradient =
        derivatives.smoothness != Smoothness::kDiscontinuous;
    Put(kGradient, "end",
        derivatives.smoothness == Smoothness::kC1 ? "|dE/dr| [W/m³]"
        : has_gradient                            ? "kink, mean |dE/dr| [W/m³]"
                                                  : "discontinuous: no dE/dr",
        kFaint);
    constexpr std::array kNames = {"red", "green", "blue"};
    for (std::size_t c = 0; c < 3; ++c) {
      Next();
      Put(22, "start", kNames[c], kFaint);
      Put(72, "start", ShortestText(inspected_.irradiance[c]));
      const Vector3& g = derivatives.channels[c].gradient;
      if (has_gradient)
        Put(kGradient, "end", SixDigits(std::hypot(g.x, g.y, g.z)));
    }
    Next(1.5);
  }

  void Swatch(const char* colour) {
    svg_ += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"14\" height=\"11\" fill=\"{}\""
        " stroke=\"#1a1a1a\" stroke-width=\"0.6\"/>\n",
        x_, y_ - 10, colour);
  }

  [[nodiscard]] std::string ColourOfFirst(RegionKind kind) const {
    const auto& regions = inspected_.view.regions;
    for (std::size_t r = 0; r < regions.size(); ++r) {
      if (KindOf(inspected_.scene, regions[r]) == kind)
        return ColourOf(inspected_, static_cast<int>(r));
    }
    return "";
  }

  void AddFills() {
    constexpr std::array kFills = {
        std::pair{RegionKind::kSource, "source, in the colour it emits"},
        std::pair{RegionKind::kBack, "back of an emitting face"},
        std::pair{RegionKind::kBlocker,
                  "blocker, lighter if it faces the receiver"},
        std::pair{RegionKind::kNothing, "nothing"}};
    Put(0, "start", "What is seen", kBold);
    for (const auto& [kind, text] : kFills) {
      const std::string colour = ColourOfFirst(kind);
      if (colour.empty()) continue;
      Next();
      Swatch(colour.c_str());
      Put(22, "start", text);
    }
    Next(1.5);
  }

  void AddCount(std::size_t count) {
    Put(kViewPanelWidth - 24, "end", std::to_string(count), kFaint);
  }

  void AddArcs() {
    Put(0, "start", "Arcs", kBold);
    for (const ViewArcKind kind : kViewArcKinds) {
      const auto count = static_cast<std::size_t>(
          std::ranges::count(inspected_.view.arcs, kind, &WholeViewArc::kind));
      if (count == 0) continue;
      Next();
      svg_ += fmt::format("<path d=\"M{0:.1f} {1:.1f}h16\" {2}/>\n", x_ - 1,
                          y_ - 4, StrokeOf(kind, false));
      Put(22, "start", LegendOf(kind));
      AddCount(count);
    }
    AddLight();
    Next(1.5);
  }

  void AddBand(const char* colour, const char* text) {
    Next();
    svg_ += fmt::format(
        "<path d=\"M{:.1f} {:.1f}h16\" stroke=\"{}\" stroke-opacity=\"0.55\""
        " stroke-width=\"{:.1f}\"/>\n",
        x_ - 1, y_ - 4, colour, kWholeGradientWidth / 2);
    Put(22, "start", text);
  }

  /// How the picture shows the gradient and V.
  void AddLight() {
    const ArcGradients& gradients = inspected_.arc_gradients;
    std::array<bool, 2> has{};  // against the gradient, with it
    for (std::size_t a = 0; a < gradients.arcs.size(); ++a) {
      const double share = LargestShareOf(gradients, a);
      if (share != 0) has[share > 0 ? 1 : 0] = true;
    }
    if (has[1]) AddBand(kWithGradientColour, "carries half of dE/dr");
    if (has[0]) AddBand(kAgainstGradientColour, "takes half of it away");
    const auto& channels = inspected_.derivatives.channels;
    const bool has_vector = std::ranges::any_of(channels, [](const auto& c) {
      return c.vector.x != 0 || c.vector.y != 0 || c.vector.z != 0;
    });
    if (!has_vector) return;
    Next();
    svg_ += fmt::format(
        "<path d=\"M{0:.1f} {1:.1f}h7\" stroke=\"#000000\""
        " stroke-width=\"2\"/><path d=\"M{2:.1f} {1:.1f}l-9 -4v8Z\"/>\n",
        x_ - 1, y_ - 4, x_ + 15);
    Put(22, "start", "direction of the vector irradiance V");
  }

  void AddMarks() {
    Put(0, "start", "Vertices", kBold);
    for (const ViewMark mark : kViewMarks) {
      const auto count = static_cast<std::size_t>(std::ranges::count_if(
          inspected_.view.vertices,
          [&](const WholeViewVertex& v) { return MarkOf(v.vertex) == mark; }));
      Next();
      svg_ += SvgViewMark(mark, {x_ + 7, y_ - 4}, true, "");
      Put(22, "start", LegendOf(mark));
      AddCount(count);
    }
    Next(1.5);
  }

  void AddSources() {
    const std::vector<SeenSource>& sources = inspected_.sources;
    Put(0, "start", "Sources", kBold);
    if (sources.empty()) {
      Next();
      Put(0, "start", "none is seen", kFaint);
      return;
    }
    Put(kSolidAngle, "end", "solid angle [sr]", kFaint);
    Put(kFormFactor, "end", "form factor", kFaint);
    const auto room =
        static_cast<std::size_t>(std::max(2.0, (bottom_ - y_) / kLine - 0.3));
    const std::size_t shown =
        sources.size() <= room ? sources.size() : room - 1;
    for (std::size_t s = 0; s < shown; ++s)
      AddSource(sources[s]);
    if (shown == sources.size()) return;
    double form_factor = 0;
    double solid_angle = 0;
    for (std::size_t s = shown; s < sources.size(); ++s) {
      form_factor += sources[s].form_factor;
      solid_angle += sources[s].solid_angle;
    }
    Next();
    Put(22, "start", fmt::format("{} more", sources.size() - shown), kFaint);
    Put(kFormFactor, "end", SixDigits(form_factor), kFaint);
    Put(kSolidAngle, "end", SixDigits(solid_angle), kFaint);
  }

  void AddSource(const SeenSource& source) {
    Next();
    const auto& regions = inspected_.view.regions;
    const auto region = std::ranges::find_if(regions, [&](const auto& r) {
      return r.face == source.face && r.front;
    });
    const std::string colour =
        ColourOf(inspected_, static_cast<int>(region - regions.begin()));
    const std::string face = TextOfFace(inspected_.scene, source.face);
    svg_ += "<g>" +
            SvgTitle(fmt::format("{}\nform factor {:.17g} (certified)\nsolid "
                                 "angle {:.17g} sr\nin {} {}",
                                 face, source.form_factor, source.solid_angle,
                                 source.regions,
                                 source.regions == 1 ? "piece" : "pieces")) +
            "\n";
    Swatch(colour.c_str());
    Put(22, "start", Shortened(NameOf(source.face), 21));
    Put(kFormFactor, "end", SixDigits(source.form_factor));
    Put(kSolidAngle, "end", SixDigits(source.solid_angle));
    svg_ += "</g>\n";
  }

  [[nodiscard]] std::string NameOf(int face) const {
    const Face& f =
        inspected_.scene.faces()[static_cast<std::size_t>(face - 1)];
    const std::string& group =
        inspected_.scene.group_names()[static_cast<std::size_t>(f.group)];
    return fmt::format("{} {}", face, group);
  }

  static constexpr double kGradient = kViewPanelWidth - 24;
  static constexpr double kFormFactor = 246;
  static constexpr double kSolidAngle = kViewPanelWidth - 24;

  const InspectedView& inspected_;
  double x_;
  double y_;
  double bottom_;
  std::string svg_;
};

}  // namespace

std::string ViewPanel(const InspectedView& inspected, ViewProjection projection,
                      PicturePoint corner, double bottom) {
  return Panel(inspected, corner, bottom).Write(projection);
}

}  // namespace truelux
