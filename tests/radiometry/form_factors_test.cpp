// SPDX-License-Identifier: GPL-3.0-or-later
// Form factors of all sources at once: the bits of each one alone.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/io.h"

#include "support/case_files.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux::testing {
namespace {

const std::vector<OracleOptions>& FastOptions() {
  static const std::vector<OracleOptions> options = {
      {},
      {.formula = Formula::kUnified},
      {.method = Method::kDouble},
      {.method = Method::kDouble, .formula = Formula::kHomogeneous},
      {.method = Method::kDouble, .formula = Formula::kCubature},
      {.method = Method::kDouble,
       .formula = Formula::kImagePlane,
       .half_side = 2}};
  return options;
}

const std::vector<OracleOptions>& SlowOptions() {
  static const std::vector<OracleOptions> options = {
      {.engine = Engine::kArrangement},
      {.engine = Engine::kArrangement, .method = Method::kDouble},
      {.engine = Engine::kAngularSpans}};
  return options;
}

bool Emits(const Face& face) {
  return face.emission != kBlack;
}

/// Equal, or both no number.
bool Same(double a, double b) {
  return a == b || (a != a && b != b);
}

/// What a comparison has seen, so that it is not about nothing.
struct Seen {
  int lit = 0;
  int dark = 0;
};

/// Every emitting face is listed, in order, with the bits of FormFactor.
void ExpectEachAlone(const Oracle& oracle, const Receiver& receiver,
                     Seen& seen) {
  const FormFactorTable table = oracle.FormFactors(receiver);
  const auto faces = oracle.scene().faces();
  std::size_t entry = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!Emits(faces[f])) continue;
    ASSERT_LT(entry, table.faces.size());
    const FaceFormFactor& factor = table.faces[entry++];
    ASSERT_EQ(factor.face, static_cast<int>(f) + 1);
    const Irradiance alone = oracle.FormFactor(receiver, factor.face);
    ASSERT_TRUE(Same(factor.value, alone.value[0]) &&
                Same(factor.bound, alone.bound[0]))
        << "face " << factor.face << ": " << factor.value << " +- "
        << factor.bound << " instead of " << alone.value[0] << " +- "
        << alone.bound[0];
    ++(factor.value > 0 ? seen.lit : seen.dark);
  }
  EXPECT_EQ(entry, table.faces.size());
}

