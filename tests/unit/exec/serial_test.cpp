// Tests Serial on the host: formatting, buffers and timing.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::serial_test {

using testing::SizeIs;

using SerialTest = HostTest;

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

}  // namespace robosim::exec::serial_test
