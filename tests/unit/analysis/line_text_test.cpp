#include "sim/campaign/analysis/line_text.h"

#include <gtest/gtest.h>

namespace robosim::analysis {
namespace line_text_test {

constexpr double kTolerance = 0.10;

Number number(const std::string& text) {
  const LineText parts = take_apart(text);
  EXPECT_EQ(parts.numbers.size(), 1u) << text;
  return parts.numbers.empty() ? Number{} : parts.numbers[0];
}
Likeness alike(const std::string& a, const std::string& b) {
  return likeness(number(a), number(b), kTolerance);
}
std::string cause(const std::string& a, const std::string& b) { return width_cause(number(a), number(b)); }

TEST(LineText, NumbersAreTakenOutOfTheirText) {
  const LineText parts = take_apart("S1=-12, v 3.50 m/s at 1200ms");
  EXPECT_EQ(parts.form, "S#=#, v # m/s at #ms");
  ASSERT_EQ(parts.numbers.size(), 4u);
  EXPECT_EQ(parts.numbers[1].value, -12.0);
  EXPECT_EQ(parts.numbers[2].form, Number::Form::fraction);
  EXPECT_EQ(parts.numbers[3].text, "1200");
}

TEST(LineText, AMinusBetweenWordsIsNoSign) {
  EXPECT_EQ(take_apart("3-4").form, "#-#");
  EXPECT_EQ(take_apart("a-4").form, "a-#");
}

TEST(LineText, HexadecimalNumbersAreThoseInCapitals) {
  EXPECT_EQ(take_apart("FFFFFFFF").numbers.size(), 1u);
  EXPECT_EQ(take_apart("1A2B").numbers[0].value, 0x1A2B);
  EXPECT_EQ(take_apart("DEAD END").form, "DEAD END");
  EXPECT_EQ(take_apart("FAR").form, "FAR");
}

TEST(LineText, NumbersAreAlikeWithinTheTolerance) {
  EXPECT_EQ(alike("100", "108"), Likeness::same);
  EXPECT_EQ(alike("100", "120"), Likeness::different);
  EXPECT_EQ(alike("3", "4"), Likeness::different);
  EXPECT_EQ(alike("-5", "5"), Likeness::different);
  EXPECT_EQ(alike("0", "0"), Likeness::same);
}

TEST(LineText, ARoundedFractionMayBeOneMoreOrLessInItsLastPlace) {
  EXPECT_EQ(alike("0.2", "0.3"), Likeness::same);
  EXPECT_EQ(alike("0.2", "0.4"), Likeness::different);
  EXPECT_EQ(alike("0.20", "0.30"), Likeness::different);
  EXPECT_EQ(alike("-0.1", "0.0"), Likeness::same);
}

TEST(LineText, ANegativeHexNumberIsAsLongAsItsType) {
  EXPECT_EQ(alike("FFFFFFFFFFFFFFFE", "FFFFFFFE"), Likeness::known);
  EXPECT_EQ(known_cause(number("FFFFFFFFFFFFFFFE"), number("FFFFFFFE")), "width of long");
  EXPECT_EQ(alike("1FFFFFFFE", "FFFFFFFE"), Likeness::different);
}

TEST(LineText, ANumberSignIsNoNumber) {
  EXPECT_NE(take_apart("# 5").form, take_apart("3 5").form);
  EXPECT_EQ(take_apart("# 5").form, take_apart("# 17").form);
}

TEST(LineText, TheLastDigitsOfAFloatAreKnownToDiffer) {
  EXPECT_EQ(alike("3.1415927", "3.1415926"), Likeness::known);
  EXPECT_EQ(known_cause(number("3.1415927"), number("3.1415926")), "float formatting");
}

TEST(LineText, WhatIntegersLoseIsNamed) {
  EXPECT_EQ(cause("40000", "-25536"), "integer width: -25536 = 40000 - 2^16, which does not fit 16 bits");
  EXPECT_EQ(cause("100000", "-31072"),
            "integer width: -31072 = 100000 - 2 * 2^16, which does not fit 16 bits");
  EXPECT_EQ(cause("4294967301", "5"), "integer width: 5 = 4294967301 - 2^32, which does not fit 32 bits");
  EXPECT_EQ(cause("40000", "100"), "");
  EXPECT_EQ(cause("7", "7"), "");
}

}  // namespace line_text_test
}  // namespace robosim::analysis
