#include "sim/base/units.h"

#include <gtest/gtest.h>

namespace robosim {

TEST(Units, ReadsQuantitiesWithAndWithoutASpace) {
  EXPECT_DOUBLE_EQ(*parse_quantity("150 mm", Dimension::length), 0.150);
  EXPECT_DOUBLE_EQ(*parse_quantity("1.5m", Dimension::length), 1.5);
  EXPECT_DOUBLE_EQ(*parse_quantity("  7.4 V ", Dimension::voltage), 7.4);
  EXPECT_DOUBLE_EQ(*parse_quantity("60 rpm", Dimension::rotation_rate), 6.283185307179586);
  EXPECT_DOUBLE_EQ(*parse_quantity("0.25", Dimension::ratio), 0.25);
  EXPECT_DOUBLE_EQ(*parse_quantity("5 %", Dimension::ratio), 0.05);
}

TEST(Units, RefusesWhatIsNoQuantityOfTheDimension) {
  EXPECT_FALSE(parse_quantity("150", Dimension::length));
  EXPECT_FALSE(parse_quantity("150 kg", Dimension::length));
  EXPECT_FALSE(parse_quantity("mm", Dimension::length));
  EXPECT_FALSE(parse_quantity("", Dimension::length));
  EXPECT_FALSE(parse_quantity("1e999 m", Dimension::length));
  EXPECT_FALSE(parse_quantity("nan m", Dimension::length));
  EXPECT_FALSE(parse_quantity("1 m m", Dimension::length));
}

TEST(Units, ReadsDurationsInExactNanoseconds) {
  EXPECT_EQ(*parse_duration_ns("60s"), 60'000'000'000);
  EXPECT_EQ(*parse_duration_ns("20ms"), 20'000'000);
  EXPECT_EQ(*parse_duration_ns("49.7 d"), 4'294'080'000'000'000);
  EXPECT_FALSE(parse_duration_ns("-1s"));
  EXPECT_FALSE(parse_duration_ns("60"));
}

TEST(Units, NamesTheUnitsOfADimension) { EXPECT_EQ(unit_names(Dimension::length), "mm, cm, m or in"); }

}  // namespace robosim
