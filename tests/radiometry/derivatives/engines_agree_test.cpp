// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives from the contour of the arrangement engine, which shares no line
// of visibility with the contour engine, have the same bits.

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"

#include "exact/recipe_evaluator.h"
#include "radiometry/derivatives/arrangement_lines.h"
#include "radiometry/derivatives/components.h"
#include "radiometry/derivatives/derivative_finder.h"
#include "radiometry/derivatives/kink_planes.h"
#include "radiometry/derivatives/vertex_limits.h"
#include "radiometry/derivatives/vertex_suspects.h"
#include "radiometry/evaluate.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/sweep.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// In the order of components.h.
ComponentArray<double> ComponentsOf(const ChannelDerivatives& c) {
  ComponentArray<double> all{};
  const auto put = [&all](std::size_t at, const Vector3& v) {
    all[at] = v.x;
    all[at + 1] = v.y;
    all[at + 2] = v.z;
  };
  put(kGradientAt, c.gradient);
  put(kTangentialAt, c.tangential);
  put(kNormalAt, c.normal);
  put(kVectorAt, c.vector);
  put(kSphereAt, c.sphere);
  all[kFluxAt] = c.flux;
  for (std::size_t p = 0; p < 3; ++p) {
    for (std::size_t k = 0; k < 3; ++k) {
      all[kJacobianAt + 3 * p + k] = c.jacobian[p][k];
      all[kSphereJacobianAt + 3 * p + k] = c.sphere_jacobian[p][k];
    }
  }
  return all;
}

enum class Kind { kLattice, kNoise, kGeneral };

/// How many there were of what.
struct Counts {
  int receivers = 0;
  int lit = 0;
  int zeros = 0;       ///< of lit channels
  int candidates = 0;  ///< receivers left out, where there may be kinks
  int slopes = 0;      ///< by vertices, that are not 0
};

/// One scene, by both engines.
class Twin {
 public:
  explicit Twin(const std::vector<TestFace>& faces)
      : scene_(MakeScene(faces)),
        oracle_(scene_),
        engine_(scene_),
        contacts_(engine_),
        lines_(scene_) {}

  void Compare(const Receiver& receiver, Counts& counts) {
    const ContourQuery query{scene_, receiver};
    SeenLineFinder finder(engine_);
    const SeenLines& seen = finder.Find(query);
    if (!FindKinkPlanes(engine_, query, seen).planes.empty()) {
      ++counts.candidates;
      return;
    }
    ++counts.receivers;
    const Contour contour = lines_.Find(query);
    const Derivatives expected = oracle_.Derivatives(receiver);
    ASSERT_EQ(EvaluateContour(query, contour, {}).value,
              expected.irradiance.value);
    counts.lit += expected.irradiance.value == Rgb{} ? 0 : 1;
    CompareComponents(query, contour, expected, counts);
    CompareVertices(query, contour,
                    FindSuspects(engine_, contacts_, query, seen), counts);
  }

  [[nodiscard]] const ArrangementLines& lines() const { return lines_; }

 private:
  static FieldRegion RegionOf(const ContourQuery& query,
                              const Contour& contour) {
    FieldRegion region;
    region.view = ViewOf(query);
    region.contour = contour;
    FindWeights(query, contour, region.weights);
    return region;
  }

