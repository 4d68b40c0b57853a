// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers that cannot be used: refused before anything is found, and named.

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "support/scenes.h"

namespace truelux::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Oracle& SomeOracle() {
  static const Oracle oracle(
      MakeScene({{Ceiling(-1, 1, -1, 1, 1), kLamp}, {Floor(0, 1, 0, 1, -1)}}));
  return oracle;
}

constexpr Receiver kGood{{0, 0, 0}, {0, 0, 1}, 0};

struct Bad {
  Receiver receiver;
  std::string message;
};

std::vector<Bad> BadReceivers() {
  const std::string position = "the receiver's position is not finite";
  const std::string normal = "the receiver's normal is zero or not finite";
  return {{{{0, std::nan(""), 0}, {0, 0, 1}, 0}, position},
          {{{kInfinity, 0, 0}, {0, 0, 1}, 0}, position},
          {{{0, 0, 0}, {0, 0, -0.0}, 0}, normal},
          {{{0, 0, 0}, {0, -kInfinity, 1}, 0}, normal},
          {{{0, 0, 0}, {0, 0, 1}, 3}, "on_face is 3, the scene has 2 faces"},
          {{{0, 0, 0}, {0, 0, 1}, -1}, "on_face is -1, the scene has 2 faces"}};
}

/// The error of a call; a failure if it does not throw one.
template <class Call>
ReceiverError ErrorOf(const Call& call) {
  try {
    call();
  } catch (const ReceiverError& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was thrown";
  return {0, ""};
}

TEST(ReceiverErrors, ABatchNamesTheReceiverByItsIndexFromZero) {
  for (const Bad& bad : BadReceivers()) {
    for (const std::size_t place : {0U, 1U, 17U, 19U}) {
      std::vector<Receiver> receivers(20, kGood);
      receivers[place] = bad.receiver;
      const ReceiverError error =
          ErrorOf([&] { (void)SomeOracle().Evaluate(receivers); });
      EXPECT_EQ(error.index(), place);
      EXPECT_EQ(error.what(),
                "receiver " + std::to_string(place) + ": " + bad.message);
    }
  }
}

TEST(ReceiverErrors, OfSeveralTheFirstIsNamed) {
  std::vector<Receiver> receivers(5, kGood);
  receivers[2].normal = {};
  receivers[3].on_face = 9;
  EXPECT_EQ(ErrorOf([&] { (void)SomeOracle().Evaluate(receivers); }).index(),
            2U);
}

TEST(ReceiverErrors, NothingIsTakenBeforeAllAreChecked) {
  std::vector<Receiver> receivers(40, kGood);
  receivers.back().normal = {};
  int taken = 0;
  const auto take = [&](std::size_t, const Irradiance&) { ++taken; };
  EXPECT_EQ(ErrorOf([&] { SomeOracle().Evaluate(receivers, take); }).index(),
            39U);
  EXPECT_EQ(taken, 0);
}

TEST(ReceiverErrors, OneReceiverNeedsNoNumber) {
  const Oracle& oracle = SomeOracle();
  for (const Bad& bad : BadReceivers()) {
    const Receiver& r = bad.receiver;
    const auto expect = [&](const ReceiverError& error) {
      EXPECT_EQ(error.what(), bad.message);
      EXPECT_EQ(error.index(), 0U);
    };
    expect(ErrorOf([&] { (void)oracle.Evaluate(r); }));
    expect(ErrorOf([&] { (void)oracle.FormFactor(r, 1); }));
    expect(ErrorOf([&] { (void)oracle.FormFactors(r); }));
    expect(ErrorOf([&] { (void)oracle.Contour(r); }));
    expect(ErrorOf([&] {
      (void)oracle.EvaluateFormula(r, Formula::kUnified, Arithmetic::kDouble);
    }));
  }
}

TEST(ReceiverErrors, AreInvalidArguments) {
  EXPECT_THROW((void)SomeOracle().Evaluate({{}, {}, 0}), std::invalid_argument);
}

TEST(ReceiverErrors, AFaceThatIsNotThereIsNoFaultOfTheReceiver) {
  for (const int face : {0, -1, 3}) {
    try {
      (void)SomeOracle().FormFactor(kGood, face);
      ADD_FAILURE() << face;
    } catch (const ReceiverError&) {
      ADD_FAILURE() << face;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "the face number is " + std::to_string(face) +
                                  ", the scene has 2 faces");
    }
  }
}

}  // namespace
}  // namespace truelux::testing
