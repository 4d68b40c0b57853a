// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/stroke_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace truelux {
namespace {

/// Within a width of 0.56, the baseline at 0 and digits up to -1.
constexpr double kWidth = 0.56;
constexpr double kBetween = 0.22;
constexpr double kPointWidth = 0.12;

/// An arc of an ellipse; angles in degrees from the right, counter-clockwise as
/// seen.
void Arc(PaperPath& path, double x, double y, double rx, double ry, double from,
         double to) {
  constexpr int kSteps = 12;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle =
        (from + (to - from) * i / kSteps) * std::numbers::pi / 180;
    path.push_back({x + rx * std::cos(angle), y - ry * std::sin(angle)});
  }
}

PaperPath ArcPath(double x, double y, double rx, double ry, double from,
                  double to) {
  PaperPath path;
  Arc(path, x, y, rx, ry, from, to);
  return path;
}

std::vector<PaperPath> StrokesOf(char c) {
  constexpr double kMiddle = kWidth / 2;
  PaperPath path;
  switch (c) {
    case '0':
      return {ArcPath(kMiddle, -0.5, kMiddle, 0.5, 0, 360)};
    case '1':
      return {{{0.08, -0.8}, {0.32, -1}, {0.32, 0}}};
    case '2':
      Arc(path, kMiddle, -0.72, kMiddle, 0.28, 170, -35);
      path.push_back({0, 0});
      path.push_back({kWidth, 0});
      return {path};
    case '3':
      Arc(path, 0.27, -0.76, 0.25, 0.24, 150, -90);
      Arc(path, 0.27, -0.26, 0.29, 0.26, 90, -150);
      return {path};
    case '4':
      return {{{0.42, 0}, {0.42, -1}, {0, -0.28}, {kWidth, -0.28}}};
    case '5':
      path = {{0.5, -1}, {0.08, -1}, {0.04, -0.55}};
      Arc(path, 0.26, -0.32, 0.3, 0.32, 130, -150);
      return {path};
    case '6':
      Arc(path, 0.46, -0.32, 0.46, 0.68, 90, 180);
      Arc(path, kMiddle, -0.31, kMiddle, 0.31, 180, -180);
      return {path};
    case '7':
      return {{{0, -1}, {kWidth, -1}, {0.18, 0}}};
    case '8':
      return {ArcPath(kMiddle, -0.76, 0.24, 0.24, 0, 360),
              ArcPath(kMiddle, -0.26, kMiddle, 0.26, 0, 360)};
    case '9':
      Arc(path, kMiddle, -0.69, kMiddle, 0.31, 0, 360);
      Arc(path, 0.1, -0.68, 0.46, 0.68, 0, -90);
      return {path};
    case '.':
      return {{{kPointWidth / 2, -0.05}, {kPointWidth / 2, 0}}};
    case '-':
      return {{{0.06, -0.42}, {0.5, -0.42}}};
    case '+':
      return {{{0.06, -0.42}, {0.5, -0.42}}, {{0.28, -0.64}, {0.28, -0.2}}};
    case 'e':
      path = {{0.02, -0.34}, {0.54, -0.34}};
      Arc(path, kMiddle, -0.32, 0.26, 0.32, 0, 310);
      return {path};
    default:
      return {};
  }
}

double WidthOf(char c) {
  return c == '.' ? kPointWidth : kWidth;
}

}  // namespace

std::vector<PaperPath> TextStrokes(std::string_view text) {
  std::vector<PaperPath> strokes;
  double left = 0;
  for (const char c : text) {
    for (PaperPath& stroke : StrokesOf(c)) {
      for (PaperPoint& p : stroke)
        p.x += left;
      strokes.push_back(std::move(stroke));
    }
    left += WidthOf(c) + kBetween;
  }
  return strokes;
}

double StrokeTextWidth(std::string_view text) {
  double width = 0;
  for (const char c : text)
    width += WidthOf(c) + kBetween;
  return text.empty() ? 0 : width - kBetween;
}

}  // namespace truelux
