// SPDX-License-Identifier: GPL-3.0-or-later
// Tables, JSON and DXF, read back: every number is the one that was written.

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "plan/made_isolux.h"
#include "plan/plan_dxf.h"
#include "plan/plan_json.h"
#include "plan/plan_tables.h"
#include "support/csv_rows.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)
using Json = nlohmann::json;

double NumberOf(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  EXPECT_TRUE(!text.empty() && *end == '\0') << text;
  return value;
}

TEST(PlanTables, ContoursReadBack) {
  const Isolux isolux = MadeIsolux();
  const auto rows = RowsOf(ContourCsv(isolux));
  std::size_t row = 0;
  ASSERT_EQ(rows[row].size(), 14U);
  EXPECT_EQ(rows[row][0], "contour");
  for (std::size_t i = 0; i < isolux.contours.size(); ++i) {
    const IsoluxContour& contour = isolux.contours[i];
    for (std::size_t k = 0; k < contour.vertices.size(); ++k) {
      ASSERT_LT(++row, rows.size());
      const auto& fields = rows[row];
      ASSERT_EQ(fields.size(), 14U);
      const IsoluxVertex& vertex = contour.vertices[k];
      EXPECT_EQ(fields[0], std::to_string(i + 1));
      EXPECT_EQ(NumberOf(fields[1]), contour.level);
      EXPECT_EQ(fields[2], contour.is_closed ? "1" : "0");
      EXPECT_EQ(fields[3], std::to_string(k + 1));
      EXPECT_EQ(NumberOf(fields[4]), vertex.at.x);
      EXPECT_EQ(NumberOf(fields[5]), vertex.at.y);
      EXPECT_EQ(NumberOf(fields[6]), vertex.at.z);
      EXPECT_EQ(NumberOf(fields[7]), vertex.half_width);
      EXPECT_EQ(NumberOf(fields[8]), vertex.across.x);
      EXPECT_EQ(NumberOf(fields[9]), vertex.across.y);
      EXPECT_EQ(NumberOf(fields[10]), vertex.across.z);
      EXPECT_EQ(fields[11], vertex.is_certified ? "1" : "0");
      EXPECT_EQ(fields[12], Name(vertex.on));
      if (k < contour.widths.size()) {
        EXPECT_EQ(NumberOf(fields[13]), contour.widths[k]);
      } else {
        EXPECT_EQ(fields[13], "");
        EXPECT_FALSE(contour.is_closed);
      }
    }
  }
  EXPECT_EQ(rows.size(), row + 1);
  EXPECT_NE(ContourCsv(isolux).find(",inf\n"), std::string::npos);
}

TEST(PlanTables, LinesNameFacesAndEdges) {
  const std::string text =
      SurfaceLineCsv(MadeIsolux().lines, MadeSubject().vertex_numbers);
  EXPECT_EQ(text,
            "kind,x0,y0,z0,x1,y1,z1,b_r,b_g,b_b,left_r,left_g,left_b,right_r,"
            "right_g,right_b,faces,edges\n"
            "jump,7,2,1,9.8,2,1,,,,1,2,3,0,0,0,3;5,\n"
            "kink,0,1,1,10,7,1,-0.5,0.25,1e-300,,,,,,,,11-13;cut\n");
}

TEST(PlanTables, ExtremaAndWhatIsUndecided) {
  SurfaceExtrema extrema;
  extrema.points.push_back({ExtremumKind::kSaddle,
                            {1, 2, 3},
                            0.5,
                            0.25,
                            0.75,
                            0.125,
                            ContourPlace::kInside});
  extrema.points.push_back(
      {ExtremumKind::kMaximum, {0, 0, 0}, 1, 1, 1, 0, ContourPlace::kJump});
  UndecidedRegion region;
  region.triangles.push_back({{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}});
  region.least = 0.5;
  region.most = 2;
  extrema.undecided.push_back(region);
  EXPECT_EQ(ExtremaCsv(extrema),
            "kind,x,y,z,E,least,most,radius,on\n"
            "saddle,1,2,3,0.5,0.25,0.75,0.125,inside\n"
            "maximum,0,0,0,1,1,1,0,jump\n"
            "undecided,1,1,0,,0.5,2,2.23606797749979,\n");
}

