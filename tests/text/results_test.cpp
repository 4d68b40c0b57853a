// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/results.h"

#include <cstdlib>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace truelux {
namespace {

std::string Text(double value) {
  std::string text;
  AppendNumber(text, value);
  return text;
}

TEST(Results, NumbersAreTheShortestThatReadBack) {
  EXPECT_EQ(Text(0), "0");
  EXPECT_EQ(Text(0.1), "0.1");
  EXPECT_EQ(Text(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(Text(1e22), "1e+22");
  EXPECT_EQ(Text(std::numeric_limits<double>::infinity()), "inf");
  for (const double value :
       {std::numeric_limits<double>::denorm_min(),
        std::numeric_limits<double>::min(), std::numeric_limits<double>::max(),
        0.1 + 0.2, 2.2250738585072011e-308, -1.7976931348623155e308}) {
    EXPECT_EQ(std::strtod(Text(value).c_str(), nullptr), value) << Text(value);
  }
}

TEST(Results, BoundsAreColumnsOfMethodDoubleOnly) {
  Irradiance irradiance;
  irradiance.value = {1, 0.5, 0};
  irradiance.bound = {1e-16, 2e-16, 0};
  std::string certified;
  AppendResult(certified, irradiance, Method::kCertified);
  EXPECT_EQ(ResultHeader(Method::kCertified), ",E_r,E_g,E_b");
  EXPECT_EQ(certified, ",1,0.5,0");
  std::string with_bounds;
  AppendResult(with_bounds, irradiance, Method::kDouble);
  EXPECT_EQ(ResultHeader(Method::kDouble),
            ",E_r,E_g,E_b,bound_r,bound_g,bound_b");
  EXPECT_EQ(with_bounds, ",1,0.5,0,1e-16,2e-16,0");
}

TEST(Results, ReportIsJsonWithEveryCount) {
  RunReport report;
  report.version = "1.2.3";
  report.load_seconds = 0.5;
  report.evaluate_seconds = 1.25;
  report.threads = 4;
  report.receivers = 7;
  report.left_out = {{"a reason", {2, 5}}};
  report.options.method = Method::kDouble;
  Statistics& s = report.statistics;
  s.receiver_side = {1, 2, 3, 20, 4};
  s.vertex_side = {5, 6, 7, 21, 8};
  s.plane_side = {9, 10, 11, 22, 12};
  s.edge_order = {0, 0, 0, 0, 1};
  s.sources = 13;
  s.blockers = 14;
  s.arcs = 15;
  s.evaluated_zero = 16;
  s.evaluated_double = 17;
  s.evaluated_double_double = 18;
  s.evaluated_multiprecision = 19;
  s.ties = 20;
  s.overflows = 21;
  s.max_precision_bits = 22;
  EXPECT_EQ(JsonText(report), R"({
  "version": "1.2.3",
  "engine": "contour",
  "method": "double",
  "emission": "exitance",
  "formula": "auto",
  "load_seconds": 0.5,
  "evaluate_seconds": 1.25,
  "threads": 4,
  "receivers": 7,
  "left_out": [{"reason":"a reason","faces":[2,5]}],
  "predicates": {
    "receiver_side": {"symbolic": 1, "filter": 2, "interval": 3, "double_double": 20, "exact": 4},
    "vertex_side": {"symbolic": 5, "filter": 6, "interval": 7, "double_double": 21, "exact": 8},
    "plane_side": {"symbolic": 9, "filter": 10, "interval": 11, "double_double": 22, "exact": 12},
    "edge_order": {"symbolic": 0, "filter": 0, "interval": 0, "double_double": 0, "exact": 1}
  },
  "visibility": {
    "sources": 13,
    "blockers": 14,
    "arcs": 15
  },
  "evaluation": {
    "zero": 16,
    "double": 17,
    "double_double": 18,
    "multiprecision": 19,
    "ties": 20,
    "overflows": 21,
    "max_precision_bits": 22
  }
}
)");
}

}  // namespace
}  // namespace truelux
