// Boards with other chips in the emulator: sketches that use what only they have, or lack.
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace {

using testing::HasSubstr;

class Boards : public AvrTest {};

TEST_F(Boards, ANano168HasHalfTheMemory) {
  board_name_ = "nano168";
  EXPECT_EQ(output(R"(
#include <EEPROM.h>
void setup() {
  Serial.begin(115200);
  Serial.println(RAMEND, HEX);
  Serial.println(EEPROM.length());
  EEPROM.write(511, 77);
  Serial.println(EEPROM.read(511));
}
void loop() {}
)"),
            "4FF\r\n512\r\n77\r\n");
  try {
    build(
        "char big[1100]; void setup() { Serial.begin(9600); Serial.println(big); } void loop() { ++big[3]; "
        "}");
    FAIL() << "it fits";
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), HasSubstr("and the nano168 has 1024 of RAM"));
  }
}

}  // namespace
}  // namespace robosim::exec
