// Tests Serial on the host: formatting, buffers and timing.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec {
namespace serial_test {

using testing::ElementsAre;
using testing::SizeIs;

using SerialTest = HostTest;

TEST_F(SerialTest, PrintGivesTheGenuineCoresText) {
  EXPECT_EQ(output(R"(void setup() {
  Serial.begin(115200);
  Serial.print("a"); Serial.print('b'); Serial.print(-12); Serial.print(3.14159, 3); Serial.print(255, HEX);
  Serial.print(F(" flash ")); Serial.print(String("s") + 5); Serial.println(true); Serial.write(65);
}
void loop() {})"),
            "ab-123.142FF flash s51\r\nA");
}

TEST_F(SerialTest, AFullBufferHoldsTheSketchUpAtTheBaudRate) {
  // At 9600 baud, a byte takes 10 bits of 1/9615 s each, because UBRR is 207 with U2X.
  start(R"(void setup() {
  Serial.begin(9600);
  pinMode(13, OUTPUT);
  for (int i = 0; i < 165; ++i) Serial.write('x');
  digitalWrite(13, HIGH);
}
void loop() {})");
  run(300 * kMillisecond);
  EXPECT_EQ(serial_.size(), 165u);
  ASSERT_EQ(changes(13).size(), 2u);
  EXPECT_NEAR(static_cast<double>(changes(13)[1]), 100 * 1.04e6, 1.1e6);  // 65 of 165 bytes are buffered
}

TEST_F(SerialTest, SixtyFiveBytesFitWithoutWaiting) {
  start(R"(void setup() {
  Serial.begin(9600);
  pinMode(13, OUTPUT);
  for (int i = 0; i < 65; ++i) Serial.write('x');
  digitalWrite(13, HIGH);
}
void loop() {})");
  run(300 * kMillisecond);
  ASSERT_EQ(changes(13).size(), 2u);
  EXPECT_LT(changes(13)[1], 2 * kMillisecond);
}

TEST_F(SerialTest, FlushWaitsForTheLastByte) {
  output(R"(void setup() {
  Serial.begin(9600);
  const unsigned long start = micros();
  Serial.write("abcdefghij");
  Serial.flush();
  const unsigned long took = micros() - start;
  Serial.println();
  Serial.println(took);
}
void loop() {})");
  EXPECT_NEAR(std::stod(serial_.substr(12)), 10400, 20);
}

TEST_F(SerialTest, BytesArriveOneByOneAndAreRead) {
  start(R"(void setup() { Serial.begin(9600); }
void loop() { if (Serial.available()) { int c = Serial.read(); Serial.write(c + 1); } })");
  run(5 * kMillisecond);
  for (const char c : std::string("HAL")) board().receive_byte(static_cast<std::uint8_t>(c), now_);
  run(10 * kMillisecond);
  EXPECT_EQ(serial_, "IBM");
  EXPECT_GE(byte_times_[0], 6 * kMillisecond);
  EXPECT_GE(byte_times_[2] - byte_times_[0], 2 * kMillisecond);
}

TEST_F(SerialTest, TheReceiveBufferHolds63BytesAndTheRestIsLost) {
  start(
      "void setup() { Serial.begin(115200); delay(100); Serial.println(Serial.available()); "
      "Serial.println(Serial.peek()); } void loop() {}");
  run(5 * kMillisecond);
  for (int i = 0; i < 100; ++i) board().receive_byte(static_cast<std::uint8_t>(i), now_);
  run(200 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(63, 0));
}

TEST_F(SerialTest, WithInterruptsOffOnlyTheReceiversThreeBytesStay) {
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

TEST_F(SerialTest, ParsingWaitsForItsTimeout) {
  start(
      R"(void setup() { Serial.begin(9600); Serial.setTimeout(50); const unsigned long start = millis(); Serial.println(Serial.parseInt()); Serial.println(millis() - start); }
void loop() {})");
  run(5 * kMillisecond);
  for (const char c : std::string("x123")) board().receive_byte(static_cast<std::uint8_t>(c), now_);
  run(200 * kMillisecond);
  ASSERT_THAT(numbers(), SizeIs(2));
  EXPECT_EQ(numbers()[0], 123);
  EXPECT_NEAR(static_cast<double>(numbers()[1]), 58, 3);
}

TEST_F(SerialTest, WithoutBeginNothingIsSentAndNothingBlocks) {
  start(
      "void setup() { pinMode(13, OUTPUT); for (int i = 0; i < 200; ++i) Serial.println(i); digitalWrite(13, "
      "HIGH); } void loop() {}");
  run(300 * kMillisecond);
  EXPECT_EQ(serial_, "");
  EXPECT_EQ(changes(13).size(), 2u);
}

TEST_F(SerialTest, SerialEventIsCalledAfterALoopWithBytes) {
  start(
      "void setup() { Serial.begin(9600); } void loop() {} void serialEvent() { Serial.write(Serial.read()); "
      "}");
  run(5 * kMillisecond);
  board().receive_byte('q', now_);
  run(10 * kMillisecond);
  EXPECT_EQ(serial_, "q");
}

TEST_F(SerialTest, NumbersTakeTheTimeOfTheirFormatting) {
  output(R"(void setup() {
  Serial.begin(115200);
  unsigned long start = micros();
  Serial.print("abcde");
  const unsigned long text = micros() - start;
  delay(10);
  start = micros();
  Serial.print(10000L);
  const unsigned long number = micros() - start;
  Serial.println();
  Serial.println(text);
  Serial.println(number);
}
void loop() {})");
  const std::string tail = serial_.substr(serial_.find("\r\n") + 2);
  EXPECT_NEAR(std::stod(tail), 626.0 / 16, 25);
  EXPECT_NEAR(std::stod(tail.substr(tail.find("\r\n") + 2)), 3765.0 / 16, 25);
}

}  // namespace serial_test
}  // namespace robosim::exec
