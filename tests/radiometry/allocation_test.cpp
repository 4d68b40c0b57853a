// SPDX-License-Identifier: GPL-3.0-or-later
// One receiver after the other costs no memory once the storage has grown.

#include <cstddef>
#include <cstdlib>
#include <new>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "support/mesh_scenes.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace {

/// Counts the calls of operator new of this program, which replaces it.
std::size_t allocations = 0;

void* Counted(void* memory) {
  ++allocations;
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

/// Not inline: else the compiler sees that what operator new returned is freed,
/// and takes it for a mistake.
[[gnu::noinline]] void Release(void* memory) {
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
  return Counted(std::malloc(size));
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  return Counted(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}

void operator delete(void* memory) noexcept {
  Release(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  Release(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept {
  Release(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  Release(memory);
}

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

enum class Blockers { kTriangles, kMesh };

/// A lamp above triangles; or one that is cut in quads above a noisy mesh, so
/// that chains are made.
Scene SceneOf(Blockers blockers, PortableRandom& random) {
  std::vector<TestFace> faces;
  if (blockers == Blockers::kMesh) {
    for (int i = -2; i < 2; ++i) {
      for (int k = -2; k < 2; ++k)
        faces.push_back({Ceiling(i, i + 1, k, k + 1, 4), kLamp});
    }
    for (const Ring& ring : SphereMesh(random, 12, {0, 0, 2}, 1, 0.1))
      faces.push_back({ring, kBlack});
    return MakeScene(faces);
  }
  faces.push_back({Ceiling(-2, 2, -2, 2, 4), kLamp});
  for (int i = 0; i < 60; ++i) {
    const auto corner = [&]() -> Point3 {
      return {random.Uniform(-2, 2), random.Uniform(-2, 2),
              random.Uniform(1, 3)};
    };
    faces.push_back({{corner(), corner(), corner()}, kBlack});
  }
  return MakeScene(faces);
}

class Allocation
    : public ::testing::TestWithParam<std::tuple<Method, Blockers>> {};

TEST_P(Allocation, NoneInTheSteadyState) {
  const auto [method, blockers] = GetParam();
  PortableRandom random(1);
  const Oracle oracle(SceneOf(blockers, random), {.method = method});
  std::vector<Receiver> receivers;
  for (int i = 0; i < 200; ++i) {
    receivers.push_back(
        {{random.Uniform(-2, 2), random.Uniform(-2, 2), 0}, {0, 0, 1}, 0});
  }
  // For faint light the bound of kDouble, about 1e-14 M, is wide: formulas are
  // then chosen for each source, which does allocate.
  const std::size_t all = receivers.size();
  std::erase_if(receivers, [&oracle](const Receiver& receiver) {
    const double e = oracle.Evaluate(receiver).value[0];
    return e > 0 && e < 1e-4;
  });
  EXPECT_GT(receivers.size(), all * 9 / 10);
  double sum = 0;
  const auto take = [&sum](std::size_t, const Irradiance& irradiance) {
    sum += irradiance.value[0];
  };
  oracle.Evaluate(receivers, take);
  const double first_sum = sum;
  sum = 0;
  const std::size_t before = allocations;
  oracle.Evaluate(receivers, take);
  EXPECT_GT(first_sum, 0);
  EXPECT_EQ(sum, first_sum);
  // The first call made the storage; of the second, at most a constant few.
  EXPECT_LE(allocations - before, 4U);
  EXPECT_GT(before, 100U);
}

INSTANTIATE_TEST_SUITE_P(
    Methods, Allocation,
    ::testing::Combine(::testing::Values(Method::kCertified, Method::kDouble),
                       ::testing::Values(Blockers::kTriangles,
                                         Blockers::kMesh)));

}  // namespace
}  // namespace truelux
