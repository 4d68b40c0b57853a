// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/regimes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "baselines/seen_from.h"

namespace truelux::testing {
namespace {

constexpr std::uint64_t kSeed = 2024;
constexpr std::uint64_t kCases = 60;

Regime Named(const std::string& name) {
  for (Regime& regime : Regimes()) {
    if (regime.name == name) return regime;
  }
  throw std::invalid_argument("no regime is called " + name);
}

/// Calls check(case, loop seen from its receiver) for the cases of a regime.
template <class Check>
void ForCasesOf(const std::string& name, const Check& check) {
  const Regime regime = Named(name);
  for (std::uint64_t i = 0; i < kCases; ++i) {
    SCOPED_TRACE(name + ", case " + std::to_string(i));
    const RegimeCase made = regime.Make(kSeed, i);
    check(made, SeenFrom(made.receiver, made.loop));
  }
}

std::string Text(int k) {
  return "1e-" + std::to_string(k);
}

double Elevation(const RealVec& v) {
  return Atan2(v.z, Sqrt(v.x * v.x + v.y * v.y)).ToDouble();
}

/// Whether two sides of a loop cross as seen from the receiver.
bool Crosses(const std::vector<RealVec>& loop) {
  const std::size_t n = loop.size();
  const auto apart = [](const RealVec& a, const RealVec& b, const RealVec& c,
                        const RealVec& d) {
    const RealVec plane = Cross(a, b);
    return Dot(plane, c) * Dot(plane, d) < ShortReal(0);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const RealVec& a = loop[i];
      const RealVec& b = loop[i + 1];
      const RealVec& c = loop[j];
      const RealVec& d = loop[(j + 1) % n];
      // All above the horizon, so that no antipodes come into it.
      if (apart(a, b, c, d) && apart(c, d, a, b)) return true;
    }
  }
  return false;
}

TEST(Regimes, NamesAreUniqueAndFitIntoATable) {
  std::set<std::string> names;
  bool occluded = false;
  for (const Regime& regime : Regimes()) {
    EXPECT_TRUE(names.insert(regime.name).second) << regime.name;
    EXPECT_EQ(regime.name.find_first_of(",\"\n"), regime.name.npos);
    EXPECT_FALSE(occluded && !regime.occluded) << "the unoccluded ones first";
    occluded = regime.occluded;
  }
  EXPECT_EQ(names.size(), 28U + 8U + 33U);
}

TEST(Regimes, TheSameSeedGivesTheSameBits) {
  const auto points = [](const RegimeCase& made) {
    std::vector<Point3> all = made.loop;
    const auto vertices = made.scene.vertices();
    all.insert(all.end(), vertices.begin(), vertices.end());
    all.push_back(made.receiver.position);
    return all;
  };
  for (const Regime& regime : Regimes()) {
    const std::vector<Point3> first = points(regime.Make(kSeed, 3));
    EXPECT_EQ(points(regime.Make(kSeed, 3)), first) << regime.name;
    EXPECT_NE(points(regime.Make(kSeed, 4)), first) << regime.name;
    EXPECT_NE(points(regime.Make(kSeed + 1, 3)), first) << regime.name;
  }
}

TEST(Regimes, UnoccludedCasesAreSimpleLoopsAboveTheHorizon) {
  for (const Regime& regime : Regimes()) {
    if (regime.occluded) continue;
    std::set<std::size_t> sizes;
    ForCasesOf(regime.name, [&](const RegimeCase& made, const auto& loop) {
      EXPECT_TRUE(made.scene.faces().empty());
      EXPECT_GE(loop.size(), 3U);
      EXPECT_LE(loop.size(), 6U);
      sizes.insert(loop.size());
      const Vector3& n = made.receiver.normal;
      for (const RealVec& v : loop)
        EXPECT_LT(ShortReal(0), Dot(v, RealVec{n.x, n.y, n.z}));
      EXPECT_FALSE(Crosses(loop));
      const ShortReal e = SignedFormFactor(loop, n);
      EXPECT_LT(ShortReal(0), e);
      EXPECT_LT(e, ShortReal(1));
      if (regime.name.rfind("far", 0) == 0) return;
      EXPECT_EQ(made.receiver.position, Point3{});
      EXPECT_EQ(n, (Vector3{0, 0, 1}));
    });
    const bool fixed = regime.name.find("vertical") != std::string::npos ||
                       regime.name.find("axis") != std::string::npos;
    EXPECT_GE(sizes.size(), fixed ? 1U : 3U) << regime.name;
  }
}

TEST(Regimes, AngularSize) {
  for (int k = 0; k <= 8; ++k) {
    const double size = std::pow(10, -k);
    ForCasesOf("size " + Text(k), [&](const RegimeCase&, const auto& loop) {
      EXPECT_GT(Diameter(loop), 0.15 * size);
      EXPECT_LT(Diameter(loop), 1.001 * size);
    });
  }
}

TEST(Regimes, ElevationAboveTheHorizon) {
  for (const int k : {2, 4, 6, 8}) {
    const double elevation = std::pow(10, -k);
    ForCasesOf("elevation " + Text(k) + " iso",
               [&](const RegimeCase&, const auto& loop) {
                 EXPECT_GT(Diameter(loop), 0.08 * elevation);
                 EXPECT_LT(Diameter(loop), 0.601 * elevation);
                 for (const RealVec& v : loop)
                   EXPECT_NEAR(Elevation(v), elevation, 0.301 * elevation);
               });
    ForCasesOf("elevation " + Text(k) + " wide",
               [&](const RegimeCase&, const auto& loop) {
                 EXPECT_GT(Diameter(loop), 0.08);
                 EXPECT_LT(Diameter(loop), 1.2);
                 for (const RealVec& v : loop) {
                   EXPECT_GT(Elevation(v), 0.75 * elevation);
                   EXPECT_LT(Elevation(v), 3 * elevation);
                 }
               });
  }
}

TEST(Regimes, VerticesOnTheHorizonButForTheLastBits) {
  for (const int count : {1, 2}) {
    const std::string name = count == 1 ? "1 vertex" : "2 vertices";
    ForCasesOf(name + " at 1e-12", [&](const RegimeCase&, const auto& loop) {
      int low = 0;
      for (const RealVec& v : loop) {
        const double elevation = Elevation(v);
        if (elevation < 0.1) {
          ++low;
          EXPECT_GT(elevation, 0.99e-12);
          EXPECT_LT(elevation, 3.01e-12);
        } else {
          EXPECT_GT(elevation, 0.14);
        }
      }
      EXPECT_EQ(low, count);
    });
  }
}

TEST(Regimes, SliversAreThin) {
  const auto check = [](const std::string& name, double length, double width) {
    ForCasesOf(name, [&](const RegimeCase&, const auto& loop) {
      EXPECT_GT(Diameter(loop), 0.1 * length);
      EXPECT_LT(Diameter(loop), 1.001 * length);
      const auto farthest = std::ranges::max_element(
          loop, {}, [&](const auto& v) { return AngleBetween(loop[0], v); });
      const RealVec chord = Cross(loop[0], *farthest);
      double away = 0;
      for (const RealVec& v : loop)
        away = std::max(away, std::abs(AngleToPlane(v, chord)));
      EXPECT_GT(away, 0.02 * width);
      EXPECT_LT(away, 2 * width);
    });
  };
  check("sliver 0.5 x 5e-7", 0.5, 5e-7);
  check("sliver 2e-3 x 2e-9", 2e-3, 2e-9);
}

TEST(Regimes, TheSourcePlanePassesCloseToTheReceiver) {
  for (const int k : {4, 8}) {
    ForCasesOf(Text(k) + " off the source plane", [&](const RegimeCase&,
                                                      const auto& loop) {
      const RealVec plane = Cross(loop[1] - loop[0], loop[2] - loop[0]);
      const ShortReal height = Dot(plane, loop[0]) / LengthOf(plane);
      EXPECT_NEAR(Abs(height).ToDouble() * std::pow(10, k), 1, 1e-4);
    });
  }
}

TEST(Regimes, TheSourcePlaneIsParallelToTheReceivers) {
  for (const bool above : {false, true}) {
    ForCasesOf(
        above ? "source plane 1e-8 up above" : "source plane 1e-8 up beside",
        [&](const RegimeCase& made, const auto& loop) {
          for (const Point3& p : made.loop) {
            EXPECT_EQ(p.z, made.loop[0].z);
            EXPECT_GE(p.z, 0.5e-8);
            EXPECT_LE(p.z, 3e-8);
          }
          const double e =
              SignedFormFactor(loop, made.receiver.normal).ToDouble();
          if (above) {
            EXPECT_NEAR(e, 1, 1e-6);
          } else {
            EXPECT_LT(e, 1e-14);
          }
        });
  }
}

TEST(Regimes, EdgesAlongYAndPastTheAxis) {
  ForCasesOf("vertical edges", [](const RegimeCase& made, const auto&) {
    EXPECT_EQ(made.loop[0].x, made.loop[1].x);
    EXPECT_EQ(made.loop[2].x, made.loop[3].x);
  });
  ForCasesOf(
      "edges 1e-9 off vertical", [](const RegimeCase& made, const auto&) {
        for (const std::size_t i : {0U, 2U}) {
          const double off = std::abs(made.loop[i].x - made.loop[i + 1].x);
          EXPECT_GT(off, 0);
          EXPECT_LE(off, 3.01e-9);
        }
      });
  ForCasesOf("edge 1e-9 off the axis", [](const RegimeCase&, const auto& loop) {
    const RealVec plane = Cross(loop[2], loop[0]);
    EXPECT_NEAR(AngleToPlane({0, 0, 1}, plane) * 1e9, 1, 1e-5);
  });
}

TEST(Regimes, FarFromTheOrigin) {
  for (const std::string offset : {"0", "1e3", "1e6", "1e9"}) {
    for (const std::string size : {"1", "1e-3"}) {
      double farthest = 0;
      ForCasesOf(
          std::string("far ").append(offset).append(" size ").append(size),
          [&](const RegimeCase& made, const auto& loop) {
            EXPECT_GT(Diameter(loop), 0.6 * std::stod(size));
            EXPECT_LT(Diameter(loop), 1.05 * std::stod(size));
            const Point3& r = made.receiver.position;
            for (const double x : {r.x, r.y, r.z})
              farthest = std::max(farthest, std::abs(x));
            const Vector3& n = made.receiver.normal;
            EXPECT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1, 1e-15);
          });
      EXPECT_GT(farthest, 0.9 * std::stod(offset));
      EXPECT_LT(farthest, std::stod(offset) + 1);
    }
  }
}

}  // namespace
}  // namespace truelux::testing
