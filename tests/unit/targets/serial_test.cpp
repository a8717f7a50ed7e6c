// Tests Serial: formatting, buffers and timing.
#include "tests/unit/targets/fixture.h"

namespace robosim::exec::serial_test {

using testing::ElementsAre;

TEST_P(OnEveryTarget, PrintGivesTheGenuineCoresText) {
  EXPECT_EQ(output(R"(void setup() {
  Serial.begin(115200);
  Serial.print("a"); Serial.print('b'); Serial.print(-12); Serial.print(3.14159, 3); Serial.print(255, HEX);
  Serial.print(F(" flash ")); Serial.print(String("s") + 5); Serial.println(true); Serial.write(65);
}
void loop() {})",
                   20 * kMillisecond),
            "ab-123.142FF flash s51\r\nA");
}

// Runs only on chips, because the host reports a byte when the sketch writes it to the buffer.
TEST_P(OnEveryChip, BytesLeaveAtTheBaudRate) {
  output("void setup() { Serial.begin(9600); Serial.print(\"0123456789\"); }\nvoid loop() {}",
         20 * kMillisecond);
  ASSERT_EQ(serial_, "0123456789");
  EXPECT_NEAR(static_cast<double>(byte_times_[9] - byte_times_[2]) / 7e3, GetParam().byte_us, 1);
}

TEST_P(OnEveryTarget, FlushWaitsUntilTheLastBitIsOut) {
  output(R"(void setup() {
  Serial.begin(9600);
  const unsigned long start = micros();
  Serial.write("abcdefghij");
  Serial.flush();
  const unsigned long took = micros() - start;
  Serial.println();
  Serial.println(took);
}
void loop() {})",
         30 * kMillisecond);
  EXPECT_NEAR(std::stod(serial_.substr(12)), 10 * GetParam().byte_us, 20);
}

TEST_P(OnEveryTarget, BytesArriveAtTheBaudRateAndAreEchoed) {
  start(R"(void setup() { Serial.begin(9600); }
void loop() { if (Serial.available()) Serial.write(Serial.read() + 1); })");
  run(5 * kMillisecond);
  const std::string text = "a longer text than the receiver's two bytes hold";
  for (const char c : text) board().receive_byte(static_cast<std::uint8_t>(c - 1), now_);
  run(60 * kMillisecond);
  EXPECT_EQ(serial_, text);
  EXPECT_GE(byte_times_[0], 6 * kMillisecond) << "a byte takes its time to arrive";
  EXPECT_GE(byte_times_[2] - byte_times_[0], 2 * kMillisecond);
}

TEST_P(OnAtmega, TheReceiveBufferHolds63BytesAndTheRestIsLost) {
  start(R"(void setup() {
  Serial.begin(115200);
  delay(20);
  Serial.println(Serial.available());
  Serial.println(Serial.peek());
}
void loop() {})");
  run(5 * kMillisecond);
  for (int i = 0; i < 100; ++i) board().receive_byte(static_cast<std::uint8_t>(i), now_);
  run(50 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(63, 0));
}

TEST_P(OnAtmega, WithInterruptsOffTheReceiversTwoBytesStayAndTheThirdInItsShiftRegister) {
  start(R"(void setup() {
  Serial.begin(115200);
  noInterrupts();
  delayMicroseconds(16000);
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

TEST_P(OnEveryTarget, BytesBeforeTheReceiverListensAreLost) {
  start(R"(void setup() { delay(10); Serial.begin(115200); delay(5); Serial.println(Serial.available()); }
void loop() {})");
  board().receive_byte('x', 2 * kMillisecond);
  run(30 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0));
}

}  // namespace robosim::exec::serial_test
