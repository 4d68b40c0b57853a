// SPDX-License-Identifier: GPL-3.0-or-later
// The cases in tests/data/derivatives, whose 30 digits come from an independent
// program: every component, relative to the largest of its row; zeros exactly.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"
#include "truelux/io.h"

namespace truelux {
namespace {

namespace fs = std::filesystem;

using Row = std::map<std::string, std::string>;

/// A CSV without quotes.
std::vector<Row> ReadRows(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> fields(1);
    for (const char c : line) {
      if (c == ',') {
        fields.emplace_back();
      } else if (c != '\r') {
        fields.back() += c;
      }
    }
    if (names.empty()) {
      names = fields;
      continue;
    }
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && i < fields.size(); ++i)
      row[names[i]] = fields[i];
  }
  return rows;
}

double NumberOf(const std::string& text) {
  return ParseNumber(text).value();
}

std::vector<std::string> CaseNames() {
  std::vector<std::string> names;
  for (const auto& entry :
       fs::directory_iterator(TRUELUX_TEST_DATA "/derivatives")) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::size_t ChannelOf(const Row& row) {
  return std::string("rgb").find(row.at("channel"));
}

std::size_t ReceiverOf(const Row& row) {
  return std::stoul(row.at("receiver")) - 1;
}

class DerivativeCase : public ::testing::TestWithParam<std::string> {
 protected:
  DerivativeCase() {
    for (const Row& row : ReadRows(folder_ / "receivers.csv")) {
      const auto number = [&row](const char* name) {
        return NumberOf(row.at(name));
      };
      const auto face = row.find("on_face");
      receivers_.push_back({{number("x"), number("y"), number("z")},
                            {number("nx"), number("ny"), number("nz")},
                            face == row.end() || face->second.empty()
                                ? 0
                                : static_cast<int>(NumberOf(face->second))});
    }
  }

  static void ExpectNear(double got, const std::string& text, double size,
                         const std::string& what) {
    const double want = NumberOf(text);
    if (text == "0") {
      EXPECT_EQ(got, 0) << what;
    } else {
      EXPECT_LE(std::fabs(got - want),
                1e-15 * std::max(size, std::fabs(want)) + 5e-324)
          << what << ' ' << got << ' ' << text;
    }
  }

  fs::path folder_ = fs::path(TRUELUX_TEST_DATA "/derivatives") / GetParam();
  Oracle oracle_{ReadScene((folder_ / "scene.obj").string()).value.value()};
  std::vector<Receiver> receivers_;
};

TEST_P(DerivativeCase, ByTheReceiver) {
  std::vector<Derivatives> found;
  for (const Receiver& receiver : receivers_)
    found.push_back(oracle_.Derivatives(receiver));
  int rows = 0;
  for (const Row& row : ReadRows(folder_ / "expected_gradient.csv")) {
    const Derivatives& d = found[ReceiverOf(row)];
    const std::size_t channel = ChannelOf(row);
    const ChannelDerivatives& c = d.channels[channel];
    EXPECT_EQ(d.irradiance.value[channel], NumberOf(row.at("E")));
    EXPECT_EQ(Name(d.smoothness), row.at("status"));
    EXPECT_EQ(d.undecided, 0);
    ++rows;
    if (d.smoothness == Smoothness::kDiscontinuous) continue;
    const auto expect_vector = [&](const Vector3& v, const std::string& name) {
      double size = 0;
      for (const char* axis : {"x", "y", "z"})
        size = std::max(size, std::fabs(NumberOf(row.at(name + axis))));
      ExpectNear(v.x, row.at(name + "x"), size, name + "x");
      ExpectNear(v.y, row.at(name + "y"), size, name + "y");
      ExpectNear(v.z, row.at(name + "z"), size, name + "z");
    };
    expect_vector(c.gradient, "g");
    expect_vector(c.normal, "dn");
    ExpectNear(c.flux, row.at("netflux"), 0, "flux");
  }
  EXPECT_GT(rows, 0);
  std::map<std::string, double> sizes;
  const std::vector<Row> jacobians =
      ReadRows(folder_ / "expected_jacobian.csv");
  const auto key = [](const Row& row) {
    return row.at("receiver") + row.at("channel") + row.at("quantity");
  };
  for (const Row& row : jacobians) {
    double& size = sizes[key(row)];
    size = std::max(size, std::fabs(NumberOf(row.at("value"))));
  }
  const auto axis_of = [](const std::string& text) {
    const std::size_t at = std::string("xyz").find(text);
    return at != std::string::npos ? at : std::stoul(text);
  };
  for (const Row& row : jacobians) {
    const Derivatives& d = found[ReceiverOf(row)];
    const ChannelDerivatives& c = d.channels[ChannelOf(row)];
    const std::size_t p = axis_of(row.at("row"));
    const std::string& quantity = row.at("quantity");
    double got = 0;
    if (row.at("col").empty()) {
      const Vector3& v = quantity == "V_hemi" ? c.vector : c.sphere;
      got = p == 0 ? v.x : p == 1 ? v.y : v.z;
    } else {
      const Matrix3& j = quantity == "J_hemi" ? c.jacobian : c.sphere_jacobian;
      got = j[p][axis_of(row.at("col"))];
    }
    ExpectNear(got, row.at("value"), sizes[key(row)], key(row));
  }
}

TEST_P(DerivativeCase, ByVertices) {
  std::vector<std::map<int, VertexDerivative>> found;
  for (const Receiver& receiver : receivers_) {
    auto& vertices = found.emplace_back();
    for (const VertexDerivative& v :
         oracle_.VertexDerivatives(receiver).vertices) {
      vertices[v.number] = v;
    }
  }
  const std::vector<Row> rows = ReadRows(folder_ / "expected_vertex.csv");
  std::map<std::string, double> sizes;
  const auto is_number = [](const std::string& text) {
    return !text.empty() && text != "jump";
  };
  for (const Row& row : rows) {
    for (const char* name : {"value", "left", "right"}) {
      double& size = sizes[row.at("receiver") + row.at("channel")];
      if (is_number(row.at(name)))
        size = std::max(size, std::fabs(NumberOf(row.at(name))));
    }
  }
  for (const Row& row : rows) {
    auto& vertices = found[ReceiverOf(row)];
    const int number = std::stoi(row.at("vertex"));
    const VertexSlope& slope =
        vertices[number]
            .slopes[ChannelOf(row)][std::string("xyz").find(row.at("axis"))];
    const double size = sizes[row.at("receiver") + row.at("channel")];
    const std::string what = "receiver " + row.at("receiver") + " vertex " +
                             row.at("vertex") + row.at("axis");
    if (is_number(row.at("value"))) {
      EXPECT_TRUE(slope.IsSmooth()) << what;
      ExpectNear(slope.left, row.at("value"), size, what);
      continue;
    }
    EXPECT_EQ(slope.left_jumps, row.at("left") == "jump") << what;
    EXPECT_EQ(slope.right_jumps, row.at("right") == "jump") << what;
    if (is_number(row.at("left")))
      ExpectNear(slope.left, row.at("left"), size, what);
    if (is_number(row.at("right")))
      ExpectNear(slope.right, row.at("right"), size, what);
  }
  EXPECT_GT(rows.size(), 8U);
}

INSTANTIATE_TEST_SUITE_P(All, DerivativeCase, ::testing::ValuesIn(CaseNames()),
                         [](const auto& row) { return row.param; });

}  // namespace
}  // namespace truelux
