// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_dxf.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "plan/plan_points.h"
#include "text/results.h"

namespace truelux {
namespace {

/// Writes groups.
class DxfText {
 public:
  void Add(int code, std::string_view value) {
    text_ += std::to_string(code) + '\n';
    text_ += value;
    text_ += '\n';
  }

  void Add(int code, int value) { Add(code, std::to_string(value)); }

  /// A real number has a point or an exponent.
  void Add(int code, double value) {
    std::string number;
    AppendNumber(number, value);
    if (number.find_first_of(".e") == std::string::npos) number += ".0";
    Add(code, number);
  }

  /// The k-th point of an entity.
  void Add(int k, const Point3& p) {
    constexpr int kX = 10;
    constexpr int kY = 20;
    constexpr int kZ = 30;
    Add(kX + k, p.x);
    Add(kY + k, p.y);
    Add(kZ + k, p.z);
  }

  [[nodiscard]] std::string& text() { return text_; }

 private:
  std::string text_;
};

// Codes of groups.
constexpr int kStart = 0;
constexpr int kName = 2;
constexpr int kLineType = 6;
constexpr int kLayer = 8;
constexpr int kColour = 62;
constexpr int kFollow = 66;
constexpr int kFlags = 70;

constexpr const char* kSolid = "CONTINUOUS";
constexpr const char* kDashed = "DASHED";

struct Layer {
  std::string name;
  int colour = 7;  ///< of AutoCAD's table; 7 is black or white
  const char* line_type = kSolid;
};

std::vector<Layer> LayersOf(const Isolux& isolux) {
  constexpr int kGrey = 8;
  constexpr int kLightGrey = 9;
  constexpr int kRed = 1;
  std::vector<Layer> layers = {{"0"},
                               {"OUTLINE"},
                               {"JUMPS", kGrey},
                               {"KINKS", kLightGrey, kDashed},
                               {"OPEN", kRed}};
  // Levels from blue to red along AutoCAD's circle of colours.
  constexpr std::array kColours = {170, 150, 130, 110, 92, 62, 42, 30, 20, 10};
  const std::size_t count = isolux.levels.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place =
        count < 2 ? 0 : i * (kColours.size() - 1) / (count - 1);
    layers.push_back({LayerOf(isolux.levels[i]), kColours[place]});
  }
  return layers;
}

void AddLineTypes(DxfText& dxf) {
  constexpr int kShown = 3;
  constexpr int kAlignment = 72;
  constexpr int kAligned = 65;  // the letter A
  constexpr int kPieces = 73;
  constexpr int kLength = 40;
  constexpr int kPiece = 49;
  dxf.Add(kStart, "TABLE");
  dxf.Add(kName, "LTYPE");
  dxf.Add(kFlags, 2);
  dxf.Add(kStart, "LTYPE");
  dxf.Add(kName, kSolid);
  dxf.Add(kFlags, 0);
  dxf.Add(kShown, "Solid line");
  dxf.Add(kAlignment, kAligned);
  dxf.Add(kPieces, 0);
  dxf.Add(kLength, 0.0);
  dxf.Add(kStart, "LTYPE");
  dxf.Add(kName, kDashed);
  dxf.Add(kFlags, 0);
  dxf.Add(kShown, "__ __ __");
  dxf.Add(kAlignment, kAligned);
  dxf.Add(kPieces, 2);
  dxf.Add(kLength, 0.75);
  dxf.Add(kPiece, 0.5);
  dxf.Add(kPiece, -0.25);
  dxf.Add(kStart, "ENDTAB");
}

void AddTables(DxfText& dxf, const Isolux& isolux) {
  dxf.Add(kStart, "SECTION");
  dxf.Add(kName, "TABLES");
  AddLineTypes(dxf);
  const std::vector<Layer> layers = LayersOf(isolux);
  dxf.Add(kStart, "TABLE");
  dxf.Add(kName, "LAYER");
  dxf.Add(kFlags, static_cast<int>(layers.size()));
  for (const Layer& layer : layers) {
    dxf.Add(kStart, "LAYER");
    dxf.Add(kName, layer.name);
    dxf.Add(kFlags, 0);
    dxf.Add(kColour, layer.colour);
    dxf.Add(kLineType, layer.line_type);
  }
  dxf.Add(kStart, "ENDTAB");
  dxf.Add(kStart, "ENDSEC");
}

/// What the drawing covers, so that programs show all of it.
void AddHeader(DxfText& dxf, const Isolux& isolux) {
  constexpr int kVariable = 9;
  constexpr int kText = 1;
  dxf.Add(kStart, "SECTION");
  dxf.Add(kName, "HEADER");
  dxf.Add(kVariable, "$ACADVER");
  dxf.Add(kText, "AC1009");
  std::optional<Point3> low;
  Point3 high;
  ForEachPlanPoint(isolux, [&](const Point3& p) {
    if (!low) low = high = p;
    low = {std::min(low->x, p.x), std::min(low->y, p.y), std::min(low->z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y),
            std::max(high.z, p.z)};
  });
  if (low) {
    dxf.Add(kVariable, "$EXTMIN");
    dxf.Add(0, *low);
    dxf.Add(kVariable, "$EXTMAX");
    dxf.Add(0, high);
  }
  dxf.Add(kStart, "ENDSEC");
}

void AddContour(DxfText& dxf, const IsoluxContour& contour) {
  constexpr int kClosed = 1;
  constexpr int kInSpace = 8;
  constexpr int kVertexInSpace = 32;
  const std::string layer = LayerOf(contour.level);
  dxf.Add(kStart, "POLYLINE");
  dxf.Add(kLayer, layer);
  dxf.Add(kFollow, 1);
  dxf.Add(0, Point3{});
  dxf.Add(kFlags, kInSpace + (contour.is_closed ? kClosed : 0));
  for (const IsoluxVertex& vertex : contour.vertices) {
    dxf.Add(kStart, "VERTEX");
    dxf.Add(kLayer, layer);
    dxf.Add(0, vertex.at);
    dxf.Add(kFlags, kVertexInSpace);
  }
  dxf.Add(kStart, "SEQEND");
  dxf.Add(kLayer, layer);
}

void AddLine(DxfText& dxf, const char* layer,
             const std::array<Point3, 2>& ends) {
  dxf.Add(kStart, "LINE");
  dxf.Add(kLayer, layer);
  dxf.Add(0, ends[0]);
  dxf.Add(1, ends[1]);
}

void AddTriangle(DxfText& dxf, const std::array<Point3, 3>& corners) {
  dxf.Add(kStart, "3DFACE");
  dxf.Add(kLayer, "OPEN");
  for (int k = 0; k < 4; ++k)  // the third corner also is the fourth
    dxf.Add(k, corners[static_cast<std::size_t>(std::min(k, 2))]);
}

}  // namespace

std::string LayerOf(double level) {
  std::string name = "LEVEL_";
  AppendNumber(name, level);
  std::ranges::replace(name, '.', '_');
  std::erase(name, '+');
  std::ranges::replace(name, 'e', 'E');
  return name;
}

std::string PlanDxf(const Isolux& isolux) {
  DxfText dxf;
  AddHeader(dxf, isolux);
  AddTables(dxf, isolux);
  dxf.Add(kStart, "SECTION");
  dxf.Add(kName, "ENTITIES");
  for (const auto& side : isolux.outline)
    AddLine(dxf, "OUTLINE", side);
  for (const SurfaceLine& line : isolux.lines.lines) {
    AddLine(dxf, line.kind == SurfaceLineKind::kJump ? "JUMPS" : "KINKS",
            line.ends);
  }
  for (const OpenTriangle& open : isolux.open)
    AddTriangle(dxf, open.corners);
  for (const IsoluxContour& contour : isolux.contours)
    AddContour(dxf, contour);
  dxf.Add(kStart, "ENDSEC");
  dxf.Add(kStart, "EOF");
  return std::move(dxf.text());
}

}  // namespace truelux