void ExpectEachAlone(const Scene& scene, const Receiver& receiver,
                     const std::vector<OracleOptions>& all, Seen& seen) {
  const PreparedScene prepared(scene);
  for (const OracleOptions& options : all) {
    SCOPED_TRACE(std::string(Name(options.engine)) + " " +
                 std::string(Name(options.method)) + " " +
                 std::string(Name(options.formula)));
    ExpectEachAlone(Oracle(prepared, options), receiver, seen);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

std::vector<Receiver> ReceiversOf(const std::string& name) {
  std::vector<Receiver> receivers;
  for (const auto& row : ReadNumbers(CaseFolder(name) / "receivers.csv")) {
    Receiver r{{row[0], row[1], row[2]}, {row[3], row[4], row[5]}, 0};
    if (row.size() > 6) r.on_face = static_cast<int>(row[6]);
    receivers.push_back(r);
  }
  return receivers;
}

class FormFactorsOfCase : public ::testing::TestWithParam<std::string> {};

TEST_P(FormFactorsOfCase, AreThoseOfEachFaceAlone) {
  const Scene scene = *ReadScene(CaseFolder(GetParam()) / "scene.obj").value;
  std::vector<Receiver> receivers = ReceiversOf(GetParam());
  receivers.resize(std::min<std::size_t>(receivers.size(), 6));
  Seen seen;
  for (const Receiver& receiver : receivers) {
    ExpectEachAlone(scene, receiver, FastOptions(), seen);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.lit + seen.dark, 0);
}

INSTANTIATE_TEST_SUITE_P(Cases, FormFactorsOfCase,
                         ::testing::ValuesIn(CaseNames()),
                         [](const auto& instance) {
                           return std::string(instance.param);
                         });

// Lattice soups: coplanar and overlapping sources, conjunctions, faces that
// pass through each other.
TEST(FormFactors, AgreeOnRandomSoupsForEveryEngine) {
  Seen fast;
  Seen slow;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    PortableRandom random(seed);
    const bool lattice = seed % 4 != 0;
    const int range = random.Integer(1, 4);
    const std::vector<TestFace> faces =
        RandomScene(random, lattice, random.Integer(2, 10), range);
    const Scene scene = MakeScene(faces);
    Receiver r = RandomReceiver(random, lattice, range);
    if (random.OneIn(4))
      r.on_face = random.Integer(1, static_cast<int>(faces.size()));
    SCOPED_TRACE(seed);
    ExpectEachAlone(scene, r, FastOptions(), fast);
    if (seed < 20) ExpectEachAlone(scene, r, SlowOptions(), slow);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(fast.lit, 50);
  EXPECT_GT(fast.dark, 50);
  EXPECT_GT(slow.lit, 20);
}

// Equal neighbours, whose common arcs an irradiance leaves out.
TEST(FormFactors, OfFacesThatShareEdges) {
  const Scene tiles = MakeScene({{Ceiling(0, 1, 0, 1, 1), kLamp},
                                 {Ceiling(1, 2, 0, 1, 1), kLamp},
                                 {Ceiling(0, 1, 1, 2, 1), kLamp},
                                 {Ceiling(0.5, 1.5, 0.5, 1.5, 0.5), kBlack}});
  Seen seen;
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  ExpectEachAlone(tiles, receiver, FastOptions(), seen);
  ExpectEachAlone(tiles, receiver, SlowOptions(), seen);
  EXPECT_EQ(seen.dark, 0);
}

// A lamp in tiles is one source until its tiles are asked for; few and many
// edges between, so that a face alone would choose one path or the other.
TEST(FormFactors, OfATiledLampBehindFewAndManyTriangles) {
  Seen seen;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    PortableRandom random(seed);
    std::vector<TestFace> faces =
        RandomScene(random, true, random.Integer(4, 40), 3);
    for (TestFace& face : faces)
      face.emission = kBlack;
    for (int x = -6; x < 6; x += 4) {
      for (int y = -6; y < 6; y += 4)
        faces.push_back({Ceiling(x, x + 4, y, y + 4, 4), kLamp});
    }
    SCOPED_TRACE(seed);
    const Receiver receiver{
        {0.25 * random.Integer(-8, 8), 0.5, -4}, {0.25, 0, 1}, 0};
    ExpectEachAlone(MakeScene(faces), receiver, FastOptions(), seen);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.lit, 500);
  EXPECT_GT(seen.dark, 50);
}

/// A quad that is bent along a diagonal, between two others.
Scene BentLamp() {
  return MakeScene({{Ceiling(-3, -2, 0, 1, 1), kLamp},
                    {{{-1, -1, 2}, {-1, 1, 1}, {1, 1, 2}, {1, -1, 1}}, kLamp},
                    {Ceiling(0, 5, -1, 0, 1.5), kBlack},
                    {Ceiling(2, 3, 0, 1, 1), {0, 0, 7}}});
}

TEST(FormFactors, OfAFaceThatIsSplitIntoTriangles) {
  const Scene scene = BentLamp();
  ASSERT_EQ(scene.faces()[1].facet_count, 2);
  Seen seen;
  for (const double x : {-0.5, 0.0, 0.25}) {
    const Receiver receiver{{x, 0, 0}, {0.125, 0, 1}, 0};
    ExpectEachAlone(scene, receiver, FastOptions(), seen);
    ExpectEachAlone(scene, receiver, SlowOptions(), seen);
  }
  EXPECT_GT(seen.lit, 0);
}

TEST(FormFactors, ListEveryFaceThatEmitsAndNoOther) {
  const Scene scene =
      MakeScene({{Floor(-1, 1, -1, 1, 2), kLamp},  // from behind
                 {Ceiling(-1, 1, -1, 1, 5), kBlack},
                 {{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}, kLamp},
                 {Ceiling(-1, 1, -1, 1, 1), {0, 1, 0}}});
  ASSERT_EQ(scene.faces()[2].facet_count, 0);
  for (const Engine engine :
       {Engine::kContour, Engine::kArrangement, Engine::kAngularSpans}) {
    const FormFactorTable table = Oracle(scene, {.engine = engine})
                                      .FormFactors({{0, 0, 0}, {0, 0, 1}, 0});
    ASSERT_EQ(table.faces.size(), 3U);
    EXPECT_EQ(table.faces[0].face, 1);
    EXPECT_EQ(table.faces[0].value, 0);
    EXPECT_EQ(table.faces[0].bound, 0);
    EXPECT_EQ(table.faces[1].face, 3);
    EXPECT_EQ(table.faces[1].value, 0);
    EXPECT_EQ(table.faces[2].face, 4);
    EXPECT_NEAR(table.faces[2].value, 0.5541, 1e-4);
    EXPECT_GT(table.faces[2].bound, 0);
  }
  EXPECT_TRUE(Oracle(Scene()).FormFactors({{}, {0, 0, 1}, 0}).faces.empty());
}

TEST(FormFactors, DoNotDependOnHowKeIsRead) {
  const Scene scene = BentLamp();
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  const auto exitance = Oracle(scene).FormFactors(receiver);
  const auto radiance =
      Oracle(scene, {.emission = Emission::kRadiance}).FormFactors(receiver);
  ASSERT_EQ(exitance.faces.size(), radiance.faces.size());
  for (std::size_t i = 0; i < exitance.faces.size(); ++i)
    EXPECT_EQ(exitance.faces[i].value, radiance.faces[i].value);
}

// E is their sum, weighted with what the faces emit.
TEST(FormFactors, AddUpToTheIrradiance) {
  const Scene scene = BentLamp();
  const Oracle oracle(scene);
  const Receiver receiver{{-0.5, 0, 0}, {0, 0, 1}, 0};
  Rgb sum{};
  for (const FaceFormFactor& factor : oracle.FormFactors(receiver).faces) {
    const Face& face = scene.faces()[static_cast<std::size_t>(factor.face - 1)];
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += face.emission[c] * factor.value;
  }
  const Rgb value = oracle.Evaluate(receiver).value;
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(sum[c], value[c], 1e-15 * value[c]);
}

TEST(FormFactors, CountTheVisibilityOnceAndAnEvaluationForEachFace) {
  const Scene scene = BentLamp();
  const Oracle oracle(scene);
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  const FormFactorTable table = oracle.FormFactors(receiver);
  const Statistics contour = oracle.Contour(receiver).statistics;
  EXPECT_EQ(table.statistics.plane_side, contour.plane_side);
  EXPECT_EQ(table.statistics.arcs, contour.arcs);
  EXPECT_EQ(table.statistics.sources, contour.sources);
  EXPECT_EQ(table.statistics.evaluated_zero +
                table.statistics.evaluated_double_double +
                table.statistics.evaluated_multiprecision,
            3U);
}

}  // namespace
}  // namespace truelux::testing
