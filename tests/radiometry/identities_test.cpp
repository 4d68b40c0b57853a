// SPDX-License-Identifier: GPL-3.0-or-later
// Identities that keep every bit, on random scenes.

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

using Faces = std::vector<TestFace>;

class Identities : public ::testing::TestWithParam<int> {
 protected:
  Identities()
      : random_(static_cast<std::uint64_t>(GetParam())),
        faces_(RandomScene(random_, GetParam() % 2 == 0, 14)),
        receiver_(RandomReceiver(random_, GetParam() % 2 == 0)) {}

  Rgb Value(const Faces& faces) {
    return Evaluate(MakeScene(faces), receiver_);
  }

  PortableRandom random_;
  Faces faces_;
  Receiver receiver_;
};

TEST_P(Identities, OrderOfFacesThatAreNotCoplanar) {
  const Faces faces = WithoutCoplanarFaces(faces_);
  EXPECT_GT(faces.size(), 5U);
  EXPECT_EQ(Value(Faces(faces.rbegin(), faces.rend())), Value(faces));
}

TEST_P(Identities, FirstVertexOfAPlanarRing) {
  Faces turned = faces_;
  for (TestFace& face : turned) {
    const auto shift =
        random_.Integer(0, static_cast<int>(face.ring.size()) - 1);
    std::rotate(face.ring.begin(), face.ring.begin() + shift, face.ring.end());
  }
  EXPECT_EQ(Value(turned), Value(faces_));
}

TEST_P(Identities, SourceSplitIntoTriangles) {
  Faces split;
  for (const TestFace& face : faces_) {
    for (std::size_t k = 1; k + 1 < face.ring.size(); ++k) {
      split.push_back(
          {{face.ring[0], face.ring[k], face.ring[k + 1]}, face.emission});
    }
  }
  EXPECT_EQ(Value(split), Value(faces_));
}

TEST_P(Identities, ScalingByAPowerOfTwo) {
  const Rgb value = Value(faces_);
  for (const double s : {0x1p-30, 0x1p-300, 0x1p90}) {
    Faces scaled = faces_;
    for (TestFace& face : scaled)
      face.ring = Scaled(face.ring, s);
    const Point3& p = receiver_.position;
    const Receiver r{{p.x * s, p.y * s, p.z * s}, receiver_.normal, 0};
    EXPECT_EQ(Evaluate(MakeScene(scaled), r), value) << s;
  }
}

/// |q|^2 R(q) v for an integer quaternion: exact for lattice coordinates.
Point3 Rotate(const std::array<double, 4>& q, const Point3& v) {
  const auto [a, b, c, d] = q;
  return {(a * a + b * b - c * c - d * d) * v.x + 2 * (b * c - a * d) * v.y +
              2 * (b * d + a * c) * v.z,
          2 * (b * c + a * d) * v.x + (a * a - b * b + c * c - d * d) * v.y +
              2 * (c * d - a * b) * v.z,
          2 * (b * d - a * c) * v.x + 2 * (c * d + a * b) * v.y +
              (a * a - b * b - c * c + d * d) * v.z};
}

using LatticeIdentities = Identities;

TEST_P(LatticeIdentities, RotationByIntegerQuaternions) {
  const Rgb value = Value(faces_);
  for (const std::array<double, 4>& q : {std::array<double, 4>{1, 2, 3, 4},
                                         {0, 3, -5, 11},
                                         {101, -57, 33, 20}}) {
    Faces rotated = faces_;
    for (TestFace& face : rotated) {
      for (Point3& p : face.ring)
        p = Rotate(q, p);
    }
    const Vector3& n = receiver_.normal;
    const Point3 normal = Rotate(q, {n.x, n.y, n.z});
    const Receiver r{
        Rotate(q, receiver_.position), {normal.x, normal.y, normal.z}, 0};
    EXPECT_EQ(Evaluate(MakeScene(rotated), r), value);
  }
}

TEST_P(Identities, FormulasAgreeAndDoubleKeepsItsBound) {
  const Scene scene = MakeScene(faces_);
  const Rgb value = Evaluate(scene, receiver_);
  EXPECT_EQ(Evaluate(scene, receiver_, {.formula = Formula::kUnified}), value);
  for (const Formula formula : {Formula::kAuto, Formula::kUnified}) {
    const Irradiance rough =
        Oracle(scene, {.method = Method::kDouble, .formula = formula})
            .Evaluate(receiver_);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_LE(std::abs(rough.value[c] - value[c]), rough.bound[c]);
    }
  }
}

TEST_P(Identities, SourcesAddUp) {
  // E as the sum of what the faces send one by one, from their form factors.
  const Scene scene = MakeScene(faces_);
  const Oracle oracle(scene);
  double sum = 0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (faces_[f].emission[0] == 0) continue;
    sum += faces_[f].emission[0] *
           oracle.FormFactor(receiver_, static_cast<int>(f) + 1).value[0];
  }
  EXPECT_NEAR(sum, Value(faces_)[0], 1e-13 * (1 + sum));
}

TEST_P(Identities, FurnaceGivesExactlyM) {
  // All faces emit M towards the receiver, in a closed box that does, too.
  Faces furnace;
  for (const TestFace& face : faces_) {
    const bool front = AbovePlane(face.ring, receiver_.position) > 0;
    furnace.push_back({front ? face.ring : Reversed(face.ring), kLamp});
  }
  for (const Ring& ring : BoxAround(64))
    furnace.push_back({ring, kLamp});
  EXPECT_EQ(Value(furnace), kLamp);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Identities, ::testing::Range(0, 40));
INSTANTIATE_TEST_SUITE_P(Scenes, LatticeIdentities, ::testing::Range(0, 40, 2));

}  // namespace
}  // namespace truelux
