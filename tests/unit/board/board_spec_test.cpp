#include "hal/board/board_spec.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>

namespace robosim {

TEST(BoardSpec, FindsPinsByEveryNamePeopleUse) {
  const BoardSpec& uno = *find_board("uno");
  EXPECT_EQ(find_pin(uno, "5"), 5);
  EXPECT_EQ(find_pin(uno, "D5"), 5);
  EXPECT_EQ(find_pin(uno, "a0"), 14);
  EXPECT_EQ(find_pin(uno, "PB5"), 13);
  EXPECT_EQ(find_pin(uno, "14"), 14);
  EXPECT_EQ(find_pin(uno, "20"), kNoPin);
  EXPECT_EQ(find_pin(uno, "A6"), kNoPin);
  EXPECT_EQ(find_pin(uno, ""), kNoPin);
  EXPECT_EQ(find_pin(*find_board("nano"), "A6"), 20);
}

TEST(BoardSpec, TheBluePillHasEveryPinOnceAndOfAnUnosPinsWhatTheyCan) {
  const BoardSpec& blue = *find_board("bluepill");
  const BoardSpec& uno = *find_board("uno");
  std::set<std::string> names;
  for (Pin pin = 0; pin < blue.pin_count; ++pin) {
    EXPECT_TRUE(names.insert(blue.pins[pin].chip_name).second) << blue.pins[pin].chip_name;
    EXPECT_EQ(find_pin(blue, blue.pins[pin].chip_name), pin);
    if (pin >= uno.pin_count) continue;
    EXPECT_STREQ(blue.pins[pin].name, uno.pins[pin].name);
    EXPECT_TRUE(blue.pins[pin].pwm || !uno.pins[pin].pwm) << pin;
    EXPECT_TRUE(blue.pins[pin].analog_channel >= 0 || uno.pins[pin].analog_channel < 0) << pin;
  }
  EXPECT_EQ(find_pin(blue, "pc13"), blue.led_builtin);
}

TEST(BoardSpec, TheBluePillsChipIsResetAtPowerDownOnly) {
  EXPECT_EQ(find_board("bluepill")->brown_out_volts, 1.88);
  EXPECT_EQ(find_board("bluepill8")->brown_out_volts, 1.88);
}

TEST(BoardSpec, AProMiniIsANanoWithAnotherClockAndSupply) {
  const BoardSpec& nano = *find_board("nano");
  for (const auto& [name, clock_hz, volts] :
       {std::tuple{"promini8", 8000000u, 3.3}, {"promini16", 16000000u, 5.0}}) {
    const BoardSpec& mini = *find_board(name);
    EXPECT_EQ(mini.clock_hz, clock_hz);
    EXPECT_EQ(mini.supply_volts, volts);
    EXPECT_EQ(mini.chip, nano.chip);
    EXPECT_EQ(mini.pins, nano.pins);
    EXPECT_EQ(find_pin(mini, "A7"), 21);
  }
}

TEST(BoardSpec, APinWithTwoNumbersIsFoundUnderTheFirst) {
  const BoardSpec& leonardo = *find_board("leonardo");
  for (const char* name : {"A6", "24", "D4", "4", "PD4"}) EXPECT_EQ(find_pin(leonardo, name), 4) << name;
  EXPECT_EQ(find_pin(leonardo, "A5"), 23);
}

TEST(BoardSpec, KnowsNoOtherBoards) { EXPECT_EQ(find_board("due"), nullptr); }

}  // namespace robosim