TEST(PlanTables, VerticesHaveTheNumbersOfTheFile) {
  SceneBuilder builder("scene");
  const Ring ring = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  builder.AddFace(ring, kBlack);
  const Result<Scene> scene = builder.Build();
  ASSERT_TRUE(scene.ok());
  const std::vector<int> numbers = VertexNumbers(*scene.value);
  ASSERT_EQ(numbers.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(numbers[i], static_cast<int>(i) + 1);
}

TEST(PlanJson, HasEverything) {
  const Isolux isolux = MadeIsolux();
  PlanSubject subject = MadeSubject();
  subject.surface = "fl\"oor\xFF";
  const Json json = Json::parse(PlanJson(isolux, subject));
  EXPECT_EQ(json["surface"], "fl\"oor\xEF\xBF\xBD");
  EXPECT_EQ(json["method"], "certified");
  EXPECT_EQ(json["levels"].get<std::vector<double>>(), isolux.levels);
  EXPECT_EQ(json["dark_area"], 8);
  EXPECT_EQ(json["triangles"], 321);
  EXPECT_EQ(json["notes"][0], "say \"so\"");
  EXPECT_EQ(json["right"], Json({1, 0, 0}));
  EXPECT_EQ(json["outline"].size(), 4U);
  ASSERT_EQ(json["contours"].size(), isolux.contours.size());
  for (std::size_t i = 0; i < isolux.contours.size(); ++i) {
    const IsoluxContour& contour = isolux.contours[i];
    const Json& own = json["contours"][i];
    EXPECT_EQ(own["level"], contour.level);
    EXPECT_EQ(own["closed"], contour.is_closed);
    ASSERT_EQ(own["vertices"].size(), contour.vertices.size());
    ASSERT_EQ(own["widths"].size(), contour.widths.size());
    for (std::size_t k = 0; k < contour.vertices.size(); ++k) {
      const IsoluxVertex& vertex = contour.vertices[k];
      EXPECT_EQ(own["vertices"][k]["at"],
                Json({vertex.at.x, vertex.at.y, vertex.at.z}));
      EXPECT_EQ(own["vertices"][k]["certified"], vertex.is_certified);
      EXPECT_EQ(own["vertices"][k]["on"], Name(vertex.on));
    }
  }
  EXPECT_TRUE(json["contours"][1]["widths"][3].is_null());
  EXPECT_EQ(json["lines"][0]["faces"], Json({3, 5}));
  EXPECT_EQ(json["lines"][0]["left"], Json({1, 2, 3}));
  EXPECT_EQ(json["lines"][1]["edges"], Json::parse("[[11,13],null]"));
  EXPECT_EQ(json["open"][0]["most"], 0.75);
  EXPECT_TRUE(json["lines_complete"]);
  const Json nothing = Json::parse(PlanJson({}, MadeSubject()));
  EXPECT_TRUE(nothing["contours"].empty());
}

/// An entity or the like: the groups up to the next one.
struct DxfItem {
  std::string type;
  std::multimap<int, std::string> groups;

  [[nodiscard]] std::string At(int code) const {
    const auto found = groups.find(code);
    return found == groups.end() ? "" : found->second;
  }
};

std::vector<DxfItem> ItemsOf(const std::string& dxf) {
  std::vector<DxfItem> items;
  std::istringstream stream(dxf);
  std::string code;
  std::string value;
  while (std::getline(stream, code) && std::getline(stream, value)) {
    const int number = std::stoi(code);
    if (number == 0) {
      items.push_back({value, {}});
    } else if (!items.empty()) {
      items.back().groups.emplace(number, value);
    }
  }
  return items;
}

TEST(PlanDxf, ReadsBack) {
  const Isolux isolux = MadeIsolux();
  std::set<std::string> layers;
  std::map<std::string, int> counts;
  std::vector<std::vector<Point3>> paths;
  std::vector<bool> closed;
  int depth = 0;
  const auto items = ItemsOf(PlanDxf(isolux));
  for (const DxfItem& item : items) {
    ++counts[item.type];
    if (item.type == "SECTION") {
      EXPECT_EQ(depth++, 0);
    } else if (item.type == "ENDSEC") {
      EXPECT_EQ(--depth, 0);
    }
    if (item.type == "LAYER") {
      EXPECT_TRUE(layers.insert(item.At(2)).second);
      EXPECT_EQ(item.At(2).find_first_not_of(
                    "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-$"),
                std::string::npos)
          << item.At(2);
      continue;
    }
    EXPECT_TRUE(item.At(8).empty() || layers.contains(item.At(8)));
    if (item.type == "POLYLINE") {
      const int flags = std::stoi(item.At(70));
      EXPECT_EQ(flags & 8, 8);
      EXPECT_EQ(item.At(66), "1");
      closed.push_back((flags & 1) != 0);
      paths.emplace_back();
    } else if (item.type == "VERTEX") {
      EXPECT_EQ(item.At(70), "32");
      paths.back().push_back({NumberOf(item.At(10)), NumberOf(item.At(20)),
                              NumberOf(item.At(30))});
    }
  }
  EXPECT_EQ(items.back().type, "EOF");
  EXPECT_EQ(counts["LINE"], 4 + 2);
  EXPECT_EQ(counts["3DFACE"], 1);
  EXPECT_EQ(counts["SEQEND"], static_cast<int>(isolux.contours.size()));
  for (const char* layer : {"OUTLINE", "JUMPS", "KINKS", "OPEN", "LEVEL_0_1"})
    EXPECT_TRUE(layers.contains(layer)) << layer;
  ASSERT_EQ(paths.size(), isolux.contours.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    EXPECT_EQ(closed[i], isolux.contours[i].is_closed);
    ASSERT_EQ(paths[i].size(), isolux.contours[i].vertices.size());
    for (std::size_t k = 0; k < paths[i].size(); ++k)
      EXPECT_EQ(paths[i][k], isolux.contours[i].vertices[k].at);
  }
}

TEST(PlanDxf, LayersHaveNamesThatArePermitted) {
  EXPECT_EQ(LayerOf(20), "LEVEL_20");
  EXPECT_EQ(LayerOf(0.5), "LEVEL_0_5");
  EXPECT_EQ(LayerOf(1e-5), "LEVEL_1E-05");
  EXPECT_EQ(LayerOf(1.5e22), "LEVEL_1_5E22");
  EXPECT_LE(LayerOf(2.2250738585072014e-308).size(), 31U);
}

}  // namespace
}  // namespace truelux
