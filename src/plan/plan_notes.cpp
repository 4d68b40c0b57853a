// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_notes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fmt/format.h>
#include <string_view>

namespace truelux {
namespace {

/// What vertices and chords have in common.
struct LineCounts {
  std::size_t vertices = 0;
  std::size_t uncertified = 0;
  double half_width = 0;  ///< the largest of a certified vertex
  std::size_t chords = 0;
  std::size_t unknown = 0;
  double width = 0;  ///< the largest that is known
};

LineCounts CountsOf(const Isolux& isolux) {
  LineCounts counts;
  for (const IsoluxContour& contour : isolux.contours) {
    counts.vertices += contour.vertices.size();
    for (const IsoluxVertex& vertex : contour.vertices) {
      if (vertex.is_certified) {
        counts.half_width = std::max(counts.half_width, vertex.half_width);
      } else {
        ++counts.uncertified;
      }
    }
    counts.chords += contour.widths.size();
    for (const double width : contour.widths) {
      if (std::isfinite(width)) {
        counts.width = std::max(counts.width, width);
      } else {
        ++counts.unknown;
      }
    }
  }
  return counts;
}

std::string ContourNote(const Isolux& isolux, const LineCounts& counts) {
  std::string text = fmt::format(
      "{} at {}, ", Counted(isolux.contours.size(), "contour", "contours"),
      Counted(isolux.levels.size(), "level", "levels"));
  if (counts.vertices == 0) return text + "no vertices";
  text += Counted(counts.vertices, "vertex", "vertices");
  if (counts.uncertified == counts.vertices)
    return text + ", none of them certified";
  const std::string within =
      fmt::format("certified within {}", ShortBound(counts.half_width));
  if (counts.uncertified == 0) return text + ", all " + within;
  return text + fmt::format(": {} not certified, the others {}",
                            counts.uncertified == 1
                                ? "1 is"
                                : fmt::format("{} are", counts.uncertified),
                            within);
}

std::string OpenNote(const Isolux& isolux) {
  if (isolux.open.empty()) {
    return isolux.lines.is_complete
               ? "no contour of these levels is missing"
               : "no contour of these levels is missing, unless at a kink that "
                 "was not looked for";
  }
  return fmt::format(
      "{} ({} of the surface) {} open: contours that were not found lie there",
      Counted(isolux.open.size(), "triangle", "triangles"),
      ShareText(isolux.open_area, isolux.area),
      isolux.open.size() == 1 ? "is" : "are");
}

std::string ChordNote(const LineCounts& counts) {
  const std::string known =
      fmt::format("contours are within {} of {}", ShortBound(counts.width),
                  counts.unknown == 0 ? "their chords" : "the other chords");
  if (counts.unknown == 0) return known;
  return fmt::format("for {} of {} it is not known how far the contour is",
                     counts.unknown,
                     Counted(counts.chords, "chord", "chords")) +
         (counts.unknown == counts.chords ? "" : "; " + known);
}

}  // namespace

std::string Counted(std::size_t count, std::string_view one,
                    std::string_view more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

std::string ShortNumber(double value) {
  constexpr double kPlainFrom = 99.5;  // no 1e+02
  constexpr double kPlainTo = 1e6;
  return value >= kPlainFrom && value < kPlainTo ? fmt::format("{:.0f}", value)
                                                 : fmt::format("{:.2g}", value);
}

std::string ShortBound(double value) {
  std::string text = ShortNumber(value);
  constexpr double kStep = 0.01;
  for (double more = 1 + kStep; std::strtod(text.c_str(), nullptr) < value;
       more += kStep) {
    text = ShortNumber(more * value);
  }
  return text;
}

std::string ShareText(double part, double whole) {
  constexpr double kPercent = 100;
  return ShortNumber(whole > 0 ? kPercent * part / whole : 0) + " %";
}

std::vector<std::string> PlanNotes(const Isolux& isolux) {
  std::vector<std::string> notes;
  const LineCounts counts = CountsOf(isolux);
  if (!isolux.levels.empty()) {
    notes.push_back(ContourNote(isolux, counts));
    notes.push_back(OpenNote(isolux));
    if (counts.chords > 0) notes.push_back(ChordNote(counts));
  }
  if (isolux.dark_area > 0) {
    notes.push_back(fmt::format("no light reaches {} of the surface",
                                ShareText(isolux.dark_area, isolux.area)));
  }
  notes.push_back(fmt::format("irradiance from {:.4g} to {:.4g} W/m^2 was met",
                              isolux.least, isolux.most));
  for (std::string& note : LineNotes(isolux.lines))
    notes.push_back(std::move(note));
  return notes;
}

std::vector<std::string> ExtremaNotes(const SurfaceExtrema& extrema) {
  const auto count = [&extrema](ExtremumKind kind) {
    return std::ranges::count(extrema.points, kind, &SurfaceExtremum::kind);
  };
  std::vector<std::string> notes;
  const auto counted = [&count](ExtremumKind kind, std::string_view one,
                                std::string_view more) {
    const auto found = count(kind);
    return fmt::format("{} {}", found, found == 1 ? one : more);
  };
  notes.push_back(
      fmt::format("proven are {}, {} and {}",
                  counted(ExtremumKind::kMaximum, "maximum", "maxima"),
                  counted(ExtremumKind::kMinimum, "minimum", "minima"),
                  counted(ExtremumKind::kSaddle, "saddle", "saddles")));
  if (!extrema.undecided.empty()) {
    notes.push_back(fmt::format(
        "further ones may be in {} regions ({} of the surface){}",
        extrema.undecided.size(),
        ShareText(extrema.undecided_area, extrema.area),
        extrema.dark_area > 0 ? ", at the borders of shadows among others"
                              : ""));
  }
  notes.push_back(fmt::format(
      "irradiance on the whole surface is proven to be from {} to {} W/m^2",
      extrema.least, extrema.most));
  return notes;
}

std::string WorkNote(const Isolux& isolux) {
  const std::size_t vertices = CountsOf(isolux).vertices;
  std::string text = fmt::format(
      "irradiance was asked for {} times to settle which contours there are",
      isolux.search_evaluations);
  if (vertices == 0) return text;
  return text + fmt::format(", and {:.1f} times a vertex to place them",
                            static_cast<double>(isolux.line_evaluations) /
                                static_cast<double>(vertices));
}

std::vector<std::string> LineNotes(const SurfaceLines& lines) {
  const auto jumps = static_cast<std::size_t>(
      std::ranges::count(lines.lines, SurfaceLineKind::kJump,
                         [](const SurfaceLine& line) { return line.kind; }));
  std::vector<std::string> notes = {
      fmt::format("{} where irradiance may jump, {} where its gradient does",
                  Counted(jumps, "line", "lines"),
                  Counted(lines.lines.size() - jumps, "line", "lines"))};
  if (!lines.is_complete) {
    notes.emplace_back(
        "the scene has too many edges to look at all pairs of them: lines "
        "where "
        "the gradient jumps may be missing");
  }
  return notes;
}

}  // namespace truelux