  void CompareComponents(const ContourQuery& query, const Contour& contour,
                         const Derivatives& expected, Counts& counts) {
    const FieldRegion hemisphere = RegionOf(query, contour);
    const FieldRegion sphere = RegionOf(query, lines_.FindSphere(query));
    const Vec3<Exact> n =
        RecipeEvaluator<Exact>(ViewOf(query)).ReceiverNormal();
    EvaluationWorkspace workspace;
    const CertifiedNumbers found =
        FindComponents({hemisphere, sphere, n, n}, {}, workspace).numbers;
    EXPECT_EQ(found.undecided, expected.undecided);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const auto values = ComponentsOf(expected.channels[channel]);
      const auto bounds = ComponentsOf(expected.bounds[channel]);
      for (std::size_t k = 0; k < kComponentCount; ++k) {
        const std::size_t i = channel * kComponentCount + k;
        ASSERT_EQ(found.values[i], values[k]) << "component " << k;
        ASSERT_EQ(found.bounds[i], bounds[k]) << "component " << k;
        if (values[k] == 0 && expected.irradiance.value[channel] != 0)
          ++counts.zeros;
      }
    }
  }

  /// Whether sums round to slopes.
  static bool AreEqual(
      const std::array<Vec3<ArbReal>, 3>& sums,
      const std::array<std::array<VertexSlope, 3>, 3>& slopes) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const Vec3<ArbReal>& v = sums[channel];
      const std::array<const ArbReal*, 3> axes = {&v.x, &v.y, &v.z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool is_open = arb_contains_zero(axes[axis]->get()) != 0;
        const double value = is_open ? 0 : axes[axis]->Nearest();
        if (value != slopes[channel][axis].left) return false;
      }
    }
    return true;
  }

  /// dE/dv by exact arcs and Arb, of vertices that are no suspects.
  void CompareVertices(const ContourQuery& query, const Contour& contour,
                       const std::set<int>& suspects, Counts& counts) {
    std::map<int, VertexDerivative> expected;
    for (const VertexDerivative& vertex :
         oracle_.VertexDerivatives(query.receiver).vertices) {
      if (!suspects.contains(vertex.number)) expected[vertex.number] = vertex;
    }
    const ReceiverView view = ViewOf(query);
    std::vector<Rgb> weights;
    FindWeights(query, contour, weights);
    MovingContour moving = MovingContourOf(view, contour);
    SplitCuts(view, scene_, moving);
    for (const auto& [number, terms] : VertexTermsOf(view, scene_, moving)) {
      if (suspects.contains(number)) continue;
      const auto slopes = expected[number].slopes;
      expected.erase(number);
      // Noise of 5e-324 takes more bits than anything else.
      const auto few =
          VertexSums(moving, terms, weights, Emission::kExitance, 512);
      const bool is_enough = AreEqual(few, slopes);
      ASSERT_TRUE(is_enough || AreEqual(VertexSums(moving, terms, weights,
                                                   Emission::kExitance, 4096),
                                        slopes))
          << "vertex " << number;
      for (const auto& channel : slopes) {
        for (const VertexSlope& slope : channel)
          counts.slopes += slope.left != 0 ? 1 : 0;
      }
    }
    // Corners of faces that are cut elsewhere do not matter.
    for (const auto& [number, vertex] : expected) {
      for (const auto& channel : vertex.slopes) {
        for (const VertexSlope& slope : channel)
          EXPECT_EQ(slope.left, 0) << number;
      }
    }
  }

  Scene scene_;
  Oracle oracle_;
  ContourEngine engine_;
  SceneContacts contacts_;
  ArrangementLines lines_;
};

class DerivativeEnginesAgree : public ::testing::TestWithParam<Kind> {};

TEST_P(DerivativeEnginesAgree, OnRandomSoups) {
  const bool lattice = GetParam() != Kind::kGeneral;
  Counts counts;
  int cuts = 0;
  int walls = 0;
  int horizons = 0;
  // Numbers of 1e-324 and of 1 together are long.
  const int scenes =
      GetParam() == Kind::kNoise ? SweepSize(5, 20) : SweepSize(12, 60);
  for (int seed = 0; seed < scenes; ++seed) {
    PortableRandom random(static_cast<std::uint64_t>(seed) * 3 + 7000 +
                          static_cast<std::uint64_t>(GetParam()));
    const int range = random.Integer(1, 4);
    std::vector<TestFace> faces =
        RandomScene(random, lattice, random.Integer(2, 12), range);
    if (GetParam() == Kind::kNoise) {
      for (TestFace& face : faces) {
        face.ring.resize(3);  // noise would bend a quad
        for (Point3& p : face.ring)
          p = {random.Nudge(p.x), random.Nudge(p.y), random.Nudge(p.z)};
      }
    }
    Twin twin(faces);
    for (int i = 0; i < 4; ++i) {
      Receiver r = RandomReceiver(random, lattice, range);
      // On the lattice itself there are kinks nearly everywhere.
      if (lattice) {
        r.position.x += random.Integer(-50, 50) / 128.0;
        r.position.y += random.Integer(-50, 50) / 128.0;
      }
      twin.Compare(r, counts);
      if (HasFatalFailure()) FAIL() << "seed " << seed << ", receiver " << i;
    }
    cuts += twin.lines().cuts();
    walls += twin.lines().walls();
    horizons += twin.lines().horizons();
  }
  EXPECT_GT(counts.receivers, scenes);
  EXPECT_GT(counts.lit, counts.receivers / 4);
  EXPECT_GT(counts.slopes, 200);
  EXPECT_GT(cuts, 10);
  EXPECT_GT(walls, 10);
  EXPECT_GT(horizons, 10);
  RecordProperty("receivers", counts.receivers);
  RecordProperty("zeros", counts.zeros);
  RecordProperty("left_out", counts.candidates);
}

INSTANTIATE_TEST_SUITE_P(Kinds, DerivativeEnginesAgree,
                         ::testing::Values(Kind::kLattice, Kind::kNoise,
                                           Kind::kGeneral));

// Zeros by symmetry are found from either contour.
TEST(DerivativeEnginesAgree, OnZeros) {
  Twin twin({{Ceiling(-1, 1, -1, 1, 2), kLamp},
             {Ceiling(-0.25, 0.25, -0.25, 0.25, 1), kBlack},
             {Floor(-3, 3, -3, 3, -1), kLamp}});
  Counts counts;
  twin.Compare({{0, 0, 0}, {0, 0, 1}, 0}, counts);
  EXPECT_EQ(counts.receivers, 1);
  EXPECT_GT(counts.zeros, 30);
}

}  // namespace
}  // namespace truelux
