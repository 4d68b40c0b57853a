// SPDX-License-Identifier: GPL-3.0-or-later
// Names of what can be chosen: each choice has one, and no two share it.

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/diagnostics.h"
#include "truelux/formulas.h"
#include "truelux/irradiance.h"
#include "truelux/visibility.h"

namespace truelux {
namespace {

/// All values from the first enumerator to the last.
template <class Enum>
std::vector<Enum> UpTo(Enum last) {
  std::vector<Enum> values;
  for (int i = 0; i <= static_cast<int>(last); ++i)
    values.push_back(static_cast<Enum>(i));
  return values;
}

/// Names are words of a command line: not empty, without blanks.
template <class Enum>
void ExpectDistinctNames(const std::vector<Enum>& values) {
  std::set<std::string_view> names;
  for (const Enum value : values) {
    const std::string_view name = Name(value);
    EXPECT_FALSE(name.empty()) << static_cast<int>(value);
    EXPECT_EQ(name.find_first_of(" \t\n"), name.npos) << name;
    EXPECT_TRUE(names.insert(name).second) << name << " twice";
  }
}

TEST(Names, EveryChoiceHasItsOwn) {
  ExpectDistinctNames(UpTo(Severity::kNote));
  ExpectDistinctNames(UpTo(VertexKind::kApparent));
  ExpectDistinctNames(UpTo(Engine::kAngularSpans));
  ExpectDistinctNames(UpTo(Method::kDouble));
  ExpectDistinctNames(UpTo(Emission::kRadiance));
  ExpectDistinctNames(UpTo(Formula::kCubature));
  ExpectDistinctNames(UpTo(Arithmetic::kMultiprecision));
}

TEST(Names, AreThoseOfTheManual) {
  EXPECT_EQ(Name(OracleOptions().engine), "contour");
  EXPECT_EQ(Name(OracleOptions().method), "certified");
  EXPECT_EQ(Name(OracleOptions().emission), "exitance");
  EXPECT_EQ(Name(OracleOptions().formula), "auto");
  EXPECT_EQ(Name(Arithmetic::kMultiprecision), "MPFR");
  EXPECT_EQ(Name(VertexKind::kHorizon), "horizon");
}

TEST(Names, AValueThatIsNoneOfThemHasNoName) {
  EXPECT_EQ(Name(static_cast<Engine>(3)), "");
  EXPECT_EQ(Name(static_cast<VertexKind>(3)), "");
}

TEST(Names, AllFormulasAreAllInTheirOrder) {
  EXPECT_TRUE(std::ranges::equal(AllFormulas(), UpTo(Formula::kCubature)));
}

TEST(Names, AFormulaIsFoundByItsName) {
  for (const Formula formula : AllFormulas())
    EXPECT_EQ(FormulaByName(Name(formula)), formula);
  EXPECT_EQ(FormulaByName("Auto"), std::nullopt);
  EXPECT_EQ(FormulaByName(""), std::nullopt);
}

}  // namespace
}  // namespace truelux
