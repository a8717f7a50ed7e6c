// Tests the serial port of an emulated AVR.
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace serial_test {

using testing::ElementsAre;

class SerialTest : public AvrTest {};

TEST_F(SerialTest, BytesLeaveAtTheBaudRate) {
  output("void setup() { Serial.begin(9600); Serial.print(\"0123456789\"); }\nvoid loop() {}");
  EXPECT_EQ(serial_, "0123456789");
  // A byte takes 10 bits. At 16 MHz, the rate nearest to 9600 baud is 9615 baud (UBRR = 207).
  EXPECT_NEAR(static_cast<double>(byte_times_[9] - byte_times_[2]) / 7, 1.04e6, 1e3);
}

TEST_F(SerialTest, BytesArriveAtTheBaudRateAndAreEchoed) {
  start(
      "void setup() { Serial.begin(115200); }\nvoid loop() { if (Serial.available()) "
      "Serial.write(Serial.read()); }");
  run(5 * kMillisecond);
  const std::string text = "a longer text than the receiver's two bytes hold";
  for (const char c : text) board().receive_byte(static_cast<std::uint8_t>(c), now_);
  run(20 * kMillisecond);
  EXPECT_EQ(serial_, text);
  EXPECT_GT(byte_times_[0], 5 * kMillisecond + 85 * kMicrosecond) << "a byte takes its time to arrive";
}

TEST_F(SerialTest, WithInterruptsOffTheReceiversTwoBytesStayAndTheThirdInItsShiftRegister) {
  start(R"(void setup() {
  Serial.begin(115200);
  noInterrupts();
  for (byte i = 0; i < 4; ++i) delayMicroseconds(10000);
  interrupts();
  delay(1);
  Serial.println(Serial.available());
}
void loop() {})");
  run(5 * kMillisecond);
  for (int i = 0; i < 10; ++i) board().receive_byte(static_cast<std::uint8_t>(i), now_);
  run(100 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(3));
}

TEST_F(SerialTest, FlushWaitsUntilTheLastBitIsOut) {
  output(
      "void setup() { Serial.begin(9600); pinMode(13, OUTPUT); Serial.print(\"abc\"); Serial.flush(); "
      "digitalWrite(13, HIGH); }\nvoid loop() {}");
  EXPECT_NEAR(static_cast<double>(changes(13)[1] - changes(13)[0]), 3.12e6, 0.1e6);
}

TEST_F(SerialTest, BytesBeforeTheReceiverListensAreLost) {
  start(
      "void setup() { delay(10); Serial.begin(115200); delay(5); Serial.println(Serial.available()); }\nvoid "
      "loop() {}");
  board().receive_byte('x', 2 * kMillisecond);
  run(30 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0));
}

}  // namespace serial_test
}  // namespace robosim::exec
