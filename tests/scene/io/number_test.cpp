// SPDX-License-Identifier: GPL-3.0-or-later
// ParseNumber against MPFR, which rounds any decimal text correctly.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>

#include <mpfr.h>

#include <gtest/gtest.h>

#include "truelux/io.h"

namespace truelux {
namespace {

/// A binary64 with its exponent range, including subnormals.
class Binary64 {
 public:
  Binary64() {
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
    mpfr_init2(value_, 53);
  }

  ~Binary64() { mpfr_clear(value_); }

  Binary64(const Binary64&) = delete;
  Binary64& operator=(const Binary64&) = delete;

  std::optional<double> Read(const std::string& text) {
    const int ternary =
        mpfr_strtofr(value_, text.c_str(), nullptr, 10, MPFR_RNDN);
    mpfr_subnormalize(value_, ternary, MPFR_RNDN);
    if (mpfr_inf_p(value_) != 0) return std::nullopt;
    return mpfr_get_d(value_, MPFR_RNDN);
  }

 private:
  mpfr_t value_{};
};

/// The exact value of x + half an ulp, x >= 0: digits and an exponent so that
/// it is 0.digits * 10^exponent.
struct ExactDecimal {
  std::string digits;
  long exponent = 0;
};

ExactDecimal MidpointAbove(double x) {
  mpfr_t value;
  mpfr_t half;
  mpfr_set_emin(mpfr_get_emin_min());
  mpfr_init2(value, 1200);
  mpfr_init2(half, 1200);
  const double next =
      std::nextafter(x, std::numeric_limits<double>::infinity());
  mpfr_set_d(value, x, MPFR_RNDN);
  mpfr_set_d(half, next - x, MPFR_RNDN);
  mpfr_div_2ui(half, half, 1, MPFR_RNDN);
  mpfr_add(value, value, half, MPFR_RNDN);
  mpfr_exp_t exponent = 0;
  char* const digits =
      mpfr_get_str(nullptr, &exponent, 10, 800, value, MPFR_RNDN);
  ExactDecimal result{digits, exponent};
  mpfr_free_str(digits);
  mpfr_clear(value);
  mpfr_clear(half);
  return result;
}

void ExpectAsMpfr(const std::string& text) {
  Binary64 reference;
  const std::optional<double> expected = reference.Read(text);
  const std::optional<double> actual = ParseNumber(text);
  ASSERT_EQ(actual.has_value(), expected.has_value()) << text;
  if (!actual) return;
  ASSERT_EQ(std::bit_cast<std::uint64_t>(*actual),
            std::bit_cast<std::uint64_t>(*expected))
      << text;
}

std::string RandomDigits(std::mt19937_64& random, std::size_t count) {
  std::string digits;
  while (digits.size() < count) {
    digits += static_cast<char>('0' + random() % 10);
  }
  return digits;
}

double RandomMagnitude(std::mt19937_64& random) {
  // A third of them subnormal or near it.
  const std::uint64_t exponent =
      random() % 3 == 0 ? random() % 3 : random() % 2046;
  return std::bit_cast<double>((exponent << 52U) | (random() >> 12U));
}

TEST(ParseNumber, ReadsTheUsualForms) {
  EXPECT_EQ(ParseNumber("1."), 1);
  EXPECT_EQ(ParseNumber(".5"), 0.5);
  EXPECT_EQ(ParseNumber("-1E-3"), -1e-3);
  EXPECT_EQ(ParseNumber("+2"), 2);
  EXPECT_EQ(ParseNumber("1.e+2"), 100);
  EXPECT_EQ(ParseNumber("007.250"), 7.25);
  EXPECT_EQ(ParseNumber("0.1"), 0.1);
}

TEST(ParseNumber, RefusesWhatIsNoDecimalNumber) {
  for (const char* text :
       {"",    "+",        "-",      ".",     "e5",          "+.",
        "1e",  "1e+",      "1.5.2",  "1,5",   "1 ",          " 1",
        "+-1", "--1",      "- 1",    "inf",   "-inf",        "nan",
        "NaN", "infinity", "nan(0)", "0x10",  "0x1p3",       "1p3",
        "1d5", "1_000",    "1f",     "1e5.5", "\xEF\xBC\x91"}) {
    EXPECT_EQ(ParseNumber(text), std::nullopt) << text;
  }
  EXPECT_EQ(ParseNumber(std::string_view("1\0", 2)), std::nullopt);
}

TEST(ParseNumber, OverflowIsNoNumber) {
  EXPECT_EQ(ParseNumber("1e999"), std::nullopt);
  EXPECT_EQ(ParseNumber("-1e99999999999999999999"), std::nullopt);
  EXPECT_EQ(ParseNumber("1.7976931348623159e308"), std::nullopt);
  EXPECT_EQ(ParseNumber("1.7976931348623158e308"),
            std::numeric_limits<double>::max());
  EXPECT_EQ(ParseNumber(std::string("1").append(400, '0')), std::nullopt);
}

TEST(ParseNumber, UnderflowIsTheNearestSubnormalOrZero) {
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(ParseNumber("5e-324"), kLeast);
  EXPECT_EQ(ParseNumber("2.5e-324"), kLeast);
  EXPECT_EQ(ParseNumber("2.4e-324"), 0);
  EXPECT_EQ(ParseNumber("1e-999"), 0);
  EXPECT_EQ(ParseNumber("1e-99999999999"), 0);
  const std::optional<double> negative = ParseNumber("-1e-999");
  ASSERT_EQ(negative, 0);
  EXPECT_TRUE(std::signbit(*negative));
}

TEST(ParseNumber, LongZerosAndExponentsCancel) {
  EXPECT_EQ(ParseNumber("0e99999"), 0);
  EXPECT_EQ(ParseNumber("0e-99999999999999999999"), 0);
  EXPECT_EQ(ParseNumber(std::string("0.").append(700000, '0') + "1e700001"), 1);
  EXPECT_EQ(ParseNumber(std::string("25").append(700000, '0') + "e-700001"),
            2.5);
  EXPECT_EQ(ParseNumber(std::string(5000, '0') + "3"), 3);
  EXPECT_EQ(ParseNumber(std::string(5000, '0') + "3e-1000"), 0);
  EXPECT_EQ(ParseNumber(std::string("1e").append(60, '9')), std::nullopt);
  EXPECT_EQ(ParseNumber(std::string("1e-").append(60, '9')), 0);
  EXPECT_EQ(ParseNumber(std::string("0.").append(70000, '0') + "1e9"), 0);
}

TEST(ParseNumber, RoundsRandomTextsAsMpfr) {
  std::mt19937_64 random(20240501);
  for (int i = 0; i < 20000; ++i) {
    const std::string whole = RandomDigits(random, random() % 25);
    const std::string fraction = RandomDigits(random, 1 + random() % 25);
    const int exponent = static_cast<int>(random() % 700) - 360;
    const std::string sign = random() % 2 == 0 ? "-" : "";
    ExpectAsMpfr(sign + whole + "." + fraction + "e" +
                 std::to_string(exponent));
    if (HasFatalFailure()) return;
  }
}

TEST(ParseNumber, RoundsMidpointsToEvenAndTheirNeighboursToNearest) {
  std::mt19937_64 random(20240502);
  for (int i = 0; i < 3000; ++i) {
    const ExactDecimal middle = MidpointAbove(RandomMagnitude(random));
    const std::string exponent =
        std::string("e").append(std::to_string(middle.exponent));
    ExpectAsMpfr("0." + middle.digits + exponent);
    ExpectAsMpfr("0." + middle.digits + "000000001" + exponent);
    std::string below = middle.digits;
    std::size_t last = below.find_last_not_of('0');
    --below[last];
    ExpectAsMpfr("-0." + below + "99999" + exponent);
    // The same far behind the point, brought back by the exponent.
    ExpectAsMpfr(std::string("0.").append(12000, '0') + middle.digits + "1e" +
                 std::to_string(middle.exponent + 12000));
    if (HasFatalFailure()) return;
  }
}

TEST(ParseNumber, RoundsMidpointsAtTheEndsOfTheRange) {
  using Limits = std::numeric_limits<double>;
  const double max = Limits::max();
  for (const double x :
       {0.0, Limits::denorm_min(), std::nextafter(Limits::min(), 0.0),
        Limits::min(), std::nextafter(max, 0.0)}) {
    const ExactDecimal middle = MidpointAbove(x);
    for (const int shift : {0, 12000}) {
      const std::string text =
          std::string("0.").append(static_cast<std::size_t>(shift), '0') +
          middle.digits;
      const std::string exponent = std::to_string(middle.exponent + shift);
      ExpectAsMpfr(text + "e" + exponent);
      ExpectAsMpfr(text + "1e" + exponent);
    }
  }
  // max + half an ulp, 1.797693134862315807937...e308, is the first number
  // that overflows.
  const std::string zeros(12000, '0');
  EXPECT_EQ(ParseNumber("0." + zeros + "17976931348623158080e12309"),
            std::nullopt);
  EXPECT_EQ(ParseNumber("0." + zeros + "17976931348623158079e12309"), max);
}

TEST(ParseNumber, DigitsFarBehindAMidpointStillCount) {
  const double above = std::nextafter(0.5, 1.0);
  EXPECT_EQ(ParseNumber("0.50000000000000005551115123125782702118158340454"
                        "1015625"),
            0.5);
  EXPECT_EQ(ParseNumber("0.50000000000000005551115123125782702118158340454"
                        "1015625" +
                        std::string(2000, '0') + "1"),
            above);
}

}  // namespace
}  // namespace truelux
